#include "render/cuda/packed_sections.h"

namespace enfilade::render::cuda {
namespace {

PackedStack packed_stack(const accel::SceneView& scene, std::size_t section) {
    const std::uint32_t first = scene.section_tails[section].first_face;
    const std::uint32_t count = scene.section_tails[section + 1].first_face - first;
    const accel::SideFace& lowest = scene.side_faces[first];
    const std::uint32_t few = count < 2 ? 1u : count == 2 ? 2u : 3u;
    const std::uint32_t above = few == 2 ? scene.side_faces[first + 1].target.bits : count;
    return {lowest.z_top, lowest.target, above, first | few << 30};
}

}  // namespace

PackedArrays::PackedArrays(const accel::SceneView& scene) {
    if (scene.side_faces.size() >= std::size_t{1} << 30)
        throw CudaError("This scene has more than a thousand million side faces; packed sections number no more.");
    cells.reserve(scene.cells.size());
    for (std::size_t i = 0; i < scene.cells.size(); ++i) {
        const accel::Cell& c = scene.cells[i];
        PackedCell cell = {c.first_section, c.section_count, c.z_floor, c.z_ceiling, c.floor, c.ceiling, 0, 0};
        if (!scene.cell_object_offsets.empty()) {
            cell.first_object = scene.cell_object_offsets[i];
            cell.past_object = scene.cell_object_offsets[i + 1];
        }
        cells.push_back(cell);
    }
    const std::size_t sections = scene.cells.empty() ? 0 : scene.section_count();
    lines.reserve(sections + 2);
    stacks.reserve(sections);
    for (std::size_t i = 0; i < sections; ++i) {
        lines.push_back({scene.section_x[i], scene.section_y[i]});
        stacks.push_back(packed_stack(scene, i));
    }
    lines.resize(sections + 2);
}

}  // namespace enfilade::render::cuda
