#include "modeler/furnishing/furnish.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "modeler/furnishing/furnish_room.h"
#include "modeler/furnishing/standing_pieces.h"
#include "modeler/place.h"

namespace enfilade::modeler {
namespace {

/// What becomes of one room, before objects have ids and meshes.
struct RoomOutcome {
    std::uint32_t space = 0;
    std::string kind;
    bool by_default = false;
    bool without_shape = false;
    RoomLayout layout;
    plans::GridFrame frame;
    std::array<double, 3> middle = {};
    double area_m2 = 0;
};

/// What a room is by what stands there; the first of these of which a room has a piece.
constexpr std::pair<std::string_view, std::string_view> room_of_piece[] = {
    {"bathtub", "bathroom"}, {"shower", "bathroom"},  {"toilet", "toilet"},        {"double_bed", "bedroom"},
    {"bed", "bedroom"},      {"bunk_bed", "bedroom"}, {"cot", "bedroom"},          {"sofa", "living"},
    {"stove", "kitchen"},    {"fridge", "kitchen"},   {"kitchen_sink", "kitchen"}, {"dining_table", "dining"},
    {"desk", "study"},
};

class Furnisher {
public:
    Furnisher(const Building& building, const Rules& rules, const Catalogue& catalogue, const FurnishOptions& options)
        : building_(building),
          rules_(rules),
          catalogue_(catalogue),
          options_(options),
          shapes_(building),
          entries_(catalogue.entries()),
          standing_(building, catalogue) {}

    Furnished run(const accel::Executor& executor) {
        std::vector<std::uint32_t> spaces = shapes_.spaces();
        if (!options_.spaces.empty()) {
            const std::set<std::uint32_t> wanted(options_.spaces.begin(), options_.spaces.end());
            std::erase_if(spaces, [&](std::uint32_t s) { return !wanted.contains(s); });
        }
        std::vector<RoomOutcome> rooms(spaces.size());
        accel::parallel_for(executor, spaces.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) rooms[k] = furnish(spaces[k]);
        });
        result_.furnishing = building_.furnishing;
        for (const FurnishedObject& object : result_.furnishing.objects) ids_.insert(object.id);
        load_meshes(rooms);
        for (const RoomOutcome& room : rooms) add(room);
        report_unknown_kinds();
        std::sort(result_.furnishing.objects.begin(), result_.furnishing.objects.end(),
                  [](const FurnishedObject& a, const FurnishedObject& b) { return a.id < b.id; });
        return std::move(result_);
    }

private:
    [[nodiscard]] RoomOutcome furnish(std::uint32_t space) const {
        RoomOutcome outcome;
        outcome.space = space;
        const Space& from = building_.spaces[space];
        outcome.kind = room_kind(rules_, from.kind, from.name);
        if (outcome.kind.empty() && from.label == Label::Room) outcome.kind = kind_by_pieces(space);
        outcome.by_default = outcome.kind.empty() && from.label == Label::Room;
        if (outcome.by_default) outcome.kind = "default";
        const RoomRules* rules = rules_.find(outcome.kind);
        const std::optional<RoomShape> shape = rules == nullptr ? std::nullopt : shapes_.shape(space);
        if (!shape) {
            if (rules == nullptr) outcome.kind.clear();
            else outcome.without_shape = true;
            return outcome;
        }
        outcome.frame = shape->frame;
        outcome.area_m2 = shape->area_m2;
        outcome.middle = {shape->frame.origin_x + shape->frame.unit * shape->middle.x,
                          shape->frame.origin_y + shape->frame.unit * shape->middle.y,
                          shape->frame.world_z(shape->z_floor)};
        outcome.layout =
            furnish_room(*shape, *rules, rules_.temperature, entries_, standing_.in(*shape), options_.seed);
        return outcome;
    }

    /// The kind of a room, among those of the rules, that the pieces of the plan tell; empty where they tell none.
    [[nodiscard]] std::string kind_by_pieces(std::uint32_t space) const {
        std::set<std::string, std::less<>> kinds;
        for (const FurnishedObject& object : building_.furnishing.objects)
            if (object.space == space)
                if (const CatalogueEntry* entry = catalogue_.find(object.model)) kinds.insert(entry->kind);
        for (const auto& [piece, room] : room_of_piece)
            if (kinds.contains(piece) && rules_.find(room) != nullptr) return std::string(room);
        return {};
    }

    /// Each used entry once, by ascending id; what cannot be read is reported and left out.
    void load_meshes(const std::vector<RoomOutcome>& rooms) {
        std::map<std::string, const CatalogueEntry*> used;
        for (const RoomOutcome& room : rooms)
            for (const RoomPiece& piece : room.layout.pieces) used.emplace(piece.entry->id, piece.entry);
        std::map<std::string, std::uint32_t> there;
        for (const FurnishedObject& object : result_.furnishing.objects) there.emplace(object.model, object.mesh);
        for (const auto& [id, entry] : used) {
            try {
                auto mesh = std::make_shared<const ObjectMesh>(catalogue_.load(*entry).mesh);
                const auto same = there.find(id);
                if (same != there.end() && *result_.furnishing.meshes[same->second] == *mesh) {
                    mesh_of_[id] = same->second;
                    continue;
                }
                mesh_of_[id] = std::uint32_t(result_.furnishing.meshes.size());
                result_.furnishing.meshes.push_back(std::move(mesh));
            } catch (const InputError& error) {
                Finding finding{.code = "U205", .severity = Severity::Warning};
                finding.sentence = "The model \"" + id +
                                   "\" cannot be read, so that its pieces are left out: " + std::string(error.what());
                finding.hint = "Mend the file, or take it out of the catalogue.";
                result_.findings.push_back(std::move(finding));
            }
        }
    }

    void add(const RoomOutcome& room) {
        RoomFurnished told;
        told.space = room.space;
        told.kind = room.kind;
        told.requested = room.layout.requested;
        std::map<std::string, std::uint32_t> numbers;
        std::vector<std::string> ids(room.layout.pieces.size());
        const std::string& prefix = building_.spaces[room.space].id;
        for (std::size_t k = 0; k < room.layout.pieces.size(); ++k) {
            const RoomPiece& piece = room.layout.pieces[k];
            if (!mesh_of_.contains(piece.entry->id)) continue;
            const std::string word = piece.entry->kind.empty() ? "piece" : piece.entry->kind;
            do ids[k] = prefix + "/" + word + "-" + std::to_string(++numbers[word]);
            while (!ids_.insert(ids[k]).second);
        }
        for (std::size_t k = 0; k < room.layout.pieces.size(); ++k) {
            const RoomPiece& piece = room.layout.pieces[k];
            if (ids[k].empty()) continue;
            // What stands on a piece that is left out goes with it.
            bool carried = true;
            for (std::uint32_t c = piece.carrier; c != UINT32_MAX; c = room.layout.pieces[c].carrier)
                carried = carried && !ids[c].empty();
            if (!carried) continue;
            FurnishedObject object;
            object.id = ids[k];
            object.name = piece.entry->name;
            object.model = piece.entry->id;
            object.mesh = mesh_of_.at(piece.entry->id);
            object.space = room.space;
            object.position = {room.frame.origin_x + room.frame.unit * piece.pose.at.x,
                               room.frame.origin_y + room.frame.unit * piece.pose.at.y,
                               room.frame.world_z(piece.z_low)};
            object.angle = piece.pose.angle;
            object.size = piece.size;
            object.by_rule = true;
            if (piece.carrier != UINT32_MAX) object.stands_on = ids[piece.carrier];
            result_.furnishing.objects.push_back(std::move(object));
            ++told.placed;
        }
        for (const std::string& kind : room.layout.no_place) told.not_placed.push_back(kind + ": no free place");
        for (const std::string& kind : room.layout.unknown) told.not_placed.push_back(kind + ": in no catalogue");
        report(room, told);
        result_.rooms.push_back(std::move(told));
    }

    void report(const RoomOutcome& room, const RoomFurnished& told) {
        for (const std::string& kind : room.layout.unknown) unknown_.insert(kind);
        const std::string title = modeler::title(building_.spaces[room.space]);
        const auto say = [&](const char* code, const std::string& sentence, const std::string& hint) {
            Finding finding{.code = code, .severity = Severity::Note};
            finding.sentence = sentence;
            finding.hint = hint;
            if (room.area_m2 > 0) finding.point = room.middle;
            place_at_space(building_, room.space, finding);
            result_.findings.push_back(std::move(finding));
        };
        if (room.kind.empty() && building_.spaces[room.space].label == Label::Room)
            return say("U204", "No rule tells how to furnish the " + title + ": it stays empty.",
                       "Name its kind in the rules, or give them a room \"default\".");
        if (room.by_default)
            say("U203", "The kind of the " + title + " is not known: it is furnished by the rules for \"default\".",
                "Name the room by its use, or add its name to the rules.");
        if (told.requested > 0 && told.placed == 0)
            return say("U201", "The " + title + " is too small for what its rules ask for: it stays empty.",
                       "Give it rules of its own, with smaller pieces.");
        if (room.layout.no_place.empty()) return;
        std::string kinds;
        for (const std::string& kind : room.layout.no_place) kinds += (kinds.empty() ? "" : ", ") + kind;
        say("U202", "The " + title + " has no free place for all that its rules ask for: " + kinds + ".",
            "Ask for less in the rules, or for smaller pieces.");
    }

    void report_unknown_kinds() {
        for (const std::string& kind : unknown_) {
            Finding finding{.code = "U206", .severity = Severity::Warning};
            finding.sentence = "The rules ask for \"" + kind + "\", which no catalogue has: it is left out.";
            finding.hint = "Add a catalogue that has it, or correct the word in the rules.";
            result_.findings.push_back(std::move(finding));
        }
    }

    const Building& building_;
    const Rules& rules_;
    const Catalogue& catalogue_;
    const FurnishOptions& options_;
    RoomShapes shapes_;
    EntryLists entries_;
    StandingPieces standing_;
    std::map<std::string, std::uint32_t> mesh_of_;
    std::set<std::string> ids_;
    std::set<std::string> unknown_;
    Furnished result_;
};

}  // namespace

Furnished furnish(const Building& building, const Rules& rules, const Catalogue& catalogue,
                  const FurnishOptions& options, const accel::Executor& executor) {
    return Furnisher(building, rules, catalogue, options).run(executor);
}

}  // namespace enfilade::modeler
