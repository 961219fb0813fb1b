#include "modeler/exports/wall_views.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include "modeler/exports/part_sides.h"
#include "modeler/outline.h"

namespace enfilade::modeler {

namespace {

using Point2 = std::array<double, 2>;
constexpr std::uint32_t no_index = UINT32_MAX;
constexpr double least = 0.001;           ///< metres: narrower stretches are rounding's
constexpr std::size_t most_openings = 4;  ///< one behind the other
constexpr double bucket = 2.0;            ///< metres: edge of the squares in which borders are looked up

/// A stretch over which a part with light, or the earth, ends at something solid.
struct Border {
    Point2 a, b;  ///< the open side on the left
    double z_low, z_high;
    std::uint32_t side;
};

/// What one place of a side shows.
struct View {
    Across across = Across::Nothing;
    bool is_air = false;
    std::uint32_t part = no_index;
    std::uint32_t side = no_index;
    std::uint32_t opening = no_index;  ///< part
    [[nodiscard]] bool like(const View& o) const {
        return across == o.across && is_air == o.is_air && part == o.part && side == o.side;
    }
};

struct Run {
    View view;
    double z_low, z_high;
    [[nodiscard]] bool like(const Run& o) const { return view.like(o.view) && z_low == o.z_low && z_high == o.z_high; }
};

class Viewer {
public:
    Viewer(const Building& building, const std::vector<SpacePart>& parts, double most_thickness)
        : building_(building),
          parts_(parts),
          most_thickness_(most_thickness),
          part_of_(building.volumes.size(), no_index) {
        for (std::uint32_t p = 0; p < parts.size(); ++p)
            for (const std::uint32_t v : parts[p].volumes) part_of_[v] = p;
    }

    WallViews run() {
        const PartSides part_sides(building_);
        for (std::uint32_t p = 0; p < parts_.size(); ++p) {
            const Label label = label_of(p);
            if (!accel::carries_light(label) && label != Label::Ground) continue;
            for (const RingSides& ring : part_sides.of(parts_[p]))
                for (const StraightSide& side : ring.sides) add_side(p, side);
        }
        for (std::uint32_t s = 0; s < result_.sides.size(); ++s)
            if (is_room(building_, parts_[result_.sides[s].part])) view_side(s);
        return std::move(result_);
    }

private:
    static bool is_hole(Label label) {
        return label == Label::Door || label == Label::Window || label == Label::Opening;
    }
    Label label_of(std::uint32_t part) const { return building_.spaces[parts_[part].space].label; }
    Point2 metres(std::uint32_t point) const {
        const double unit = building_.frame.unit;
        return {building_.points[point].x * unit, building_.points[point].y * unit};
    }
    double metres_z(std::int32_t z) const { return z * building_.frame.unit; }

    void add_side(std::uint32_t p, const StraightSide& side) {
        const auto s = std::uint32_t(result_.sides.size());
        result_.sides.push_back({p,
                                 metres(start_of(building_, side.strips.front().half_edge)),
                                 metres(start_of(building_, side.strips.back().half_edge ^ 1)),
                                 {}});
        strips_.push_back(side.strips);
        for (const SideStrip& strip : side.strips)
            for (const SideInterval& interval : strip.intervals) {
                const Label behind = building_.volumes[interval.behind].label;
                if (is_hole(behind)) {
                    auto& list = around_[part_of_[interval.behind]];
                    if (list.empty() || list.back() != s) list.push_back(s);
                } else if (behind == Label::Wall || behind == Label::Slab) {
                    add_border({metres(start_of(building_, strip.half_edge)),
                                metres(start_of(building_, strip.half_edge ^ 1)), metres_z(interval.z_low),
                                metres_z(interval.z_high), s});
                }
            }
    }

    static std::uint64_t key(std::int64_t x, std::int64_t y) {
        return std::uint64_t(x) << 32 ^ std::uint64_t(std::uint32_t(y));
    }
    template <class Visit>
    static void for_each_bucket(const Point2& low, const Point2& high, Visit visit) {
        for (auto x = std::int64_t(std::floor(low[0] / bucket)); x <= std::int64_t(std::floor(high[0] / bucket)); ++x)
            for (auto y = std::int64_t(std::floor(low[1] / bucket)); y <= std::int64_t(std::floor(high[1] / bucket));
                 ++y)
                visit(key(x, y));
    }
    void add_border(const Border& border) {
        const auto number = std::uint32_t(borders_.size());
        borders_.push_back(border);
        const Point2 low = {std::min(border.a[0], border.b[0]), std::min(border.a[1], border.b[1])};
        const Point2 high = {std::max(border.a[0], border.b[0]), std::max(border.a[1], border.b[1])};
        for_each_bucket(low, high, [&](std::uint64_t at) { buckets_[at].push_back(number); });
    }

    /// A border as a side sees it: over [u_low, u_high], at distances v.
    struct Candidate {
        double u_low, u_high, v_low, v_high;
        const Border* border;
        [[nodiscard]] double v(double u) const { return v_low + (v_high - v_low) * (u - u_low) / (u_high - u_low); }
    };

    void view_side(std::uint32_t s) {
        ViewedSide& side = result_.sides[s];
        const double length = std::hypot(side.to[0] - side.from[0], side.to[1] - side.from[1]);
        if (!(length > 0)) return;
        const Point2 d = {(side.to[0] - side.from[0]) / length, (side.to[1] - side.from[1]) / length};
        const std::vector<Candidate> candidates = candidates_of(side, d, length);
        std::vector<double> us = {0, length}, zs;
        std::vector<double> ends;  // of the strips
        for (const SideStrip& strip : strips_[s]) {
            const Point2 p = metres(start_of(building_, strip.half_edge ^ 1));
            ends.push_back((p[0] - side.from[0]) * d[0] + (p[1] - side.from[1]) * d[1]);
            us.push_back(ends.back());
            for (const SideInterval& interval : strip.intervals) {
                zs.push_back(metres_z(interval.z_low));
                zs.push_back(metres_z(interval.z_high));
            }
        }
        ends.back() = length;
        const auto z_range = std::minmax_element(zs.begin(), zs.end());
        const double bottom = *z_range.first, top = *z_range.second;
        for (const Candidate& candidate : candidates) {
            us.push_back(std::clamp(candidate.u_low, 0.0, length));
            us.push_back(std::clamp(candidate.u_high, 0.0, length));
            zs.push_back(std::clamp(candidate.border->z_low, bottom, top));
            zs.push_back(std::clamp(candidate.border->z_high, bottom, top));
        }
        thin(us);
        thin(zs);
        std::vector<std::vector<Run>> columns;
        std::vector<WallOpening> openings;
        for (std::size_t i = 0; i + 1 < us.size(); ++i) {
            const double u = (us[i] + us[i + 1]) / 2;
            const auto strip = std::size_t(std::lower_bound(ends.begin(), ends.end() - 1, u) - ends.begin());
            std::vector<Run> column;
            for (std::size_t j = 0; j + 1 < zs.size(); ++j) {
                const View view = view_at(s, strips_[s][strip], candidates, u, (zs[j] + zs[j + 1]) / 2);
                if (view.opening != no_index) add_opening({view.opening, us[i], us[i + 1], zs[j], zs[j + 1]}, openings);
                if (!column.empty() && column.back().view.like(view)) column.back().z_high = zs[j + 1];
                else column.push_back({view, zs[j], zs[j + 1]});
            }
            columns.push_back(std::move(column));
        }
        add_tiles(columns, us, openings, side);
    }

    std::vector<Candidate> candidates_of(const ViewedSide& side, const Point2& d, double length) const {
        const Point2 n = {d[1], -d[0]};  // outward
        Point2 low = side.from, high = side.from;
        for (const double u : {0.0, length})
            for (const double v : {0.0, most_thickness_})
                for (std::size_t axis = 0; axis < 2; ++axis) {
                    const double at = side.from[axis] + u * d[axis] + v * n[axis];
                    low[axis] = std::min(low[axis], at), high[axis] = std::max(high[axis], at);
                }
        std::vector<std::uint32_t> near;
        for_each_bucket(low, high, [&](std::uint64_t at) {
            if (const auto found = buckets_.find(at); found != buckets_.end())
                near.insert(near.end(), found->second.begin(), found->second.end());
        });
        std::sort(near.begin(), near.end());
        near.erase(std::unique(near.begin(), near.end()), near.end());
        std::vector<Candidate> candidates;
        for (const std::uint32_t number : near) {
            const Border& border = borders_[number];
            const auto u = [&](const Point2& p) { return (p[0] - side.from[0]) * d[0] + (p[1] - side.from[1]) * d[1]; };
            const auto v = [&](const Point2& p) { return (p[0] - side.from[0]) * n[0] + (p[1] - side.from[1]) * n[1]; };
            // Those that are turned to the side run against it.
            const Candidate candidate{u(border.b), u(border.a), v(border.b), v(border.a), &border};
            if (candidate.u_high - candidate.u_low < least || candidate.u_high < least ||
                candidate.u_low > length - least)
                continue;
            if (std::max(candidate.v_low, candidate.v_high) < least) continue;
            candidates.push_back(candidate);
        }
        return candidates;
    }

    /// Sorted, without numbers less than a millimetre after the one before; the last one stays.
    static void thin(std::vector<double>& values) {
        std::sort(values.begin(), values.end());
        const double last = values.back();
        std::vector<double> kept;
        for (const double value : values)
            if (kept.empty() || value - kept.back() >= least) kept.push_back(value);
        if (kept.size() > 1 && last - kept.back() < least && kept.back() != last) kept.back() = last;
        values = std::move(kept);
    }

    View view_at(std::uint32_t s, const SideStrip& strip, const std::vector<Candidate>& candidates, double u,
                 double z) const {
        const auto interval = std::find_if(strip.intervals.begin(), strip.intervals.end(),
                                           [&](const SideInterval& i) { return z < metres_z(i.z_high); });
        const std::uint32_t behind =
            interval == strip.intervals.end() ? strip.intervals.back().behind : interval->behind;
        switch (building_.volumes[behind].label) {
            case Label::Door:
            case Label::Window:
            case Label::Opening: return view_through(s, part_of_[behind]);
            case Label::Wall:
            case Label::Slab: break;
            default: return view_of(part_of_[behind], no_index, true);
        }
        const Candidate* nearest = nullptr;
        for (const Candidate& candidate : candidates) {
            if (u < candidate.u_low || u > candidate.u_high) continue;
            if (z < candidate.border->z_low || z > candidate.border->z_high) continue;
            const double v = candidate.v(u);
            if (v >= least && v <= most_thickness_ && (!nearest || v < nearest->v(u))) nearest = &candidate;
        }
        if (!nearest) return {};
        const std::uint32_t side = nearest->border->side;
        return view_of(result_.sides[side].part, side, false);
    }

    View view_of(std::uint32_t part, std::uint32_t side, bool is_air) const {
        switch (label_of(part)) {
            case Label::Exterior: return {Across::Outdoors, false, no_index, no_index, no_index};
            case Label::Ground: return {Across::Ground, false, no_index, no_index, no_index};
            default: break;
        }
        if (!is_room(building_, parts_[part])) return {};
        return {Across::Part, is_air, part, side, no_index};
    }

    /// Through a door or window, and what lies behind it in walls that lie against each other, to the side that is most
    /// turned to this one.
    View view_through(std::uint32_t s, std::uint32_t opening) const {
        const auto direction = [&](std::uint32_t side) {
            const ViewedSide& viewed = result_.sides[side];
            return std::atan2(viewed.to[1] - viewed.from[1], viewed.to[0] - viewed.from[0]);
        };
        std::vector<std::uint32_t> passed = {result_.sides[s].part};
        bool is_air = true;
        for (std::uint32_t part = opening; passed.size() <= most_openings;) {
            passed.push_back(part);
            is_air = is_air && label_of(part) == Label::Opening;
            std::uint32_t best = no_index;
            double least_cosine = 0;
            for (const std::uint32_t side : around_.at(part)) {
                if (std::find(passed.begin() + 1, passed.end(), result_.sides[side].part) != passed.end()) continue;
                const double cosine = std::cos(direction(side) - direction(s));
                if (side != s && cosine < least_cosine) best = side, least_cosine = cosine;
            }
            if (best == no_index) return {};
            part = result_.sides[best].part;
            if (is_hole(label_of(part))) continue;
            View view = view_of(part, best, is_air);
            if (view.across != Across::Nothing && !view.is_air) view.opening = opening;
            return view;
        }
        return {};
    }

    static void add_opening(const WallOpening& piece, std::vector<WallOpening>& openings) {
        for (WallOpening& opening : openings)
            if (opening.part == piece.part) {
                opening.u_low = std::min(opening.u_low, piece.u_low),
                opening.u_high = std::max(opening.u_high, piece.u_high);
                opening.z_low = std::min(opening.z_low, piece.z_low),
                opening.z_high = std::max(opening.z_high, piece.z_high);
                return;
            }
        openings.push_back(piece);
    }

    /// Columns with the same runs are one; each run is a tile.
    static void add_tiles(const std::vector<std::vector<Run>>& columns, const std::vector<double>& us,
                          const std::vector<WallOpening>& openings, ViewedSide& side) {
        for (std::size_t i = 0; i < columns.size();) {
            std::size_t end = i + 1;
            const auto alike = [&](const std::vector<Run>& a, const std::vector<Run>& b) {
                return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                                  [](const Run& x, const Run& y) { return x.like(y); });
            };
            while (end < columns.size() && alike(columns[i], columns[end])) ++end;
            for (const Run& run : columns[i]) {
                WallTile tile{run.view.across, run.view.is_air, run.view.part,
                              run.view.side,   us[i],           us[end],
                              run.z_low,       run.z_high,      {}};
                for (const WallOpening& opening : openings) {
                    const WallOpening inside{opening.part, std::max(opening.u_low, tile.u_low),
                                             std::min(opening.u_high, tile.u_high), std::max(opening.z_low, tile.z_low),
                                             std::min(opening.z_high, tile.z_high)};
                    if (!tile.is_air && inside.u_high - inside.u_low > least && inside.z_high - inside.z_low > least)
                        tile.openings.push_back(inside);
                }
                side.tiles.push_back(std::move(tile));
            }
            i = end;
        }
    }

    const Building& building_;
    const std::vector<SpacePart>& parts_;
    double most_thickness_;
    std::vector<std::uint32_t> part_of_;                          ///< [volume]
    std::vector<std::vector<SideStrip>> strips_;                  ///< [side]
    std::map<std::uint32_t, std::vector<std::uint32_t>> around_;  ///< sides at each door or window, by its part
    std::vector<Border> borders_;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> buckets_;
    WallViews result_;
};

}  // namespace

bool is_room(const Building& building, const SpacePart& part) {
    const Label label = building.spaces[part.space].label;
    return label == Label::Room || label == Label::Stair || label == Label::Shaft;
}

WallViews wall_views(const Building& building, const std::vector<SpacePart>& parts, double most_thickness) {
    return Viewer(building, parts, most_thickness).run();
}

}  // namespace enfilade::modeler
