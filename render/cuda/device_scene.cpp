#include "render/cuda/device_scene.h"

namespace enfilade::render::cuda {

DeviceArrays::~DeviceArrays() {
    for (void* memory : memory_) device_->release(memory);
}

const void* DeviceArrays::copy_bytes(const void* values, std::size_t bytes) {
    if (bytes == 0) return nullptr;
    memory_.push_back(nullptr);  // so that nothing is lost where there is no memory for its number
    memory_.back() = device_->allocate(bytes);
    device_->upload(memory_.back(), values, bytes);
    bytes_ += bytes;
    return memory_.back();
}

accel::SceneView copy_scene(const accel::SceneView& scene, DeviceArrays& arrays) {
    accel::SceneView copy = scene;
    const auto move = [&](auto&... array) { ((array = arrays.copy(array)), ...); };
    move(copy.cells, copy.cell_portals, copy.section_x, copy.section_y, copy.section_tails, copy.side_faces,
         copy.side_face_portals, copy.portals, copy.tints, copy.source_faces, copy.materials);
    move(copy.meshes, copy.mesh_vertices, copy.mesh_triangles, copy.objects, copy.cell_object_offsets,
         copy.cell_objects);
    move(copy.locator_nodes, copy.locator_cells);  // dollhouses ask where rays fall through the cut
    move(copy.lights, copy.material_looks, copy.textures, copy.texels, copy.mesh_texcoords, copy.face_frames);
    // What no ray reads stays where it is, and is not to be had there.
    copy.vertices = {};
    copy.spaces = {};
    copy.text_offsets = {};
    copy.text = {};
    return copy;
}

accel::LightTreesView copy_trees(const accel::LightTreesView& trees, DeviceArrays& arrays) {
    return {arrays.copy(trees.cell_offsets), arrays.copy(trees.cell_lights), arrays.copy(trees.beams),
            arrays.copy(trees.planes),       arrays.copy(trees.tints),       arrays.copy(trees.beam_object_lists),
            arrays.copy(trees.beam_objects)};
}

}  // namespace enfilade::render::cuda
