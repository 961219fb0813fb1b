#include "modeler/model_group.h"

#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/error.h"
#include "modeler/lighting/lamps_text.h"
#include "modeler/objects/furnishing_text.h"
#include "modeler/objects/scene_textures.h"

namespace enfilade::modeler {
namespace {

using Json = nlohmann::ordered_json;

/// Rows of 32-bit numbers <-> the building's tables: `visit(row)` names the columns, in order, for both ways.
template <class Row>
struct Columns;
template <>
struct Columns<std::array<std::int32_t, 3>> {
    static auto of(auto& r) { return std::tie(r[0], r[1], r[2]); }
};
template <>
struct Columns<plans::GridPoint> {
    static auto of(auto& r) { return std::tie(r.x, r.y); }
};
template <>
struct Columns<PlanEdge> {
    static auto of(auto& r) { return std::tie(r.a, r.b); }
};
template <>
struct Columns<Piece> {
    static auto of(auto& r) { return std::tie(r.first_corner, r.corner_count, r.parent); }
};
template <>
struct Columns<Corner> {
    static auto of(auto& r) { return std::tie(r.vertex, r.half_edge, r.line); }
};
template <>
struct Columns<Volume> {
    static auto of(auto& r) { return std::tie(r.label, r.space, r.piece, r.parent, r.z_low, r.z_high); }
};
template <>
struct Columns<Face> {
    static auto of(auto& r) { return std::tie(r.direction, r.front, r.back, r.edge, r.z_low, r.z_high); }
};
template <>
struct Columns<std::uint32_t> {
    static auto of(auto& r) { return std::tie(r); }
};

template <class Row>
accel::InputModelArray packed(const std::string& name, const std::vector<Row>& rows) {
    using Tie = decltype(Columns<Row>::of(rows.front()));
    constexpr std::size_t columns = std::tuple_size_v<Tie>;
    std::vector<std::uint32_t> numbers;
    numbers.reserve(columns * rows.size());
    for (const Row& row : rows)
        std::apply([&](const auto&... column) { (numbers.push_back(std::uint32_t(column)), ...); },
                   Columns<Row>::of(row));
    accel::InputModelArray array{name, std::uint32_t(4 * columns), std::vector<std::byte>(4 * numbers.size())};
    if (!numbers.empty()) std::memcpy(array.bytes.data(), numbers.data(), array.bytes.size());
    return array;
}

accel::InputModelArray text_array(const std::string& name, const std::string& text) {
    accel::InputModelArray array{name, 1, std::vector<std::byte>(text.size())};
    if (!text.empty()) std::memcpy(array.bytes.data(), text.data(), text.size());
    return array;
}

[[noreturn]] void damaged(const std::string& what) {
    throw InputError("F20", "", "The scene's model is damaged: " + what + ". Build the scene again from its plan.");
}

std::span<const std::byte> bytes_of(const accel::Scene& scene, const std::string& name) {
    const accel::SceneArray* array = scene.find(name);
    if (!array) damaged("array \"" + name + "\" is missing");
    return array->bytes;
}

template <class Row>
std::vector<Row> unpacked(const accel::Scene& scene, const std::string& name) {
    const std::span<const std::byte> bytes = bytes_of(scene, name);
    Row probe{};
    constexpr std::size_t columns = std::tuple_size_v<decltype(Columns<Row>::of(probe))>;
    if (bytes.size() % (4 * columns) != 0) damaged("array \"" + name + "\" has half a row");
    std::vector<Row> rows(bytes.size() / (4 * columns));
    const std::byte* at = bytes.data();
    for (Row& row : rows)
        std::apply(
            [&](auto&... column) {
                const auto take = [&](auto& value) {
                    std::uint32_t number = 0;
                    std::memcpy(&number, at, 4);
                    at += 4;
                    value = static_cast<std::remove_reference_t<decltype(value)>>(number);
                };
                (take(column), ...);
            },
            Columns<Row>::of(row));
    return rows;
}

std::string text_of(const accel::Scene& scene, const std::string& name) {
    const std::span<const std::byte> bytes = bytes_of(scene, name);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

Json colour_json(const std::optional<plans::Colour>& colour) { return colour ? Json(*colour) : Json(nullptr); }
std::optional<plans::Colour> colour_from(const Json& json) {
    if (json.is_null()) return std::nullopt;
    return json.get<plans::Colour>();
}

Json finding_json(const Finding& finding) {
    Json json = {{"code", finding.code}, {"severity", int(finding.severity)}, {"sentence", finding.sentence},
                 {"hint", finding.hint}, {"storey", finding.storey},          {"moved_mm", finding.moved_mm}};
    if (finding.point) json["point"] = *finding.point;
    for (const ElementRef& element : finding.elements)
        json["elements"].push_back({element.kind, element.id, element.name});
    return json;
}
Finding finding_from(const Json& json) {
    Finding finding{json.at("code"), Severity(json.at("severity").get<int>()), json.at("sentence"), json.at("hint")};
    finding.storey = json.at("storey");
    finding.moved_mm = json.at("moved_mm");
    if (json.contains("point")) finding.point = json.at("point").get<std::array<double, 3>>();
    if (json.contains("elements"))
        for (const Json& element : json.at("elements"))
            finding.elements.push_back({element.at(0), element.at(1), element.at(2)});
    return finding;
}

Json meta_json(const Building& building) {
    Json meta = {
        {"name", building.name},
        {"frame", {building.frame.unit, building.frame.origin_x, building.frame.origin_y, building.frame.origin_z}},
        {"site_min", building.site_min},
        {"site_max", building.site_max},
        {"convex", building.convex},
        {"opaque_glass", building.opaque_glass},
        {"max_deviation", building.max_deviation},
        {"sagitta", building.sagitta}};
    for (const Space& space : building.spaces)
        meta["spaces"].push_back({int(space.label), space.id, space.name, space.kind, space.storey, space.area_m2,
                                  colour_json(space.colour), colour_json(space.ceiling_colour), space.closed});
    for (std::uint32_t k = 0; k < building.spaces.size(); ++k)
        if (building.spaces[k].room != UINT32_MAX) meta["object_rooms"].push_back({k, building.spaces[k].room});
    for (const StoreyInfo& storey : building.storeys)
        meta["storeys"].push_back({storey.id, storey.name, storey.z_floor, storey.z_ceiling});
    meta["line_count"] = building.line_count;
    meta["wall_colours"] = Json::array();
    for (const WallColour& wall : building.wall_colours)
        meta["wall_colours"].push_back({wall.line, wall.wall_space, wall.colour});
    if (!building.pictures.empty()) meta["pictures"] = building.pictures.size();
    meta["findings"] = Json::array();
    for (const Finding& finding : building.findings) meta["findings"].push_back(finding_json(finding));
    return meta;
}

void read_meta(const Json& meta, Building& building) {
    building.name = meta.at("name");
    const auto frame = meta.at("frame").get<std::array<double, 4>>();
    building.frame = {frame[0], frame[1], frame[2], frame[3]};
    building.site_min = meta.at("site_min").get<std::array<std::int32_t, 3>>();
    building.site_max = meta.at("site_max").get<std::array<std::int32_t, 3>>();
    building.convex = meta.at("convex");
    building.opaque_glass = meta.at("opaque_glass");
    building.max_deviation = meta.at("max_deviation");
    building.sagitta = meta.at("sagitta");
    for (const Json& row : meta.at("spaces")) {
        const int label = row.at(0);
        if (label < 0 || label >= accel::label_count) damaged("a space has no known label");
        building.spaces.push_back({Label(label), row.at(1), row.at(2), row.at(3), row.at(4), row.at(5),
                                   colour_from(row.at(6)), colour_from(row.at(7)), row.at(8), UINT32_MAX});
    }
    if (meta.contains("object_rooms"))
        for (const Json& row : meta.at("object_rooms")) {
            const auto [object, room] = row.get<std::array<std::uint32_t, 2>>();
            if (object >= building.spaces.size() || room >= building.spaces.size()) damaged("a space out of range");
            building.spaces[object].room = room;
        }
    for (const Json& row : meta.at("storeys")) building.storeys.push_back({row.at(0), row.at(1), row.at(2), row.at(3)});
    building.line_count = meta.at("line_count");
    for (const Json& row : meta.at("wall_colours"))
        building.wall_colours.push_back({row.at(0), row.at(1), row.at(2).get<plans::Colour>()});
    for (const Json& row : meta.at("findings")) building.findings.push_back(finding_from(row));
}

/// The pictures of its plan are the scene's first textures.
void read_pictures(std::size_t count, const accel::SceneView& scene, Building& building) {
    if (count == 0) return;
    if (count > scene.textures.size()) damaged("pictures of its walls are missing");
    building.pictures = scene_textures(scene);
    building.pictures.resize(count);
}

/// Every index of the tables, so that nothing that works on the building can run out of them.
void check_indices(const Building& b) {
    const auto below = [](std::uint64_t index, std::size_t bound, const char* what) {
        if (index >= bound) damaged(std::string(what) + " out of range");
    };
    for (const PlanEdge& edge : b.edges)
        below(edge.a, b.points.size(), "a point"), below(edge.b, b.points.size(), "a point");
    for (const Corner& corner : b.corners)
        below(corner.vertex, b.points.size(), "a point"), below(corner.half_edge / 2, b.edges.size(), "an edge"),
            below(corner.line, b.line_count, "a line");
    for (const Piece& piece : b.pieces) {
        if (piece.corner_count < 3) damaged("a piece without area");
        below(std::uint64_t(piece.first_corner) + piece.corner_count - 1, b.corners.size(), "a corner");
    }
    if (b.volumes.empty() || b.volumes.back().label != Label::Outside) damaged("no volume outside");
    for (std::size_t v = 0; v < b.volumes.size(); ++v) {
        const Volume& volume = b.volumes[v];
        if (int(volume.label) >= accel::label_count || (volume.label == Label::Outside) != (v + 1 == b.volumes.size()))
            damaged("a volume has no known label");
        below(volume.space, b.spaces.size(), "a space");
        below(volume.parent, b.volumes.size(), "a parent");
        if (volume.label != Label::Outside) below(volume.piece, b.pieces.size(), "a piece");
    }
    bool sides_first = true;
    for (const Face& face : b.faces) {
        below(face.front, b.volumes.size(), "a volume"), below(face.back, b.volumes.size(), "a volume");
        if (face.direction > Direction::Up) damaged("a face has no known direction");
        if (face.direction == Direction::Side) below(face.edge, b.edges.size(), "an edge");
        if (face.direction == Direction::Side && !sides_first) damaged("faces out of order");
        sides_first = face.direction == Direction::Side;
    }
    if (b.map.cell_bound<0>() > b.vertices.size() || b.map.cell_bound<2>() > b.faces.size() ||
        b.map.cell_bound<3>() > b.volumes.size())
        damaged("the map has cells without a row");
}

}  // namespace

std::vector<accel::InputModelArray> model_group(const Building& building) {
    const gmap::MapArrays& map = building.map.arrays();
    std::vector<accel::InputModelArray> arrays;
    arrays.push_back(text_array("m.plan", building.plan_json));
    arrays.push_back(text_array("m.meta", meta_json(building).dump(-1, ' ', false, Json::error_handler_t::replace)));
    for (std::size_t i = 0; i < 4; ++i) arrays.push_back(packed("m.alpha" + std::to_string(i), map.alpha[i]));
    const char* cells[] = {"m.dart.vertex", "m.dart.edge", "m.dart.face", "m.dart.volume"};
    for (std::size_t i = 0; i < 4; ++i) arrays.push_back(packed(cells[i], map.cell_id[i]));
    arrays.push_back(packed("m.vertices", building.vertices));
    arrays.push_back(packed("m.points", building.points));
    arrays.push_back(packed("m.edges", building.edges));
    arrays.push_back(packed("m.corners", building.corners));
    arrays.push_back(packed("m.pieces", building.pieces));
    arrays.push_back(packed("m.faces", building.faces));
    arrays.push_back(packed("m.volumes", building.volumes));
    if (!building.furnishing.empty()) arrays.push_back(text_array("m.objects", furnishing_text(building.furnishing)));
    if (!building.lamps.empty()) arrays.push_back(text_array("m.lamps", lamps_text(building.lamps)));
    return arrays;
}

Building read_model(const accel::Scene& scene) {
    if (!scene.has_model())
        throw InputError(
            "F21", "",
            "The scene holds no model (it was stripped): check and edit the scene as it was built, without --strip.");
    Building building;
    try {
        building.plan_json = text_of(scene, "m.plan");
        const Json meta = Json::parse(text_of(scene, "m.meta"));
        read_meta(meta, building);
        read_pictures(meta.value("pictures", std::size_t{0}), scene.view(), building);
        gmap::MapArrays map;
        const char* cells[] = {"m.dart.vertex", "m.dart.edge", "m.dart.face", "m.dart.volume"};
        for (std::size_t i = 0; i < 4; ++i) {
            map.alpha[i] = unpacked<std::uint32_t>(scene, "m.alpha" + std::to_string(i));
            map.cell_id[i] = unpacked<std::uint32_t>(scene, cells[i]);
            for (const std::uint32_t id : map.cell_id[i])
                if (id != UINT32_MAX) map.cell_bound[i] = std::max(map.cell_bound[i], id + 1);
        }
        building.map = gmap::Map(std::move(map));
    } catch (const Json::exception& error) {
        damaged(error.what());
    } catch (const std::logic_error& error) {
        damaged(error.what());
    }
    building.vertices = unpacked<std::array<std::int32_t, 3>>(scene, "m.vertices");
    building.points = unpacked<plans::GridPoint>(scene, "m.points");
    building.edges = unpacked<PlanEdge>(scene, "m.edges");
    building.corners = unpacked<Corner>(scene, "m.corners");
    building.pieces = unpacked<Piece>(scene, "m.pieces");
    building.faces = unpacked<Face>(scene, "m.faces");
    building.volumes = unpacked<Volume>(scene, "m.volumes");
    check_indices(building);
    if (scene.find("m.objects"))
        building.furnishing = read_furnishing(text_of(scene, "m.objects"), scene.view(), building.spaces);
    if (scene.find("m.lamps")) building.lamps = read_lamps(text_of(scene, "m.lamps"), building.storeys.size());
    return building;
}

}  // namespace enfilade::modeler
