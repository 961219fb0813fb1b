#include "modeler/constraints/culprits.h"

#include <algorithm>
#include <map>
#include <queue>
#include <tuple>

namespace enfilade::modeler {
namespace {

struct Weight {
    std::uint32_t all = 0, off_plan = 0, upright_without = 0;
    std::uint32_t vertex = 0;
    bool operator<(const Weight& other) const {
        return std::tie(all, off_plan, upright_without, other.vertex) <
               std::tie(other.all, other.off_plan, other.upright_without, vertex);
    }
    bool operator==(const Weight&) const = default;
};

class Detective {
public:
    Detective(const Building& building, const FaceRings& rings, const std::vector<FaceFault>& faults)
        : rings_(rings), faults_(faults), plan_(building.points), explained_(faults.size(), false) {
        std::sort(plan_.begin(), plan_.end());
        std::vector<std::uint32_t> rest;
        for (std::uint32_t k = 0; k < faults.size(); ++k)
            for (const std::uint32_t v : faults[k].suspects) {
                const auto ring = rings.ring(faults[k].face);
                rest.assign(ring.begin(), ring.end());
                std::erase(rest, v);
                const Lie lie = lie_of(rest, rings.points());
                suspected_[v].push_back({k, lie == Lie::Level || lie == Lie::Upright});
            }
    }

    /// Weights only fall as faults are explained, so an old one is an upper bound: look again before it is believed.
    std::vector<Culprit> run() {
        std::priority_queue<Weight> queue;
        for (const auto& [v, evidence] : suspected_) queue.push(weigh(v, evidence));
        std::vector<Culprit> result;
        while (!queue.empty()) {
            const Weight top = queue.top();
            queue.pop();
            const Weight now = weigh(top.vertex, suspected_[top.vertex]);
            if (now.all == 0) continue;
            if (now == top) result.push_back(convict(top.vertex));
            else queue.push(now);
        }
        for (std::uint32_t k = 0; k < faults_.size(); ++k)
            if (!explained_[k] && faults_[k].decisive) result.push_back({UINT32_MAX, {k}});
        return result;
    }

private:
    struct Evidence {
        std::uint32_t fault = 0;
        bool upright_without = false;
    };

    /// Nothing counts where no decisive fault is left.
    Weight weigh(std::uint32_t v, const std::vector<Evidence>& evidence) const {
        Weight weight{.vertex = v};
        bool decisive = false;
        for (const Evidence& e : evidence) {
            if (explained_[e.fault]) continue;
            decisive = decisive || faults_[e.fault].decisive;
            ++weight.all;
            weight.upright_without += e.upright_without;
        }
        if (!decisive) return {.vertex = v};
        const Point3& p = rings_.point(v);
        weight.off_plan = !std::binary_search(plan_.begin(), plan_.end(), plans::GridPoint{p[0], p[1]});
        return weight;
    }

    Culprit convict(std::uint32_t v) {
        Culprit culprit{v, {}};
        for (const bool decisive : {true, false})
            for (const Evidence& e : suspected_[v])
                if (!explained_[e.fault] && faults_[e.fault].decisive == decisive) culprit.faults.push_back(e.fault);
        for (const std::uint32_t k : culprit.faults) explained_[k] = true;
        return culprit;
    }

    const FaceRings& rings_;
    const std::vector<FaceFault>& faults_;
    std::vector<plans::GridPoint> plan_;
    std::map<std::uint32_t, std::vector<Evidence>> suspected_;  ///< by vertex
    std::vector<bool> explained_;
};

/// The vertices off the plane through three others; `few` of them at most.
std::vector<std::uint32_t> off_plane(std::span<const std::uint32_t> ring, const std::vector<Point3>& points,
                                     const std::array<std::uint32_t, 3>& plane, std::uint32_t without,
                                     std::size_t few) {
    std::vector<std::uint32_t> off;
    const Point3& a = points[plane[0]];
    const auto normal = normal_of(a, points[plane[1]], points[plane[2]]);
    for (const std::uint32_t v : ring) {
        if (v == without || height_over(a, normal, points[v]) == 0) continue;
        off.push_back(v);
        if (off.size() >= few) break;
    }
    return off;
}

}  // namespace

std::vector<Culprit> culprits(const Building& building, const FaceRings& rings, const std::vector<FaceFault>& faults) {
    return faults.empty() ? std::vector<Culprit>{} : Detective(building, rings, faults).run();
}

std::vector<std::uint32_t> bent_corners(std::span<const std::uint32_t> ring, const std::vector<Point3>& points) {
    std::vector<std::uint32_t> found;
    const auto plane = plane_corners(ring, points);
    if (!plane) return found;
    // One off the plane: it. More: one of the three that span it, if any.
    const auto off = off_plane(ring, points, *plane, UINT32_MAX, 2);
    if (off.size() == 1) found.push_back(off[0]);
    for (const std::uint32_t v : *plane) {
        if (off.empty()) break;
        const auto rest = plane_corners(ring, points, v);
        if (!rest || off_plane(ring, points, *rest, v, 1).empty()) found.push_back(v);
    }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace enfilade::modeler
