#include "modeler/exports/ring_trace.h"

#include <algorithm>
#include <iterator>

#include "base/error.h"

namespace enfilade::modeler {

namespace {

using Node = std::array<std::int64_t, 2>;

[[noreturn]] void refuse() {
    throw InputError("F22", "",
                     "The model cannot be exported: a border of one of its spaces does not close. Check the plan and "
                     "mend what is reported first.");
}

std::int64_t orientation(const Node& a, const Node& b, const Node& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Whether direction p comes before q, counter-clockwise from the positive x axis on.
bool turns_before(const Node& origin, const Node& p, const Node& q) {
    const auto lower = [&](const Node& d) { return d[1] < origin[1] || (d[1] == origin[1] && d[0] < origin[0]); };
    if (lower(p) != lower(q)) return lower(q);
    return orientation(origin, p, q) > 0;
}

/// Whether a ray that turns counter-clockwise from `from` meets p before q.
bool is_first_after(const Node& origin, const Node& from, const Node& p, const Node& q) {
    const bool p_wraps = !turns_before(origin, from, p);
    const bool q_wraps = !turns_before(origin, from, q);
    return p_wraps != q_wraps ? q_wraps : turns_before(origin, p, q);
}

class Tracer {
public:
    Tracer(std::vector<BorderSegment> border, std::span<const Node> nodes) : nodes_(nodes) {
        std::sort(border.begin(), border.end());
        for (const BorderSegment& segment : border)
            if (!std::binary_search(border.begin(), border.end(), BorderSegment{segment.to, segment.from}))
                border_.push_back(segment);
        used_.assign(border_.size(), false);
    }

    RegionRings run() {
        RegionRings rings;
        for (std::size_t k = 0; k < border_.size(); ++k) {
            if (used_[k]) continue;
            std::vector<std::uint32_t> ring;
            for (std::size_t at = k; !used_[at]; at = next(at, k)) {
                used_[at] = true;
                ring.push_back(border_[at].from);
            }
            std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
            if (area2(ring) < 0) {
                rings.holes.push_back(std::move(ring));
                continue;
            }
            if (!rings.outer.empty()) refuse();
            rings.outer = std::move(ring);
        }
        if (rings.outer.empty()) refuse();
        std::sort(rings.holes.begin(), rings.holes.end());
        return rings;
    }

private:
    /// A ring goes on to the border that it sees across what is not the region, so that rings touch and never cross.
    std::size_t next(std::size_t at, std::size_t first) const {
        const std::uint32_t here = border_[at].to;
        const auto begin = std::lower_bound(border_.begin(), border_.end(), BorderSegment{here, 0});
        std::size_t best = SIZE_MAX;
        for (auto k = std::size_t(begin - border_.begin()); k < border_.size() && border_[k].from == here; ++k) {
            if (used_[k] && k != first) continue;
            if (best == SIZE_MAX ||
                is_first_after(nodes_[here], nodes_[border_[at].from], nodes_[border_[k].to], nodes_[border_[best].to]))
                best = k;
        }
        if (best == SIZE_MAX) refuse();
        return best;
    }

    /// Twice the area on the left of a ring; sums wrap round, the result does not.
    std::int64_t area2(const std::vector<std::uint32_t>& ring) const {
        std::uint64_t sum = 0;
        for (std::size_t k = 1; k + 1 < ring.size(); ++k)
            sum += std::uint64_t(orientation(nodes_[ring[0]], nodes_[ring[k]], nodes_[ring[k + 1]]));
        return std::int64_t(sum);
    }

    std::span<const Node> nodes_;
    std::vector<BorderSegment> border_;  ///< sorted
    std::vector<bool> used_;
};

}  // namespace

RegionRings trace_rings(std::vector<BorderSegment> border, std::span<const std::array<std::int64_t, 2>> nodes) {
    return Tracer(std::move(border), nodes).run();
}

}  // namespace enfilade::modeler
