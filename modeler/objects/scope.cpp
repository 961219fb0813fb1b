#include "modeler/objects/scope.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "accel/beam.h"
#include "accel/locate.h"
#include "modeler/objects/lamp_paths.h"
#include "modeler/objects/lit_region.h"
#include "modeler/objects/sun_paths.h"

namespace enfilade::modeler {
namespace {

using accel::BeamSource;
using accel::BeamStep;
using accel::BeamWalker;
using accel::CellId;
using accel::SceneView;

constexpr std::uint32_t most_mirrorings = 4;  ///< of beams that a floor throws back one by one
constexpr std::uint32_t followed_beams = 16;  ///< through a portal, before they are widened: rooms have many cells

/// By how much a ray of the float walk may pass beside an edge, metres (render/oracle.h, `error_band`).
double noise_of(const SceneView& scene) {
    double largest = 0;
    for (std::size_t k = 0; k < 3; ++k)
        largest = std::max({largest, std::abs(double{scene.locator_nodes[0].low[k]}),
                            std::abs(double{scene.locator_nodes[0].high[k]})});
    return 16 * largest * 0x1p-24 + 2 * scene.unit;
}

/// Runs `work(item, own)` for items 0 ... count - 1 in batches that do not depend on the number of threads, each batch
/// with what `make()` gave it, and hands those to `collect` in their order.
template <class Make, class Work, class Collect>
void in_batches(const accel::Executor& executor, std::size_t count, const Make& make, const Work& work,
                const Collect& collect) {
    constexpr std::size_t most_batches = 8;
    const std::size_t batches = std::min(count, most_batches);
    std::vector<decltype(make())> made(batches);
    executor.run(batches, [&](std::size_t batch) {
        made[batch] = make();
        for (std::size_t item = batch; item < count; item += batches) work(item, *made[batch]);
    });
    for (const auto& one : made) collect(*one);
}

class ScopeFinder {
public:
    ScopeFinder(const SceneView& scene, const ScopeLight& light, const accel::Executor& executor)
        : scene_(scene),
          light_(light),
          executor_(executor),
          noise_(noise_of(scene)),
          margin_(std::int64_t(std::ceil(noise_ / scene.unit))),
          seen_(scene),
          is_needed_(scene.cells.size()) {}

    Scope find(const ScopeEyes& eyes) {
        Scope scope;
        see(eyes);
        lit_ = seen_.cells();
        for (const CellId cell : lit_) is_needed_[index(cell)] = 1;
        scope.seen = count_new();
        const std::vector<char> is_seen = is_needed_;
        if (light_.reach > 0) darken();
        scope.darkening = count_new();
        if (light_.sun != std::array<double, 3>{}) shine();
        scope.sunlit = count_new();
        for (const std::array<double, 3>& lamp : light_.lamps)
            if (const std::optional<BeamSource> source = accel::source_at(scene_, lamp))
                mark_lamp_paths(scene_, *source, margin_, is_seen, is_needed_);
        scope.lamplit = count_new();
        for (std::size_t c = 0; c < is_needed_.size(); ++c) {
            if (is_needed_[c] == 0) continue;
            scope.cells.push_back(CellId(c));
            scope.spaces.push_back(scene_.cells[c].space);
        }
        std::sort(scope.spaces.begin(), scope.spaces.end());
        scope.spaces.erase(std::unique(scope.spaces.begin(), scope.spaces.end()), scope.spaces.end());
        return scope;
    }

private:
    /// A thread's walkers, and what they have lit.
    struct Seer {
        BeamWalker walker, mirrored;
        LitRegions lit;
        std::vector<std::uint32_t> mirrorings;  ///< [cell] of the source at hand
        std::vector<std::uint32_t> mirrors;     ///< cells with some
    };

    /// What straight lines from the eyes light, and what mirrors throw back.
    void see(const ScopeEyes& eyes) {
        std::vector<BeamSource> sources;
        for (const accel::SpaceId room : eyes.rooms)
            for (BeamSource& source : accel::sources_of_space(scene_, room)) sources.push_back(std::move(source));
        for (const ScopeEyes::Point& eye : eyes.points)
            sources.push_back(accel::source_at(scene_, eye.cell, eye.position));
        const accel::BeamOptions options = {.margin = margin_, .max_beams = followed_beams};
        in_batches(
            executor_, sources.size(),
            [&] {
                return std::make_unique<Seer>(Seer{BeamWalker(scene_, options),
                                                   BeamWalker(scene_, options),
                                                   LitRegions(scene_),
                                                   std::vector<std::uint32_t>(scene_.cells.size()),
                                                   {}});
            },
            [&](std::size_t k, Seer& own) { see_from(sources[k], own); },
            [&](const Seer& own) { seen_.merge(own.lit); });
    }

    void see_from(const BeamSource& source, Seer& own) const {
        own.walker.start(source);
        while (const BeamStep* step = own.walker.next()) {
            own.lit.add(*step);
            if (light_.mirrors && has_mirror(step->cell)) see_mirrored(source, *step, own);
        }
        for (const std::uint32_t cell : own.mirrors) own.mirrorings[cell] = 0;
        own.mirrors.clear();
    }

    /// Whether the cell's floor can be a mirror (render/mirror.h).
    [[nodiscard]] bool has_mirror(CellId cell) const {
        const accel::Target floor = scene_.cells[index(cell)].floor;
        return !floor.is_portal() && scene_.source_faces[index(floor.source_face())].surface == accel::Surface::Floor;
    }

    /// Beam by beam at first, then all that could come from the source.
    void see_mirrored(const BeamSource& source, const BeamStep& step, Seer& own) const {
        std::uint32_t& count = own.mirrorings[index(step.cell)];
        if (count > most_mirrorings) return;
        if (count == 0) own.mirrors.push_back(std::uint32_t(index(step.cell)));
        BeamStep down = step;
        if (count++ == most_mirrorings) {
            down.is_level = true;
            down.beam = {};
            down.beam.height = {{double(source.z_low), double(source.z_high)}, {-INFINITY, 0}};
        }
        own.mirrored.start_mirrored(source, down);
        while (const BeamStep* next = own.mirrored.next()) own.lit.add(*next);
    }

    /// Short rays from whatever is seen.
    void darken() {
        const double reach = (light_.reach + 2 * noise_) / scene_.unit + 2 * double(margin_);
        struct Own {
            BeamWalker walker;
            std::vector<char> is_reached;
        };
        in_batches(
            executor_, lit_.size(),
            [&] {
                const accel::BeamOptions options = {.margin = margin_, .max_beams = 1};
                return std::make_unique<Own>(Own{BeamWalker(scene_, options), std::vector<char>(scene_.cells.size())});
            },
            [&](std::size_t k, Own& own) {
                const BeamSource source = seen_.region(lit_[k]);
                own.walker.start(source);
                while (const BeamStep* step = own.walker.next()) {
                    if (step->depth > 0 && way_to(source, *step) > reach) own.walker.prune();
                    else own.is_reached[index(step->cell)] = 1;
                }
            },
            [&](const Own& own) { add(own.is_reached); });
    }

    /// At least so far, in grid units, is it from the source to the portal by which the beam has come.
    [[nodiscard]] double way_to(const BeamSource& source, const BeamStep& step) const {
        double flat = 0, low = 0, high = 0;
        if (step.is_level) {
            const accel::Cell& cell = scene_.cells[index(step.cell)];
            const bool goes_up = scene_.cell_portals[index(step.cell)].floor == step.portal;
            low = high = double{goes_up ? cell.z_floor : cell.z_ceiling} / scene_.unit;
            if (step.beam.has_gate) flat = accel::distances(source, step.beam.lit, margin_).low;
        } else {
            flat = accel::distances(source, step.beam.lit, margin_).low;
            low = step.beam.opening.low;
            high = step.beam.opening.high;
        }
        const double up = std::max({0.0, low - double(source.z_high), double(source.z_low) - high});
        return std::hypot(flat, up);
    }

    void shine() {
        struct Own {
            SunPaths paths;
            std::vector<char> is_crossed;
        };
        in_batches(
            executor_, lit_.size(),
            [&] {
                return std::make_unique<Own>(
                    Own{SunPaths(scene_, light_.sun, 2 * noise_), std::vector<char>(scene_.cells.size())});
            },
            [&](std::size_t k, Own& own) { own.paths.mark(seen_.region(lit_[k]), own.is_crossed); },
            [&](const Own& own) { add(own.is_crossed); });
    }

    void add(const std::vector<char>& cells) {
        for (std::size_t c = 0; c < cells.size(); ++c) is_needed_[c] |= cells[c];
    }

    /// Cells that became needed since the last call.
    std::size_t count_new() {
        const auto all = std::size_t(std::count(is_needed_.begin(), is_needed_.end(), char{1}));
        return all - std::exchange(counted_, all);
    }

    SceneView scene_;
    const ScopeLight& light_;
    const accel::Executor& executor_;
    double noise_;
    std::int64_t margin_;
    LitRegions seen_;
    std::vector<CellId> lit_;  ///< cells that are seen
    std::vector<char> is_needed_;
    std::size_t counted_ = 0;
};

}  // namespace

Scope scope_of(const SceneView& scene, const ScopeEyes& eyes, const ScopeLight& light,
               const accel::Executor& executor) {
    return ScopeFinder(scene, light, executor).find(eyes);
}

}  // namespace enfilade::modeler
