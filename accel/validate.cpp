#include "accel/validate.h"

#include <cmath>
#include <optional>
#include <utility>

#include "accel/defect_report.h"

namespace enfilade::accel {
namespace {

using detail::is_finite;

std::string at(const char* array, std::size_t i) { return detail::element(array, i); }

class Validator {
public:
    Validator(const SceneView& view, const Executor& executor) : view_(view), executor_(executor) {}

    std::vector<Defect> run() {
        check_sizes();
        if (!report_.empty()) return report_.take();
        check_tables();
        check_section_arrays();
        check_source_faces();
        check_locator();
        check_cell_ranges();
        detail::validate_objects(view_, executor_, report_);
        detail::validate_lights(view_, executor_, report_);
        if (report_.empty()) detail::validate_looks(view_, executor_, report_);
        if (!report_.empty()) return report_.take();  // what follows relies on the ranges
        check_cells();
        if (report_.empty()) check_portals_seen();
        return report_.take();
    }

private:
    void check_sizes() {
        const auto need = [&](bool holds, const char* sentence) {
            if (!holds) report_.add(0, "F3", sentence);
        };
        const SceneView& v = view_;
        need(!v.cells.empty() && v.cells.size() <= Target::index_mask, "the array cells is missing or too long");
        need(v.cell_portals.size() == v.cells.size(), "the array cell_portals has not one entry a cell");
        need(v.section_x.size() >= 4 && v.section_x.size() < UINT32_MAX, "the array section_x is missing or too long");
        need(v.section_y.size() == v.section_x.size(), "the array section_y has not the length of section_x");
        need(v.section_tails.size() == v.section_x.size(), "the array section_tails has not the length of section_x");
        need(!v.side_faces.empty() && v.side_faces.size() < UINT32_MAX, "the array side_faces is missing or too long");
        need(v.side_face_portals.size() == v.side_faces.size(), "the array side_face_ports has not one entry a face");
        need(v.portals.size() < UINT32_MAX, "the array portals is too long");
        need(!v.source_faces.empty() && v.source_faces.size() <= Target::index_mask,
             "the array source_faces is missing or too long");
        need(v.vertices.size() < UINT32_MAX, "the array vertices is too long");
        need(!v.text_offsets.empty() && v.text_offsets.size() < UINT32_MAX, "the array text_offsets is missing");
        need(!v.locator_nodes.empty() && v.locator_nodes.size() < UINT32_MAX, "the array locator_nodes is missing");
        need(v.locator_cells.size() < UINT32_MAX >> 3, "the array locator_cells is too long");
    }

    template <class IsSound, class Describe>
    void check_each(std::size_t count, const IsSound& is_sound, const Describe& describe) {
        detail::check_each(executor_, count, is_sound, describe);
    }

    [[nodiscard]] bool is_text(TextId id) const { return index(id) + 1 < view_.text_offsets.size(); }

    void check_tables() {
        const SceneView& v = view_;
        check_each(
            v.text_offsets.size(),
            [&](std::size_t i) {
                const std::uint64_t next =
                    i + 1 < v.text_offsets.size() ? v.text_offsets[i + 1] : std::uint64_t{v.text.size()};
                return i + 1 < v.text_offsets.size() ? v.text_offsets[i] <= next : v.text_offsets[i] == next;
            },
            [&](std::size_t i) { report_.add(i, "F4", at("text_offsets", i) + " is not in order"); });
        check_each(
            v.materials.size(),
            [&](std::size_t i) {
                const auto& c = v.materials[i].colour;
                return is_text(v.materials[i].name) && is_finite(c[0]) && is_finite(c[1]) && is_finite(c[2]);
            },
            [&](std::size_t i) { report_.add(i, "F5", at("materials", i) + " has no name or no colour"); });
        check_each(
            v.spaces.size(),
            [&](std::size_t i) {
                const Space& s = v.spaces[i];
                return is_text(s.id) && is_text(s.name) && is_text(s.storey) && std::isfinite(s.area_m2) &&
                       static_cast<int>(s.label) < label_count;
            },
            [&](std::size_t i) { report_.add(i, "F4", at("spaces", i) + " has an index out of range"); });
        check_each(
            v.tints.size(),
            [&](std::size_t i) {
                return is_finite(v.tints[i].x) && is_finite(v.tints[i].y) && is_finite(v.tints[i].z);
            },
            [&](std::size_t i) { report_.add(i, "F5", at("tints", i) + " is not finite"); });
        check_each(
            v.portals.size(),
            [&](std::size_t i) {
                const Portal& p = v.portals[i];
                return p.front < p.back && index(p.back) < v.cells.size() && (p.kind_and_tint & 3u) < 3u &&
                       (p.kind() == PortalKind::Glass ? p.tint() < v.tints.size() : p.tint() == 0);
            },
            [&](std::size_t i) {
                report_.add(i, "F4", at("portals", i) + " does not name two cells in ascending order and a tint");
            });
    }

    void check_section_arrays() {
        const SceneView& v = view_;
        const auto limit = static_cast<float>(v.unit * (1 << 24));
        const std::size_t count = v.section_count();
        check_each(
            count,
            [&](std::size_t i) { return std::abs(v.section_x[i]) <= limit && std::abs(v.section_y[i]) <= limit; },
            [&](std::size_t i) { report_.add(i, "F5", at("section_x/y", i) + " lies beyond 2^24 grid units"); });
        check_each(
            count, [&](std::size_t i) { return v.section_tails[i].first_face < v.section_tails[i + 1].first_face; },
            [&](std::size_t i) { report_.add(i, "F4", at("section_tails", i) + " has no side face"); });
        if (v.section_tails[0].first_face != 0 || v.section_tails[count].first_face != v.side_faces.size())
            report_.add(0, "F4", "the sections do not share out the array side_faces");
    }

    void check_source_faces() {
        const SceneView& v = view_;
        const std::size_t count = v.source_face_count();
        check_each(
            count,
            [&](std::size_t i) {
                const SourceFace& f = v.source_faces[i];
                const std::uint32_t next = v.source_faces[i + 1].first_vertex;
                return f.first_vertex < next && next - f.first_vertex >= 3 &&
                       static_cast<int>(f.surface) < surface_count && index(f.space) < v.spaces.size() &&
                       index(f.material) < v.materials.size();
            },
            [&](std::size_t i) { report_.add(i, "F4", at("source_faces", i) + " has an index out of range"); });
        if (v.source_faces[0].first_vertex != 0 || v.source_faces[count].first_vertex != v.vertices.size())
            report_.add(0, "F4", "the source faces do not share out the array vertices");
        const auto limit = static_cast<float>(v.unit * (1 << 24));
        check_each(
            v.vertices.size(),
            [&](std::size_t i) {
                const Vertex& p = v.vertices[i];
                return std::abs(p.x) <= limit && std::abs(p.y) <= limit && std::abs(p.z) <= limit;
            },
            [&](std::size_t i) { report_.add(i, "F5", at("vertices", i) + " lies beyond 2^24 grid units"); });
    }

    void check_locator() {
        const SceneView& v = view_;
        check_each(
            v.locator_nodes.size(),
            [&](std::size_t i) {
                const LocatorNode& n = v.locator_nodes[i];
                bool sound = n.skip > i && n.skip <= v.locator_nodes.size() &&
                             (n.first_and_count >> 3) + (n.first_and_count & 7u) <= v.locator_cells.size();
                for (int k = 0; k < 3; ++k) sound = sound && is_finite(n.low[k]) && is_finite(n.high[k]);
                return sound;
            },
            [&](std::size_t i) { report_.add(i, "F4", at("locator_nodes", i) + " has an index out of range"); });
        check_each(
            v.locator_cells.size(), [&](std::size_t i) { return index(v.locator_cells[i]) < v.cells.size(); },
            [&](std::size_t i) { report_.add(i, "F4", at("locator_cells", i) + " is no cell"); });
    }

    void check_cell_ranges() {
        const SceneView& v = view_;
        check_each(
            v.cells.size(),
            [&](std::size_t i) {
                const Cell& c = v.cells[i];
                const std::uint64_t next =
                    i + 1 < v.cells.size() ? v.cells[i + 1].first_section : std::uint64_t{v.section_count()};
                return c.section_count >= 3 && std::uint64_t{c.first_section} + c.section_count == next &&
                       index(c.space) < v.spaces.size() && static_cast<int>(c.label) < label_count;
            },
            [&](std::size_t i) { report_.add(i, "F4", at("cells", i) + " has an index out of range"); });
        if (v.cells[0].first_section != 0) report_.add(0, "F4", "the first cell does not begin with the first section");
    }

    /// Whether a face of cell c leads to where it says, through the portal that it says; marks that side of the portal.
    bool is_sound_target(std::size_t c, Target target, PortalId portal) {
        if (!target.is_portal()) return portal == none<PortalId> && target.bits < view_.source_face_count();
        if (index(portal) >= view_.portals.size()) return false;
        const Portal& p = view_.portals[index(portal)];
        if (static_cast<std::uint32_t>(p.kind()) + 1 != static_cast<std::uint32_t>(target.kind())) return false;
        const bool from_front = index(p.front) == c;
        if (!from_front && index(p.back) != c) return false;
        if (target.neighbour() != (from_front ? p.back : p.front)) return false;
        // Only the thread that has cell c writes this byte.
        char& seen = (from_front ? seen_from_front_ : seen_from_back_)[index(portal)];
        return std::exchange(seen, char{1}) == 0;
    }

    std::optional<std::string> defect_of_section(std::size_t c, std::size_t s) {
        const SceneView& v = view_;
        const Cell& cell = v.cells[c];
        float below = cell.z_floor;
        for (std::size_t f = v.section_tails[s].first_face; f < v.section_tails[s + 1].first_face; ++f) {
            const SideFace& face = v.side_faces[f];
            if (!(face.z_top > below)) return at("side_faces", f) + " does not lie above the one below it";
            below = face.z_top;
            if (!is_sound_target(c, face.target, v.side_face_portals[f]))
                return at("side_faces", f) + " of cell " + std::to_string(c) + " leads nowhere";
        }
        if (below != cell.z_ceiling) return at("section_tails", s) + " has a stack that does not end at the ceiling";
        return std::nullopt;
    }

    std::optional<std::string> defect_of_cell(std::size_t c) {
        const Cell& cell = view_.cells[c];
        if (!(cell.z_floor < cell.z_ceiling) || !is_finite(cell.z_floor) || !is_finite(cell.z_ceiling))
            return at("cells", c) + " has no height";
        if (!is_sound_target(c, cell.floor, view_.cell_portals[c].floor))
            return "the floor of " + at("cells", c) + " leads nowhere";
        if (!is_sound_target(c, cell.ceiling, view_.cell_portals[c].ceiling))
            return "the ceiling of " + at("cells", c) + " leads nowhere";
        const std::size_t begin = cell.first_section;
        const std::size_t end = begin + cell.section_count;
        for (std::size_t s = begin; s < end; ++s)
            if (auto defect = defect_of_section(c, s)) return defect;
        return std::nullopt;
    }

    void check_cells() {
        seen_from_front_.assign(view_.portals.size(), 0);
        seen_from_back_.assign(view_.portals.size(), 0);
        parallel_for(executor_, view_.cells.size(), detail::validate_grain / 4,
                     [&](std::size_t begin, std::size_t end) {
                         for (std::size_t c = begin; c < end; ++c)
                             if (auto defect = defect_of_cell(c)) return report_.add(c, "F6", std::move(*defect));
                     });
    }

    void check_portals_seen() {
        check_each(
            view_.portals.size(), [&](std::size_t i) { return (seen_from_front_[i] & seen_from_back_[i]) != 0; },
            [&](std::size_t i) { report_.add(i, "F6", at("portals", i) + " is not seen from both of its cells"); });
    }

    const SceneView& view_;
    const Executor& executor_;
    detail::DefectReport report_;
    std::vector<char> seen_from_front_, seen_from_back_;
};

}  // namespace

std::vector<Defect> validate(const SceneView& view, const Executor& executor) {
    return Validator(view, executor).run();
}

std::vector<Defect> validate(const SceneView& view) { return validate(view, ThreadExecutor()); }

}  // namespace enfilade::accel
