#include "tools/lamp_judge.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "render/lamp_light.h"
#include "render/oracle.h"
#include "render/trace_rays.h"
#include "tools/spread_lamps.h"

namespace enfilade::tools {

namespace {

using render::Vec3d;
using render::Vec3f;

Vec3d place_of(const accel::Light& lamp) { return {lamp.position[0], lamp.position[1], lamp.position[2]}; }

/// One place and one lamp.
struct Pair {
    Vec3d place;
    std::uint32_t cell;
    std::uint32_t lamp;
};

class Judge {
public:
    Judge(const accel::SceneView& scene, const accel::LightTreesView& trees, const render::ObjectTracer* objects,
          std::uint64_t seed)
        : scene_(scene),
          trees_(trees),
          objects_(objects),
          random_{81, seed},
          band_(render::error_band(scene)),
          dark_(scene.lights.begin(), scene.lights.end()) {
        for (accel::Light& lamp : dark_) lamp.intensity = {0, 0, 0};
        asked_ = with_lamps(scene, dark_);
        for (std::uint32_t c = 0; c < scene.cells.size(); ++c)
            if (scene.cells[c].section_count > 2) cells_.push_back(c);
    }

    void judge_one(LampPairs& tally) {
        const std::optional<Pair> pair = next();
        if (!pair) return;
        ++tally.pairs;
        const bool sees = walks(pair->place, pair->lamp, pair->cell);
        tally.seen += sees ? 1 : 0;
        const bool is_listed = listed(*pair);
        const bool by_tree = tree_says(*pair);
        if (sees == by_tree && (is_listed || !sees)) return;
        const bool is_certain = !is_near_an_edge(*pair, sees);
        if (sees && !is_listed && is_certain) ++tally.missed;
        if (sees == by_tree) return;
        ++tally.others;
        tally.outside_band += is_certain ? 1 : 0;
    }

private:
    std::optional<Pair> next() {
        const std::uint32_t cell = cells_[random_.below(static_cast<std::uint32_t>(cells_.size()))];
        const Vec3d exact = random_place(scene_, scene_.cells[cell], 1e-3, random_);
        Pair pair = {render::vec_cast<double>(render::vec_cast<float>(exact)), cell, 0};
        const std::uint32_t first = trees_.cell_offsets[cell], end = trees_.cell_offsets[cell + 1];
        pair.lamp = end > first && random_.chance(0.5)
                        ? static_cast<std::uint32_t>(trees_.cell_lights[first + random_.below(end - first)].light)
                        : random_.below(static_cast<std::uint32_t>(scene_.lights.size()));
        if (scene_.lights[pair.lamp].cell == none<accel::CellId>) return std::nullopt;
        return pair;
    }

    [[nodiscard]] bool walks(Vec3d from, std::uint32_t lamp, std::uint32_t cell) const {
        return reaches(from, place_of(scene_.lights[lamp]), cell);
    }
    /// Objects within a hundredth of a millimetre of either end are not in the way (touch_slack).
    [[nodiscard]] bool reaches(Vec3d from, Vec3d to, std::uint32_t cell) const {
        const Vec3d way = to - from;
        const double metres = length(way);
        const render::RayQuery query = {from, way, static_cast<accel::CellId>(cell), metres};
        return trace_ray(scene_, query, render::Precision::Double, objects_).status == render::WalkStatus::Reached;
    }

    [[nodiscard]] bool listed(const Pair& pair) const {
        const auto begin = trees_.cell_lights.begin() + trees_.cell_offsets[pair.cell];
        const auto end = trees_.cell_lights.begin() + trees_.cell_offsets[pair.cell + 1];
        return std::any_of(begin, end,
                           [&](const accel::CellLight& l) { return static_cast<std::uint32_t>(l.light) == pair.lamp; });
    }

    /// What the tracers' own code makes of it: all other lamps are out.
    [[nodiscard]] bool tree_says(const Pair& pair) {
        const Vec3d way = place_of(scene_.lights[pair.lamp]) - pair.place;
        const double metres = length(way);
        if (!(metres > 0)) return true;
        const render::LitPlace<float> place = {render::vec_cast<float>(pair.place),
                                               render::vec_cast<float>((1 / metres) * way), pair.cell};
        render::Lamps lamps;
        lamps.trees = trees_;
        lamps.search = render::LampSearch::Tree;
        dark_[pair.lamp].intensity = {1, 1, 1};
        render::NoEvents events;
        const auto lit = [&](const auto& rooms) {
            return largest_part(render::LampLight(asked_, lamps, rooms, events).at(place)) > 0;
        };
        const bool says = objects_ != nullptr ? lit(render::FurnishedRooms{*objects_}) : lit(render::BareRooms{});
        dark_[pair.lamp].intensity = {0, 0, 0};
        return says;
    }

    /// Whether the answer changes where both ends are moved by as much as roundings may.
    [[nodiscard]] bool is_near_an_edge(const Pair& pair, bool sees) {
        constexpr int tries = 32;
        const Vec3d lamp = place_of(scene_.lights[pair.lamp]);
        for (int k = 0; k < tries; ++k) {
            const Vec3d from = pair.place + moved(), to = lamp + moved();
            if (reaches(from, to, pair.cell) != sees) return true;
        }
        return false;
    }
    Vec3d moved() {
        const auto one = [&] { return random_.uniform(-1, 1) * 2 * band_; };
        return {one(), one(), one()};
    }

    const accel::SceneView& scene_;
    const accel::LightTreesView& trees_;
    const render::ObjectTracer* objects_;
    plans::Random random_;
    double band_;
    std::vector<accel::Light> dark_;
    accel::SceneView asked_;
    std::vector<std::uint32_t> cells_;
};

}  // namespace

LampPairs& LampPairs::operator+=(const LampPairs& other) {
    pairs += other.pairs;
    seen += other.seen;
    missed += other.missed;
    others += other.others;
    outside_band += other.outside_band;
    return *this;
}

LampPairs judge_lamp_pairs(const accel::SceneView& scene, const accel::LightTreesView& trees,
                           const render::ObjectTracer* objects, std::uint64_t seed, std::uint64_t count) {
    Judge judge(scene, trees, objects, seed);
    LampPairs tally;
    for (std::uint64_t k = 0; k < count; ++k) judge.judge_one(tally);
    return tally;
}

}  // namespace enfilade::tools
