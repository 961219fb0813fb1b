#include "modeler/constraints/prism_shell.h"

#include <algorithm>

#include "modeler/constraints/ring_crossings.h"

namespace enfilade::modeler {

bool PrismShells::is_prism(std::uint32_t volume) {
    if (!find_heights(volume)) return false;
    stands_.clear();
    std::array<std::uint32_t, 2> level_faces{};
    for (auto& level : levels_) level.clear();
    for (const std::uint32_t f : rings_.faces_of(volume)) {
        if (rings_.lie(f) == Lie::Upright) {
            if (!add_stand(f)) return false;
            continue;
        }
        const std::size_t at = rings_.point(rings_.ring(f)[0])[2] == z_low_ ? 0 : 1;
        add_level(f, levels_[at]);
        ++level_faces[at];
    }
    if (!sides_stack_up()) return false;
    for (std::size_t at = 0; at < 2; ++at)
        if ((level_faces[at] > 1 && !cancel(levels_[at])) || !runs_over_sides(levels_[at])) return false;
    // The ring of a lone face is known to be simple; one of the two says it for both.
    return level_faces[0] == 1 || level_faces[1] == 1 || is_one_simple_ring(levels_[0]);
}

/// Two heights, with level faces at both and nothing but upright ones between them.
bool PrismShells::find_heights(std::uint32_t volume) {
    z_low_ = INT32_MAX, z_high_ = INT32_MIN;
    for (const std::uint32_t f : rings_.faces_of(volume)) {
        const Lie lie = rings_.lie(f);
        if (lie != Lie::Level && lie != Lie::Upright) return false;
        if (lie == Lie::Upright) continue;
        const std::int32_t z = rings_.point(rings_.ring(f)[0])[2];
        z_low_ = std::min(z_low_, z);
        z_high_ = std::max(z_high_, z);
    }
    if (z_low_ >= z_high_) return false;
    for (const std::uint32_t f : rings_.faces_of(volume)) {
        if (rings_.lie(f) != Lie::Level) continue;
        const std::int32_t z = rings_.point(rings_.ring(f)[0])[2];
        if (z != z_low_ && z != z_high_) return false;
    }
    return true;
}

bool PrismShells::add_stand(std::uint32_t face) {
    const auto ring = rings_.ring(face);
    std::array<std::uint64_t, 2> feet = {foot(ring[0]), foot(ring[0])};
    std::array<std::int32_t, 2> low = {INT32_MAX, INT32_MAX}, high = {INT32_MIN, INT32_MIN};
    for (const std::uint32_t v : ring) {
        const std::uint64_t at = foot(v);
        if (at != feet[0] && feet[1] == feet[0]) feet[1] = at;
        const std::size_t k = at == feet[0] ? 0 : 1;
        if (at != feet[k]) return false;
        const std::int32_t z = rings_.point(v)[2];
        low[k] = std::min(low[k], z);
        high[k] = std::max(high[k], z);
    }
    if (low[0] != low[1] || high[0] != high[1] || low[0] >= high[0]) return false;
    stands_.push_back({std::min(feet[0], feet[1]), std::max(feet[0], feet[1]), low[0], high[0]});
    return true;
}

void PrismShells::add_level(std::uint32_t face, std::vector<LevelEdge>& edges) const {
    const auto ring = rings_.ring(face);
    const auto at = [&](std::size_t k) {
        const Point3& p = rings_.point(ring[k]);
        return plans::GridPoint{p[0], p[1]};
    };
    std::int64_t area = 0;
    for (std::size_t k = 1; k + 1 < ring.size(); ++k) area += orientation(at(0), at(k), at(k + 1));
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const std::uint32_t a = ring[k], b = ring[k + 1 < ring.size() ? k + 1 : 0];
        edges.push_back(area > 0 ? LevelEdge{a, b} : LevelEdge{b, a});
    }
}

bool PrismShells::sides_stack_up() {
    std::sort(stands_.begin(), stands_.end());
    sides_.clear();
    for (std::size_t k = 0; k < stands_.size();) {
        const Stand& first = stands_[k];
        sides_.push_back({first.foot, first.other_foot});
        std::int32_t z = z_low_;
        for (; k < stands_.size() && stands_[k].foot == first.foot && stands_[k].other_foot == first.other_foot; ++k) {
            if (stands_[k].z_low != z) return false;
            z = stands_[k].z_high;
        }
        if (z != z_high_) return false;
    }
    return true;
}

bool PrismShells::cancel(std::vector<LevelEdge>& edges) {
    const auto key = [](const LevelEdge& e) {
        return std::uint64_t(std::min(e.from, e.to)) << 32 | std::max(e.from, e.to);
    };
    std::sort(edges.begin(), edges.end(), [&](const LevelEdge& a, const LevelEdge& b) { return key(a) < key(b); });
    std::size_t kept = 0;
    for (std::size_t k = 0; k < edges.size();) {
        std::size_t end = k + 1;
        while (end < edges.size() && key(edges[end]) == key(edges[k])) ++end;
        if (end - k > 2 || (end - k == 2 && edges[k].from == edges[k + 1].from)) return false;
        if (end - k == 1) edges[kept++] = edges[k];
        k = end;
    }
    edges.resize(kept);
    return true;
}

bool PrismShells::runs_over_sides(const std::vector<LevelEdge>& edges) {
    if (edges.size() != sides_.size()) return false;
    over_.clear();
    for (const LevelEdge& e : edges) {
        const std::uint64_t a = foot(e.from), b = foot(e.to);
        over_.push_back({std::min(a, b), std::max(a, b)});
    }
    std::sort(over_.begin(), over_.end());
    return over_ == sides_;
}

bool PrismShells::is_one_simple_ring(std::vector<LevelEdge>& edges) const {
    const auto by_from = [](const LevelEdge& a, const LevelEdge& b) { return a.from < b.from; };
    std::sort(edges.begin(), edges.end(), by_from);
    std::vector<plans::GridPoint> ring;
    std::uint32_t at = edges.front().from;
    do {
        const auto next = std::lower_bound(edges.begin(), edges.end(), LevelEdge{at, 0}, by_from);
        if (next == edges.end() || next->from != at) return false;
        ring.push_back({rings_.point(at)[0], rings_.point(at)[1]});
        at = next->to;
    } while (at != edges.front().from && ring.size() <= edges.size());
    return ring.size() == edges.size() && ring_crossings(ring, 1).empty();
}

}  // namespace enfilade::modeler
