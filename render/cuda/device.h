#pragma once
// Where kernels run: a card, or the cores of this machine, which run the same functions warp by warp (tests; looking
// for faults without a card). Memory, order of work, and time.

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "accel/parallel_for.h"
#include "render/cuda/card.h"

namespace enfilade::render::cuda {

/// Work is done in the order in which it is asked for, and not before it is waited for: uploads, kernels (launch.h),
/// downloads. Not for several threads at once.
class Device {
public:
    Device() = default;
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;
    virtual ~Device() = default;

    [[nodiscard]] virtual const std::string& name() const = 0;
    /// False: this machine's cores play the card.
    [[nodiscard]] virtual bool is_card() const = 0;
    [[nodiscard]] virtual int multiprocessors() const = 0;

    /// Memory that kernels see; aligned to 256 bytes, what is in it is not defined. \throws CudaError where there is
    /// not enough
    [[nodiscard]] virtual void* allocate(std::size_t bytes) = 0;
    virtual void release(void* memory) noexcept = 0;
    /// From this machine's memory, which may change once the call returns.
    virtual void upload(void* to, const void* from, std::size_t bytes) = 0;
    /// Waits for all work before.
    virtual void download(void* to, const void* from, std::size_t bytes) = 0;
    /// All bytes 0.
    virtual void clear(void* memory, std::size_t bytes) = 0;
    /// \throws CudaError if any of the work failed
    virtual void wait() = 0;
    /// Seconds from the first piece of work in `ask` to the end of the last one; waits for it. Of a card by its own
    /// clock, without what the host needs before and after.
    [[nodiscard]] virtual double seconds_of(const std::function<void()>& ask) = 0;

    /// The queue of a card's work (cudaStream_t); nullptr where there is none.
    [[nodiscard]] virtual void* stream() const = 0;
    /// Who plays the card's threads where there is none.
    [[nodiscard]] virtual const accel::Executor& executor() const = 0;
};

/// \throws CudaError with why_no_card(number)
[[nodiscard]] std::unique_ptr<Device> open_card(int number);

/// This machine's cores. The executor must outlive the device.
[[nodiscard]] std::unique_ptr<Device> open_host(const accel::Executor& executor);

}  // namespace enfilade::render::cuda
