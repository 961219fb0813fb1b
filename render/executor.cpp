#include "render/executor.h"

#if defined(ENFILADE_HAS_TBB)
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace enfilade::render {
namespace {

#if defined(ENFILADE_HAS_TBB)
class TbbExecutor final : public accel::Executor {
public:
    explicit TbbExecutor(unsigned thread_count)
        : arena_(thread_count > 0 ? static_cast<int>(thread_count) : tbb::task_arena::automatic) {}
    void run(std::size_t chunk_count, const std::function<void(std::size_t)>& body) const override {
        arena_.execute([&] { tbb::parallel_for(std::size_t{0}, chunk_count, [&](std::size_t i) { body(i); }); });
    }

private:
    mutable tbb::task_arena arena_;  // synchronises itself
};
#endif

}  // namespace

std::unique_ptr<accel::Executor> make_executor(unsigned thread_count) {
    if (thread_count == 1) return std::make_unique<accel::SerialExecutor>();
#if defined(ENFILADE_HAS_TBB)
    return std::make_unique<TbbExecutor>(thread_count);
#else
    return std::make_unique<accel::ThreadExecutor>(thread_count);
#endif
}

}  // namespace enfilade::render
