#include "tools/report/ring_chain.h"

#include <algorithm>
#include <numeric>

namespace enfilade::tools {

std::vector<std::vector<std::uint32_t>> chain_rings(std::span<const std::array<std::uint32_t, 2>> sides) {
    const auto n = std::uint32_t(sides.size());
    std::vector<std::uint32_t> order(n);
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t i, std::uint32_t j) { return sides[i][0] < sides[j][0]; });
    std::vector<std::uint8_t> used(n, 0);
    const auto next = [&](std::uint32_t point) {
        auto at = std::lower_bound(order.begin(), order.end(), point,
                                   [&](std::uint32_t i, std::uint32_t p) { return sides[i][0] < p; });
        while (at != order.end() && sides[*at][0] == point && used[*at]) ++at;
        return at == order.end() || sides[*at][0] != point ? n : *at;
    };
    std::vector<std::vector<std::uint32_t>> rings;
    for (const std::uint32_t start : order) {
        if (used[start]) continue;
        std::vector<std::uint32_t>& ring = rings.emplace_back();
        for (std::uint32_t at = start; at < n; at = next(sides[at][1])) {
            used[at] = 1;
            ring.push_back(at);
        }
    }
    return rings;
}

}  // namespace enfilade::tools
