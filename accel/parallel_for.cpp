#include "accel/parallel_for.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace enfilade::accel {

void SerialExecutor::run(std::size_t chunk_count, const std::function<void(std::size_t)>& body) const {
    for (std::size_t chunk = 0; chunk < chunk_count; ++chunk) body(chunk);
}

ThreadExecutor::ThreadExecutor(unsigned thread_count)
    : thread_count_(thread_count > 0 ? thread_count : std::max(1u, std::thread::hardware_concurrency())) {}

void ThreadExecutor::run(std::size_t chunk_count, const std::function<void(std::size_t)>& body) const {
    const std::size_t thread_count = std::min<std::size_t>(thread_count_, chunk_count);
    if (thread_count <= 1) {
        SerialExecutor().run(chunk_count, body);
        return;
    }
    std::atomic<std::size_t> next = 0;
    std::mutex error_mutex;
    std::exception_ptr error;
    const auto work = [&] {
        for (std::size_t chunk = next++; chunk < chunk_count; chunk = next++) {
            try {
                body(chunk);
            } catch (...) {
                const std::scoped_lock lock(error_mutex);
                if (!error) error = std::current_exception();
            }
        }
    };
    std::vector<std::jthread> threads;
    try {
        for (std::size_t i = 1; i < thread_count; ++i) threads.emplace_back(work);
    } catch (const std::system_error&) {
        // A machine that refuses more threads still gets the work done by those there are.
    }
    work();
    threads.clear();
    if (error) std::rethrow_exception(error);
}

}  // namespace enfilade::accel
