#include "modeler/objects/lamp_paths.h"

#include <utility>

namespace enfilade::modeler {
namespace {

using accel::BeamStep;
using accel::BeamWalker;

constexpr std::size_t most_steps = 100000;  ///< of beams that are followed one by one

/// One beam after the other: the tree of steps says by which cells each has come. False where there are too many.
bool mark_exactly(const accel::SceneView& scene, const accel::BeamSource& lamp, std::int64_t margin,
                  const std::vector<char>& is_wanted, std::vector<char>& is_crossed) {
    BeamWalker walker(scene, {.margin = margin, .max_beams = 0});
    std::vector<std::pair<std::uint32_t, std::uint32_t>> steps;  // cell, parent
    walker.start(lamp);
    while (const BeamStep* step = walker.next()) {
        if (steps.size() == most_steps) return false;
        steps.emplace_back(index(step->cell), step->parent);
    }
    std::vector<char> leads(steps.size());
    for (std::size_t k = steps.size(); k-- > 0;) {
        const auto [cell, parent] = steps[k];
        if (leads[k] == 0 && is_wanted[cell] == 0) continue;
        is_crossed[cell] = 1;
        leads[parent] = 1;
    }
    return true;
}

/// Widened beams stand for others that came by other cells, but through the same portals: so every cell from which
/// crossed portals lead to a wanted one.
void mark_all_ways(const accel::SceneView& scene, const accel::BeamSource& lamp, std::int64_t margin,
                   const std::vector<char>& is_wanted, std::vector<char>& is_crossed) {
    BeamWalker walker(scene, {.margin = margin, .max_beams = 16});
    std::vector<std::vector<std::uint32_t>> from(scene.cells.size());
    std::vector<std::uint32_t> pending;
    std::vector<char> leads(scene.cells.size());
    walker.start(lamp);
    while (const BeamStep* step = walker.next()) {
        const auto cell = std::uint32_t(index(step->cell));
        if (step->depth > 0) from[cell].push_back(std::uint32_t(index(step->from)));
        if (is_wanted[cell] != 0 && std::exchange(leads[cell], char{1}) == 0) pending.push_back(cell);
    }
    while (!pending.empty()) {
        const std::uint32_t cell = pending.back();
        pending.pop_back();
        is_crossed[cell] = 1;
        for (const std::uint32_t before : from[cell])
            if (std::exchange(leads[before], char{1}) == 0) pending.push_back(before);
    }
}

}  // namespace

void mark_lamp_paths(const accel::SceneView& scene, const accel::BeamSource& lamp, std::int64_t margin,
                     const std::vector<char>& is_wanted, std::vector<char>& is_crossed) {
    std::vector<char> crossed = is_crossed;
    if (mark_exactly(scene, lamp, margin, is_wanted, crossed)) is_crossed = std::move(crossed);
    else mark_all_ways(scene, lamp, margin, is_wanted, is_crossed);
}

}  // namespace enfilade::modeler
