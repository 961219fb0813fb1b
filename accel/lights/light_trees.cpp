#include "accel/lights/light_trees.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "accel/beam.h"
#include "accel/lights/beam_objects.h"
#include "accel/lights/beam_planes.h"

namespace enfilade::accel {
namespace {

/// One lamp's beams; parents, planes and tints counted from its own first ones.
struct Tree {
    std::vector<LightBeam> beams;
    std::vector<BeamPlane> planes;
    std::vector<Vertex> tints;
    std::vector<CellId> cells;  ///< of a lamp without tree: where it may be seen
};

constexpr std::uint32_t most_planes = 1023;

/// How far a walk in float may be from the truth (render/oracle.h, `error_band`), in grid units.
std::int64_t float_margin(const SceneView& view) {
    double largest = 0;
    for (int k = 0; k < 3; ++k)
        largest = std::max(
            {largest, std::abs(double{view.locator_nodes[0].low[k]}), std::abs(double{view.locator_nodes[0].high[k]})});
    return static_cast<std::int64_t>(std::ceil(16 * largest * 0x1p-24 / view.unit + 2));
}

class TreeBuilder {
public:
    TreeBuilder(const SceneView& view, const LightTreeOptions& options)
        : view_(view),
          options_(options),
          margin_(options.margin.value_or(float_margin(view))),
          walker_(view, {.margin = margin_, .through_glass = options.through_glass, .max_beams = 0}) {}

    [[nodiscard]] Tree build(const Light& light) {
        Tree tree;
        if (light.cell == none<CellId>) return tree;
        const std::array<double, 3> lamp = {light.position[0], light.position[1], light.position[2]};
        const BeamSource source = source_at(view_, light.cell, lamp);
        if (!options_.trees || !follow(lamp, source, tree)) list_cells(source, tree);
        return tree;
    }

private:
    bool follow(const std::array<double, 3>& lamp, const BeamSource& source, Tree& tree) {
        walker_.start(source);
        while (const BeamStep* step = walker_.next()) {
            if (tree.beams.size() == options_.most_beams) return false;
            LightBeam beam = {static_cast<std::uint32_t>(tree.planes.size()), step->parent, step->cell, 0, 0};
            Vertex tint = {1, 1, 1};
            if (step->depth > 0) {
                const LightBeam parent = tree.beams[step->parent];
                for (std::uint32_t p = 0; p < parent.plane_count; ++p)
                    tree.planes.push_back(BeamPlane(tree.planes[parent.first_plane + p]));
                detail::add_portal_planes(view_, lamp, *step, margin_, tree.planes);
                tint = tinted(tree.tints[parent.tint], *step);
            }
            const std::size_t planes = tree.planes.size() - beam.first_plane;
            if (planes > most_planes) return false;
            beam.tint = number_of(tree, tint) & 0x3fffffu;
            beam.plane_count = planes & most_planes;
            tree.beams.push_back(beam);
        }
        return true;
    }

    [[nodiscard]] Vertex tinted(Vertex tint, const BeamStep& step) const {
        const Portal& portal = view_.portals[index(step.portal)];
        if (portal.kind() != PortalKind::Glass) return tint;
        const Vertex& glass = view_.tints[portal.tint()];
        return {tint.x * glass.x, tint.y * glass.y, tint.z * glass.z};
    }

    static std::uint32_t number_of(Tree& tree, const Vertex& tint) {
        for (std::size_t i = 0; i < tree.tints.size(); ++i)
            if (tree.tints[i].x == tint.x && tree.tints[i].y == tint.y && tree.tints[i].z == tint.z)
                return static_cast<std::uint32_t>(i);
        tree.tints.push_back(tint);
        return static_cast<std::uint32_t>(tree.tints.size() - 1);
    }

    void list_cells(const BeamSource& source, Tree& tree) const {
        tree = {};
        tree.cells = reachable_cells(view_, source, {.margin = margin_, .through_glass = options_.through_glass});
    }

    const SceneView& view_;
    const LightTreeOptions& options_;
    std::int64_t margin_;
    BeamWalker walker_;
};

}  // namespace

LightTreesView LightTrees::view() const {
    return {{cell_offsets_.data(), cell_offsets_.size()},
            {cell_lights_.data(), cell_lights_.size()},
            {beams_.data(), beams_.size()},
            {planes_.data(), planes_.size()},
            {tints_.data(), tints_.size()},
            {beam_object_lists_.data(), beam_object_lists_.size()},
            {beam_objects_.data(), beam_objects_.size()}};
}

std::size_t LightTrees::bytes() const {
    return cell_offsets_.size() * sizeof cell_offsets_[0] + cell_lights_.size() * sizeof cell_lights_[0] +
           beams_.size() * sizeof beams_[0] + planes_.size() * sizeof planes_[0] + tints_.size() * sizeof tints_[0] +
           beam_object_lists_.size() * sizeof beam_object_lists_[0] + beam_objects_.size() * sizeof beam_objects_[0];
}

LightTrees build_light_trees(const SceneView& view, const LightTreeOptions& options, const Executor& executor) {
    std::vector<Tree> trees(view.lights.size());
    constexpr std::size_t grain = 16;
    parallel_for(executor, trees.size(), grain, [&](std::size_t begin, std::size_t end) {
        TreeBuilder builder(view, options);
        for (std::size_t i = begin; i < end; ++i) trees[i] = builder.build(view.lights[i]);
    });

    LightTrees all;
    all.cell_offsets_.assign(view.cells.size() + 1, 0);
    all.tints_.push_back({1, 1, 1});
    for (const Tree& tree : trees) {
        for (const LightBeam& beam : tree.beams) ++all.cell_offsets_[index(beam.cell) + 1];
        for (const CellId cell : tree.cells) ++all.cell_offsets_[index(cell) + 1];
    }
    for (std::size_t c = 0; c < view.cells.size(); ++c) all.cell_offsets_[c + 1] += all.cell_offsets_[c];
    all.cell_lights_.resize(all.cell_offsets_.back());
    std::vector<std::uint32_t> next(all.cell_offsets_.begin(), all.cell_offsets_.end() - 1);
    for (std::size_t i = 0; i < trees.size(); ++i) {
        const Tree& tree = trees[i];
        const auto light = static_cast<LightId>(i);
        if (!tree.cells.empty() && options.trees) ++all.without_tree_;
        for (const CellId cell : tree.cells) all.cell_lights_[next[index(cell)]++] = {light, no_beam};
        const auto first_beam = static_cast<std::uint32_t>(all.beams_.size());
        const auto first_plane = static_cast<std::uint32_t>(all.planes_.size());
        const auto first_tint = static_cast<std::uint32_t>(all.tints_.size());
        for (const LightBeam& beam : tree.beams) {
            all.cell_lights_[next[index(beam.cell)]++] = {light, static_cast<std::uint32_t>(all.beams_.size())};
            const Vertex& tint = tree.tints[beam.tint];
            const bool is_clear = tint.x == 1 && tint.y == 1 && tint.z == 1;
            all.beams_.push_back({first_plane + beam.first_plane, first_beam + beam.parent, beam.cell,
                                  is_clear ? 0 : (first_tint + beam.tint) & 0x3fffffu, beam.plane_count});
        }
        all.planes_.insert(all.planes_.end(), tree.planes.begin(), tree.planes.end());
        all.tints_.insert(all.tints_.end(), tree.tints.begin(), tree.tints.end());
    }
    if (options.objects && options.trees && view.has_objects())
        detail::list_objects(view, all.view(), executor, all.beam_object_lists_, all.beam_objects_);
    return all;
}

}  // namespace enfilade::accel
