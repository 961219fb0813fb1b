#include <nlohmann/json.hpp>

#include "accel/scene_file.h"
#include "base/error.h"
#include "modeler/exports/gltf.h"
#include "modeler/exports/graphml.h"
#include "modeler/exports/obj.h"
#include "tools/commands.h"
#include "tools/exit_code.h"
#include "tools/output_file.h"
#include "tools/progress.h"

namespace enfilade::tools {

namespace {

/// Writes `scene` as the extension of `output` says; returns the files written.
std::vector<std::filesystem::path> write_export(const accel::SceneView& scene, const std::filesystem::path& output) {
    const std::string extension = output.extension().string();
    if (extension == ".glb") {
        write_text(output, modeler::to_glb(scene));
        return {output};
    }
    if (extension == ".graphml") {
        write_text(output, modeler::to_graphml(scene));
        return {output};
    }
    const std::filesystem::path materials = std::filesystem::path(output).replace_extension(".mtl");
    const modeler::ObjText text = modeler::to_obj(scene, materials.filename().string());
    write_text(materials, text.mtl);
    write_text(output, text.obj);
    return {output, materials};
}

}  // namespace

int run_export(const ExportOptions& options, const Console& console) {
    const std::string extension = options.output.extension().string();
    if (extension != ".glb" && extension != ".obj" && extension != ".graphml")
        throw InputError("F105", options.output.string(),
                         "Scenes are exported as .glb, .obj or .graphml: end the name so.");
    std::vector<std::filesystem::path> written;
    {
        Progress progress(console, {"Reading the scene", "Writing"});
        const accel::Scene scene = accel::open(options.scene);
        progress.next();
        written = write_export(scene.view(), options.output);
    }
    nlohmann::ordered_json json = {
        {"command", "export"}, {"input", options.scene.string()}, {"output", nlohmann::ordered_json::array()}};
    for (const std::filesystem::path& file : written) {
        const auto bytes = std::filesystem::file_size(file);
        json["output"].push_back({{"file", file.string()}, {"bytes", bytes}});
        console.say(file.string() + ": " + byte_text(double(bytes)) + '.');
    }
    if (console.json()) console.print(json.dump(2) + '\n');
    return exit_ok;
}

}  // namespace enfilade::tools
