#pragma once
// Sets that grow together (union and find, with path halving).

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace enfilade::modeler {

class Components {
public:
    explicit Components(std::size_t count) : root_(count) { std::iota(root_.begin(), root_.end(), 0u); }
    /// The lowest member of the set of k.
    [[nodiscard]] std::uint32_t root(std::uint32_t k) {
        while (root_[k] != k) k = root_[k] = root_[root_[k]];
        return k;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        a = root(a), b = root(b);
        root_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::uint32_t> root_;
};

}  // namespace enfilade::modeler
