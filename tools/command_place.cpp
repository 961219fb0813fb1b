#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "accel/certificate.h"
#include "accel/scene_file.h"
#include "base/error.h"
#include "modeler/check.h"
#include "modeler/export_scene.h"
#include "modeler/lighting/moved_lamps.h"
#include "modeler/model_group.h"
#include "modeler/objects/put_objects.h"
#include "render/executor.h"
#include "tools/bench.h"
#include "tools/check_report.h"
#include "tools/commands.h"
#include "tools/exit_code.h"
#include "tools/findings_text.h"
#include "tools/object_edit.h"
#include "tools/output_file.h"
#include "tools/rebuild.h"

namespace enfilade::tools {

namespace {

using Json = nlohmann::ordered_json;
using modeler::FurnishedObject;

/// Above -180, up to 180, however often a piece was turned on its way.
double degrees(double radians) {
    const double turn = std::remainder(radians * 180 / std::numbers::pi, 360.0);
    const double told = std::round(turn * 100) / 100;  // neither -0.0 nor -180.0 is
    if (told == 0) return 0;
    return told == -180 ? 180 : turn;
}

Json object_json(const modeler::Building& building, const FurnishedObject& object) {
    const modeler::Space& space = building.spaces[object.space];
    Json json = {{"id", object.id}, {"name", object.name}, {"model", object.model}, {"space", space.id}};
    json["space_name"] = space.name;
    json["position"] = object.position;
    json["angle_deg"] = degrees(object.angle);
    json["size"] = object.size;
    json["triangles"] = building.furnishing.meshes[object.mesh]->triangles.size();
    json["by_rule"] = object.by_rule;
    json["stands_on"] = nullptr;
    if (!object.stands_on.empty()) json["stands_on"] = object.stands_on;
    return json;
}

int list(const PlaceOptions& options, const modeler::Building& building, const Console& console) {
    const std::vector<FurnishedObject>& objects = building.furnishing.objects;
    if (console.json()) {
        Json json = {{"command", "place"}, {"input", options.scene.string()}, {"objects", Json::array()}};
        for (const FurnishedObject& object : objects) json["objects"].push_back(object_json(building, object));
        console.print(dump(json));
        return exit_ok;
    }
    std::size_t width = 2;
    for (const FurnishedObject& object : objects) width = std::max(width, object.id.size());
    std::string text;
    for (const FurnishedObject& object : objects) {
        char place[96];
        std::snprintf(place, sizeof place, "  (%8.3f, %8.3f, %7.3f) %6.1f deg  ", object.position[0],
                      object.position[1], object.position[2], degrees(object.angle));
        const modeler::Space& space = building.spaces[object.space];
        text += object.id + std::string(width - object.id.size(), ' ') + place + object.model + " in " +
                (space.name.empty() ? space.id : space.name) + '\n';
    }
    console.print(text.empty() ? options.scene.string() + " holds no objects.\n" : text);
    return exit_ok;
}

std::size_t edit_count(const PlaceOptions& options) {
    return std::size_t(!options.move.empty()) + !options.turn.empty() + !options.add.empty() + !options.remove.empty();
}

void check_flags(const PlaceOptions& options) {
    const auto refuse = [](const std::string& sentence) { throw InputError("F117", "", sentence); };
    if (!options.move.empty() && options.at.empty()) refuse("--move needs --at X,Y: where to?");
    if (!options.add.empty() && options.at.empty()) refuse("--add needs --at X,Y: where does it stand?");
    if (!options.turn.empty() && !options.angle_deg) refuse("--turn needs --angle DEGREES: by how much?");
    if (options.move.empty() && options.add.empty() && !options.at.empty())
        refuse("--at says where --move and --add put something: give one of them.");
    if (options.add.empty() && !options.id.empty()) refuse("--id names what --add puts there: give that.");
    if (options.angle_deg && (options.move.empty() && options.turn.empty() && options.add.empty()))
        refuse("--angle is for --turn, --move and --add: give one of them.");
    if (options.angle_deg && !std::isfinite(*options.angle_deg)) refuse("--angle is no number of degrees.");
    if (edit_count(options) == 0 && !options.output.empty())
        refuse("Nothing changes, so nothing is written: leave out -o, or give --move, --turn, --add or --remove.");
}

EditedObjects edit(const PlaceOptions& options, const modeler::Building& building) {
    if (!options.remove.empty()) return removed(building, options.remove);
    if (!options.turn.empty()) return turned(building, options.turn, *options.angle_deg * std::numbers::pi / 180);
    const PlaceAt at = parse_place(options.at);
    std::optional<double> angle;
    if (options.angle_deg) angle = *options.angle_deg * std::numbers::pi / 180;
    if (!options.move.empty()) return moved(building, options.move, at, angle);
    return added(building, options.add, options.id, at, angle.value_or(0), options.catalogues);
}

Json result_json(const PlaceOptions& options, const EditedObjects& edited, const modeler::Building& building,
                 const modeler::CheckReport& report, bool written, double seconds) {
    Json json = {{"command", "place"}, {"input", options.scene.string()}, {"edit", edited.what}};
    json["output"] = nullptr;
    if (written) json["output"] = (options.output.empty() ? options.scene : options.output).string();
    json["objects"] = Json::array();
    for (const FurnishedObject& object : building.furnishing.objects)
        if (std::ranges::binary_search(edited.ids, object.id)) json["objects"].push_back(object_json(building, object));
    json["ids"] = edited.ids;
    json["seconds"] = seconds;
    json["check"] = report_json({options.scene.string(), ""}, report);
    return json;
}

/// What the edit brought: what was said of the scene before is not said again.
modeler::CheckReport news_of(modeler::CheckReport report, const std::vector<Finding>& before) {
    std::erase_if(report.findings, [&](const Finding& finding) {
        return std::ranges::any_of(
            before, [&](const Finding& old) { return old.code == finding.code && old.sentence == finding.sentence; });
    });
    return report;
}

}  // namespace

int run_place(const PlaceOptions& options, const Console& console) {
    check_flags(options);
    const std::filesystem::path output = output_path(options.output.empty() ? options.scene : options.output);
    modeler::Building building;
    std::string options_json;
    EditedObjects edited;
    modeler::CheckReport report;
    std::vector<Finding> before;
    bool written = false;
    const double seconds = seconds_of([&] {
        const accel::Scene scene = accel::open(options.scene);
        if (!scene.has_model())
            throw InputError("F118", options.scene.string(),
                             "The scene was stripped of its model, which says what stands where: build it without "
                             "--strip.");
        building = modeler::read_model(scene);
        before = building.findings;
        if (edit_count(options) == 0) return;
        const std::optional<accel::Certificate> certificate = accel::certificate(scene);
        options_json = certificate ? certificate->options : "{}";
        edited = edit(options, building);
        edited.furnishing.cells = building.furnishing.empty() && options_json.find("\"cut\"") != std::string::npos
                                      ? modeler::ObjectCells::Cut
                                      : building.furnishing.cells;
        std::vector<modeler::Lamp> lamps = modeler::moved_lamps(building.lamps, building.furnishing, edited.furnishing);
        if (edited.furnishing.cells == modeler::ObjectCells::Cut) building = rebuilt(building, options_json);
        std::vector<Finding> findings;
        building = modeler::put_objects(building, std::move(edited.furnishing), findings, *render::make_executor());
        building.findings.insert(building.findings.end(), findings.begin(), findings.end());
        building.lamps = std::move(lamps);
        report = modeler::check(building);
        if (has_defects(report, false) && !options.keep_going) return;
        const accel::Scene again = modeler::export_scene(building, report, options_json);
        accel::write(again, output);
        written = true;
    });
    if (edit_count(options) == 0) return list(options, building, console);
    const bool defects = has_defects(report, false);
    if (console.json()) {
        console.print(dump(result_json(options, edited, building, report, written, seconds)));
        return defects ? exit_defects : exit_ok;
    }
    if (const modeler::CheckReport news = news_of(report, before); !news.findings.empty())
        console.say(findings_text(news.findings, 20));
    if (written) console.say(output.string() + ": " + edited.what + ", in " + time_text(seconds) + '.');
    else
        console.warn("enfilade: " + output.string() + " stays as it is, because the model would have defects (" +
                     counts_text(report.findings) + "): choose another place, or give --keep-going.");
    return defects ? exit_defects : exit_ok;
}

}  // namespace enfilade::tools
