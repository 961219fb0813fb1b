#include "accel/lights/light_descent.h"

namespace enfilade::accel {

LightDescent::LightDescent(const LightTreesView& trees, std::size_t light_count) {
    constexpr std::uint32_t nothing = UINT32_MAX;
    const auto count = static_cast<std::uint32_t>(trees.beams.size());
    std::vector<std::uint32_t> roots(light_count, nothing), first_child(count, nothing), next_sibling(count, nothing);
    for (const CellLight& entry : trees.cell_lights)
        if (entry.beam != no_beam && trees.beams[entry.beam].parent == entry.beam)
            roots[index(entry.light)] = entry.beam;
    for (std::uint32_t b = count; b-- > 0;) {
        const std::uint32_t parent = trees.beams[b].parent;
        if (parent == b) continue;
        next_sibling[b] = first_child[parent];
        first_child[parent] = b;
    }
    nodes_.reserve(count);
    light_offsets_.push_back(0);
    std::vector<std::uint32_t> open;  // nodes whose branches are being written down
    for (const std::uint32_t root : roots) {
        for (std::uint32_t beam = root; beam != nothing;) {
            open.push_back(static_cast<std::uint32_t>(nodes_.size()));
            nodes_.push_back({beam, 0});
            beam = first_child[beam];
            while (beam == nothing && !open.empty()) {
                DescentNode& done = nodes_[open.back()];
                open.pop_back();
                done.skip = static_cast<std::uint32_t>(nodes_.size());
                if (!open.empty()) beam = next_sibling[done.beam];
            }
        }
        light_offsets_.push_back(static_cast<std::uint32_t>(nodes_.size()));
    }
}

}  // namespace enfilade::accel
