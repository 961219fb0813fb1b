#pragma once
// Machine instructions of some work, counted one by one where the machine has no counters for it, as in most virtual
// ones.

#include <cstdint>
#include <functional>
#include <optional>

namespace enfilade::tools {

/// Instructions that `work` takes on the calling thread, without those of starting it. It runs in a copy of the process
/// that is stepped instruction by instruction, about 2 us each: nothing that it changes is seen here, and it must not
/// wait for other threads. The same work counts the same. Nothing where processes may not be traced, or where there are
/// more than `most`.
[[nodiscard]] std::optional<std::uint64_t> counted_instructions(const std::function<void()>& work,
                                                                std::uint64_t most = 2'000'000);

}  // namespace enfilade::tools
