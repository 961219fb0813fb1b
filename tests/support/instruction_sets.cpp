#include "tests/support/instruction_sets.h"

#if defined(ENFILADE_HAS_LANES)

#include <hwy/targets.h>

namespace enfilade::test {
namespace {

void choose(std::int64_t targets) {
    hwy::SetSupportedTargetsForTest(targets);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace

std::vector<InstructionSet> instruction_sets() {
    std::vector<InstructionSet> sets;
    // The sets that render/lanes compiles for; others would fall back to the scalar tracer.
    constexpr std::int64_t compiled = HWY_SSE4 | HWY_AVX2 | HWY_AVX3 | HWY_NEON;
    for (std::int64_t left = hwy::SupportedTargets() & compiled; left != 0; left &= left - 1) {
        const std::int64_t target = left & ~(left - 1);
        sets.push_back({hwy::TargetName(target), target});
    }
    sets.push_back({"none", HWY_EMU128});
    return sets;
}

UsingInstructionSet::UsingInstructionSet(const InstructionSet& set) { choose(set.target); }
UsingInstructionSet::~UsingInstructionSet() { choose(0); }

}  // namespace enfilade::test

#else

namespace enfilade::test {

std::vector<InstructionSet> instruction_sets() { return {{"best", 0}}; }
UsingInstructionSet::UsingInstructionSet(const InstructionSet&) {}
UsingInstructionSet::~UsingInstructionSet() = default;

}  // namespace enfilade::test

#endif
