#include "modeler/furnishing/rules.h"

#include <algorithm>

#include "modeler/furnishing/embedded.h"
#include "modeler/furnishing/plain_words.h"

namespace enfilade::modeler {

std::string_view name_of(Relation relation) {
    switch (relation) {
        case Relation::AgainstWall: return "against_wall";
        case Relation::NearWindow: return "near_window";
        case Relation::Middle: return "middle";
        case Relation::Rows: return "rows";
        case Relation::OnWall: return "on_wall";
        case Relation::Ceiling: return "ceiling";
        case Relation::Beside: return "beside";
        case Relation::InFront: return "in_front";
        case Relation::Around: return "around";
        case Relation::OnTop: return "on_top";
        case Relation::Under: return "under";
        case Relation::Above: return "above";
        case Relation::Opposite: return "opposite";
        case Relation::InRow: return "in_row";
    }
    return "against_wall";
}

const RoomRules* Rules::find(std::string_view kind) const {
    const auto found = std::find_if(rooms.begin(), rooms.end(), [&](const RoomRules& r) { return r.kind == kind; });
    return found == rooms.end() ? nullptr : &*found;
}

const Rules& own_rules() {
    static const Rules rules = read_rules_text(embedded::own_rules, "the program's own rules");
    return rules;
}

namespace {

/// The room whose word fills most of the text: "garden room" is more than "room".
const RoomRules* named_in(const Rules& rules, const std::string& text) {
    const RoomRules* best = nullptr;
    std::size_t most = 0;
    for (const RoomRules& room : rules.rooms) {
        const auto take = [&](const std::string& name) {
            const std::string word = plain_words(name);
            if (word.size() <= most || !holds_words(text, word)) return;
            most = word.size();
            best = &room;
        };
        take(room.kind);
        for (const std::string& name : room.names) take(name);
    }
    return best;
}

}  // namespace

std::string room_kind(const Rules& rules, const std::string& kind, const std::string& name) {
    if (const RoomRules* room = named_in(rules, plain_words(name))) return room->kind;
    if (const RoomRules* room = named_in(rules, plain_words(kind))) return room->kind;
    return {};
}

}  // namespace enfilade::modeler
