// One class draws one storey after the other on the skeleton of generate_floor.h.
#include "plans/generate.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/error.h"
#include "plans/colour.h"
#include "plans/generate_floor.h"
#include "plans/random.h"

namespace enfilade::plans {
namespace {

using office::Row;
using office::Skeleton;

constexpr double storey_height = 2.8;
constexpr double slab = 0.3;
constexpr double facade = 0.36;
constexpr double back_wall = 0.20;
constexpr double corridor_wall = 0.16;
constexpr double divider_wall = 0.12;
constexpr double door_width = 0.9;
constexpr double door_head = 2.1;
constexpr double passage_width = 1.6;
constexpr double corner_clearance = 0.35;  // from a wall's axis to the edge of an opening
constexpr double inset = 0.25;             // of a room's polygon from the wall axes

double to_mm(double metres) { return std::round(metres * 1000) / 1000; }
Point to_mm(Point p) { return {to_mm(p.x), to_mm(p.y)}; }

/// The wall between two neighbouring offices, drawn from the corridor to the back wall.
struct Divider {
    double at_corridor = 0;
    double at_back = 0;
    double bulge = 0;  ///< sagitta of an arc, towards +x; 0: straight

    /// x at the share `t` of the way to the back wall; a parabola stands for the arc (they differ by millimetres).
    [[nodiscard]] double x(double t) const {
        return at_corridor + (at_back - at_corridor) * t + 4 * bulge * t * (1 - t);
    }
};

/// One side of one corridor segment: `out` is +1 where its offices lie above the corridor, -1 below.
struct Side {
    std::uint32_t row;
    std::uint32_t segment;
    std::uint32_t number;
    double corridor_y;
    double back_y;
    bool has_windows;
    [[nodiscard]] double out() const { return back_y > corridor_y ? 1 : -1; }
    [[nodiscard]] double y(double t) const { return corridor_y + (back_y - corridor_y) * t; }
};

class StoreyBuilder {
public:
    StoreyBuilder(const GenerateOptions& options, const Skeleton& skeleton, std::uint32_t level, std::uint32_t rooms)
        : options_(options), skeleton_(skeleton), level_(level), rooms_(rooms) {
        const std::string number = std::to_string(level);
        storey_.id = "s" + number;
        storey_.name = level == 0 ? "Ground floor" : "Floor " + number;
        storey_.elevation = to_mm(level * (storey_height + slab));
        storey_.height = storey_height;
        storey_.slab_thickness = slab;
    }

    Storey build() {
        if (rooms_ == 1) {
            build_single_room();
            return std::move(storey_);
        }
        for (std::uint32_t r = 0; r < skeleton_.row_count(); ++r) build_row(r);
        for (std::uint32_t k = 0; k < skeleton_.spines; ++k) build_spine(k == 0);
        return std::move(storey_);
    }

private:
    [[nodiscard]] bool is_ground() const { return level_ == 0; }
    [[nodiscard]] bool has_storey_above() const { return level_ + 1 < options_.storeys; }

    /// Adds a wall and returns its index.
    std::size_t add_wall(Point a, Point b, double thickness, double arc_extent = 0) {
        Wall wall;
        wall.id = storey_.id + "-w" + std::to_string(storey_.walls.size() + 1);
        wall.start = to_mm(a);
        wall.end = to_mm(b);
        wall.arc_extent = arc_extent;
        wall.thickness = thickness;
        wall.height_at_start = wall.height_at_end = storey_height;
        storey_.walls.push_back(std::move(wall));
        return storey_.walls.size() - 1;
    }

    void add_opening(OpeningKind kind, std::size_t wall, double offset, double width, double sill, double head) {
        Opening opening;
        opening.id = storey_.id + "-o" + std::to_string(storey_.openings.size() + 1);
        opening.kind = kind;
        opening.wall = storey_.walls[wall].id;
        opening.offset = to_mm(offset);
        opening.width = to_mm(width);
        opening.sill = sill;
        opening.head = head;
        storey_.openings.push_back(std::move(opening));
    }
    void add_window(std::size_t wall, double offset, double room) {
        if (room < 1.6) return;
        add_opening(OpeningKind::Window, wall, offset, std::min(2.4, room - 1.2), 0.9, 2.3);
    }

    void add_room(const std::string& kind, const std::string& name, std::vector<Point> polygon,
                  std::uint32_t floor_rgb) {
        Room room;
        room.id = storey_.id + "-r" + std::to_string(storey_.rooms.size() + 1);
        room.name = name;
        room.kind = kind;
        for (const Point& p : polygon) room.polygon.push_back(to_mm(p));
        room.floor_colour = colour_from_rgb(floor_rgb);
        storey_.rooms.push_back(std::move(room));
    }
    void add_rectangle(const std::string& kind, const std::string& name, Point low, Point high,
                       std::uint32_t floor_rgb) {
        const Point a{low.x + inset, low.y + inset};
        const Point b{high.x - inset, high.y - inset};
        add_room(kind, name, {a, {b.x, a.y}, b, {a.x, b.y}}, floor_rgb);
    }

    void add_light(Point position, double lumen) {
        Light light;
        light.id = storey_.id + "-l" + std::to_string(storey_.lights.size() + 1);
        light.position = to_mm(position);
        light.elevation = storey_height - 0.1;
        light.power_lumen = lumen;
        storey_.lights.push_back(std::move(light));
    }

    void add_stair(Point low, Point high) {
        if (!has_storey_above()) return;
        Stair stair;
        stair.id = storey_.id + "-t" + std::to_string(storey_.stairs.size() + 1);
        stair.polygon = {to_mm(low), to_mm({high.x, low.y}), to_mm(high), to_mm({low.x, high.y})};
        storey_.stairs.push_back(std::move(stair));
    }

    std::string office_name(const char* what) {
        const std::string number = std::to_string(++office_number_);
        return std::string(what) + " " + std::to_string(level_) + "." +
               std::string(number.size() < 3 ? 3 - number.size() : 0, '0') + number;
    }

    void build_single_room() {
        const Point low{0, 0};
        const Point high{6, 5};
        const std::size_t south = add_wall(low, {high.x, low.y}, facade);
        add_wall({high.x, low.y}, high, facade);
        const std::size_t north = add_wall(high, {low.x, high.y}, facade);
        add_wall({low.x, high.y}, low, facade);
        if (is_ground()) add_opening(OpeningKind::Door, south, 1.2, door_width, 0, door_head);
        add_window(south, 4.2, 3);
        add_window(north, 3.0, 3);
        add_rectangle("office", office_name("Office"), low, high, 0xC9B79C);
        add_stair({0.6, 2.2}, {2.6, 4.4});
        add_light({3, 2.5}, 2000);
    }

    void build_row(std::uint32_t r) {
        const Row& row = skeleton_.rows[r];
        const std::uint32_t offices = rooms_ - skeleton_.corridor_count();
        for (std::uint32_t s = 0; s < skeleton_.segments; ++s) {
            const std::uint32_t lower = 2 * (r * skeleton_.segments + s);
            const bool row_above_shares = r + 1 < skeleton_.row_count() && skeleton_.rows[r + 1].shares_bottom;
            build_side({r, s, lower, row.corridor_low, row.bottom, !row.shares_bottom},
                       skeleton_.offices_on_side(lower, offices));
            build_side({r, s, lower + 1, row.corridor_high, row.top, !row_above_shares},
                       skeleton_.offices_on_side(lower + 1, offices));
            build_corridor(row, s);
        }
        build_cross_walls(r);
        if (skeleton_.court_above(r))
            add_rectangle("courtyard", "Courtyard", {0, row.top}, {skeleton_.length(), skeleton_.rows[r + 1].bottom},
                          0x7F8F6A);
    }

    void build_corridor(const Row& row, std::uint32_t s) {
        const Point low{skeleton_.x(s), row.corridor_low};
        const Point high{skeleton_.x(s + 1), row.corridor_high};
        add_rectangle("corridor", office_name("Corridor"), low, high, 0x9FA6AA);
        const double middle = (low.y + high.y) / 2;
        const int lamps = std::max(1, static_cast<int>((high.x - low.x) / 6));
        for (int k = 0; k < lamps; ++k) add_light({low.x + (high.x - low.x) * (k + 0.5) / lamps, middle}, 1200);
    }

    /// The walls across a row: its two ends, and between its corridor segments.
    void build_cross_walls(std::uint32_t r) {
        const Row& row = skeleton_.rows[r];
        const std::uint32_t offices = rooms_ - skeleton_.corridor_count();
        for (std::uint32_t s = 0; s <= skeleton_.segments; ++s) {
            const bool left_end = s == 0;
            const bool right_end = s == skeleton_.segments;
            const bool to_spine = (left_end && skeleton_.spines >= 1) || (right_end && skeleton_.spines == 2);
            const bool outer = (left_end || right_end) && !to_spine;
            const std::uint32_t side = 2 * (r * skeleton_.segments + std::min(s, skeleton_.segments - 1));
            const double low = skeleton_.offices_on_side(side, offices) == 0 ? row.corridor_low : row.bottom;
            const double x = skeleton_.x(s);
            const std::size_t wall = add_wall({x, low}, {x, row.top},
                                              outer      ? facade
                                              : to_spine ? back_wall
                                                         : corridor_wall);
            const double offset = (row.corridor_low + row.corridor_high) / 2 - low;
            if (!outer) add_opening(OpeningKind::Opening, wall, offset, passage_width, 0, door_head + 0.2);
            else if (left_end && r == 0 && is_ground())
                add_opening(OpeningKind::Door, wall, offset, 1.2, 0, door_head + 0.2);
            else add_opening(OpeningKind::Window, wall, offset, 1.2, 0.9, 2.3);
        }
    }

    void build_side(const Side& side, std::uint32_t count) {
        const Point begin{skeleton_.x(side.segment), side.corridor_y};
        const Point end{skeleton_.x(side.segment + 1), side.corridor_y};
        if (count == 0) {  // the corridor lies at the facade
            const std::size_t wall = add_wall(begin, end, facade);
            add_window(wall, (end.x - begin.x) / 2, end.x - begin.x);
            return;
        }
        const std::size_t corridor = add_wall(begin, end, corridor_wall);
        // A back wall between two rows belongs to both: the lower row draws it.
        const bool shared = side.out() < 0 && skeleton_.rows[side.row].shares_bottom;
        std::size_t back = 0;
        if (!shared)
            back = add_wall({begin.x, side.back_y}, {end.x, side.back_y}, side.has_windows ? facade : back_wall);
        const bool stairwell = side.out() > 0 && side.segment % 3 == 0 && side.row % 2 == 0 && options_.storeys > 1;
        const std::vector<Divider> dividers = divide(side, count, begin.x, end.x, stairwell);
        for (std::uint32_t k = 0; k < count; ++k) {
            const bool is_stairwell = stairwell && k == 0;
            build_office(side, dividers[k], dividers[k + 1], corridor, shared ? corridor : back, is_stairwell);
            if (k > 0) add_divider(side, dividers[k]);
        }
    }

    /// The `count + 1` boundaries of the offices of one side, from left to right.
    std::vector<Divider> divide(const Side& side, std::uint32_t count, double begin, double end, bool stairwell) {
        Random random{options_.seed, level_, side.number};
        std::vector<double> shares(count);
        for (double& share : shares) share = random.uniform(0.88, 1.12);
        if (count >= 3 && random.chance(0.4)) shares[1 + random.below(count - 1)] = 1.9;  // a meeting room
        double total = 0;
        const std::uint32_t first = stairwell && count > 1 ? 1 : 0;
        for (std::uint32_t k = first; k < count; ++k) total += shares[k];
        const double from = first == 1 ? begin + office::stair_slot : begin;
        std::vector<Divider> dividers(count + 1);
        dividers[0].at_corridor = dividers[0].at_back = begin;
        double x = from;
        for (std::uint32_t k = first; k <= count; ++k) {
            dividers[k].at_corridor = dividers[k].at_back = k == count ? end : x;
            if (k < count) x += (end - from) * shares[k] / total;
        }
        for (std::uint32_t k = first + 1; k < count; ++k) bend(dividers, k, random);
        return dividers;
    }

    /// Turns the divider into an arc or an oblique wall, as the options ask, so little that its neighbours keep their
    /// shape.
    void bend(std::vector<Divider>& dividers, std::uint32_t k, Random& random) const {
        const double choice = random.uniform();
        const double size = random.uniform(0.4, 1.0) * (random.chance(0.5) ? 1 : -1);
        const auto middle = [](const Divider& d) { return (d.at_corridor + d.at_back) / 2; };
        Divider& divider = dividers[k];
        const double room =
            std::min(middle(divider) - middle(dividers[k - 1]), middle(dividers[k + 1]) - middle(divider));
        if (choice < options_.curved) {
            divider.bulge = size * std::min(0.5, 0.16 * room);
        } else if (choice < options_.curved + options_.oblique) {
            divider.at_corridor -= size * 0.12 * room;
            divider.at_back += size * 0.12 * room;
        }
    }

    void add_divider(const Side& side, const Divider& d) {
        const Point corridor{d.at_corridor, side.corridor_y};
        const Point back{d.at_back, side.back_y};
        double extent = 0;
        if (d.bulge != 0) {
            // The sagitta is half the chord times tan(extent / 4); three terms of the arc tangent do, without libm.
            const double t = 2 * d.bulge / office::room_depth;
            extent = 4 * (t - t * t * t / 3 + t * t * t * t * t / 5) * side.out();
            extent = std::round(extent * 1e6) / 1e6;
        }
        add_wall(corridor, back, divider_wall, extent);
    }

    void build_office(const Side& side, const Divider& left, const Divider& right, std::size_t corridor,
                      std::size_t back, bool is_stairwell) {
        const double begin = skeleton_.x(side.segment);
        const double width = (right.at_corridor + right.at_back - left.at_corridor - left.at_back) / 2;
        const double out = side.out();
        Random random{options_.seed, level_, side.number,
                      static_cast<std::uint64_t>(std::llround(left.at_corridor * 1000)), 7};
        const double reach = corner_clearance + door_width / 2;
        const double low = left.at_corridor + reach;
        const double high = right.at_corridor - reach;
        const double door = is_stairwell ? low + 0.1 : random.uniform(low, high);
        add_opening(OpeningKind::Door, corridor, door - begin, door_width, 0, door_head);
        if (side.has_windows)
            add_window(back, (left.at_back + right.at_back) / 2 - begin, right.at_back - left.at_back);

        const double middle = (left.x(0.5) + right.x(0.5)) / 2;
        const bool meeting = width > 5.2;
        if (is_stairwell) {
            add_room("stairwell", office_name("Stairwell"), outline(side, left, right), 0x8C8C88);
            const double y1 = side.corridor_y + out * 1.8;
            const double y2 = side.corridor_y + out * 4.4;
            add_stair({begin + 0.5, std::min(y1, y2)}, {begin + 2.9, std::max(y1, y2)});
        } else {
            static constexpr std::uint32_t floors[] = {0xC9B79C, 0xB9C2C6, 0xC4B8A8, 0xA9B7A4};
            add_room(meeting ? "meeting" : "office", office_name(meeting ? "Meeting room" : "Office"),
                     outline(side, left, right), meeting ? 0x9C6B4A : floors[random.below(4)]);
            if (meeting) add_column({middle, side.y(0.6)});
        }
        add_light({middle + (meeting ? 1.0 : 0.0), side.y(0.5)}, meeting ? 4000 : 2400);
    }

    void add_column(Point centre) {
        constexpr double half = 0.18;
        Column column;
        column.id = storey_.id + "-c" + std::to_string(storey_.columns.size() + 1);
        column.polygon = {to_mm({centre.x - half, centre.y - half}), to_mm({centre.x + half, centre.y - half}),
                          to_mm({centre.x + half, centre.y + half}), to_mm({centre.x - half, centre.y + half})};
        storey_.columns.push_back(std::move(column));
    }

    /// The office's floor, clear of its walls, counter-clockwise.
    static std::vector<Point> outline(const Side& side, const Divider& left, const Divider& right) {
        std::vector<Point> points;
        const double y_in = inset / office::room_depth;
        const auto trace = [&](const Divider& d, double aside, bool outwards) {
            const int steps = d.bulge == 0 ? 1 : 8;
            for (int k = 0; k <= steps; ++k) {
                const double share = static_cast<double>(outwards ? k : steps - k) / steps;
                const double t = y_in + (1 - 2 * y_in) * share;
                points.push_back({d.x(t) + aside, side.y(t)});
            }
        };
        trace(right, -inset, side.out() > 0);
        trace(left, inset, side.out() < 0);
        return points;
    }

    /// A cross corridor along all rows: one room a row, so that none has many corners.
    void build_spine(bool at_left) {
        const double inner = at_left ? 0 : skeleton_.length();
        const double outer = at_left ? -office::spine_width : skeleton_.length() + office::spine_width;
        const double low_x = std::min(inner, outer);
        const double high_x = std::max(inner, outer);
        const std::uint32_t rows = skeleton_.row_count();
        for (std::uint32_t r = 0; r < rows; ++r) {
            const double bottom = skeleton_.rows[r].bottom;
            const double top = r + 1 < rows ? skeleton_.rows[r + 1].bottom : skeleton_.rows[r].top;
            const std::size_t partition = add_wall({low_x, bottom}, {high_x, bottom}, r == 0 ? facade : corridor_wall);
            const double middle = office::spine_width / 2;
            if (r > 0) add_opening(OpeningKind::Opening, partition, middle, passage_width, 0, door_head + 0.2);
            else if (at_left && is_ground()) add_opening(OpeningKind::Door, partition, middle, 1.2, 0, door_head + 0.2);
            else add_opening(OpeningKind::Window, partition, middle, 1.2, 0.9, 2.3);
            const std::size_t facade_wall = add_wall({outer, bottom}, {outer, top}, facade);
            for (double at = 2.5; at + 2.5 < top - bottom; at += 4.5) add_window(facade_wall, at, 3);
            if (skeleton_.court_above(r)) {
                const double row_top = skeleton_.rows[r].top;
                const std::size_t wall = add_wall({inner, row_top}, {inner, top}, facade);
                add_window(wall, (top - row_top) / 2, 4);
                if (at_left && is_ground()) add_opening(OpeningKind::Door, wall, 1.2, door_width, 0, door_head);
            }
            add_rectangle("corridor", office_name("Corridor"), {low_x, bottom}, {high_x, top}, 0x9FA6AA);
            add_light({(low_x + high_x) / 2, bottom + (top - bottom) * 0.25}, 1200);
            add_light({(low_x + high_x) / 2, bottom + (top - bottom) * 0.75}, 1200);
        }
        add_wall({low_x, skeleton_.rows.back().top}, {high_x, skeleton_.rows.back().top}, facade);
    }

    const GenerateOptions& options_;
    const Skeleton& skeleton_;
    std::uint32_t level_;
    std::uint32_t rooms_;
    std::uint32_t office_number_ = 0;
    Storey storey_;
};

void check_options(const GenerateOptions& options) {
    const auto refuse = [](const std::string& sentence) { throw InputError("P110", "", sentence); };
    if (options.storeys < 1) refuse("A building needs at least one storey.");
    if (options.rooms < options.storeys) refuse("A building needs at least one room on each storey.");
    if (options.rooms > 10000000) refuse("At most 10 million rooms can be generated.");
    const bool shares = options.curved >= 0 && options.oblique >= 0 && options.curved + options.oblique <= 1;
    if (!shares) refuse("The shares of curved and of oblique walls must not be negative, nor more than 1 together.");
}

}  // namespace

Plan generate(const GenerateOptions& options) {
    check_options(options);
    const std::uint32_t most = (options.rooms + options.storeys - 1) / options.storeys;
    const Skeleton skeleton = most >= 2 ? office::plan_skeleton(most) : Skeleton{};
    Plan plan;
    plan.name = "Office of " + std::to_string(options.rooms) + " rooms";
    for (std::uint32_t level = 0; level < options.storeys; ++level) {
        const std::uint32_t rooms = options.rooms / options.storeys + (level < options.rooms % options.storeys ? 1 : 0);
        plan.storeys.push_back(StoreyBuilder(options, skeleton, level, rooms).build());
    }
    return plan;
}

}  // namespace enfilade::plans
