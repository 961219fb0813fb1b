// S1: every volume and every face of the map has its one label.

#include <algorithm>
#include <map>

#include "modeler/constraints/constraints.h"
#include "modeler/constraints/map_faces.h"
#include "modeler/place.h"

namespace enfilade::modeler {
namespace {

constexpr const char* hint = "The tables of the model do not fit its map: build it again from the plan, and report it.";

/// The pieces that have a half-edge of the plan as a side.
class PiecesAtHalfEdges {
public:
    explicit PiecesAtHalfEdges(const Building& building) : first_(2 * building.edges.size() + 1, 0) {
        for (const Corner& corner : building.corners) ++first_[corner.half_edge + 1];
        for (std::size_t h = 1; h < first_.size(); ++h) first_[h] += first_[h - 1];
        pieces_.resize(building.corners.size());
        std::vector<std::uint32_t> fill(first_.begin(), first_.end() - 1);
        for (std::uint32_t p = 0; p < building.pieces.size(); ++p) {
            const Piece& piece = building.pieces[p];
            for (std::uint32_t k = 0; k < piece.corner_count; ++k)
                pieces_[fill[building.corners[piece.first_corner + k].half_edge]++] = p;
        }
    }
    [[nodiscard]] bool has(std::uint32_t half_edge, std::uint32_t piece) const {
        const auto end = pieces_.begin() + first_[half_edge + 1];
        return std::find(pieces_.begin() + first_[half_edge], end, piece) != end;
    }

private:
    std::vector<std::uint32_t> first_;  ///< [half-edge + 1] into pieces_
    std::vector<std::uint32_t> pieces_;
};

class LabelCheck {
public:
    LabelCheck(const Subject& subject, Blame& blame, CheckReport& report)
        : building_(subject.building), faces_(subject.faces), blame_(blame), report_(report) {}

    void run() {
        check_volume_rows();
        if (blame_.whole_map) return;
        check_labels();
        check_parents();
        check_face_rows();
    }

private:
    [[nodiscard]] const Space& space(std::uint32_t v) const { return building_.spaces[building_.volumes[v].space]; }

    void blame_map(std::string sentence) {
        Finding finding{.code = "S1", .severity = Severity::Error, .sentence = std::move(sentence), .hint = hint};
        blame_.whole_map = true;
        report_.findings.push_back(std::move(finding));
    }

    void blame_volume(std::uint32_t v, std::string sentence) {
        Finding finding{.code = "S1", .severity = Severity::Error, .sentence = std::move(sentence), .hint = hint};
        place_at_volume(building_, v, finding);
        blame_.volume[v] = true;
        report_.findings.push_back(std::move(finding));
    }

    void check_volume_rows() {
        const std::size_t rows = building_.volumes.size();
        for (std::size_t v = rows; v < building_.map.cell_bound<3>(); ++v)
            if (faces_.in_map(std::uint32_t(v))) return blame_map("The map has a volume that nothing labels.");
        for (std::size_t f = building_.faces.size(); f < faces_.size(); ++f)
            if (faces_[std::uint32_t(f)].in_map()) return blame_map("The map has a face that nothing labels.");
        for (std::uint32_t v = 0; v < rows; ++v)
            if (!faces_.in_map(v) && !skipped(v))
                blame_volume(v, "A volume of " + title(space(v)) + " has a label, but is not in the map.");
    }

    /// Counts what is left out because it is blamed already.
    bool skipped(std::uint32_t v) {
        report_.suppressed += blame_.volume[v];
        return blame_.volume[v];
    }

    /// All volumes of a space that have one wrong label are one fault: perhaps the space's own label is wrong.
    void check_labels() {
        std::map<std::pair<std::uint32_t, Label>, std::vector<std::uint32_t>> wrong;
        const std::uint32_t outside = std::uint32_t(building_.volumes.size() - 1);
        for (std::uint32_t v = 0; v <= outside; ++v) {
            const Volume& volume = building_.volumes[v];
            const bool fits = volume.label == space(v).label && (volume.label == Label::Outside) == (v == outside);
            if (!fits && !skipped(v)) wrong[{volume.space, volume.label}].push_back(v);
        }
        for (const auto& [key, volumes] : wrong) {
            const std::string count = volumes.size() == 1 ? "A volume" : std::to_string(volumes.size()) + " volumes";
            blame_volume(volumes.front(), count + " of " + title(building_.spaces[key.first]) +
                                              (volumes.size() == 1 ? " is" : " are") + " labelled \"" +
                                              accel::name_of(key.second) + "\".");
            for (const std::uint32_t v : volumes) blame_.volume[v] = true;
        }
    }

    /// Pieces of one volume are of one space; the few that are not are wrong.
    void check_parents() {
        std::map<std::uint32_t, std::map<std::uint32_t, std::vector<std::uint32_t>>> mixed;  // parent, space -> volumes
        std::vector<std::uint32_t> first(building_.volumes.size(), UINT32_MAX);
        for (std::uint32_t v = 0; v < building_.volumes.size(); ++v) {
            const Volume& volume = building_.volumes[v];
            std::uint32_t& known = first[volume.parent];
            if (known == UINT32_MAX) known = volume.space;
            else if (known != volume.space) mixed[volume.parent];
        }
        if (mixed.empty()) return;
        for (std::uint32_t v = 0; v < building_.volumes.size(); ++v)
            if (const auto at = mixed.find(building_.volumes[v].parent); at != mixed.end())
                at->second[building_.volumes[v].space].push_back(v);
        for (const auto& [parent, spaces] : mixed) {
            const auto most = std::max_element(spaces.begin(), spaces.end(), [](const auto& l, const auto& r) {
                return l.second.size() < r.second.size();
            });
            for (const auto& [index, volumes] : spaces) {
                if (index == most->first) continue;
                for (const std::uint32_t v : volumes) {
                    if (skipped(v)) continue;
                    blame_volume(v, "A piece of " + title(building_.spaces[most->first]) + " is said to belong to " +
                                        title(building_.spaces[index]) + ".");
                }
            }
        }
    }

    void check_face_rows() {
        const PiecesAtHalfEdges pieces(building_);
        for (std::uint32_t f = 0; f < building_.faces.size(); ++f) {
            const MapFace& face = faces_[f];
            const char* fault = face_fault(f, face, pieces);
            if (!fault) continue;
            const auto is_blamed = [&](std::uint32_t v) { return v != UINT32_MAX && blame_.volume[v]; };
            if (blame_.face[f] || is_blamed(face.volumes[0]) || is_blamed(face.volumes[1])) {
                ++report_.suppressed;
                continue;
            }
            Finding finding{.code = "S1", .severity = Severity::Error, .hint = hint};
            if (face.in_map()) {
                finding.point = middle(building_, face);
                for (const std::uint32_t v : face.volumes) place_at_volume(building_, v, finding);
                finding.sentence = "The row of a face between " + title_of(face.volumes[0]) + " and " +
                                   title_of(face.volumes[1]) + ' ' + fault + '.';
            } else {
                place_at_face(building_, f, finding);
                finding.sentence = std::string("A face ") + fault + '.';
            }
            blame_.face[f] = true;
            report_.findings.push_back(std::move(finding));
        }
    }

    [[nodiscard]] std::string title_of(std::uint32_t v) const {
        return v < building_.volumes.size() ? title(space(v)) : "nothing";
    }

    [[nodiscard]] bool joins_cells(std::uint32_t a, std::uint32_t b) const {
        return a < building_.volumes.size() && b < building_.volumes.size() &&
               carries_light(building_.volumes[a].label) && carries_light(building_.volumes[b].label);
    }

    /// What is wrong with a row, nullptr for nothing. Faces between two cells, by row or by map, are portals: whether
    /// they join the same cells is D2.
    [[nodiscard]] const char* face_fault(std::uint32_t f, const MapFace& face, const PiecesAtHalfEdges& pieces) const {
        const Face& row = building_.faces[f];
        if (!face.in_map()) return joins_cells(row.front, row.back) ? nullptr : "has a label, but is not in the map";
        if (!face.joins_two || face.volumes[1] == UINT32_MAX) return nullptr;  // T4
        const auto [low, high] = std::minmax(row.front, row.back);
        if (low != face.volumes[0] || high != face.volumes[1])
            return joins_cells(low, high) || joins_cells(face.volumes[0], face.volumes[1])
                       ? nullptr
                       : "puts it between other volumes";
        if (!faces_.is_prism(low) || !faces_.is_prism(high)) return nullptr;  // its geometry is at fault
        if ((row.direction == Direction::Up) != face.level())
            return "says that it stands where it lies, or lies where it stands";
        if (row.z_low != face.z_low || row.z_high != face.z_high) return "puts it at another height";
        if (row.direction == Direction::Up)
            return faces_.side(face, row.front) == -1 ? nullptr : "turns it upside down";
        const PlanEdge& edge = building_.edges[row.edge];
        const auto [a, b] = std::minmax(building_.points[edge.a], building_.points[edge.b]);
        const auto [p, q] = std::minmax(face.feet[0], face.feet[1]);
        if (a != p || b != q) return "puts it over another edge of the plan";
        // Both its volumes have to say so: one alone may have the wrong polygon (D1).
        const auto stands_on = [&](std::uint32_t v, std::uint32_t half_edge) {
            return v + 1 == building_.volumes.size() || (pieces.has(half_edge, building_.volumes[v].piece) &&
                                                         !pieces.has(half_edge ^ 1, building_.volumes[v].piece));
        };
        const bool is_turned = stands_on(row.front, 2 * row.edge + 1) && stands_on(row.back, 2 * row.edge);
        return is_turned ? "turns it round" : nullptr;
    }

    const Building& building_;
    const MapFaces& faces_;
    Blame& blame_;
    CheckReport& report_;
};

}  // namespace

void check_labels(const Subject& subject, Blame& blame, CheckReport& report) {
    report.codes_checked.emplace_back("S1");
    if (blame.whole_map) ++report.suppressed;
    else LabelCheck(subject, blame, report).run();
}

}  // namespace enfilade::modeler
