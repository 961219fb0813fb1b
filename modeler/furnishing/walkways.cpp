#include "modeler/furnishing/walkways.h"

#include <algorithm>
#include <cmath>

namespace enfilade::modeler {

using plans::Point;

namespace {

constexpr double fine = 0.02;           // metres
constexpr double largest_fine = 1e6;    // nodes
constexpr std::int32_t coarse = 3;      // fine steps in a coarse one
constexpr double standing_depth = 0.4;  // metres from the wall

}  // namespace

std::int32_t fine_step(const Floor& floor, double unit) {
    const GridBox box = floor.box();
    const double area = (double(box.x_high) - box.x_low) * (double(box.y_high) - box.y_low);
    auto step = std::max<std::int32_t>(1, std::int32_t(std::lround(fine / unit)));
    while (area / (double(step) * step) > largest_fine) step *= 2;
    return step;
}

Point standing_place(const RoomOpening& gate, double unit) {
    return (gate.a + gate.b) * 0.5 + gate.inward * (standing_depth / unit);
}

double standing_reach(double unit) { return 0.06 / unit; }

Walkways::Groups Walkways::groups_of(WalkLattice& lattice, const std::vector<std::uint32_t>& nodes) {
    Groups groups;
    std::vector<bool> done(nodes.size());
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        if (done[k]) continue;
        lattice.start_reaching();
        lattice.reach(nodes[k]);
        groups.emplace_back();
        for (std::size_t j = k; j < nodes.size(); ++j)
            if (!done[j] && lattice.has_reached(nodes[j])) {
                done[j] = true;
                groups.back().push_back(nodes[j]);
            }
    }
    return groups;
}

Walkways::Walkways(const RoomShape& room, const std::vector<Ring>& obstacles) {
    const double unit = room.frame.unit, radius = walker_radius / unit;
    const std::int32_t step = fine_step(room.floor, unit);
    const auto set_up = [&](std::int32_t lattice_step, double margin, std::vector<std::size_t>& gates) {
        lattice_ = std::make_unique<WalkLattice>(room.floor, lattice_step, radius, margin);
        for (const Ring& ring : obstacles) lattice_->put(ring, 1);
        std::vector<std::uint32_t> nodes;
        const double reach = std::max(standing_reach(unit), 1.0 * lattice_step);
        for (std::size_t g = 0; g < room.gates.size(); ++g) {
            if (!is_passage(room.gates[g].beyond)) continue;
            const auto node = lattice_->free_node(standing_place(room.gates[g], unit), reach);
            if (!node) continue;
            nodes.push_back(*node);
            gates.push_back(g);
        }
        return groups_of(*lattice_, nodes);
    };
    std::vector<std::size_t> fine_gates, coarse_gates;
    groups_ = set_up(step, 0, fine_gates);
    if (groups_.empty()) {
        lattice_ = std::make_unique<WalkLattice>(room.floor, coarse * step, radius, 0);
        for (const Ring& ring : obstacles) lattice_->put(ring, 1);
        return;
    }
    const std::size_t fine_groups = groups_.size();
    Groups kept_groups = std::move(groups_);
    std::unique_ptr<WalkLattice> kept = std::move(lattice_);
    // A way that is free by this margin more is a way of the fine lattice: its points are rounded to nodes at most
    // step / sqrt(2) away, which have to be free by step / 2.
    const double margin = 1.25 * step;
    groups_ = set_up(coarse * step, margin, coarse_gates);
    if (coarse_gates == fine_gates && groups_.size() == fine_groups) return;
    groups_ = std::move(kept_groups);
    lattice_ = std::move(kept);
}

bool Walkways::all_open() {
    lattice_->start_reaching();
    for (const std::vector<std::uint32_t>& group : groups_) {
        lattice_->reach(group.front());
        for (const std::uint32_t node : group)
            if (!lattice_->has_reached(node)) return false;
    }
    return true;
}

bool Walkways::some_reached(const std::vector<std::uint32_t>& nodes) const {
    if (groups_.empty()) return true;
    return std::any_of(nodes.begin(), nodes.end(), [&](std::uint32_t n) { return lattice_->has_reached(n); });
}

}  // namespace enfilade::modeler
