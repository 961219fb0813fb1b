#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "accel/certificate.h"
#include "accel/scene_file.h"
#include "tools/commands.h"
#include "tools/exit_code.h"
#include "tools/scene_summary.h"
#include "tools/version.h"

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
    SceneCounts counts;
    std::array<std::size_t, accel::label_count> cells_by_label = {};
    std::array<std::size_t, 3> portals_by_kind = {};
    std::vector<std::size_t> space_cells;
    Spread cells_per_room;
    Spread sections_per_cell;
    Spread faces_per_section;
    std::size_t components = 0;
    std::optional<accel::Certificate> certificate;
};

Info gather(const accel::Scene& scene) {
    const accel::SceneView& view = scene.view();
    Info info;
    info.counts = scene_counts(scene);
    for (const accel::Cell& cell : view.cells) ++info.cells_by_label[std::size_t(cell.label)];
    for (const accel::Portal& portal : view.portals) ++info.portals_by_kind[std::size_t(portal.kind())];
    info.space_cells = cells_per_space(view);
    std::vector<std::size_t> rooms, sections, faces;
    for (std::size_t s = 0; s < info.space_cells.size(); ++s)
        if (info.space_cells[s] > 0 && view.spaces[s].label == accel::Label::Room) rooms.push_back(info.space_cells[s]);
    for (const accel::Cell& cell : view.cells) sections.push_back(cell.section_count);
    for (std::size_t s = 0; s < view.section_count(); ++s)
        faces.push_back(view.section_tails[s + 1].first_face - view.section_tails[s].first_face);
    info.cells_per_room = spread(rooms);
    info.sections_per_cell = spread(sections);
    info.faces_per_section = spread(faces);
    info.components = component_count(view);
    info.certificate = accel::certificate(scene);
    return info;
}

double bytes_per_cell(const Info& info) {
    return info.counts.cells == 0 ? 0 : double(info.counts.trace_bytes) / double(info.counts.cells);
}

Json info_json(const std::string& file, const accel::Scene& scene, const Info& info) {
    const accel::SceneView& view = scene.view();
    Json json = {{"program", "enfilade"}, {"version", version}, {"file", file}};
    json["unit_m"] = view.unit;
    json["origin_m"] = view.origin;
    json["counts"] = scene_counts_json(info.counts);
    json["cells_by_label"] = Json::object();
    for (std::size_t label = 0; label < info.cells_by_label.size(); ++label)
        if (info.cells_by_label[label] > 0)
            json["cells_by_label"][accel::name_of(accel::Label(label))] = info.cells_by_label[label];
    json["portals_by_kind"] = Json::object();
    for (std::size_t kind = 0; kind < info.portals_by_kind.size(); ++kind)
        json["portals_by_kind"][accel::name_of(accel::PortalKind(kind))] = info.portals_by_kind[kind];
    json["cells_per_room"] = spread_json(info.cells_per_room);
    json["sections_per_cell"] = spread_json(info.sections_per_cell);
    json["faces_per_section"] = spread_json(info.faces_per_section);
    json["bytes_per_cell"] = bytes_per_cell(info);
    json["graph"] = {{"nodes", info.counts.cells}, {"edges", info.counts.portals}, {"components", info.components}};
    json["rooms"] = Json::array();
    for (std::size_t s = 0; s < view.spaces.size(); ++s) {
        const accel::Space& space = view.spaces[s];
        if (space.label != accel::Label::Room || info.space_cells[s] == 0) continue;
        json["rooms"].push_back({{"id", view.string(space.id)},
                                 {"name", view.string(space.name)},
                                 {"storey", view.string(space.storey)},
                                 {"area_m2", space.area_m2},
                                 {"cells", info.space_cells[s]}});
    }
    json["certificate"] = nullptr;
    if (info.certificate) {
        json["certificate"] = {{"program_version", info.certificate->program_version},
                               {"options", info.certificate->options}};
        json["certificate"]["code_counts"] = Json::object();
        for (const auto& [code, count] : info.certificate->code_counts)
            json["certificate"]["code_counts"][code] = count;
    }
    return json;
}

std::string room_line(const accel::SceneView& view, const accel::Space& space, std::size_t cells) {
    const std::string_view name = view.string(space.name).empty() ? view.string(space.id) : view.string(space.name);
    char numbers[64];
    std::snprintf(numbers, sizeof numbers, "%9.2f m2 %6zu cells  ", space.area_m2, cells);
    return "  " + std::string(numbers) + std::string(name) + "  (storey " + std::string(view.string(space.storey)) +
           ")";
}

std::string info_text(const std::string& file, const accel::Scene& scene, const Info& info) {
    const accel::SceneView& view = scene.view();
    const SceneCounts& counts = info.counts;
    std::string text = file + ": " + scene_counts_text(counts) + "\n\nRooms\n";
    for (std::size_t s = 0; s < view.spaces.size(); ++s)
        if (view.spaces[s].label == accel::Label::Room && info.space_cells[s] > 0)
            text += room_line(view, view.spaces[s], info.space_cells[s]) + '\n';
    text += "\nCells by label\n";
    for (std::size_t label = 0; label < info.cells_by_label.size(); ++label)
        if (info.cells_by_label[label] > 0)
            text += "  " + grouped(info.cells_by_label[label]) + ' ' + accel::name_of(accel::Label(label)) + '\n';
    text += "\nShape\n  cells a room        " + spread_text(info.cells_per_room);
    text += "\n  sections a cell     " + spread_text(info.sections_per_cell);
    text += "\n  faces a section     " + spread_text(info.faces_per_section);
    text += "\n  source faces        " + grouped(counts.source_faces);
    text += "\n  bytes a cell        " + grouped((unsigned long long)(bytes_per_cell(info)));
    text += "\n  trace group         " + byte_text(double(counts.trace_bytes));
    text += "\n  model group         " +
            (counts.model_bytes > 0 ? byte_text(double(counts.model_bytes)) : "none: a stripped scene");
    text += "\n\nGraph\n  " + counted(counts.cells, "node") + ", " + counted(counts.portals, "edge") + ", " +
            counted(info.components, "component") + "; portals:";
    for (std::size_t kind = 0; kind < info.portals_by_kind.size(); ++kind)
        text += ' ' + grouped(info.portals_by_kind[kind]) + ' ' + accel::name_of(accel::PortalKind(kind));
    text += "\n\nCertificate\n";
    if (!info.certificate) return text + "  none\n";
    text += "  checked by enfilade " + info.certificate->program_version + ", built with " + info.certificate->options +
            "\n ";
    for (const auto& [code, count] : info.certificate->code_counts) text += ' ' + code + ':' + std::to_string(count);
    return text + '\n';
}

}  // namespace

int run_info(const InfoOptions& options, const Console& console) {
    const accel::Scene scene = accel::open(options.scene);
    const Info info = gather(scene);
    const std::string file = options.scene.string();
    console.print(console.json()
                      ? info_json(file, scene, info).dump(2, ' ', false, Json::error_handler_t::replace) + '\n'
                      : info_text(file, scene, info));
    return exit_ok;
}

}  // namespace enfilade::tools
