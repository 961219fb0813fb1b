#include "plans/dxf/room_names.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "plans/layout.h"
#include "plans/read.h"
#include "plans/sweet_home/words.h"

namespace enfilade::plans {
namespace {

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
}

/// Words of which names of rooms are made, folded: they tell names from the notes that stand among them.
constexpr std::array room_words = {
    "room",    "bed",        "bath",       "kitchen",    "living",   "dining",   "hall",       "entry",     "entrance",
    "closet",  "w.i.c",      "garage",     "util",       "laundr",   "pantry",   "porch",      "deck",      "patio",
    "office",  "toil",       "wc",         "shower",     "stor",     "corridor", "lobby",      "foyer",     "study",
    "den",     "cellar",     "basement",   "balcony",    "terrace",  "lounge",   "lift",       "master",    "nursery",
    "meeting", "conference", "reception",  "kuche",      "kueche",   "bad",      "zimmer",     "flur",      "diele",
    "raum",    "buro",       "buero",      "keller",     "abstell",  "wohn",     "schlaf",     "kind",      "esszimmer",
    "cuisine", "sejour",     "salon",      "chambre",    "salle",    "couloir",  "bureau",     "entree",    "cellier",
    "cocina",  "bano",       "dormitorio", "habitacion", "sala",     "comedor",  "pasillo",    "cucina",    "bagno",
    "camera",  "soggiorno",  "ingresso",   "corridoio",  "keuken",   "badkamer", "slaapkamer", "woonkamer", "gang",
    "cozinha", "banheiro",   "quarto",     "kuchnia",    "lazienka", "pokoj",    "korytarz",   "кухн",      "комнат",
    "ванн",    "коридор",    "спальн",     "厨房",       "卫",       "卧",       "厅",         "室",        "courtyard",
    "hof",
};

/// Names of places that walls enclose and no roof covers.
constexpr std::array courtyard_words = {"courtyard", "light well", "lightwell", "innenhof",    "lichthof",
                                        "cour",      "patio",      "cortile",   "dziedziniec", "внутренний двор",
                                        "天井",      "庭院"};

std::string kind_of_room(const std::string& name) {
    const std::string plain = folded(name);
    for (const std::string_view word : courtyard_words) {
        const std::size_t at = plain.find(word);
        if (at == std::string::npos) continue;
        const std::size_t after = at + word.size();
        if ((at == 0 || !is_letter(plain[at - 1])) && (after == plain.size() || !is_letter(plain[after])))
            return "courtyard";
    }
    return room_kind(name);
}

bool names_a_room(const std::string& text) {
    const std::string plain = folded(text);
    return std::any_of(room_words.begin(), room_words.end(), [&](const char* word) {
        const std::size_t at = plain.find(word);
        return at != std::string::npos && (at == 0 || !is_letter(plain[at - 1]) || !is_letter(word[0]));
    });
}

/// "Bedroom 2", "Office 0.105", "Bath/WC", "W.I.C.", "WC", "书房"; not "13'8 x 14'", "2668", "GFCI 220V", "UP", "R",
/// nor a sentence.
bool reads_like_a_name(const std::string& text) {
    const bool usual = names_a_room(text);
    std::size_t letters = 0, digits = 0, words = 1;
    for (const char c : text) {
        letters += is_letter(c);
        digits += c >= '0' && c <= '9';
        words += c == ' ';
        if (c == '"' || c == '=' || c == '@' || (c == '/' && !usual) || c == ':' || c == '%') return false;
    }
    return (letters >= 3 || usual) && (usual ? letters >= digits : letters > 2 * digits) && text.size() <= 30 &&
           words <= 4 && !text.starts_with("www");
}

struct Line {
    std::string text;
    Point at;
    double height;
    std::uint32_t layer;
};

/// MTEXT holds several lines: each stands a little lower than the one before.
std::vector<Line> lines_of(const Drawing& drawing, const Roles& roles, double scale) {
    const bool has_name_layer = std::any_of(drawing.texts.begin(), drawing.texts.end(), [&](const DrawingText& text) {
        return roles.layer[text.layer] == Role::RoomName;
    });
    std::vector<Line> lines;
    for (const DrawingText& text : drawing.texts) {
        if (has_name_layer && roles.layer[text.layer] != Role::RoomName) continue;
        double drop = 0;
        for (std::size_t begin = 0; begin <= text.text.size();) {
            const std::size_t end = std::min(text.text.find('\n', begin), text.text.size());
            std::string line = text.text.substr(begin, end - begin);
            while (!line.empty() && line.back() == ' ') line.pop_back();
            if (reads_like_a_name(line))
                lines.push_back({line, Point{text.at.x, text.at.y - drop}, text.height, text.layer});
            drop += 1.6 * text.height;
            begin = end + 1;
        }
    }
    for (Line& line : lines) line.at = {line.at.x * scale, line.at.y * scale}, line.height *= scale;
    std::stable_sort(lines.begin(), lines.end(),
                     [](const Line& l, const Line& r) { return l.at.y != r.at.y ? l.at.y > r.at.y : l.at.x < r.at.x; });
    return lines;
}

/// Where a room's outline lies, from the half-edges of the layout.
struct RoomOutline {
    std::uint32_t room = 0;
    std::vector<Point> outer;                       ///< counter-clockwise
    std::vector<std::pair<Point, Point>> boundary;  ///< all rings
};

std::vector<RoomOutline> room_outlines(const Layout& layout, std::size_t storey) {
    const StoreyLayout& here = layout.storeys[storey];
    std::vector<RoomOutline> outlines(here.rooms.size());
    std::vector<bool> seen(2 * layout.graph.edges.size(), false);
    const auto room_of = [&](std::uint32_t h) -> std::uint32_t {
        const Owner& owner = here.owner[layout.map.face(h)];
        return owner.kind == OwnerKind::Room ? owner.element : UINT32_MAX;
    };
    const auto point = [&](std::uint32_t h) {
        const GridPoint p = layout.graph.vertices[origin(layout.graph, h)];
        return Point{layout.frame.world_x(p.x), layout.frame.world_y(p.y)};
    };
    for (std::uint32_t start = 0; start < seen.size(); ++start) {
        const std::uint32_t room = room_of(start);
        if (seen[start] || room == UINT32_MAX || room_of(start ^ 1) == room) continue;
        // Along the room's own border: edges of other storeys inside it are stepped over.
        std::vector<Point> ring;
        double area2 = 0;
        std::uint32_t h = start;
        do {
            seen[h] = true;
            ring.push_back(point(h));
            const Point a = point(h), b = point(h ^ 1);
            area2 += a.x * b.y - a.y * b.x;
            outlines[room].boundary.emplace_back(a, b);
            h = layout.map.next[h];
            while (room_of(h ^ 1) == room) h = layout.map.next[h ^ 1];
        } while (h != start && ring.size() <= seen.size());
        outlines[room].room = room;
        if (area2 > 0 && ring.size() > outlines[room].outer.size()) outlines[room].outer = std::move(ring);
    }
    return outlines;
}

bool holds(const RoomOutline& outline, Point p) {
    bool inside = false;
    for (const auto& [a, b] : outline.boundary) {
        if ((a.y > p.y) == (b.y > p.y)) continue;
        if (p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
    }
    return inside;
}

}  // namespace

std::vector<PlaceName> place_names(const Drawing& drawing, const Roles& roles, double scale) {
    std::vector<PlaceName> names;
    std::vector<Point> last;  // the lowest line of each name
    for (const Line& line : lines_of(drawing, roles, scale)) {
        std::size_t k = 0;
        for (; k < names.size(); ++k)
            if (last[k].y > line.at.y && last[k].y - line.at.y < 2.2 * line.height &&
                std::abs(last[k].x - line.at.x) < 6 * line.height)
                break;
        if (k < names.size() && names[k].text.size() + line.text.size() < 40) {
            names[k].text += ' ' + line.text;
            names[k].certain = names[k].certain || names_a_room(names[k].text);
            last[k] = line.at;
            continue;
        }
        // The text's middle rather than its corner: names begin near walls.
        const double width = 0.35 * line.height * double(std::min<std::size_t>(line.text.size(), 12));
        const bool certain = roles.layer[line.layer] == Role::RoomName || names_a_room(line.text);
        names.push_back({line.text, {line.at.x + width, line.at.y + line.height / 2}, line.height, certain});
        last.push_back(line.at);
    }
    return names;
}

std::uint32_t name_rooms(const std::vector<PlaceName>& names, Plan& plan) {
    if (names.empty() || plan.storeys.empty() || plan.storeys[0].walls.empty()) return std::uint32_t(names.size());
    Plan cleaned = clean(plan);
    if (cleaned.storeys.empty()) return std::uint32_t(names.size());
    const Layout layout = arrange(cleaned);
    const std::vector<RoomOutline> outlines = room_outlines(layout, 0);
    std::vector<std::string> texts(outlines.size());
    // Where any text of the sheet is a name for certain, the others are notes.
    const bool any_certain = std::any_of(names.begin(), names.end(), [](const PlaceName& n) { return n.certain; });
    std::uint32_t outside = 0;
    for (const PlaceName& name : names) {
        if (any_certain && !name.certain) continue;
        const auto room =
            std::find_if(outlines.begin(), outlines.end(), [&](const RoomOutline& o) { return holds(o, name.at); });
        if (room == outlines.end()) {
            ++outside;
            continue;
        }
        std::string& text = texts[std::size_t(room - outlines.begin())];
        if (text.find(name.text) != std::string::npos || text.size() > 60) continue;
        text += (text.empty() ? "" : " / ") + name.text;
    }
    for (std::size_t k = 0; k < outlines.size(); ++k) {
        if (texts[k].empty() || outlines[k].outer.size() < 3) continue;
        Room room;
        room.id = "room-" + std::to_string(plan.storeys[0].rooms.size() + 1);
        room.name = texts[k];
        room.kind = kind_of_room(room.name);
        room.polygon = outlines[k].outer;
        plan.storeys[0].rooms.push_back(std::move(room));
    }
    return outside;
}

}  // namespace enfilade::plans
