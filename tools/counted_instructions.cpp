#include "tools/counted_instructions.h"

#include <sys/ptrace.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>

#include <algorithm>

namespace enfilade::tools {

namespace {

/// The steps of a child from its first stop to its next one; it is gone afterwards.
std::optional<std::uint64_t> steps_of_child(const std::function<void()>& work, std::uint64_t most) {
    const pid_t child = fork();
    if (child < 0) return std::nullopt;
    if (child == 0) {
        if (ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0) _exit(1);
        raise(SIGSTOP);
        work();
        raise(SIGSTOP);
        _exit(0);
    }
    int status = 0;
    const auto stopped_by = [&](int signal) {
        return waitpid(child, &status, 0) == child && WIFSTOPPED(status) && WSTOPSIG(status) == signal;
    };
    std::optional<std::uint64_t> counted;
    if (stopped_by(SIGSTOP)) {
        std::uint64_t steps = 0;
        while (steps <= most && ptrace(PTRACE_SINGLESTEP, child, nullptr, nullptr) == 0) {
            if (!stopped_by(SIGTRAP)) {
                if (WIFSTOPPED(status) && WSTOPSIG(status) == SIGSTOP) counted = steps;
                break;
            }
            ++steps;
        }
    }
    if (!WIFEXITED(status) && !WIFSIGNALED(status)) {
        kill(child, SIGKILL);
        waitpid(child, &status, 0);
    }
    return counted;
}

}  // namespace

std::optional<std::uint64_t> counted_instructions(const std::function<void()>& work, std::uint64_t most) {
    static constexpr auto nothing = [] {};
    const std::optional<std::uint64_t> own = steps_of_child(nothing, most);
    const std::optional<std::uint64_t> all = own ? steps_of_child(work, most) : std::nullopt;
    if (!all) return std::nullopt;
    return *all - std::min(*all, *own);
}

}  // namespace enfilade::tools
