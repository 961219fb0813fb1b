#include "modeler/exports/city_json.h"

#include <algorithm>
#include <map>

#include "modeler/exports/json_text.h"
#include "modeler/exports/space_solid.h"
#include "modeler/exports/unique_names.h"
#include "plans/number_text.h"

namespace enfilade::modeler {

namespace {

using plans::number_text;

const char* object_type(Label label) {
    switch (label) {
        case Label::Room:
        case Label::Stair:
        case Label::Shaft: return "BuildingRoom";
        case Label::Wall:
        case Label::Slab: return "BuildingConstructiveElement";
        default: return "BuildingInstallation";
    }
}

/// What a face of a wall or slab is, from what it is turned to; nullptr where it is inside the building's body.
const char* body_surface(const Space& of, SolidFaceKind kind, Label behind, bool is_open) {
    if (!is_open) return nullptr;
    const bool outside = behind == Label::Exterior;
    switch (kind) {
        case SolidFaceKind::Side: return outside || behind == Label::Ground ? "WallSurface" : "InteriorWallSurface";
        case SolidFaceKind::Floor:
            if (behind == Label::Ground) return "GroundSurface";
            return outside ? "OuterCeilingSurface" : "CeilingSurface";
        case SolidFaceKind::Ceiling:
            if (!outside) return "FloorSurface";
            if (of.label == Label::Wall) return "WallSurface";  // the top of a fence
            return of.id.starts_with("terrace@") ? "OuterFloorSurface" : "RoofSurface";
    }
    return nullptr;
}

/// What a face of a room or of a hole through a wall is.
const char* space_surface(Label of, SolidFaceKind kind, Label behind, bool is_open) {
    if (!is_open) {
        if (kind == SolidFaceKind::Floor) return "FloorSurface";
        return kind == SolidFaceKind::Ceiling ? "CeilingSurface" : "InteriorWallSurface";
    }
    if (kind != SolidFaceKind::Side) return "ClosureSurface";
    for (const Label label : {of, behind}) {
        if (label == Label::Door) return "Door";
        if (label == Label::Window) return "Window";
    }
    return "ClosureSurface";
}

class Writer {
public:
    explicit Writer(const Building& building)
        : building_(building),
          solids_(space_solids(building, {Label::Room, Label::Stair, Label::Shaft, Label::Wall, Label::Slab,
                                          Label::Door, Label::Window, Label::Opening})) {
        name_objects();
    }

    std::string write() {
        write_head();
        text_ += "\"CityObjects\":{\n";
        write_building();
        for (std::uint32_t k = 0; k < building_.storeys.size(); ++k) write_storey(k);
        for (std::size_t k = 0; k < solids_.solids.size();) {
            std::size_t end = k + 1;
            while (end < solids_.solids.size() && space_of(end) == space_of(k)) ++end;
            write_space(k, end);
            k = end;
        }
        text_ += "\n},\n\"vertices\":[";
        for (std::size_t v = 0; v < solids_.vertices.size(); ++v) {
            const auto& [x, y, z] = solids_.vertices[v];
            text_ +=
                (v == 0 ? "[" : ",\n[") + std::to_string(x) + ',' + std::to_string(y) + ',' + std::to_string(z) + ']';
        }
        return std::move(text_ += "]}\n");
    }

private:
    std::uint32_t space_of(std::size_t solid) const { return solids_.parts[solids_.solids[solid].part].space; }

    void name_objects() {
        UniqueNames names;
        building_key_ = names.of("building");
        for (const StoreyInfo& storey : building_.storeys) storey_keys_.push_back(names.of("storey " + storey.id));
        keys_.resize(building_.spaces.size());
        children_.resize(building_.storeys.size() + 1);
        for (std::size_t k = 0; k < solids_.solids.size(); ++k) {
            const std::uint32_t s = space_of(k);
            if (!keys_[s].empty()) continue;
            keys_[s] = names.of(building_.spaces[s].id);
            children_[std::min<std::size_t>(building_.spaces[s].storey, building_.storeys.size())].push_back(s);
        }
    }

    void write_head() {
        const plans::GridFrame& frame = building_.frame;
        const std::array origin = {frame.origin_x, frame.origin_y, frame.origin_z};
        const std::string unit = number_text(frame.unit);
        text_ += "{\"type\":\"CityJSON\",\"version\":\"2.0\",\n\"transform\":{\"scale\":[" + unit + ',' + unit + ',' +
                 unit + "],\"translate\":[" + number_text(origin[0]) + ',' + number_text(origin[1]) + ',' +
                 number_text(origin[2]) + "]},\n\"metadata\":{";
        if (!building_.name.empty()) text_ += "\"title\":" + json_text(building_.name) + ',';
        text_ += "\"geographicalExtent\":[";
        for (const bool upper : {false, true})
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const auto less = [axis](const auto& a, const auto& b) { return a[axis] < b[axis]; };
                const auto& all = solids_.vertices;
                const auto at = upper ? std::max_element(all.begin(), all.end(), less)
                                      : std::min_element(all.begin(), all.end(), less);
                const double value = at == all.end() ? 0 : (*at)[axis];
                text_ += (upper || axis > 0 ? "," : "") + number_text(origin[axis] + frame.unit * value);
            }
        text_ += "]},\n";
    }

    static std::string key_list(const std::vector<std::string>& keys) {
        std::string out = "[";
        for (const std::string& key : keys) out += (out.size() > 1 ? "," : "") + json_text(key);
        return out + ']';
    }
    std::vector<std::string> keys_of(const std::vector<std::uint32_t>& spaces) const {
        std::vector<std::string> keys;
        for (const std::uint32_t s : spaces) keys.push_back(keys_[s]);
        return keys;
    }

    void write_building() {
        std::vector<std::string> children = storey_keys_;
        for (const std::string& key : keys_of(children_.back())) children.push_back(key);
        text_ += json_text(building_key_) +
                 ":{\"type\":\"Building\",\"attributes\":{\"name\":" + json_text(building_.name) +
                 "},\"children\":" + key_list(children) + ",\"geometry\":[]}";
    }

    void write_storey(std::uint32_t k) {
        const StoreyInfo& storey = building_.storeys[k];
        text_ += ",\n" + json_text(storey_keys_[k]) + ":{\"type\":\"BuildingStorey\",\"attributes\":{\"name\":" +
                 json_text(storey.name.empty() ? storey.id : storey.name) +
                 ",\"floorElevation\":" + number_text(building_.frame.world_z(storey.z_floor)) +
                 ",\"ceilingElevation\":" + number_text(building_.frame.world_z(storey.z_ceiling)) + "},\"parents\":[" +
                 json_text(building_key_) + "],\"children\":" + key_list(keys_of(children_[k])) + ",\"geometry\":[]}";
    }

    /// The object of the solids first ... end - 1, which are all of one space.
    void write_space(std::size_t first, std::size_t end) {
        const std::uint32_t s = space_of(first);
        const Space& space = building_.spaces[s];
        double floor = 0;
        double volume = 0;
        for (std::size_t k = first; k < end; ++k) {
            const SpacePart& part = solids_.parts[solids_.solids[k].part];
            const double area = area_m2(building_, part);
            floor += area;
            volume += area * building_.frame.unit * (part.z_high - part.z_low);
        }
        text_ += ",\n" + json_text(keys_[s]) + ":{\"type\":\"" + object_type(space.label) +
                 "\",\"attributes\":{\"class\":\"" + (space.kind == "column" ? "column" : accel::name_of(space.label)) +
                 '"';
        if (!space.name.empty()) text_ += ",\"name\":" + json_text(space.name);
        if (!space.kind.empty()) text_ += ",\"function\":" + json_text(space.kind);
        if (space.label == Label::Room) text_ += ",\"floorArea\":" + number_text(floor);
        text_ += ",\"volume\":" + number_text(volume);
        const bool in_storey = space.storey < building_.storeys.size();
        text_ += "},\"parents\":[" + json_text(in_storey ? storey_keys_[space.storey] : building_key_) +
                 "],\"geometry\":[{\"type\":\"" + (end - first == 1 ? "Solid" : "MultiSolid") +
                 "\",\"lod\":\"3\",\n\"boundaries\":";
        if (end - first > 1) text_ += '[';
        for (std::size_t k = first; k < end; ++k) {
            if (k > first) text_ += ",\n";
            write_shell(solids_.solids[k]);
        }
        if (end - first > 1) text_ += ']';
        write_semantics(first, end);
        text_ += "}]}";
    }

    void write_shell(const SpaceSolid& solid) {
        text_ += "[[";
        const auto write_ring = [&](const std::vector<std::uint32_t>& ring) {
            text_ += '[';
            for (std::size_t k = 0; k < ring.size(); ++k) text_ += (k == 0 ? "" : ",") + std::to_string(ring[k]);
            text_ += ']';
        };
        for (std::size_t f = 0; f < solid.faces.size(); ++f) {
            text_ += f == 0 ? "[" : ",[";
            write_ring(solid.faces[f].outer);
            for (const auto& hole : solid.faces[f].holes) {
                text_ += ',';
                write_ring(hole);
            }
            text_ += ']';
        }
        text_ += "]]";
    }

    const char* surface(const Space& space, const SolidFace& face) const {
        const bool is_open = face.behind != SolidFace::solid;
        const Label behind = building_.spaces[is_open ? face.behind : face.material].label;
        if (accel::carries_light(space.label)) return space_surface(space.label, face.kind, behind, is_open);
        return body_surface(space, face.kind, behind, is_open);
    }

    void write_semantics(std::size_t first, std::size_t end) {
        const Space& space = building_.spaces[space_of(first)];
        std::map<std::pair<std::string, std::uint32_t>, std::size_t> numbers;
        std::string surfaces;
        std::string values = end - first > 1 ? "[" : "";
        for (std::size_t k = first; k < end; ++k) {
            values += k == first ? "[[" : ",[[";  // a list of shells of lists of faces
            bool is_first = true;
            for (const SolidFace& face : solids_.solids[k].faces) {
                if (!is_first) values += ',';
                is_first = false;
                const char* type = surface(space, face);
                if (!type) {
                    values += "null";
                    continue;
                }
                const auto [at, is_new] = numbers.try_emplace({type, face.behind}, numbers.size());
                if (is_new) {
                    surfaces += std::string(at->second == 0 ? "" : ",") + "{\"type\":\"" + type + '"';
                    if (face.behind != SolidFace::solid && !keys_[face.behind].empty())
                        surfaces += ",\"adjacent\":" + json_text(keys_[face.behind]);
                    surfaces += '}';
                }
                values += std::to_string(at->second);
            }
            values += "]]";
        }
        if (end - first > 1) values += ']';
        text_ += ",\n\"semantics\":{\"surfaces\":[" + surfaces + "],\"values\":" + values + '}';
    }

    const Building& building_;
    SpaceSolids solids_;
    std::string building_key_;
    std::vector<std::string> storey_keys_;
    std::vector<std::string> keys_;                     ///< [space], empty where it is not exported
    std::vector<std::vector<std::uint32_t>> children_;  ///< [storey], then those of no storey
    std::string text_;
};

}  // namespace

std::string to_cityjson(const Building& building) { return Writer(building).write(); }

}  // namespace enfilade::modeler
