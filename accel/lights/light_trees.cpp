#include "accel/lights/light_trees.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "accel/lights/lamp_tree.h"

namespace enfilade::accel {
namespace {

using detail::LampTree;

constexpr std::uint32_t most_tints = 1u << 22;

std::vector<LampTree> build_each(const SceneView& view, LightTreeOptions options, const Executor& executor) {
    std::vector<LampTree> trees(view.lights.size());
    const std::size_t lamps = std::max<std::size_t>(trees.size(), 1);
    options.most_beams =
        static_cast<std::uint32_t>(std::min<std::size_t>(options.most_beams, options.most_beams_in_all / lamps));
    const std::size_t grain = std::clamp<std::size_t>(trees.size() / 64, 1, 16);
    parallel_for(executor, trees.size(), grain, [&](std::size_t begin, std::size_t end) {
        detail::LampTreeBuilder builder(view, options);
        for (std::size_t i = begin; i < end; ++i) trees[i] = builder.build(view.lights[i]);
    });
    return trees;
}

/// Tints by their number, each one once.
class TintTable {
public:
    std::uint32_t number_of(const Vertex& tint) {
        const auto [at, is_new] =
            known_.try_emplace({tint.x, tint.y, tint.z}, static_cast<std::uint32_t>(tints_.size()));
        if (is_new) tints_.push_back(tint);
        return at->second;
    }
    [[nodiscard]] std::vector<Vertex> take() { return std::move(tints_); }

private:
    std::vector<Vertex> tints_;
    std::map<std::tuple<float, float, float>, std::uint32_t> known_;
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

LightTreeFigures LightTrees::figures() const {
    LightTreeFigures f = figures_;
    const auto bytes = [](const auto& array) { return array.size() * sizeof array[0]; };
    f.beams = beams_.size();
    f.planes = planes_.size();
    f.objects = beam_objects_.size();
    f.list_bytes = bytes(cell_offsets_) + bytes(cell_lights_);
    f.tree_bytes = bytes(beams_) + bytes(planes_) + bytes(tints_);
    f.object_bytes = bytes(beam_object_lists_) + bytes(beam_objects_);
    for (std::size_t c = 0; c + 1 < cell_offsets_.size(); ++c) {
        const std::size_t entries = cell_offsets_[c + 1] - cell_offsets_[c];
        std::size_t lamps = 0;
        for (std::uint32_t k = cell_offsets_[c]; k < cell_offsets_[c + 1]; ++k)
            lamps += k == cell_offsets_[c] || cell_lights_[k].light != cell_lights_[k - 1].light ? 1 : 0;
        f.lit_cells += entries > 0 ? 1 : 0;
        f.listed_lamps += lamps;
        f.longest_list = std::max(f.longest_list, lamps);
        f.most_entries = std::max(f.most_entries, entries);
    }
    return f;
}

std::size_t LightTrees::bytes() const {
    const LightTreeFigures f = figures();
    return f.list_bytes + f.tree_bytes + f.object_bytes;
}

LightTrees build_light_trees(const SceneView& view, const LightTreeOptions& options, const Executor& executor) {
    const std::vector<LampTree> trees = build_each(view, options, executor);

    // Lists and beams by cell: what is asked together lies together.
    LightTrees all;
    std::vector<std::uint32_t> beam_offsets(view.cells.size() + 1, 0);
    all.cell_offsets_.assign(view.cells.size() + 1, 0);
    for (const LampTree& tree : trees) {
        for (const LightBeam& beam : tree.beams) ++beam_offsets[index(beam.cell) + 1];
        for (const CellId cell : tree.cells) ++all.cell_offsets_[index(cell) + 1];
    }
    for (std::size_t c = 0; c < view.cells.size(); ++c) {
        all.cell_offsets_[c + 1] += all.cell_offsets_[c] + beam_offsets[c + 1];
        beam_offsets[c + 1] += beam_offsets[c];
    }
    all.cell_lights_.resize(all.cell_offsets_.back());
    all.beams_.resize(beam_offsets.back());
    std::vector<std::uint32_t> next(all.cell_offsets_.begin(), all.cell_offsets_.end() - 1);
    std::vector<std::uint32_t> next_beam(beam_offsets.begin(), beam_offsets.end() - 1);
    std::vector<std::vector<std::uint32_t>> numbers(trees.size());
    TintTable tints;
    tints.number_of({1, 1, 1});
    for (std::size_t i = 0; i < trees.size(); ++i) {
        const LampTree& tree = trees[i];
        const auto light = static_cast<LightId>(i);
        for (const CellId cell : tree.cells) all.cell_lights_[next[index(cell)]++] = {light, no_beam};
        for (const LightBeam& beam : tree.beams) {
            const std::uint32_t number = next_beam[index(beam.cell)]++;
            numbers[i].push_back(number);
            all.cell_lights_[next[index(beam.cell)]++] = {light, number};
            all.beams_[number] = {0, numbers[i][beam.parent], beam.cell, 0, beam.plane_count};
            all.beams_[number].tint = tints.number_of(tree.tints[beam.tint]) & (most_tints - 1);
        }
    }
    all.tints_ = tints.take();
    std::uint32_t planes = 0;
    for (LightBeam& beam : all.beams_) beam.first_plane = std::exchange(planes, planes + beam.plane_count);
    all.planes_.resize(planes);
    for (std::size_t i = 0; i < trees.size(); ++i)
        for (std::size_t b = 0; b < trees[i].beams.size(); ++b)
            std::copy_n(trees[i].planes.begin() + trees[i].beams[b].first_plane, trees[i].beams[b].plane_count,
                        all.planes_.begin() + all.beams_[numbers[i][b]].first_plane);
    for (std::size_t i = 0; i < trees.size(); ++i) {
        all.figures_.in_solids += view.lights[i].cell == none<CellId> ? 1 : 0;
        all.figures_.without_tree += trees[i].cells.empty() ? 0 : 1;
    }
    all.figures_.lamps = trees.size();
    if (options.objects && options.trees && view.has_objects()) {
        all.beam_object_lists_.resize(all.beams_.size());
        for (std::size_t i = 0; i < trees.size(); ++i) {
            const auto first = static_cast<std::uint32_t>(all.beam_objects_.size());
            for (std::size_t b = 0; b < trees[i].object_lists.size(); ++b) {
                BeamObjects& list = all.beam_object_lists_[numbers[i][b]];
                list = trees[i].object_lists[b];
                list.first += first;
            }
            all.beam_objects_.insert(all.beam_objects_.end(), trees[i].objects.begin(), trees[i].objects.end());
        }
    }
    return all;
}

}  // namespace enfilade::accel
