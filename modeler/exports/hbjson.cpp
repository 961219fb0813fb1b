#include "modeler/exports/hbjson.h"

#include "modeler/exports/energy_model.h"
#include "modeler/exports/json_text.h"
#include "plans/number_text.h"

namespace enfilade::modeler {

namespace {

using Points = std::vector<std::array<double, 3>>;

class Writer {
public:
    explicit Writer(const Building& building) : building_(building), model_(energy_model(building)) {}

    std::string write() {
        text_ = "{\"type\":\"Model\",\"identifier\":\"building\",";
        if (!building_.name.empty()) text_ += "\"display_name\":" + json_text(building_.name) + ',';
        text_ +=
            "\"version\":\"1.59.0\",\"units\":\"Meters\",\"tolerance\":0.001,\"angle_tolerance\":1.0,\n"
            "\"properties\":{\"type\":\"ModelProperties\",\"energy\":{\"type\":\"ModelEnergyProperties\"},"
            "\"radiance\":{\"type\":\"ModelRadianceProperties\"}},\n\"rooms\":[";
        for (std::uint32_t r = 0; r < model_.rooms.size(); ++r) {
            text_ += r == 0 ? "\n" : ",\n";
            write_room(r);
        }
        return std::move(text_ += "]}\n");
    }

private:
    static std::string room_id(std::uint32_t r) { return "Room_" + std::to_string(r); }
    static std::string face_id(std::uint32_t r, std::uint32_t f) { return room_id(r) + "_Face_" + std::to_string(f); }
    static std::string opening_id(std::uint32_t r, std::uint32_t f, std::size_t o) {
        return face_id(r, f) + "_Opening_" + std::to_string(o);
    }

    void write_room(std::uint32_t r) {
        const EnergyRoom& room = model_.rooms[r];
        const Space& space = building_.spaces[room.space];
        text_ += "{\"type\":\"Room\",\"identifier\":\"" + room_id(r) +
                 "\",\"display_name\":" + json_text(space.name.empty() ? space.id : space.name);
        if (space.storey < building_.storeys.size()) {
            const StoreyInfo& storey = building_.storeys[space.storey];
            text_ += ",\"story\":" + json_text(storey.name.empty() ? storey.id : storey.name);
        }
        if (!room.has_floor) text_ += ",\"exclude_floor_area\":true";
        text_ += ",\"user_data\":{\"id\":" + json_text(space.id) + ",\"label\":\"" + accel::name_of(space.label) + '"';
        if (!space.kind.empty()) text_ += ",\"kind\":" + json_text(space.kind);
        text_ += "},\"properties\":{\"type\":\"RoomPropertiesAbridged\"},\"faces\":[";
        for (std::uint32_t f = 0; f < room.faces.size(); ++f) {
            text_ += f == 0 ? "\n" : ",\n";
            write_face(r, f);
        }
        text_ += "]}";
    }

    static const char* face_type(const EnergyFace& face) {
        if (face.is_air) return "AirBoundary";
        switch (face.kind) {
            case EnergyFaceKind::Wall: return "Wall";
            case EnergyFaceKind::Floor: return "Floor";
            case EnergyFaceKind::Ceiling: return "RoofCeiling";
        }
        return "Wall";
    }

    static std::string surface(const std::string& objects) {
        return "{\"type\":\"Surface\",\"boundary_condition_objects\":[" + objects + "]}";
    }

    void write_face(std::uint32_t r, std::uint32_t f) {
        const EnergyFace& face = model_.rooms[r].faces[f];
        text_ += "{\"type\":\"Face\",\"identifier\":\"" + face_id(r, f) + "\",\"face_type\":\"" + face_type(face) +
                 "\",\"properties\":{\"type\":\"FacePropertiesAbridged\"},\"boundary_condition\":";
        switch (face.across) {
            case Across::Nothing: text_ += "{\"type\":\"Adiabatic\"}"; break;
            case Across::Outdoors: text_ += "{\"type\":\"Outdoors\"}"; break;
            case Across::Ground: text_ += "{\"type\":\"Ground\"}"; break;
            case Across::Part:
                text_ +=
                    surface('"' + face_id(face.other_room, face.other_face) + "\",\"" + room_id(face.other_room) + '"');
                break;
        }
        text_ += ",\"geometry\":";
        write_geometry(face.outer, face.holes);
        write_openings(r, f, "doors", true);
        write_openings(r, f, "apertures", false);
        text_ += '}';
    }

    void write_openings(std::uint32_t r, std::uint32_t f, const char* list, bool doors) {
        const EnergyFace& face = model_.rooms[r].faces[f];
        bool is_first = true;
        for (std::size_t o = 0; o < face.openings.size(); ++o) {
            const Space& space = building_.spaces[face.openings[o].space];
            if ((space.label == Label::Door) != doors) continue;
            text_ += is_first ? ",\"" + std::string(list) + "\":[" : ",";
            is_first = false;
            text_ += std::string("{\"type\":\"") + (doors ? "Door" : "Aperture") + "\",\"identifier\":\"" +
                     opening_id(r, f, o) +
                     "\",\"display_name\":" + json_text(space.name.empty() ? space.id : space.name);
            if (space.label == Label::Opening) text_ += ",\"is_operable\":true";
            text_ += std::string(",\"properties\":{\"type\":\"") + (doors ? "Door" : "Aperture") +
                     "PropertiesAbridged\"},\"boundary_condition\":";
            if (face.across == Across::Part)
                text_ += surface('"' + opening_id(face.other_room, face.other_face, o) + "\",\"" +
                                 face_id(face.other_room, face.other_face) + "\",\"" + room_id(face.other_room) + '"');
            else text_ += "{\"type\":\"Outdoors\"}";
            text_ += ",\"geometry\":";
            const auto& corners = face.openings[o].corners;
            write_geometry(Points(corners.begin(), corners.end()), {});
            text_ += '}';
        }
        if (!is_first) text_ += ']';
    }

    void write_points(const Points& points) {
        text_ += '[';
        for (std::size_t k = 0; k < points.size(); ++k) {
            text_ += k == 0 ? "[" : ",[";
            for (std::size_t axis = 0; axis < 3; ++axis) {
                if (axis > 0) text_ += ',';
                text_ += plans::rounded_text(points[k][axis], 6);
            }
            text_ += ']';
        }
        text_ += ']';
    }

    void write_geometry(const Points& outer, const std::vector<Points>& holes) {
        text_ += "{\"type\":\"Face3D\",\"boundary\":";
        write_points(outer);
        for (std::size_t h = 0; h < holes.size(); ++h) {
            text_ += h == 0 ? ",\"holes\":[" : ",";
            write_points(holes[h]);
        }
        text_ += holes.empty() ? "}" : "]}";
    }

    const Building& building_;
    EnergyModel model_;
    std::string text_;
};

}  // namespace

std::string to_hbjson(const Building& building) { return Writer(building).write(); }

}  // namespace enfilade::modeler
