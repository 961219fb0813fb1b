#include "tools/counting_walk.h"

#include "render/walk.h"

namespace enfilade::tools {

using namespace render;

namespace {
std::uint32_t first_face(const accel::SceneView& scene, std::uint32_t section) {
    return scene.section_tails[section].first_face;
}
}  // namespace

WalkCount counted_walk(const accel::SceneView& scene, const RayQuery& query, std::span<const std::uint32_t> parents) {
    WalkCount count;
    Ray<float> ray;
    if (!make_ray(vec_cast<float>(query.origin), vec_cast<float>(query.direction), ray)) return count;
    NoEvents events;
    WalkEnd<float> end = {};
    std::uint32_t entry = no_section, entry_next = no_section;
    auto cell = static_cast<std::uint32_t>(query.cell);
    for (std::size_t steps = 2 * scene.cells.size() + 16; steps > 0; --steps) {
        const accel::Cell& visited = scene.cells[cell];
        leave_cell(scene, ray, cell, entry, entry_next, true, NoLimit{}, events, end);
        ++count.visits;
        count.sections += visited.section_count;
        count.eights += (visited.section_count + 7u) / 8;
        count.faces +=
            first_face(scene, visited.first_section + visited.section_count) - first_face(scene, visited.first_section);
        if (end.exit == Exit::Side) count.tested += end.face - first_face(scene, end.section) + 1;
        else if (end.exit == Exit::Ceiling && end.section != no_section)
            count.tested += first_face(scene, end.section + 1) - first_face(scene, end.section);
        if (count.visits == 1) count.wholes = 1;
        if (!end.target.is_portal()) return count;
        const auto next = static_cast<std::uint32_t>(end.target.neighbour());
        if (parents.empty() || parents[cell] != parents[next]) ++count.wholes;
        entry = end.exit == Exit::Side ? end.section : no_section;
        entry_next = end.next_section;
        cell = next;
    }
    return count;
}

std::size_t narrow_walks(const accel::SceneView& scene, std::span<const RayQuery> rays) {
    static_assert(!ENFILADE_WIDE_SIDES, "this file is compiled for every machine");
    std::size_t hits = 0;
    NoEvents events;
    for (const RayQuery& query : rays) {
        Ray<float> ray;
        if (!make_ray(vec_cast<float>(query.origin), vec_cast<float>(query.direction), ray)) continue;
        Vec3f throughput = {1, 1, 1};
        const WalkEnd<float> end =
            walk(scene, ray, static_cast<std::uint32_t>(query.cell), NoLimit{}, throughput, events);
        hits += end.status == WalkStatus::Hit && parameter(scene, ray, end) >= 0 ? 1 : 0;
    }
    return hits;
}

}  // namespace enfilade::tools
