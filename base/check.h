#pragma once
// Our own mistakes: abort with the condition and where it stands.

#include <cstdio>
#include <cstdlib>

namespace enfilade::detail {
[[noreturn]] inline void check_failed(const char* condition, const char* file, int line) {
    std::fprintf(stderr, "enfilade: internal check failed: %s (%s:%d)\n", condition, file, line);
    std::abort();
}
}  // namespace enfilade::detail

/// Always on: for cold paths whose failure would corrupt what comes after.
#define ENFILADE_CHECK(condition) \
    ((condition) ? void(0) : ::enfilade::detail::check_failed(#condition, __FILE__, __LINE__))

#ifdef NDEBUG
#define ENFILADE_ASSERT(condition) void(0)
#else
#define ENFILADE_ASSERT(condition) ENFILADE_CHECK(condition)
#endif
