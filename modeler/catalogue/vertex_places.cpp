#include "modeler/catalogue/vertex_places.h"

#include <algorithm>
#include <numeric>

namespace enfilade::modeler {

std::vector<std::uint32_t> vertex_places(std::span<const std::array<float, 3>> vertices) {
    std::vector<std::uint32_t> order(vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        // Floats compare -0 and 0 as equal, which is what is wanted.
        if (vertices[a] < vertices[b]) return true;
        if (vertices[b] < vertices[a]) return false;
        return a < b;
    });
    std::vector<std::uint32_t> places(vertices.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
        const bool same = k > 0 && vertices[order[k]] == vertices[order[k - 1]];
        places[order[k]] = same ? places[order[k - 1]] : order[k];
    }
    return places;
}

}  // namespace enfilade::modeler
