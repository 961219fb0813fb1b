#include <cmath>

#include "tests/support/synthetic_scene.h"

namespace enfilade::test {
namespace {

using accel::Label;

constexpr double wall = 0.2, room_width = 4, room_depth = 5, corridor_width = 2, stair_length = 3;
constexpr double storey_height = 3, ceiling_height = 2.7, margin = 6, terrain = -0.25, sky_above_roof = 4;

/// Lays strips of plots from south to north.
class OfficeBuilder {
public:
    explicit OfficeBuilder(const SyntheticOptions& options) : options_(options) {
        roof_ = storey_height * options.storeys;
        width_ = wall + options.rooms_per_row * (room_width + wall);
    }

    std::vector<Plot> build() {
        double y = 0;
        y = wall_strip(y, Openings::Windows);
        for (int row = 0; row < options_.rows; row += 2) {
            y = room_row(y);
            y = wall_strip(y, Openings::Doors);
            y = corridor(y);
            const bool has_partner = row + 1 < options_.rows;
            if (has_partner) {
                y = wall_strip(y, Openings::Doors);
                y = room_row(y);
            }
            y = wall_strip(y, row + 2 < options_.rows || !has_partner ? Openings::None : Openings::Windows);
        }
        exterior(-margin, -margin, width_ + margin, 0);
        exterior(-margin, y, width_ + margin, y + margin);
        exterior(-margin, 0, 0, y);
        exterior(width_, 0, width_ + margin, y);
        return std::move(plots_);
    }

private:
    enum class Openings { None, Doors, Windows };

    void add(double x0, double y0, double x1, double y1, double z0, double z1, Label label, bool through = false) {
        Plot plot{grid(x0), grid(y0), grid(x1), grid(y1), {}};
        for (int k = 0; k < options_.storeys && z1 > z0; ++k) {
            const double base = storey_height * k;
            plot.layers.push_back({grid(base + z0), grid(base + z1), label, next_space_++});
            if (through && k + 1 < options_.storeys)
                plot.layers.push_back({grid(base + z1), grid(base + storey_height), label, next_space_++});
        }
        plot.layers.push_back({grid(roof_), grid(roof_ + sky_above_roof), Label::Exterior, 0});
        plots_.push_back(std::move(plot));
    }

    void solid(double x0, double y0, double x1, double y1) { add(x0, y0, x1, y1, 0, 0, Label::Wall); }

    void exterior(double x0, double y0, double x1, double y1) {
        Plot plot{grid(x0), grid(y0), grid(x1), grid(y1), {}};
        plot.layers.push_back({grid(terrain), grid(roof_ + sky_above_roof), Label::Exterior, 0});
        plots_.push_back(std::move(plot));
    }

    double wall_strip(double y, Openings openings) {
        const double next = y + wall;
        double x = 0;
        for (int i = 0; i < options_.rooms_per_row && openings != Openings::None && options_.doors; ++i) {
            const double middle = wall + i * (room_width + wall) + 0.5 * room_width;
            const double half = openings == Openings::Doors ? 0.45 : 0.75;
            solid(x, y, middle - half, next);
            if (openings == Openings::Doors) add(middle - half, y, middle + half, next, 0, 2.1, Label::Door);
            else add(middle - half, y, middle + half, next, 0.9, 2.1, Label::Window);
            x = middle + half;
        }
        solid(x, y, width_, next);
        return next;
    }

    double room_row(double y) {
        const double next = y + room_depth;
        for (int i = 0; i < options_.rooms_per_row; ++i) {
            const double x = i * (room_width + wall);
            solid(x, y, x + wall, next);
            add(x + wall, y, x + wall + room_width, next, 0, ceiling_height, Label::Room);
        }
        solid(width_ - wall, y, width_, next);
        return next;
    }

    double corridor(double y) {
        const double next = y + corridor_width;
        if (options_.doors) add(0, y, wall, next, 0, 2.1, Label::Door);
        else solid(0, y, wall, next);
        double x = wall;
        if (options_.storeys > 1) {
            add(x, y, x + stair_length, next, 0, ceiling_height, Label::Stair, true);
            x += stair_length;
        }
        add(x, y, width_ - wall, next, 0, ceiling_height, Label::Room);
        solid(width_ - wall, y, width_, next);
        return next;
    }

    SyntheticOptions options_;
    double roof_ = 0;
    double width_ = 0;
    std::uint32_t next_space_ = 1;
    std::vector<Plot> plots_;
};

}  // namespace

std::int32_t grid(double metres) { return static_cast<std::int32_t>(std::lround(metres * 8192)); }

std::vector<Plot> office_plots(const SyntheticOptions& options) { return OfficeBuilder(options).build(); }

accel::SceneInput synthetic_office(const SyntheticOptions& options) {
    return scene_from_plots(office_plots(options), options.turn);
}

accel::SceneInput synthetic_corridor(int count) {
    std::vector<Plot> plots;
    std::uint32_t space = 0;
    for (int i = 0; i < count; ++i) {
        const double x = 0.4 * (i - 0.5 * count);  // 10^4 of them still fit on the grid
        plots.push_back({grid(x), grid(-1), grid(x + 0.3), grid(1), {{0, grid(2.5), Label::Room, space++}}});
        if (i + 1 < count)
            plots.push_back(
                {grid(x + 0.3), grid(-0.5), grid(x + 0.4), grid(0.5), {{0, grid(2), Label::Door, space++}}});
    }
    return scene_from_plots(plots);
}

}  // namespace enfilade::test
