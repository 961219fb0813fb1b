#include "accel/lights/lamp_tree.h"

#include <algorithm>
#include <cmath>

#include "accel/beam.h"

namespace enfilade::accel::detail {
namespace {

constexpr std::uint32_t most_planes = 1023;
constexpr std::uint32_t most_tints = 1u << 22;

double largest_coordinate(const SceneView& view) {
    double largest = 0;
    for (int k = 0; k < 3; ++k)
        largest = std::max(
            {largest, std::abs(double{view.locator_nodes[0].low[k]}), std::abs(double{view.locator_nodes[0].high[k]})});
    return largest;
}

/// How far a walk in float may be from the truth (render/oracle.h, `error_band`), in grid units.
std::int64_t float_margin(const SceneView& view) {
    return static_cast<std::int64_t>(std::ceil(16 * largest_coordinate(view) * 0x1p-24 / view.unit + 2));
}

/// How far (metres) a sign in float may be from the truth: the roundings of a place, of the way to it and of a normal.
double float_precision(const SceneView& view) {
    return std::max(largest_coordinate(view) * 0x1p-21, view.unit * 0x1p-4);
}

LampWalkOptions walk_options(const SceneView& view, const LightTreeOptions& options, std::int64_t margin) {
    LampWalkOptions of;
    of.margin = std::max(double(margin) * view.unit, view.unit * 0x1p-4);
    of.precision = std::min(float_precision(view), of.margin);
    of.through_glass = options.through_glass;
    of.most_steps = options.most_beams;
    return of;
}

bool are_equal(const Vertex& a, const Vertex& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

}  // namespace

LampTreeBuilder::LampTreeBuilder(const SceneView& view, const LightTreeOptions& options)
    : view_(view),
      options_(options),
      margin_(options.margin.value_or(float_margin(view))),
      walk_(view, walk_options(view, options, margin_)),
      objects_(view) {}

LampTree LampTreeBuilder::build(const Light& light) {
    LampTree tree;
    if (light.cell == none<CellId>) return tree;
    const double radius = options_.balls ? double{light.radius} : 0;
    const bool is_followed = walk_.follow(light.cell, light.position, radius);
    if (is_followed && options_.trees && radius == 0 && add_beams(light, tree)) return tree;
    tree = {};
    if (is_followed) {
        tree.cells = cells_of_steps();
    } else {
        const std::array<double, 3> lamp = {light.position[0], light.position[1], light.position[2]};
        const auto margin = margin_ + static_cast<std::int64_t>(std::ceil(radius / view_.unit));
        tree.cells = reachable_cells(view_, source_at(view_, light.cell, lamp),
                                     {.margin = margin, .through_glass = options_.through_glass});
    }
    return tree;
}

std::vector<CellId> LampTreeBuilder::cells_of_steps() const {
    std::vector<CellId> cells;
    for (const LampStep& step : walk_.steps()) cells.push_back(step.cell);
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    return cells;
}

void LampTreeBuilder::find_planes() {
    planes_.clear();
    plane_offsets_.assign(1, 0);
    for (const LampStep& step : walk_.steps()) {
        walk_.light_in_cell(step, planes_of_step_);
        planes_.insert(planes_.end(), planes_of_step_.begin(), planes_of_step_.end());
        plane_offsets_.push_back(static_cast<std::uint32_t>(planes_.size()));
    }
}

Vertex LampTreeBuilder::tint_behind(const Vertex& tint, PortalId id) const {
    const Portal& portal = view_.portals[index(id)];
    if (portal.kind() != PortalKind::Glass) return tint;
    const Vertex& glass = view_.tints[portal.tint()];
    return {tint.x * glass.x, tint.y * glass.y, tint.z * glass.z};
}

void LampTreeBuilder::find_tints(LampTree& tree) {
    tint_of_step_.clear();
    tree.tints.push_back({1, 1, 1});
    for (const LampStep& step : walk_.steps()) {
        if (step.portal == none<PortalId>) {
            tint_of_step_.push_back(0);
            continue;
        }
        const Vertex tint = tint_behind(tree.tints[tint_of_step_[step.parent]], step.portal);
        const auto known = std::ranges::find_if(tree.tints, [&](const Vertex& t) { return are_equal(t, tint); });
        tint_of_step_.push_back(static_cast<std::uint32_t>(known - tree.tints.begin()));
        if (known == tree.tints.end()) tree.tints.push_back(tint);
    }
}

/// Where one step has all of its cell, others that come there by rounding say nothing new: they are left out, unless
/// others go on from them.
void LampTreeBuilder::find_covered() {
    const std::span<const LampStep> steps = walk_.steps();
    std::vector<std::pair<CellId, std::uint32_t>> full;
    for (std::uint32_t k = 0; k < steps.size(); ++k)
        if (plane_offsets_[k] == plane_offsets_[k + 1]) full.emplace_back(steps[k].cell, k);
    std::sort(full.begin(), full.end());
    is_covered_.assign(steps.size(), 0);
    std::vector<char> goes_on(steps.size(), 0);
    for (std::size_t k = steps.size(); k-- > 1;) {
        const auto by = std::ranges::lower_bound(full, std::pair(steps[k].cell, 0u));
        const bool is_full = by != full.end() && by->first == steps[k].cell;
        is_covered_[k] = is_full && by->second != k && goes_on[k] == 0 && tint_of_step_[by->second] == tint_of_step_[k];
        if (is_covered_[k] == 0) goes_on[steps[k].parent] = 1;
    }
}

bool LampTreeBuilder::add_beams(const Light& light, LampTree& tree) {
    find_planes();
    find_tints(tree);
    if (tree.tints.size() > most_tints) return false;
    find_covered();
    const bool lists_objects = options_.objects && view_.has_objects();
    if (lists_objects) {
        objects_.list(walk_, light);
        tree.objects = objects_.objects();
    }
    const std::span<const LampStep> steps = walk_.steps();
    std::vector<std::uint32_t> number(steps.size());
    for (std::uint32_t k = 0; k < steps.size(); ++k) {
        if (is_covered_[k] != 0) continue;
        const std::uint32_t count = plane_offsets_[k + 1] - plane_offsets_[k];
        if (count > most_planes) return false;
        number[k] = static_cast<std::uint32_t>(tree.beams.size());
        LightBeam beam = {static_cast<std::uint32_t>(tree.planes.size()), number[steps[k].parent], steps[k].cell, 0, 0};
        beam.tint = tint_of_step_[k] & (most_tints - 1);
        beam.plane_count = count & most_planes;
        tree.beams.push_back(beam);
        if (lists_objects) tree.object_lists.push_back(objects_.lists()[k]);
        for (std::uint32_t p = plane_offsets_[k]; p < plane_offsets_[k + 1]; ++p)
            tree.planes.push_back(
                {static_cast<float>(planes_[p].x), static_cast<float>(planes_[p].y), static_cast<float>(planes_[p].z)});
    }
    // There may be many trees, and they all wait for the last one.
    tree.beams.shrink_to_fit();
    tree.planes.shrink_to_fit();
    return true;
}

}  // namespace enfilade::accel::detail
