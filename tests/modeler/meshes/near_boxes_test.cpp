#include "modeler/meshes/near_boxes.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

namespace enfilade::modeler {
namespace {

RC_GTEST_PROP(NearBoxes, FindsEachPairOnce, ()) {
    const auto count = *rc::gen::inRange<std::uint32_t>(0, 200);
    const int room = *rc::gen::element(1, 10, 60);
    std::vector<NearBox> boxes(count);
    for (NearBox& box : boxes)
        for (std::size_t i = 0; i < 3; ++i) {
            box.low[i] = float(*rc::gen::inRange(-room, room + 1));
            box.high[i] = box.low[i] + float(*rc::gen::inRange(0, 6));
        }
    std::multiset<std::pair<std::uint32_t, std::uint32_t>> found, expected;
    NearBoxes(boxes).pairs([&](std::uint32_t a, std::uint32_t b) { found.insert(std::minmax(a, b)); });
    for (std::uint32_t a = 0; a < count; ++a)
        for (std::uint32_t b = a + 1; b < count; ++b)
            if (boxes[a].overlaps(boxes[b])) expected.insert({a, b});
    RC_ASSERT(found == expected);
}

TEST(NearBoxes, RoundOutward) {
    for (const double x : {0.1, -0.1, 1e12 + 0.3, -1e-300, 16777217.0}) {
        EXPECT_LE(double(NearBox::below(x)), x);
        EXPECT_GE(double(NearBox::above(x)), x);
    }
    EXPECT_EQ(NearBox::below(0.5), 0.5f);
    EXPECT_EQ(NearBox::above(0.5), 0.5f);
}

}  // namespace
}  // namespace enfilade::modeler
