// T3 (which way faces look) and G5 of meshes.

#include <algorithm>
#include <cmath>

#include "modeler/meshes/mesh_solids.h"
#include "modeler/meshes/piece_shapes.h"

namespace enfilade::modeler {
namespace {

constexpr std::uint32_t nothing = UINT32_MAX;
/// Triangles that the search for nested surfaces may look at: seconds.
constexpr std::uint64_t nesting_budget = 100'000'000;

enum class Lie : std::uint8_t { Apart, Inside, Same, Unknown };

class SolidChecker {
public:
    SolidChecker(const MeshTriangles& triangles, const MeshPieces& pieces, const std::vector<std::uint32_t>& place,
                 const Crossings& crossings, MeshReport& report)
        : triangles_(triangles),
          pieces_(pieces),
          place_(place),
          crossings_(crossings),
          report_(report),
          shapes_(report.mesh(), triangles, pieces),
          blamed_(pieces.pieces.size(), false),
          is_void_(pieces.pieces.size(), false) {}

    void run() {
        blame_known();
        for (std::uint32_t p = 0; p < blamed_.size(); ++p) check_turned(p);
        for (std::uint32_t p = 0; p < blamed_.size(); ++p) check_volume(p);
        for (const auto& [p, q] : crossings_.piercing) report_pierced(p, q);
        check_nesting();
        for (std::uint32_t p = 0; p < blamed_.size(); ++p) check_inside_out(p);
        if (budget_spent_) report_budget();
    }

private:
    /// A surface with a fault encloses nothing that could be measured.
    void blame_known() {
        for (std::uint32_t f = 0; f < pieces_.piece.size(); ++f)
            if (pieces_.piece[f] != nothing && report_.blame.face[f]) blamed_[pieces_.piece[f]] = true;
        for (std::uint32_t p = 0; p < blamed_.size(); ++p)
            if (!shapes_[p].whole) blamed_[p] = true;
    }

    [[nodiscard]] bool is_inner(std::uint32_t p) const { return pieces_.pieces[p].shell != 0; }

    /// How the piece is called in a sentence: "the surface of face 3".
    [[nodiscard]] std::string title(std::uint32_t p) const {
        const std::uint32_t f = pieces_.pieces[p].first_face;
        const std::string owner = report_.owner(f);
        if (pieces_.pieces[p].solid != nothing) return owner;
        return "the surface of face " + report_.face(f) + (owner.empty() ? "" : " (" + owner + ")");
    }
    static std::string capital(std::string text) {
        if (text[0] >= 'a' && text[0] <= 'z') text[0] = char(text[0] - 'a' + 'A');
        return text;
    }

    Finding finding_at(const char* code, Severity severity, std::uint32_t face) const {
        Finding finding{.code = code, .severity = severity};
        const auto ring = report_.mesh().face(face);
        std::array<double, 3> centre{};
        for (const std::uint32_t v : ring)
            for (std::size_t i = 0; i < 3; ++i) centre[i] += report_.mesh().points[v][i] / double(ring.size());
        report_.put_at(finding, centre);
        report_.name_face(finding, face);
        return finding;
    }

    /// The faces of a piece that look another way than most of them; of a closed one, those that look inward.
    void check_turned(std::uint32_t p) {
        const bool known_sides = shapes_[p].whole && shapes_[p].has_volume();
        const bool want_outward = known_sides ? !is_inner(p) : shapes_[p].outward >= shapes_[p].inward;
        const std::uint32_t wrong = want_outward ? shapes_[p].inward : shapes_[p].outward;
        if (shapes_[p].outward == 0 || shapes_[p].inward == 0 || one_sided(p)) return;
        std::vector<std::uint32_t> faces;
        std::uint32_t before = nothing;
        for (const std::uint32_t t : shapes_.triangles_of(p)) {
            const std::uint32_t f = triangles_.face[t];
            if (f != before && shapes_.faces_outward(f) != want_outward) faces.push_back(f);
            before = f;
        }
        const auto is_known = [&](std::uint32_t f) { return report_.blame.crowded[f]; };
        if (std::all_of(faces.begin(), faces.end(), is_known)) return report_.suppress();
        Finding finding = finding_at("T3", Severity::Warning, faces.front());
        finding.sentence =
            (wrong == 1 ? "Face " + report_.face(faces[0]) + " is" : std::to_string(wrong) + " faces are") +
            " turned against the " + std::to_string(shapes_[p].outward + shapes_[p].inward - wrong) + " others of " +
            (wrong == 1 ? "its" : "their") + " surface" + (wrong == 1 ? "." : ": faces " + report_.faces(faces) + ".");
        finding.hint = "Reverse the order of corners of these faces; the solid itself is not affected.";
        for (std::size_t k = 1; k < std::min<std::size_t>(faces.size(), 6); ++k) report_.name_face(finding, faces[k]);
        report_.add(std::move(finding), "surfaces with faces that are turned");
    }

    [[nodiscard]] bool one_sided(std::uint32_t p) const { return pieces_.pieces[p].one_sided; }

    void check_volume(std::uint32_t p) {
        if (blamed_[p]) {
            if (pieces_.pieces[p].closed) report_.suppress();
            return;
        }
        if (shapes_[p].has_volume()) return;
        blamed_[p] = true;
        Finding finding = finding_at("G5", Severity::Error, pieces_.pieces[p].first_face);
        finding.sentence = capital(title(p)) + " is closed but encloses no volume.";
        finding.hint = "It is squashed flat: leave it out.";
        report_.add(std::move(finding), "surfaces that enclose no volume");
    }

    void report_pierced(std::uint32_t p, std::uint32_t q) {
        if (blamed_[p] || blamed_[q]) return report_.suppress();  // an open surface has no inside to overlap with
        Finding finding = finding_at("G5", Severity::Error, pieces_.pieces[q].first_face);
        report_.name_face(finding, pieces_.pieces[p].first_face);
        finding.sentence = capital(title(p)) + " and " + title(q) + " go through each other.";
        finding.hint = "Unite them, or move them apart.";
        report_.add(std::move(finding), "pairs of surfaces that go through each other");
    }

    [[nodiscard]] bool cross(std::uint32_t p, std::uint32_t q) const {
        return std::binary_search(crossings_.piercing.begin(), crossings_.piercing.end(),
                                  std::pair(std::min(p, q), std::max(p, q)));
    }

    [[nodiscard]] bool box_within(std::uint32_t p, std::uint32_t q) const {
        for (std::size_t i = 0; i < 3; ++i)
            if (shapes_[p].low[i] < shapes_[q].low[i] || shapes_[p].high[i] > shapes_[q].high[i]) return false;
        return true;
    }

    /// The places of the corners of a piece, ascending.
    [[nodiscard]] std::vector<std::uint32_t> places(std::uint32_t p) const {
        std::vector<std::uint32_t> result;
        for (const std::uint32_t t : shapes_.triangles_of(p))
            for (const std::uint32_t v : triangles_.corners[t]) result.push_back(place_[v]);
        std::sort(result.begin(), result.end());
        result.erase(std::unique(result.begin(), result.end()), result.end());
        return result;
    }

    /// Whether p, which does not pierce q, lies in it: by the first of its corners that is clearly in or out.
    [[nodiscard]] Lie lie(std::uint32_t p, std::uint32_t q) {
        const std::vector<std::uint32_t> corners = places(p);
        if (corners == places(q)) return Lie::Same;
        const std::uint64_t cost = shapes_.triangles_of(q).size();
        for (std::size_t k = 0; k < std::min<std::size_t>(corners.size(), 8); ++k) {
            if (spent_ + cost > nesting_budget) {
                budget_spent_ = true;
                return Lie::Unknown;
            }
            spent_ += cost;
            const PieceShapes::Side side = shapes_.side(q, report_.mesh().points[corners[k]]);
            if (side == PieceShapes::Side::Inside) return Lie::Inside;
            if (side == PieceShapes::Side::Outside) return Lie::Apart;
        }
        return Lie::Unknown;  // it lies on the other surface
    }

    /// Pairs of one group whose boxes lie in each other, found along the x axis.
    void check_nesting() {
        std::vector<std::uint32_t> order;
        for (std::uint32_t p = 0; p < blamed_.size(); ++p)
            if (!blamed_[p]) order.push_back(p);
        const auto key = [&](std::uint32_t p) { return std::tuple(pieces_.pieces[p].group, shapes_[p].low[0], p); };
        std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
        std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;  // inner, outer
        std::uint64_t looked_at = 0;
        for (std::size_t i = 0; i < order.size(); ++i)
            for (std::size_t j = i + 1; j < order.size(); ++j) {
                const std::uint32_t p = order[i], q = order[j];
                if (pieces_.pieces[p].group != pieces_.pieces[q].group || shapes_[q].low[0] > shapes_[p].high[0]) break;
                if (++looked_at > nesting_budget) {
                    budget_spent_ = true;
                    return;
                }
                if (box_within(q, p)) pairs.emplace_back(q, p);
                else if (box_within(p, q)) pairs.emplace_back(p, q);
            }
        inside_of_.assign(blamed_.size(), nothing);
        for (const auto& [inner, outer] : pairs)
            if (!cross(inner, outer)) judge_pair(inner, outer);
        for (const auto& [p, q] : crossings_.near)
            if (!blamed_[p] && !blamed_[q] && !cross(p, q) && !box_within(p, q) && !box_within(q, p) &&
                (has_point_in(p, q) || has_point_in(q, p)))
                report_pierced(p, q);
        check_voids();
    }

    /// A corner of p, or the middle of one of its triangles, inside q: how one sees an overlap where sides meet sides
    /// and none goes through the inside of a triangle.
    [[nodiscard]] bool has_point_in(std::uint32_t p, std::uint32_t q) {
        const auto& points = report_.mesh().points;
        for (const std::uint32_t v : places(p))
            if (is_in(points[v], q)) return true;
        for (const std::uint32_t t : shapes_.triangles_of(p)) {
            std::array<double, 3> middle{};
            for (const std::uint32_t v : triangles_.corners[t])
                for (std::size_t i = 0; i < 3; ++i) middle[i] += points[v][i] / 3;
            if (is_in(middle, q)) return true;
        }
        return false;
    }

    [[nodiscard]] bool is_in(const std::array<double, 3>& point, std::uint32_t q) {
        for (std::size_t i = 0; i < 3; ++i)
            if (point[i] <= shapes_[q].low[i] || point[i] >= shapes_[q].high[i]) return false;
        const std::uint64_t cost = shapes_.triangles_of(q).size();
        if (spent_ + cost > nesting_budget) {
            budget_spent_ = true;
            return false;
        }
        spent_ += cost;
        return shapes_.side(q, point) == PieceShapes::Side::Inside;
    }

    [[nodiscard]] bool same_solid(std::uint32_t p, std::uint32_t q) const {
        return pieces_.pieces[p].solid != nothing && pieces_.pieces[p].solid == pieces_.pieces[q].solid;
    }

    void judge_pair(std::uint32_t inner, std::uint32_t outer) {
        const Lie found = lie(inner, outer);
        if (found == Lie::Same) return report_same(inner, outer);
        if (found != Lie::Inside) return;
        if (same_solid(inner, outer) && !is_inner(outer)) {
            inside_of_[inner] = outer;
            return;
        }
        // A surface turned inside out within another one is a void where the file has no other way to say so.
        const bool looks_inward = shapes_[inner].outward == 0;
        if (pieces_.pieces[inner].solid == nothing && looks_inward) {
            is_void_[inner] = true;
            return;
        }
        // What lies in a void of a solid is not in the solid.
        if (is_inner(outer) && !same_solid(inner, outer)) return;
        report_within(inner, outer);
    }

    void report_same(std::uint32_t p, std::uint32_t q) {
        blamed_[std::max(p, q)] = true;
        Finding finding = finding_at("G5", Severity::Error, pieces_.pieces[std::max(p, q)].first_face);
        finding.sentence = capital(title(std::min(p, q))) + " and " + title(std::max(p, q)) + " are the same.";
        finding.hint = "Leave one of them out.";
        report_.add(std::move(finding), "surfaces that are there twice");
    }

    void report_within(std::uint32_t inner, std::uint32_t outer) {
        Finding finding = finding_at("G5", Severity::Error, pieces_.pieces[inner].first_face);
        finding.sentence = capital(title(inner)) + " lies within " + title(outer) + ": both fill the same space.";
        finding.hint = "Leave one of them out, or turn the inner one inside out where it is a void.";
        report_.add(std::move(finding), "surfaces that lie within another");
    }

    /// Each inner shell lies in the outer shell of its solid.
    void check_voids() {
        for (std::uint32_t p = 0; p < blamed_.size(); ++p) {
            if (!is_inner(p) || blamed_[p]) continue;
            const std::uint32_t outer = outer_of(p);
            if (outer == nothing || blamed_[outer] || cross(p, outer) || inside_of_[p] != nothing) continue;
            if (box_within(p, outer) && lie(p, outer) != Lie::Apart) continue;
            Finding finding = finding_at("G5", Severity::Error, pieces_.pieces[p].first_face);
            finding.sentence = capital(title(p)) + " does not lie inside the outer shell of its solid.";
            finding.hint = "Make it a solid of its own, or move it into the outer shell.";
            blamed_[p] = true;
            report_.add(std::move(finding), "voids outside of their solid");
        }
    }

    [[nodiscard]] std::uint32_t outer_of(std::uint32_t p) const {
        for (std::uint32_t q = p; q-- > 0 && same_solid(p, q);)
            if (!is_inner(q)) return q;
        return nothing;
    }

    void check_inside_out(std::uint32_t p) {
        const bool all_wrong = is_inner(p) ? shapes_[p].inward == 0 : shapes_[p].outward == 0;
        if (blamed_[p] || is_void_[p] || !all_wrong) return;
        Finding finding = finding_at("G5", Severity::Warning, pieces_.pieces[p].first_face);
        finding.sentence = capital(title(p)) + (is_inner(p) ? " is a void, but its faces look into the solid."
                                                            : " is turned inside out: all its faces look inward.");
        finding.hint = "Reverse the order of corners of all its faces.";
        report_.add(std::move(finding), "surfaces turned inside out");
    }

    void report_budget() {
        Finding finding{.code = "G5", .severity = Severity::Note};
        finding.sentence = "Not every pair of surfaces was looked at for lying within each other: there are too many.";
        finding.hint = "Check the parts of the mesh one by one.";
        report_.add(std::move(finding), "ended searches");
    }

    const MeshTriangles& triangles_;
    const MeshPieces& pieces_;
    const std::vector<std::uint32_t>& place_;
    const Crossings& crossings_;
    MeshReport& report_;
    PieceShapes shapes_;
    std::vector<bool> blamed_;   ///< [piece]
    std::vector<bool> is_void_;  ///< [piece]
    std::vector<std::uint32_t> inside_of_;
    std::uint64_t spent_ = 0;
    bool budget_spent_ = false;
};

}  // namespace

void check_solids(const MeshTriangles& triangles, const MeshPieces& pieces, const std::vector<std::uint32_t>& place,
                  const Crossings& crossings, MeshReport& report) {
    report.applied({"G5"});
    SolidChecker(triangles, pieces, place, crossings, report).run();
}

}  // namespace enfilade::modeler
