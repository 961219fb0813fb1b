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

/// The machine's choice first, then every set it has, then none: the scalar fallback. Only the first in a build without
/// Highway.
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
