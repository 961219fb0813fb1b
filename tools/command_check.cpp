#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "accel/scene_file.h"
#include "base/error.h"
#include "modeler/certify.h"
#include "modeler/meshes/mesh.h"
#include "plans/read.h"
#include "tools/check_report.h"
#include "tools/commands.h"
#include "tools/exit_code.h"
#include "tools/model.h"

namespace enfilade::tools {

namespace {

/// What a file is, by its first bytes, then by its extension: a scene with another name is one all the same.
enum class InputKind { Plan, Scene, Mesh };

InputKind kind_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string start(4096, '\0');
    stream.read(start.data(), std::streamsize(start.size()));
    start.resize(std::size_t(stream.gcount()));
    const std::string extension = file.extension().string();
    if (extension == ".enf" || start.starts_with("ENFILADE")) return InputKind::Scene;
    for (const char* mesh : {".obj", ".off", ".ply", ".stl"})
        if (extension == mesh) return InputKind::Mesh;
    const bool is_city = start.find("\"CityJSON\"") != std::string::npos || file.string().ends_with(".city.json");
    return is_city ? InputKind::Mesh : InputKind::Plan;
}

/// What there is to report on, and to draw.
struct Checked {
    std::string certificate;  ///< of scenes
    modeler::CheckReport report;
    std::optional<modeler::Building> building;  ///< of plans and whole scenes
};

Checked check_scene(const CheckOptions& options, const Console& console) {
    Progress progress(console, {"Reading the scene", "Checking"});
    const accel::Scene scene = accel::open(options.input, {.verify_hashes = true});
    progress.next();
    modeler::Certification certification = modeler::certify(scene);
    Checked checked{certification.verdict, {}, std::move(certification.building)};
    // A stripped scene has no map: what reading it validated is all there is.
    if (certification.report) checked.report = std::move(*certification.report);
    return checked;
}

Checked check_mesh(const CheckOptions& options, const Console& console) {
    Progress progress(console, {"Reading the mesh", "Checking"});
    modeler::MeshOptions mesh_options;
    if (options.weld) mesh_options.weld = *options.weld;
    if (options.planar_distance) mesh_options.planar_distance = *options.planar_distance;
    if (options.planar_angle_deg) mesh_options.planar_angle_deg = *options.planar_angle_deg;
    const modeler::Mesh mesh = modeler::read_mesh(options.input, mesh_options);
    progress.next();
    return {"", modeler::check_mesh(mesh, mesh_options), std::nullopt};
}

Checked check_plan(const CheckOptions& options, const Console& console) {
    std::vector<std::string> steps = {"Reading the plan"};
    steps.insert(steps.end(), model_steps.begin(), model_steps.end());
    Progress progress(console, std::move(steps));
    const plans::Plan plan = plans::read(options.input, options.read.options);
    progress.next();
    Modelled modelled = model(plan, options.model, progress);
    return {"", std::move(modelled.report), std::move(modelled.building)};
}

Checked checked_input(const CheckOptions& options, const Console& console) {
    switch (kind_of(options.input)) {
        case InputKind::Scene: return check_scene(options, console);
        case InputKind::Mesh: return check_mesh(options, console);
        case InputKind::Plan: break;
    }
    return check_plan(options, console);
}

}  // namespace

int run_check(const CheckOptions& options, const Console& console) {
    if (options.read.list_layers) return list_layers(options.input, console);
    need_report_name(options.report);
    const Checked checked = checked_input(options, console);
    const ReportSubject subject{options.input.string(), checked.certificate};
    if (!options.report.empty())
        write_report(options.report, subject, checked.report, checked.building ? &*checked.building : nullptr);
    if (console.json()) console.print(dump(report_json(subject, checked.report)));
    else console.say(report_text(subject, checked.report));
    return has_defects(checked.report, options.strict) ? exit_defects : exit_ok;
}

}  // namespace enfilade::tools
