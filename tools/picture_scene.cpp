#include "tools/picture_scene.h"

#include <array>
#include <fstream>

#include "accel/scene_file.h"
#include "base/error.h"

namespace enfilade::tools {

std::optional<modeler::UpAxis> up_axis(const RenderOptions& options) {
    if (options.up.empty()) return std::nullopt;
    return options.up == "y" ? modeler::UpAxis::Y : modeler::UpAxis::Z;
}

void check_mesh_flags(const RenderOptions& options, const TracerChoice& choice) {
    const bool is_mesh = is_mesh_file(options.scene);
    if (!is_mesh && !options.up.empty())
        throw InputError("F148", "", "--up says how a mesh stands, and this is none: leave it out.");
    if (is_mesh && choice.is_oracle)
        throw InputError("F148", "", "The oracle sees no objects, so it shows no mesh: choose another --tracer.");
    if (is_mesh && !options.room.empty())
        throw InputError("F148", "",
                         "A mesh by itself has no rooms: give --camera exterior, aerial or X,Y,Z:X,Y,Z instead of "
                         "--room.");
    if (is_mesh && options.camera.starts_with("dollhouse"))
        throw InputError("F148", "",
                         "A mesh by itself has no storey to cut open: give --camera exterior, aerial or X,Y,Z:X,Y,Z.");
    if (is_mesh && options.no_objects)
        throw InputError("F148", "", "A picture of a mesh shows nothing but that: leave out --no-objects.");
    if (is_mesh && options.mirror_floor)
        throw InputError("F148", "", "A mesh by itself stands on no floor that mirrors: leave out --mirror-floor.");
}

accel::Scene opened_scene(const std::filesystem::path& file) {
    try {
        return accel::open(file);
    } catch (const InputError& error) {
        std::array<char, 8> begin = {};
        std::ifstream(file, std::ios::binary).read(begin.data(), begin.size());
        if (error.code != "F1" || file.extension() == ".enf" || std::string_view(begin.data(), 8) == "ENFILADE") throw;
    }
    const std::string ending = file.extension().string();
    if (ending == ".gz" || ending == ".zip" || ending == ".xz" || ending == ".bz2")
        throw InputError("F148", file.string(), "The file is compressed: unpack it first, and give what was in it.");
    throw InputError("F148", file.string(),
                     "This is neither a scene (.enf, as \"enfilade build\" makes them) nor a mesh by its ending: .obj, "
                     ".gltf, .glb, .ply, .off and .stl are read.");
}

}  // namespace enfilade::tools
