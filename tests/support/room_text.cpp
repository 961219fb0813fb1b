#include "tests/support/room_text.h"

#include <istream>
#include <ostream>
#include <sstream>

namespace enfilade::testing {

void write_room(std::ostream& out, const Room& room) {
    for (const plans::GridPoint p : room.points) out << p.x << ' ' << p.y << '\n';
    out << '\n';
    for (const modeler::PolygonSide& s : room.sides)
        out << s.from << ' ' << s.to << ' ' << s.line << ' ' << s.tag << ' ' << s.look << ' ' << s.faces << '\n';
}

Room read_room(std::istream& in) {
    Room room;
    std::string line;
    bool at_sides = false;
    while (std::getline(in, line)) {
        if (line.starts_with('#')) continue;
        std::istringstream words(line);
        if (line.empty()) {
            at_sides = true;
        } else if (at_sides) {
            modeler::PolygonSide side;
            words >> side.from >> side.to >> side.line >> side.tag >> side.look >> side.faces;
            room.sides.push_back(side);
        } else {
            plans::GridPoint point;
            words >> point.x >> point.y;
            room.points.push_back(point);
        }
    }
    return room;
}

std::string source_of(const Room& room) {
    std::ostringstream out;
    out << "room.points = {";
    for (const plans::GridPoint p : room.points) out << '{' << p.x << ", " << p.y << "}, ";
    out << "};\nroom.sides = {";
    for (const modeler::PolygonSide& s : room.sides)
        out << '{' << s.from << ", " << s.to << ", " << s.line << ", " << s.tag << "}, ";
    out << "};\n";
    return out.str();
}

}  // namespace enfilade::testing
