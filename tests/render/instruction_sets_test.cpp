// That tests with an instruction set run with that one.
#include "tests/support/instruction_sets.h"

#include <gtest/gtest.h>

#include <string>

#include "render/kernel.h"

namespace enfilade::render {
namespace {

TEST(InstructionSets, AreUsedWhenAskedFor) {
    for (const test::InstructionSet& set : test::instruction_sets()) {
        const test::UsingInstructionSet here(set);
        const detail::LaneKernels* lanes = detail::lane_kernels();
        const std::string name = lanes == nullptr ? "none" : lanes->name;
        if (set.name != "best") {
            EXPECT_EQ(name, set.name);
        }
        RecordProperty(set.name, lanes == nullptr ? 0 : lanes->lanes);
    }
}

TEST(InstructionSets, AreTheMachinesBestAgainAfterwards) {
    const std::vector<test::InstructionSet> sets = test::instruction_sets();
    const detail::LaneKernels* before = detail::lane_kernels();
    { const test::UsingInstructionSet last(sets.back()); }
    EXPECT_EQ(detail::lane_kernels(), before);
    if (before != nullptr) {
        EXPECT_EQ(before->name, sets.front().name);
    }
}

}  // namespace
}  // namespace enfilade::render
