// Writes the seeds of scene_fuzz into the folder named by the only argument.
#include <filesystem>

#include "accel/assemble.h"
#include "accel/scene_file.h"
#include "accel/texture_chain.h"
#include "tests/support/synthetic_objects.h"
#include "tests/support/synthetic_scene.h"

namespace {

/// With a texture on walls and on a mesh, a mirror and a glass.
enfilade::accel::SceneInput with_looks(enfilade::accel::SceneInput input) {
    using namespace enfilade::accel;
    const std::vector<std::array<std::uint8_t, 4>> pixels(15, {9, 99, 199, 250});
    input.textures.push_back(std::make_shared<const InputTexture>(texture_chain("t", 5, 3, pixels, 16)));
    input.materials.front().look.texture = 0;
    input.materials.back().look = {.mirror = 0.25f, .through = {0.5f, 0.25f, 0}, .texture = 0};
    auto mesh = std::make_shared<InputMesh>(*input.meshes.front());
    mesh->texcoords.assign(3 * mesh->triangles.size(), {0.5f, -2});
    input.meshes.front() = mesh;
    return input;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    const std::filesystem::path folder = argv[1];
    std::filesystem::create_directories(folder);
    using namespace enfilade;
    accel::write(accel::assemble(test::synthetic_corridor(2)), folder / "corridor.enf");
    accel::write(accel::assemble(test::synthetic_office({.rooms_per_row = 1, .rows = 1})), folder / "office.enf");
    accel::write(accel::assemble(test::with_objects(test::synthetic_corridor(2), 1, 3)), folder / "furnished.enf");
    accel::write(accel::assemble(with_looks(test::with_objects(test::synthetic_corridor(2), 1, 3))),
                 folder / "textured.enf");
    return 0;
}
