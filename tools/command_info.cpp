#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

#include "accel/certificate.h"
#include "accel/graph.h"
#include "accel/scene_file.h"
#include "accel/stats.h"
#include "base/error.h"
#include "tools/commands.h"
#include "tools/cut_summary.h"
#include "tools/exit_code.h"
#include "tools/furniture_summary.h"
#include "tools/lamp_summary.h"
#include "tools/output_file.h"
#include "tools/report/cut_sheet.h"
#include "tools/scene_summary.h"
#include "tools/version.h"
#include "tools/visible_rooms.h"

namespace enfilade::tools {

namespace {

using Json = nlohmann::ordered_json;

struct Spread {
    std::size_t least = 0;
    std::size_t most = 0;
    double mean = 0;
};

Spread spread(const std::vector<std::size_t>& values) {
    if (values.empty()) return {};
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    double sum = 0;
    for (const std::size_t value : values) sum += double(value);
    return {*least, *most, sum / double(values.size())};
}

Json spread_json(const Spread& spread) {
    return {{"least", spread.least}, {"mean", spread.mean}, {"most", spread.most}};
}

std::string spread_text(const Spread& spread) {
    char text[96];
    std::snprintf(text, sizeof text, "%.1f (%zu to %zu)", spread.mean, spread.least, spread.most);
    return text;
}

/// Everything that `info` says, measured once for both of its voices.
struct Info {
    accel::SceneStats stats;
    std::vector<SpaceCuts> spaces;
    double virtual_area_m2 = 0;
    Spread cells_per_room;
    Spread sections_per_cell;
    Spread faces_per_section;
    std::size_t components = 0;
    std::optional<accel::Certificate> certificate;
};

Info gather(const accel::Scene& scene) {
    const accel::SceneView& view = scene.view();
    Info info;
    info.stats = accel::stats(scene);
    info.spaces = cuts_per_space(view);
    info.virtual_area_m2 = virtual_area(view);
    std::vector<std::size_t> rooms, sections, faces;
    for (std::size_t s = 0; s < info.spaces.size(); ++s)
        if (view.spaces[s].label == accel::Label::Room) rooms.push_back(info.spaces[s].cells);
    for (const accel::Cell& cell : view.cells) sections.push_back(cell.section_count);
    for (std::size_t s = 0; s < view.section_count(); ++s)
        faces.push_back(view.section_tails[s + 1].first_face - view.section_tails[s].first_face);
    info.cells_per_room = spread(rooms);
    info.sections_per_cell = spread(sections);
    info.faces_per_section = spread(faces);
    for (const std::uint32_t component : accel::components(accel::cell_graph(view)))
        info.components = std::max(info.components, std::size_t(component) + 1);
    info.certificate = accel::certificate(scene);
    return info;
}

template <class Name, std::size_t Count>
Json counts_by_name(const std::array<std::uint64_t, Count>& counts, Name name) {
    Json json = Json::object();
    for (std::size_t k = 0; k < Count; ++k)
        if (counts[k] > 0) json[name(k)] = counts[k];
    return json;
}
bool is_opening(accel::Label label) {
    return label == accel::Label::Door || label == accel::Label::Window || label == accel::Label::Opening;
}
const char* label_name(std::size_t label) { return accel::name_of(accel::Label(label)); }
const char* kind_name(std::size_t kind) { return accel::name_of(accel::PortalKind(kind)); }

Json info_json(const std::string& file, const accel::Scene& scene, const Info& info) {
    const accel::SceneView& view = scene.view();
    Json json = {{"program", "enfilade"}, {"version", version}, {"file", file}};
    json["unit_m"] = view.unit;
    json["origin_m"] = view.origin;
    json["counts"] = scene_counts_json(scene);
    json["cells_by_label"] = counts_by_name(info.stats.cells_of_label, label_name);
    json["portals_by_kind"] = counts_by_name(info.stats.portals_of_kind, kind_name);
    json["cells_per_room"] = spread_json(info.cells_per_room);
    json["sections_per_cell"] = spread_json(info.sections_per_cell);
    json["faces_per_section"] = spread_json(info.faces_per_section);
    json["virtual_portal_area_m2"] = info.virtual_area_m2;
    json["bytes_per_cell"] = info.stats.bytes_per_cell();
    json["graph"] = {{"nodes", info.stats.cells}, {"edges", info.stats.portals}, {"components", info.components}};
    json["rooms"] = Json::array();
    json["openings"] = Json::array();
    for (std::size_t s = 0; s < view.spaces.size(); ++s) {
        const accel::Space& space = view.spaces[s];
        Json place = {
            {"id", view.string(space.id)}, {"name", view.string(space.name)}, {"storey", view.string(space.storey)}};
        place["cells"] = info.spaces[s].cells;
        if (space.label == accel::Label::Room) {
            place["area_m2"] = space.area_m2;
            place["sections"] = info.spaces[s].sections;
            place["faces"] = info.spaces[s].faces;
            place["cut_area_m2"] = info.spaces[s].cut_area_m2;
            place["sah_sum"] = info.spaces[s].sah_sum;
            json["rooms"].push_back(std::move(place));
        } else if (is_opening(space.label) && info.spaces[s].cells > 0) {
            place["label"] = accel::name_of(space.label);
            json["openings"].push_back(std::move(place));
        }
    }
    json["furniture"] = furniture_json(view, info.stats);
    json["lamps"] = lamps_json(lamp_summary(view));
    json["certificate"] = nullptr;
    if (info.certificate) {
        Json certificate = {{"program_version", info.certificate->program_version},
                            {"options", info.certificate->options}};
        certificate["code_counts"] = Json::object();
        for (const auto& [code, count] : info.certificate->code_counts) certificate["code_counts"][code] = count;
        json["certificate"] = std::move(certificate);
    }
    return json;
}

std::string room_line(const accel::SceneView& view, const accel::Space& space, const SpaceCuts& cuts) {
    const std::string_view name = view.string(space.name).empty() ? view.string(space.id) : view.string(space.name);
    char numbers[96];
    std::snprintf(numbers, sizeof numbers, "%9.2f m2 %6zu cells %9.2f m2 of cuts  ", space.area_m2, cuts.cells,
                  cuts.cut_area_m2);
    return "  " + std::string(numbers) + std::string(name) + "  (storey " + std::string(view.string(space.storey)) +
           ")";
}

std::string certificate_text(const Info& info) {
    if (!info.certificate) return "  none\n";
    std::string text = "  checked by enfilade " + info.certificate->program_version + ", built with " +
                       info.certificate->options + "\n ";
    for (const auto& [code, count] : info.certificate->code_counts) text += ' ' + code + ':' + std::to_string(count);
    return text + '\n';
}

std::string info_text(const std::string& file, const accel::Scene& scene, const Info& info) {
    const accel::SceneView& view = scene.view();
    const accel::SceneStats& stats = info.stats;
    std::string text = file + ": " + scene_counts_text(scene) + "\n\nRooms\n";
    for (std::size_t s = 0; s < view.spaces.size(); ++s)
        if (view.spaces[s].label == accel::Label::Room) text += room_line(view, view.spaces[s], info.spaces[s]) + '\n';
    text += furniture_text(view, stats);
    if (const std::string lamps = lamps_text(lamp_summary(view)); !lamps.empty()) text += "\nLamps\n  " + lamps + '\n';
    text += "\nCells by label\n";
    for (std::size_t label = 0; label < stats.cells_of_label.size(); ++label)
        if (stats.cells_of_label[label] > 0)
            text += "  " + grouped(stats.cells_of_label[label]) + ' ' + label_name(label) + '\n';
    text += "\nShape\n  cells a room        " + spread_text(info.cells_per_room);
    text += "\n  sections a cell     " + spread_text(info.sections_per_cell);
    text += "\n  faces a section     " + spread_text(info.faces_per_section);
    text += "\n  virtual portals     " + grouped((unsigned long long)(info.virtual_area_m2 + 0.5)) + " m2";
    text += "\n  source faces        " + grouped(stats.source_faces);
    text += "\n  bytes a cell        " + grouped((unsigned long long)(stats.bytes_per_cell()));
    text += "\n  trace group         " + byte_text(double(stats.trace_bytes));
    text += "\n  model group         " +
            (stats.model_bytes > 0 ? byte_text(double(stats.model_bytes)) : "none: a stripped scene");
    text += "\n\nGraph\n  " + counted(stats.cells, "node") + ", " + counted(stats.portals, "edge") + ", " +
            counted(info.components, "component") + "; portals:";
    for (std::size_t kind = 0; kind < stats.portals_of_kind.size(); ++kind)
        text += ' ' + grouped(stats.portals_of_kind[kind]) + ' ' + kind_name(kind);
    return text + "\n\nCertificate\n" + certificate_text(info);
}

/// The storeys that are asked for, by name, else by number. Throws InputError.
std::vector<SceneStorey> chosen_storeys(const accel::SceneView& view, const std::string& wanted) {
    const std::vector<SceneStorey> all = scene_storeys(view);
    if (all.empty()) throw InputError("F106", "", "There is no room in this scene to draw: build it with its storeys.");
    if (wanted.empty()) return all;
    for (const SceneStorey& storey : all)
        if (storey.name == wanted) return {storey};
    std::string known;
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (wanted == std::to_string(k)) return {all[k]};
        known += (k == 0 ? "" : k + 1 == all.size() ? " and " : ", ") + all[k].name;
    }
    throw InputError("F114", "",
                     "There is no storey \"" + wanted + "\" in this scene: --storey takes a name (" + known +
                         ") or a number from 0 to " + std::to_string(all.size() - 1) + ".");
}

void draw(const InfoOptions& options, const accel::Scene& scene, const Info& info) {
    const std::vector<SceneStorey> storeys = chosen_storeys(scene.view(), options.storey);
    const std::string title = options.scene.filename().string() + ": " + counted(info.stats.rooms, "room") + ", " +
                              counted(info.stats.cells, "cell") + ", " +
                              grouped((unsigned long long)(info.virtual_area_m2 + 0.5)) + " m² of virtual portals";
    write_text(options.svg, cut_sheet(title, storey_panels(scene.view(), storeys)));
}

}  // namespace

int run_info(const InfoOptions& options, const Console& console) {
    if (!options.svg.empty() && options.svg.extension() != ".svg")
        throw InputError("F115", options.svg.string(), "The drawing is written as .svg: end its name so.");
    const accel::Scene scene = accel::open(options.scene);
    std::optional<RoomSight> sight;
    if (!options.visible_from.empty())
        sight = visible_from(scene.view(), room_by_name(scene.view(), options.visible_from));
    const Info info = gather(scene);
    if (!options.svg.empty()) draw(options, scene, info);
    const std::string file = options.scene.string();
    if (console.json()) {
        Json json = info_json(file, scene, info);
        if (sight) json["visible_from"] = sight_json(scene.view(), *sight);
        console.print(json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
    } else {
        console.print(sight ? sight_text(scene.view(), *sight) : info_text(file, scene, info));
    }
    return exit_ok;
}

}  // namespace enfilade::tools
