#include "modeler/levels.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace enfilade::modeler {
namespace {

constexpr double least_room_height = 0.5;  ///< metres between floor and ceiling
constexpr double least_slab = 0.01;
constexpr double ground_depth = 1.0;  ///< of the ground under the lowest slab
constexpr double low_storey_warning = 1.8;

std::string metres(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f m", value);
    return text;
}

ElementRef element(const plans::Storey& storey) { return {"storey", storey.id, storey.name}; }

/// Index into Plan::storeys of the next floor above, of those that the plan holds (built or not).
const plans::Storey* next_above(const plans::Plan& plan, const plans::Storey& storey) {
    const plans::Storey* next = nullptr;
    for (const plans::Storey& other : plan.storeys)
        if (other.elevation > storey.elevation && (!next || other.elevation < next->elevation)) next = &other;
    return next;
}

}  // namespace

std::vector<std::uint32_t> stackable(const plans::Plan& plan, const std::vector<std::uint32_t>& chosen,
                                     std::vector<Finding>& findings) {
    std::vector<std::uint32_t> order = chosen;
    if (order.empty()) {
        order.resize(plan.storeys.size());
        std::iota(order.begin(), order.end(), 0u);
    }
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return plan.storeys[a].elevation < plan.storeys[b].elevation;
    });
    std::vector<std::uint32_t> kept;
    for (const std::uint32_t k : order) {
        const plans::Storey& storey = plan.storeys[k];
        if (!kept.empty()) {
            const plans::Storey& below = plan.storeys[kept.back()];
            const double room = storey.elevation - storey.slab_thickness - below.elevation;
            if (room < least_room_height) {
                findings.push_back(
                    {.code = "P401",
                     .severity = Severity::Error,
                     .sentence = "Storey \"" + storey.name + "\" starts " + metres(storey.elevation - below.elevation) +
                                 " above storey \"" + below.name + "\" and leaves it no height: it is left out.",
                     .hint =
                         "Give the two storeys elevations at least a storey's height apart, or merge them into one.",
                     .storey = storey.id,
                     .elements = {element(storey), element(below)}});
                continue;
            }
        }
        kept.push_back(k);
    }
    return kept;
}

Levels find_levels(const plans::Plan& plan, const plans::Layout& layout, std::vector<Finding>& findings) {
    Levels levels;
    const plans::GridFrame& frame = layout.frame;
    const std::size_t count = layout.storeys.size();
    const auto storey = [&](std::size_t k) -> const plans::Storey& {
        return plan.storeys[layout.storeys[k].plan_storey];
    };
    const std::int32_t slab_least = std::max(1, std::int32_t(least_slab / frame.unit));

    for (std::size_t k = 0; k < count; ++k) {
        const plans::Storey& here = storey(k);
        const std::int32_t floor = frame.grid_z(here.elevation);
        std::int32_t ceiling = frame.grid_z(here.elevation + here.height);
        if (const plans::Storey* next = next_above(plan, here)) {
            const std::int32_t underside = std::min(frame.grid_z(next->elevation - next->slab_thickness),
                                                    frame.grid_z(next->elevation) - slab_least);
            if (ceiling > underside && underside > floor) {
                if (here.height - (next->elevation - next->slab_thickness - here.elevation) > 1e-3)
                    findings.push_back({.code = "P402",
                                        .severity = Severity::Note,
                                        .sentence = "Storey \"" + here.name + "\" is " + metres(here.height) +
                                                    " high but the slab above starts at " +
                                                    metres(frame.unit * (underside - floor)) +
                                                    ": its ceiling is taken there.",
                                        .hint = "Lower the storey's height or raise the next one if this is not meant.",
                                        .storey = here.id,
                                        .elements = {element(here), element(*next)},
                                        .moved_mm = 1000 * (here.height - frame.unit * (underside - floor))});
                ceiling = underside;
            }
        }
        ceiling = std::max(ceiling, floor + 1);
        if (frame.unit * (ceiling - floor) < low_storey_warning)
            findings.push_back({.code = "P403",
                                .severity = Severity::Warning,
                                .sentence = "Storey \"" + here.name + "\" is only " +
                                            metres(frame.unit * (ceiling - floor)) + " high from floor to ceiling.",
                                .hint = "Check its height and the elevation of the storey above.",
                                .storey = here.id,
                                .elements = {element(here)}});
        levels.floor.push_back(floor);
        levels.ceiling.push_back(ceiling);
    }

    double ground = storey(count - 1).elevation;
    for (std::size_t k = count; k-- > 0;)
        if (storey(k).elevation >= 0) ground = storey(k).elevation;
    levels.ground = frame.grid_z(plan.ground_level.value_or(ground));

    const auto thickness = [&](const plans::Storey& of) {
        return std::max(slab_least, std::int32_t(std::lround(of.slab_thickness / frame.unit)));
    };
    const std::int32_t ground_slab = levels.floor[0] - thickness(storey(0));
    const std::int32_t roof = levels.ceiling[count - 1] + thickness(storey(count - 1));
    const double height = frame.unit * (roof - ground_slab);
    const std::int32_t margin = std::int32_t(std::ceil(plan.site_margin.value_or(std::max(5.0, height)) / frame.unit));
    const std::int32_t bottom = std::min(ground_slab, levels.ground) - std::int32_t(ground_depth / frame.unit);
    const std::int32_t top = std::max(roof, levels.ground) + margin;

    constexpr std::uint32_t none = UINT32_MAX;
    levels.bands.push_back({LevelKind::Open, bottom, ground_slab, none, none});
    levels.bands.push_back({LevelKind::Slab, ground_slab, levels.floor[0], 0, none});
    for (std::uint32_t k = 0; k < count; ++k) {
        levels.bands.push_back({LevelKind::Storey, levels.floor[k], levels.ceiling[k], k, none});
        if (k + 1 == count) {
            levels.bands.push_back({LevelKind::Slab, levels.ceiling[k], roof, none, k});
            continue;
        }
        const bool adjacent = next_above(plan, storey(k)) == &storey(k + 1);
        const std::int32_t cap = levels.ceiling[k] + thickness(*next_above(plan, storey(k)));
        const std::int32_t under = levels.floor[k + 1] - thickness(storey(k + 1));
        if (adjacent || cap >= under) {
            levels.bands.push_back({LevelKind::Slab, levels.ceiling[k], levels.floor[k + 1], k + 1, k});
        } else {  // storeys between them are not built: each keeps its own slab
            levels.bands.push_back({LevelKind::Slab, levels.ceiling[k], cap, none, k});
            levels.bands.push_back({LevelKind::Open, cap, under, none, none});
            levels.bands.push_back({LevelKind::Slab, under, levels.floor[k + 1], k + 1, none});
        }
    }
    levels.bands.push_back({LevelKind::Open, roof, top, none, none});
    return levels;
}

}  // namespace enfilade::modeler
