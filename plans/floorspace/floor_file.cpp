#include "plans/floorspace/floor_file.h"

#include <unordered_map>

#include "plans/floorspace/entry.h"
#include "plans/limits.h"

namespace enfilade::plans {
namespace {

constexpr Range coordinate{-limits::coordinate, limits::coordinate};
constexpr Range story_height{0, limits::height};
constexpr Range part_height{0, limits::height / 2};  ///< a sill and a height together are a head
constexpr Range any_number{-1e9, 1e9};

/// The items of one list by their id, and where each was given.
class FloorIds {
public:
    FloorIds(const char* object, const JsonSource& source) : object_(object), source_(source) {}

    /// The index that this id had before, or nothing where it is new and gets `index`.
    std::optional<std::uint32_t> add(const std::string& id, std::uint32_t index, JsonPlace place) {
        const auto [at, fresh] = index_.try_emplace(id, Item{index, place});
        if (fresh) return {};
        return at->second.index;
    }
    [[nodiscard]] std::uint32_t find(const std::string& id) const {
        const auto at = index_.find(id);
        return at == index_.end() ? no_floor_item : at->second.index;
    }
    [[noreturn]] void refuse_twice(const std::string& id, JsonPlace place) const {
        refuse(source_, "P752", place,
               "The id \"" + id + "\" stands for another " + object_ + " already, on line " +
                   std::to_string(index_.at(id).place.line) + "; each needs an id of its own.");
    }
    /// \throws InputError P751 where there is none.
    [[nodiscard]] std::uint32_t at(const std::string& id, JsonPlace place, const std::string& whose) const {
        const std::uint32_t index = find(id);
        if (index == no_floor_item)
            refuse(source_, "P751", place,
                   whose + " names the " + object_ + " \"" + id + "\", but its story has no such " + object_ + ".");
        return index;
    }

private:
    struct Item {
        std::uint32_t index;
        JsonPlace place;
    };
    const char* object_;
    const JsonSource& source_;
    std::unordered_map<std::string, Item> index_;
};

class FloorFileReader {
public:
    FloorFileReader(const JsonValue& root, const std::string& file_name, std::optional<Unit> unit)
        : root_(root), source_{file_name, 1} {
        if (unit) source_.unit = metres(*unit);
        asked_ = unit.has_value();
    }

    FloorFile read() {
        const FloorEntry entry(root_, "floor plan", source_);
        read_project(entry);
        read_definitions(entry);
        for (const JsonValue& item : entry.list("space_types")) {
            const FloorEntry type(item, "space type", source_);
            type_names_.try_emplace(type.id_or_empty("id"), type.text("name"));
        }
        const JsonValue& stories = entry.at("stories");
        for (const JsonValue& item : entry.list("stories")) file_.stories.push_back(read_story(item));
        if (file_.stories.empty())
            refuse(source_, "P753", stories.place, "This floor plan has no story; draw one and save it again.");
        return std::move(file_);
    }

private:
    void read_project(const FloorEntry& entry) {
        const JsonValue* value = entry.find("project");
        const JsonValue nothing{JsonValue::Object{}, entry.place()};
        const FloorEntry project(value != nullptr ? *value : nothing, "project", source_);
        const JsonValue* config_value = project.find("config");
        const FloorEntry config(config_value != nullptr ? *config_value : nothing, "config", source_);
        read_unit(config);
        // Version 0.3 has the north axis in the config.
        file_.north_axis =
            project.number("north_axis", any_number).value_or(config.number("north_axis", any_number).value_or(0));
        if (const JsonValue* ground_value = project.find("ground")) {
            const FloorEntry ground(*ground_value, "ground", source_);
            const Range range{-limits::elevation / 2, limits::elevation / 2};
            file_.floor_offset = ground.length("floor_offset", range).value_or(0);
            file_.ground_slope = ground.number("tilt_slope", any_number).value_or(0);
        }
    }

    void read_unit(const FloorEntry& config) {
        const std::string unit = config.text("units");
        if (asked_) return;
        if (unit.empty()) {
            file_.unit_named = false;
        } else if (unit == "ip" || unit == "ft") {
            source_.unit = metres(Unit::Foot);
        } else if (unit != "si" && unit != "m") {
            refuse(source_, "P750", config.at("units").place,
                   "The unit \"" + unit.substr(0, 40) +
                       "\" is not known; it is \"ip\" (feet) or \"si\" (metres), or is given with --units.");
        }
    }

    void read_definitions(const FloorEntry& entry) {
        // Version 0.3 calls the definitions of windows "windows".
        const char* windows = entry.find("window_definitions") != nullptr ? "window_definitions" : "windows";
        FloorIds window_ids("window definition", source_);
        for (const JsonValue& item : entry.list(windows)) read_definition(item, false, file_.windows, window_ids);
        FloorIds door_ids("door definition", source_);
        for (const JsonValue& item : entry.list("door_definitions")) read_definition(item, true, file_.doors, door_ids);
        window_ids_.emplace(std::move(window_ids));
        door_ids_.emplace(std::move(door_ids));
    }

    void read_definition(const JsonValue& item, bool door, std::vector<FloorDefinition>& list, FloorIds& ids) {
        const FloorEntry entry(item, door ? "door definition" : "window definition", source_);
        FloorDefinition definition;
        definition.id = entry.id("id");
        definition.name = entry.text("name");
        std::string mode = entry.text("window_definition_mode");
        if (mode.empty()) mode = entry.text("window_definition_type");
        if (door) definition.fill = FloorFill::Door;
        else if (mode == "Single Window" || mode.empty()) definition.fill = FloorFill::Single;
        else if (mode == "Repeating Windows") definition.fill = FloorFill::Repeating;
        else if (mode == "Window to Wall Ratio") definition.fill = FloorFill::Ratio;
        definition.ratio = entry.number("wwr", any_number);
        definition.sill = entry.length("sill_height", part_height);
        definition.spacing = entry.length("window_spacing", part_height);
        definition.height = entry.length("height", part_height);
        definition.width = entry.length("width", {0, limits::coordinate});
        if (ids.add(definition.id, std::uint32_t(list.size()), entry.place()))
            ids.refuse_twice(definition.id, entry.place());
        list.push_back(std::move(definition));
    }

    FloorStory read_story(const JsonValue& value) {
        const FloorEntry entry(value, "story", source_);
        FloorStory story;
        story.line = value.place.line;
        story.column = value.place.column;
        story.id = entry.id_or_empty("id");
        story.name = entry.text("name");
        story.plenum_below = entry.length("below_floor_plenum_height", story_height).value_or(0);
        story.height = entry.length("floor_to_ceiling_height", story_height).value_or(0);
        story.plenum_above = entry.length("above_ceiling_plenum_height", story_height).value_or(0);
        story.multiplier = entry.number("multiplier", {0, 1e6}).value_or(1);
        if (entry.find("geometry") == nullptr && entry.find("walls") != nullptr)
            entry.fail("P104", entry.place(),
                       "This story lacks the key \"geometry\" of FloorspaceJS; in Enfilade's own format the list is "
                       "called \"storeys\".");
        const FloorEntry geometry(entry.at("geometry"), "geometry", source_);
        FloorIds vertices("vertex", source_);
        FloorIds edges("edge", source_);
        FloorIds faces("face", source_);
        for (const JsonValue& item : geometry.list("vertices")) read_vertex(item, story, vertices);
        for (const JsonValue& item : geometry.list("edges")) read_edge(item, story, vertices, edges);
        for (const JsonValue& item : geometry.list("faces")) read_face(item, story, edges, faces);
        for (const JsonValue& item : entry.list("spaces")) read_space(item, story, faces);
        for (const JsonValue& item : entry.list("shading")) {
            const FloorEntry shading(item, "shading", source_);
            const std::uint32_t face = faces.find(shading.id_or_empty("face_id"));
            if (face == no_floor_item) continue;  // every story has an empty one
            story.shading_faces.push_back(face);
            ++story.shadings;
        }
        for (const JsonValue& item : entry.list("windows")) read_aperture(item, false, story, edges);
        for (const JsonValue& item : entry.list("doors")) read_aperture(item, true, story, edges);
        return story;
    }

    // The editor may write a vertex, an edge or a face twice, word for word; only different ones are refused.

    void read_vertex(const JsonValue& item, FloorStory& story, FloorIds& ids) {
        const FloorEntry entry(item, "vertex", source_);
        FloorVertex vertex{entry.id("id"), {}};
        vertex.at.x = entry.number_of("x", entry.at("x"), coordinate, source_.unit, "m");
        vertex.at.y = entry.number_of("y", entry.at("y"), coordinate, source_.unit, "m");
        if (const auto other = ids.add(vertex.id, std::uint32_t(story.vertices.size()), entry.place())) {
            if (story.vertices[*other].at != vertex.at) ids.refuse_twice(vertex.id, entry.place());
            return;
        }
        story.vertices.push_back(std::move(vertex));
    }

    void read_edge(const JsonValue& item, FloorStory& story, const FloorIds& vertices, FloorIds& ids) {
        const FloorEntry entry(item, "edge", source_);
        FloorEdge edge{entry.id("id"), {}};
        const JsonValue& ends = entry.at("vertex_ids");
        const std::vector<std::string> names = entry.ids("vertex_ids");
        if (names.size() != 2)
            entry.fail("P105", ends.place,
                       "An edge has two vertices, but the edge \"" + edge.id + "\" names " +
                           std::to_string(names.size()) + ".");
        for (std::size_t k = 0; k < 2; ++k)
            edge.ends[k] = vertices.at(names[k], (*ends.array())[k].place, "The edge \"" + edge.id + "\"");
        if (const auto other = ids.add(edge.id, std::uint32_t(story.edges.size()), entry.place())) {
            if (story.edges[*other].ends != edge.ends) ids.refuse_twice(edge.id, entry.place());
            return;
        }
        story.edges.push_back(std::move(edge));
    }

    void read_face(const JsonValue& item, FloorStory& story, const FloorIds& edges, FloorIds& ids) {
        const FloorEntry entry(item, "face", source_);
        FloorFace face{entry.id("id"), {}};
        const JsonValue::Array& list = entry.list("edge_ids");
        const std::vector<std::string> names = entry.ids("edge_ids");
        const JsonValue::Array& order = entry.list("edge_order");
        if (!order.empty() && order.size() != names.size())
            entry.fail("P105", entry.at("edge_order").place,
                       "\"edge_order\" of the face \"" + face.id + "\" has " + std::to_string(order.size()) +
                           " items for " + std::to_string(names.size()) + " edges; it needs one for each.");
        for (std::size_t k = 0; k < names.size(); ++k) {
            FloorSide side{edges.at(names[k], list[k].place, "The face \"" + face.id + "\""), true};
            if (!order.empty()) {
                const bool* truth = order[k].boolean();
                side.forward = truth != nullptr ? *truth : entry.number_of("edge_order", order[k], {0, 1}) >= 0.5;
            }
            face.sides.push_back(side);
        }
        if (const auto other = ids.add(face.id, std::uint32_t(story.faces.size()), entry.place())) {
            const auto& sides = story.faces[*other].sides;
            bool same = sides.size() == face.sides.size();
            for (std::size_t k = 0; same && k < sides.size(); ++k) same = sides[k].edge == face.sides[k].edge;
            if (!same) ids.refuse_twice(face.id, entry.place());
            return;
        }
        story.faces.push_back(std::move(face));
    }

    void read_space(const JsonValue& item, FloorStory& story, const FloorIds& faces) {
        const FloorEntry entry(item, "space", source_);
        FloorSpace space;
        space.id = entry.id_or_empty("id");
        space.name = entry.text("name");
        space.face = faces.find(entry.id_or_empty("face_id"));
        if (const auto type = type_names_.find(entry.id_or_empty("space_type_id")); type != type_names_.end())
            space.type_name = type->second;
        const auto differs = [&](const char* key, double usual) {
            const auto own = entry.length(key, {-limits::height, limits::height});
            return own && *own != usual;
        };
        space.own_heights = differs("below_floor_plenum_height", story.plenum_below);
        space.own_heights |= differs("floor_to_ceiling_height", story.height);
        space.own_heights |= differs("above_ceiling_plenum_height", story.plenum_above);
        space.own_heights |= differs("floor_offset", 0);
        space.open_to_below = entry.flag("open_to_below");
        if (entry.find("pitched_roof_id") != nullptr) ++story.roofed_spaces;
        story.spaces.push_back(std::move(space));
    }

    void read_aperture(const JsonValue& item, bool door, FloorStory& story, const FloorIds& edges) {
        const FloorEntry entry(item, door ? "door" : "window", source_);
        FloorAperture aperture;
        aperture.door = door;
        aperture.id = entry.id_or_empty("id");
        aperture.name = entry.text("name");
        aperture.definition_id = entry.id_or_empty(door ? "door_definition_id" : "window_definition_id");
        if (aperture.definition_id.empty() && !door) aperture.definition_id = entry.id_or_empty("window_id");
        aperture.definition = (door ? door_ids_ : window_ids_)->find(aperture.definition_id);
        aperture.edge_id = entry.id_or_empty("edge_id");
        aperture.edge = edges.find(aperture.edge_id);
        if (const JsonValue* alpha = entry.find("alpha")) {
            aperture.alpha_list = alpha->array() != nullptr;
            if (!aperture.alpha_list) aperture.alphas.push_back(entry.number_of("alpha", *alpha, any_number));
            else
                for (const JsonValue& share : *alpha->array())
                    aperture.alphas.push_back(entry.number_of("alpha", share, any_number));
        }
        story.apertures.push_back(std::move(aperture));
    }

    const JsonValue& root_;
    JsonSource source_;
    bool asked_ = false;  ///< for a unit
    FloorFile file_;
    std::optional<FloorIds> window_ids_;
    std::optional<FloorIds> door_ids_;
    std::unordered_map<std::string, std::string> type_names_;
};

}  // namespace

FloorFile parse_floor_file(std::string_view text, const std::string& file_name, std::optional<Unit> unit) {
    const JsonValue root = parse_json(text, file_name);
    return FloorFileReader(root, file_name, unit).read();
}

}  // namespace enfilade::plans
