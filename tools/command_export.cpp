#include <array>
#include <nlohmann/json.hpp>
#include <optional>

#include "accel/scene_file.h"
#include "base/error.h"
#include "modeler/exports/city_json.h"
#include "modeler/exports/dot.h"
#include "modeler/exports/gltf.h"
#include "modeler/exports/graphml.h"
#include "modeler/exports/hbjson.h"
#include "modeler/exports/indoor_gml.h"
#include "modeler/exports/obj.h"
#include "modeler/model_group.h"
#include "tools/commands.h"
#include "tools/exit_code.h"
#include "tools/output_file.h"
#include "tools/progress.h"

namespace enfilade::tools {

namespace {

using Files = std::vector<std::filesystem::path>;

struct Request {
    const accel::Scene& scene;
    const ExportOptions& options;

    [[nodiscard]] const std::filesystem::path& output() const { return options.output; }
    /// The model, as semantic formats need it. Throws InputError for a stripped scene.
    [[nodiscard]] modeler::Building building() const { return modeler::read_model(scene); }
};

Files write_glb(const Request& request) {
    const modeler::Fittings fittings =
        request.scene.has_model() ? modeler::fittings(request.building()) : modeler::Fittings{};
    write_text(request.output(), modeler::to_glb(request.scene.view(), fittings));
    return {request.output()};
}

Files write_obj(const Request& request) {
    const std::filesystem::path materials = std::filesystem::path(request.output()).replace_extension(".mtl");
    const modeler::ObjText text = modeler::to_obj(request.scene.view(), materials.filename().string());
    write_text(materials, text.mtl);
    write_text(request.output(), text.obj);
    return {request.output(), materials};
}

Files write_graphml(const Request& request) {
    write_text(request.output(), modeler::to_graphml(request.scene.view()));
    return {request.output()};
}

Files write_dot(const Request& request) {
    const bool cells = request.options.level == "cells";
    const modeler::GraphLevel level = cells ? modeler::GraphLevel::Cells : modeler::GraphLevel::Spaces;
    write_text(request.output(), modeler::to_dot(request.scene.view(), level));
    return {request.output()};
}

template <std::string (*write)(const modeler::Building&)>
Files write_model(const Request& request) {
    write_text(request.output(), write(request.building()));
    return {request.output()};
}

std::string indoor_gml(const modeler::Building& building) { return modeler::to_indoorgml(building); }

struct Format {
    const char* ending;
    const char* sentence;
    Files (*write)(const Request&);
};

constexpr std::array formats = {
    Format{".glb", "glTF 2.0: faces with materials, lamps and furniture, for 3D programs", write_glb},
    Format{".obj", "Wavefront OBJ and MTL: faces with materials, no furniture, for 3D programs", write_obj},
    Format{".gml", "IndoorGML 1.1: rooms, doors and how they are joined, for navigation", write_model<indoor_gml>},
    Format{".city.json", "CityJSON 2.0: storeys, rooms, walls and slabs as solids, for maps of cities",
           write_model<modeler::to_cityjson>},
    Format{".hbjson", "Honeybee: rooms with their adjacent faces and windows, for energy models",
           write_model<modeler::to_hbjson>},
    Format{".graphml", "the graph of rooms and the graph of cells, for programs that walk graphs", write_graphml},
    Format{".dot", "the same for Graphviz, one of them: --level", write_dot},
};

/// The format that the output's name asks for. Throws InputError.
const Format& format_of(const std::filesystem::path& output) {
    const std::string name = output.filename().string();
    std::string known;
    for (std::size_t k = 0; k < formats.size(); ++k) {
        if (name.ends_with(formats[k].ending)) return formats[k];
        known += (k == 0 ? "" : k + 1 == formats.size() ? " or " : ", ") + std::string(formats[k].ending);
    }
    throw InputError("F105", output.string(), "Scenes are exported as " + known + ": end the name so.");
}

}  // namespace

std::string export_list() {
    std::string text;
    for (const Format& format : formats)
        text += "\n  " + std::string(format.ending) + std::string(12 - std::string_view(format.ending).size(), ' ') +
                format.sentence;
    return text;
}

int run_export(const ExportOptions& options, const Console& console) {
    const Format& format = format_of(options.output);
    Files written;
    {
        Progress progress(console, {"Reading the scene", "Writing"});
        const accel::Scene scene = accel::open(options.scene);
        progress.next();
        written = format.write({scene, options});
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
