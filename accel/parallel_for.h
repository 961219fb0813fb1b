#pragma once
// How accel and render spread work over cores, replaceable by the caller's own scheduler (TBB in render).

#include <algorithm>
#include <cstddef>
#include <functional>

namespace enfilade::accel {

/// Runs chunks of work. Results never depend on it: chunks are fixed by the caller and write to their own places.
class Executor {
public:
    virtual ~Executor() = default;
    /// Calls body(chunk) once for each chunk in [0, chunk_count), in any order, and returns when all are done.
    /// An exception from body is passed on after the others have ended.
    virtual void run(std::size_t chunk_count, const std::function<void(std::size_t)>& body) const = 0;
};

/// One chunk after the other on the calling thread.
class SerialExecutor final : public Executor {
public:
    void run(std::size_t chunk_count, const std::function<void(std::size_t)>& body) const override;
};

/// std::thread only: what a build without TBB has. Threads live for one `run`.
class ThreadExecutor final : public Executor {
public:
    /// 0: as many as the machine has.
    explicit ThreadExecutor(unsigned thread_count = 0);
    void run(std::size_t chunk_count, const std::function<void(std::size_t)>& body) const override;

private:
    unsigned thread_count_;
};

/// Calls body(begin, end) for pieces of at most `grain` of [0, count).
template <class Body>
void parallel_for(const Executor& executor, std::size_t count, std::size_t grain, const Body& body) {
    if (count == 0) return;
    executor.run((count + grain - 1) / grain,
                 [&](std::size_t chunk) { body(chunk * grain, std::min(count, (chunk + 1) * grain)); });
}

}  // namespace enfilade::accel
