// Buildings cut into rectangles at random, written as FloorspaceJS files: every room and every door comes back.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "plans/layout.h"
#include "tests/plans/floorspace/floor_text.h"

namespace enfilade::plans {
namespace {

using testing::FloorText;

/// In half metres.
struct Cell {
    int x0, y0, x1, y1;
};

constexpr int least_side = 3;  ///< half metres

void cut(const Cell& cell, int depth, std::vector<Cell>& cells) {
    const bool across = cell.x1 - cell.x0 >= cell.y1 - cell.y0;
    const int low = across ? cell.x0 : cell.y0;
    const int high = across ? cell.x1 : cell.y1;
    if (depth == 0 || high - low < 2 * least_side || *rc::gen::weightedElement<bool>({{1, true}, {5, false}})) {
        cells.push_back(cell);
        return;
    }
    const int at = *rc::gen::inRange(low + least_side, high - least_side + 1);
    Cell first = cell;
    Cell second = cell;
    (across ? first.x1 : first.y1) = at;
    (across ? second.x0 : second.y0) = at;
    cut(first, depth - 1, cells);
    cut(second, depth - 1, cells);
}

std::vector<Cell> any_cells() {
    std::vector<Cell> cells;
    cut({0, 0, *rc::gen::inRange(least_side, 40), *rc::gen::inRange(least_side, 40)}, 6, cells);
    return cells;
}

/// Where the building lies: turned and moved.
struct Frame {
    double angle = 0;
    double x = 0;
    double y = 0;

    [[nodiscard]] std::pair<double, double> at(int i, int k) const {
        const double u = 0.5 * i;
        const double v = 0.5 * k;
        return {x + std::cos(angle) * u - std::sin(angle) * v, y + std::sin(angle) * u + std::cos(angle) * v};
    }
};

/// The corners of a cell, with those of others on its sides where `split`.
std::vector<std::pair<double, double>> ring(const Cell& cell, const std::vector<Cell>& cells, bool split,
                                            const Frame& frame) {
    std::set<std::pair<int, int>> corners;
    for (const Cell& c : cells)
        for (const int x : {c.x0, c.x1})
            for (const int y : {c.y0, c.y1}) corners.insert({x, y});
    std::vector<std::pair<double, double>> ring;
    const auto side = [&](int x0, int y0, int x1, int y1) {
        const int steps = std::max(std::abs(x1 - x0), std::abs(y1 - y0));
        for (int k = 0; k < steps; ++k) {
            const int x = x0 + (x1 - x0) / steps * k;
            const int y = y0 + (y1 - y0) / steps * k;
            if (k == 0 || (split && corners.contains({x, y}))) ring.push_back(frame.at(x, y));
        }
    };
    side(cell.x0, cell.y0, cell.x1, cell.y0);
    side(cell.x1, cell.y0, cell.x1, cell.y1);
    side(cell.x1, cell.y1, cell.x0, cell.y1);
    side(cell.x0, cell.y1, cell.x0, cell.y0);
    return ring;
}

std::vector<double> sorted_areas(const std::vector<Cell>& cells, double thickness) {
    std::vector<double> areas;
    for (const Cell& c : cells) areas.push_back((0.5 * (c.x1 - c.x0) - thickness) * (0.5 * (c.y1 - c.y0) - thickness));
    std::sort(areas.begin(), areas.end());
    return areas;
}

std::vector<double> found_areas(const Plan& plan) {
    std::vector<double> areas;
    const Layout layout = arrange(clean(plan));
    for (const FoundRoom& room : layout.storeys.at(0).rooms) {
        RC_ASSERT(!room.name.empty());
        areas.push_back(room.area_m2);
    }
    std::sort(areas.begin(), areas.end());
    return areas;
}

RC_GTEST_PROP(FloorspaceProperties, EveryRoomAndDoorComesBack, ()) {
    const std::vector<Cell> cells = any_cells();
    const bool split = *rc::gen::arbitrary<bool>();
    Frame frame;
    if (*rc::gen::arbitrary<bool>())
        frame = {*rc::gen::inRange(0, 6283) / 1000.0, *rc::gen::inRange(-1000, 1000) / 7.0,
                 *rc::gen::inRange(-1000, 1000) / 7.0};
    FloorText text;
    for (const Cell& cell : cells) text.space("room", ring(cell, cells, split, frame));
    const int doors = *rc::gen::inRange(0, 5);
    for (int k = 0; k < doors; ++k)
        text.door("d" + std::to_string(k), "door",
                  "e" + std::to_string(*rc::gen::inRange<std::size_t>(0, text.edges())),
                  std::to_string(*rc::gen::inRange(0, 101) / 100.0));
    ReadOptions options;
    options.wall_thickness = *rc::gen::element(0.05, 0.1, 0.2, 0.3);

    const Plan plan = testing::read_floor({text.story()}, options);
    RC_ASSERT(!has_errors(plan.findings));
    RC_ASSERT(plan.storeys[0].rooms.size() == cells.size());
    RC_ASSERT(plan.storeys[0].openings.size() == std::size_t(doors));
    RC_CLASSIFY(cells.size() > 8);
    const std::vector<double> expected = sorted_areas(cells, options.wall_thickness);
    const std::vector<double> found = found_areas(plan);
    RC_ASSERT(found.size() == expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) RC_ASSERT(std::abs(found[k] - expected[k]) < 0.02);
    const std::string json = write_json(plan);
    RC_ASSERT(write_json(read_json(json, "plan.json")) == json);
}

/// A wall by what is built of it, ends in order.
std::vector<std::array<double, 5>> wall_places(const Plan& plan) {
    std::vector<std::array<double, 5>> places;
    for (const Wall& wall : plan.storeys.at(0).walls) {
        const bool turned = std::pair(wall.end.x, wall.end.y) < std::pair(wall.start.x, wall.start.y);
        const Point a = turned ? wall.end : wall.start;
        const Point b = turned ? wall.start : wall.end;
        places.push_back({a.x, a.y, b.x, b.y, wall.thickness});
    }
    std::sort(places.begin(), places.end());
    return places;
}

RC_GTEST_PROP(FloorspaceProperties, TheOrderInTheFileChangesNothing, ()) {
    const std::vector<Cell> cells = any_cells();
    const bool split = *rc::gen::arbitrary<bool>();
    FloorText text;
    for (const Cell& cell : cells) text.space("room", ring(cell, cells, split, {}));
    text.window("w", "half", "e0", "0.5");
    text.door("d", "door", "e2", "0.5");
    const std::string members = "\"id\":\"g\",\"floor_to_ceiling_height\":3";
    const Plan forwards = testing::read_floor({text.story(members)});
    const Plan backwards = testing::read_floor({text.story(members, true)});
    RC_ASSERT(wall_places(forwards) == wall_places(backwards));
    RC_ASSERT(found_areas(forwards) == found_areas(backwards));
    RC_ASSERT(forwards.storeys[0].openings.size() == backwards.storeys[0].openings.size());
    RC_ASSERT(forwards.findings.size() == backwards.findings.size());
}

}  // namespace
}  // namespace enfilade::plans
