#include "modeler/map_geometry.h"

namespace enfilade::modeler {
namespace {

constexpr std::int8_t unseen = 0;

/// +1 or -1 per dart, neighbours opposite; nothing where that cannot be.
std::optional<std::vector<std::int8_t>> orient(const gmap::MapArrays& arrays) {
    const std::size_t count = arrays.alpha[0].size();
    std::vector<std::int8_t> sign(count, unseen);
    std::vector<std::uint32_t> queue;
    for (std::uint32_t start = 0; start < count; ++start) {
        if (sign[start] != unseen || arrays.alpha[0][start] == UINT32_MAX) continue;
        sign[start] = 1;
        queue.push_back(start);
        while (!queue.empty()) {
            const std::uint32_t d = queue.back();
            queue.pop_back();
            for (const auto& alpha : arrays.alpha) {
                const std::uint32_t e = alpha[d];
                if (e == d) continue;
                if (sign[e] == sign[d]) return std::nullopt;
                if (sign[e] != unseen) continue;
                sign[e] = std::int8_t(-sign[d]);
                queue.push_back(e);
            }
        }
    }
    return sign;
}

}  // namespace

std::optional<std::vector<Int128>> volumes6(const gmap::Map& map,
                                            const std::vector<std::array<std::int32_t, 3>>& vertices) {
    const gmap::MapArrays& arrays = map.arrays();
    const auto sign = orient(arrays);
    if (!sign) return std::nullopt;
    const std::size_t count = arrays.alpha[0].size();
    // Each face is a fan of triangles around its first vertex, each triangle a cone over the origin.
    std::vector<std::uint32_t> apex(arrays.cell_bound[2], UINT32_MAX);
    std::vector<Int128> sum(arrays.cell_bound[3], 0);
    for (std::uint32_t d = 0; d < count; ++d) {
        if ((*sign)[d] != 1) continue;
        std::uint32_t& top = apex[arrays.cell_id[2][d]];
        if (top == UINT32_MAX) top = arrays.cell_id[0][d];
        const auto& p = vertices[top];
        const auto& a = vertices[arrays.cell_id[0][d]];
        const auto& b = vertices[arrays.cell_id[0][arrays.alpha[0][d]]];
        const auto minor = [&](int i, int j) {
            return std::int64_t(a[std::size_t(i)]) * b[std::size_t(j)] -
                   std::int64_t(a[std::size_t(j)]) * b[std::size_t(i)];
        };
        sum[arrays.cell_id[3][d]] +=
            Int128(p[0]) * minor(1, 2) + Int128(p[1]) * minor(2, 0) + Int128(p[2]) * minor(0, 1);
    }
    // Which way round is inside: all cells but one (`Outside`) are positive.
    std::size_t positive = 0;
    for (const Int128 v : sum) positive += v > 0;
    if (2 * positive < sum.size())
        for (Int128& v : sum) v = -v;
    return sum;
}

}  // namespace enfilade::modeler
