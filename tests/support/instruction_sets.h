#pragma once
// The instruction sets that the loops of many rays are compiled for, to run tests with each that the machine has.

#include <cstdint>
#include <string>
#include <vector>

namespace enfilade::test {

struct InstructionSet {
    std::string name;
    std::int64_t target;  ///< of Highway; 0: what the machine chooses
};

/// Every set that the machine has, the one it chooses first, then none: the scalar fallback. In a build without Highway
/// only "best", which is that fallback.
[[nodiscard]] std::vector<InstructionSet> instruction_sets();

/// Has `lane_kernels` choose this set while it lives.
class UsingInstructionSet {
public:
    explicit UsingInstructionSet(const InstructionSet& set);
    ~UsingInstructionSet();
    UsingInstructionSet(const UsingInstructionSet&) = delete;
    UsingInstructionSet& operator=(const UsingInstructionSet&) = delete;
};

}  // namespace enfilade::test
