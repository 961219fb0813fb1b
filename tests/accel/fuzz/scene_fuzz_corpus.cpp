// Writes the seeds of scene_fuzz into the folder named by the only argument.
#include <filesystem>

#include "accel/assemble.h"
#include "accel/scene_file.h"
#include "tests/support/synthetic_objects.h"
#include "tests/support/synthetic_scene.h"

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    const std::filesystem::path folder = argv[1];
    std::filesystem::create_directories(folder);
    using namespace enfilade;
    accel::write(accel::assemble(test::synthetic_corridor(2)), folder / "corridor.enf");
    accel::write(accel::assemble(test::synthetic_office({.rooms_per_row = 1, .rows = 1})), folder / "office.enf");
    accel::write(accel::assemble(test::with_objects(test::synthetic_corridor(2), 1, 3)), folder / "furnished.enf");
    return 0;
}
