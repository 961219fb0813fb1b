#include "accel/stats.h"

#include <algorithm>

namespace enfilade::accel {

double SceneStats::bytes_per_cell() const {
    return cells == 0 ? 0 : static_cast<double>(cell_bytes + locator_bytes) / static_cast<double>(cells);
}

double SceneStats::cells_per_room() const {
    return rooms == 0 ? 0 : static_cast<double>(room_cells) / static_cast<double>(rooms);
}

SceneStats stats(const Scene& scene) {
    const SceneView& view = scene.view();
    SceneStats s;
    s.cells = view.cells.size();
    s.sections = view.section_count();
    s.side_faces = view.side_faces.size();
    s.portals = view.portals.size();
    s.source_faces = view.source_face_count();
    s.spaces = view.spaces.size();
    for (const Space& space : view.spaces) s.rooms += space.label == Label::Room;
    if (!view.locator_nodes.empty()) {  // the first box holds all others
        s.low = view.locator_nodes[0].low;
        s.high = view.locator_nodes[0].high;
    }
    for (const Cell& cell : view.cells) {
        ++s.cells_of_label[static_cast<std::size_t>(cell.label)];
        s.room_cells += view.spaces[index(cell.space)].label == Label::Room;
        s.max_sections = std::max<std::uint64_t>(s.max_sections, cell.section_count);
    }
    for (const Portal& portal : view.portals) ++s.portals_of_kind[static_cast<std::size_t>(portal.kind())];
    const auto bytes = [](const auto& array) { return array.size() * sizeof(array[0]); };
    s.cell_bytes = bytes(view.cells) + bytes(view.cell_portals) + bytes(view.section_x) + bytes(view.section_y) +
                   bytes(view.section_tails) + bytes(view.side_faces) + bytes(view.side_face_portals) +
                   bytes(view.portals) + bytes(view.tints);
    s.locator_bytes = bytes(view.locator_nodes) + bytes(view.locator_cells);
    s.objects = view.objects.size();
    s.meshes = view.meshes.size();
    s.unique_triangles = view.mesh_triangles.size();
    for (const PlacedObject& object : view.objects)
        s.instanced_triangles += view.meshes[index(object.mesh)].triangle_count;
    s.listed_objects = view.cell_objects.size();
    s.object_bytes = bytes(view.objects) + bytes(view.cell_object_offsets) + bytes(view.cell_objects);
    s.mesh_bytes = bytes(view.meshes) + bytes(view.mesh_vertices) + bytes(view.mesh_triangles);
    s.textures = view.textures.size();
    s.texture_bytes = bytes(view.material_looks) + bytes(view.textures) + bytes(view.texels) +
                      bytes(view.mesh_texcoords) + bytes(view.face_frames);
    for (const SceneArray& array : scene.arrays()) {
        if (array.group == Group::Trace) s.trace_bytes += array.bytes.size();
        if (array.group == Group::Model) s.model_bytes += array.bytes.size();
    }
    return s;
}

}  // namespace enfilade::accel
