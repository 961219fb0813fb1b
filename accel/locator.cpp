#include "accel/locator.h"

#include <algorithm>
#include <array>
#include <limits>

namespace enfilade::accel::detail {
namespace {

class LocatorBuilder {
public:
    explicit LocatorBuilder(const SceneView& view) : boxes_(view.cells.size()) {
        for (std::size_t i = 0; i < view.cells.size(); ++i) {
            const Cell& cell = view.cells[i];
            Box& box = boxes_[i];
            for (std::uint32_t k = cell.first_section; k < cell.first_section + cell.section_count; ++k)
                box.add({view.section_x[k], view.section_y[k], cell.z_floor});
            box.add({box.low[0], box.low[1], cell.z_ceiling});
            result_.cells.push_back(static_cast<CellId>(i));
        }
    }

    Locator build() {
        if (!result_.cells.empty()) build_node(0, static_cast<std::uint32_t>(result_.cells.size()));
        return std::move(result_);
    }

private:
    struct Box {
        std::array<float, 3> low = {std::numeric_limits<float>::max(), std::numeric_limits<float>::max(),
                                    std::numeric_limits<float>::max()};
        std::array<float, 3> high = {std::numeric_limits<float>::lowest(), std::numeric_limits<float>::lowest(),
                                     std::numeric_limits<float>::lowest()};
        void add(const std::array<float, 3>& p) {
            for (int k = 0; k < 3; ++k) {
                low[k] = std::min(low[k], p[k]);
                high[k] = std::max(high[k], p[k]);
            }
        }
        [[nodiscard]] float centre(int axis) const { return low[axis] + high[axis]; }
    };

    void build_node(std::uint32_t begin, std::uint32_t end) {
        const std::size_t node = result_.nodes.size();
        Box box;
        Box centres;
        for (std::uint32_t i = begin; i < end; ++i) {
            const Box& of_cell = boxes_[index(result_.cells[i])];
            box.add(of_cell.low);
            box.add(of_cell.high);
            centres.add({of_cell.centre(0), of_cell.centre(1), of_cell.centre(2)});
        }
        const std::uint32_t count = end - begin;
        const bool is_leaf = count <= locator_leaf_cells;
        result_.nodes.push_back({box.low, box.high, 0, is_leaf ? begin << 3 | count : 0});
        if (!is_leaf) {
            int axis = 0;
            for (int k = 1; k < 3; ++k)
                if (centres.high[k] - centres.low[k] > centres.high[axis] - centres.low[axis]) axis = k;
            const std::uint32_t middle = begin + count / 2;
            std::nth_element(result_.cells.begin() + begin, result_.cells.begin() + middle, result_.cells.begin() + end,
                             [&](CellId a, CellId b) {
                                 const float ca = boxes_[index(a)].centre(axis);
                                 const float cb = boxes_[index(b)].centre(axis);
                                 return ca != cb ? ca < cb : a < b;
                             });
            build_node(begin, middle);
            build_node(middle, end);
        } else {
            std::sort(result_.cells.begin() + begin, result_.cells.begin() + end);
        }
        result_.nodes[node].skip = static_cast<std::uint32_t>(result_.nodes.size());
    }

    std::vector<Box> boxes_;
    Locator result_;
};

}  // namespace

Locator build_locator(const SceneView& view) { return LocatorBuilder(view).build(); }

}  // namespace enfilade::accel::detail
