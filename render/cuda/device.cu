#include "render/cuda/device.h"

#include <chrono>
#include <cstring>
#include <new>

#if defined(__CUDACC__)
#include "render/cuda/check_call.h"
#endif

namespace enfilade::render::cuda {
namespace {

constexpr std::align_val_t alignment = std::align_val_t(256);

/// This machine's cores.
class HostDevice final : public Device {
public:
    explicit HostDevice(const accel::Executor& executor) : executor_(executor) {}

    const std::string& name() const override { return name_; }
    bool is_card() const override { return false; }
    int multiprocessors() const override { return 1; }
    void* allocate(std::size_t bytes) override { return ::operator new(bytes, alignment); }
    void release(void* memory) noexcept override { ::operator delete(memory, alignment); }
    void upload(void* to, const void* from, std::size_t bytes) override { std::memcpy(to, from, bytes); }
    void download(void* to, const void* from, std::size_t bytes) override { std::memcpy(to, from, bytes); }
    void clear(void* memory, std::size_t bytes) override { std::memset(memory, 0, bytes); }
    void wait() override {}
    double seconds_of(const std::function<void()>& ask) override {
        const auto begin = std::chrono::steady_clock::now();
        ask();
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }
    void* stream() const override { return nullptr; }
    const accel::Executor& executor() const override { return executor_; }

private:
    const accel::Executor& executor_;
    std::string name_ = "this machine's cores";
};

#if defined(__CUDACC__)

class CardDevice final : public Device {
public:
    explicit CardDevice(int number) {
        check_call(cudaSetDevice(number), "choosing it");
        cudaDeviceProp properties = {};
        check_call(cudaGetDeviceProperties(&properties, number), "describing it");
        name_ = properties.name;
        multiprocessors_ = properties.multiProcessorCount;
        check_call(cudaStreamCreateWithFlags(&stream_, cudaStreamNonBlocking), "making a queue");
        check_call(cudaEventCreate(&begin_), "making a clock");
        check_call(cudaEventCreate(&end_), "making a clock");
    }
    ~CardDevice() override {
        cudaEventDestroy(begin_);
        cudaEventDestroy(end_);
        cudaStreamDestroy(stream_);
    }

    const std::string& name() const override { return name_; }
    bool is_card() const override { return true; }
    int multiprocessors() const override { return multiprocessors_; }
    void* allocate(std::size_t bytes) override {
        void* memory = nullptr;
        const cudaError_t answer = cudaMalloc(&memory, bytes);
        if (answer == cudaErrorMemoryAllocation) {
            cudaGetLastError();
            throw CudaError("The memory of " + name_ + " does not hold another " + std::to_string(bytes >> 20) +
                            " MiB: choose a smaller scene or picture.");
        }
        check_call(answer, "getting memory");
        return memory;
    }
    void release(void* memory) noexcept override { cudaFree(memory); }
    void upload(void* to, const void* from, std::size_t bytes) override {
        check_call(cudaMemcpyAsync(to, from, bytes, cudaMemcpyHostToDevice, stream_), "copying to it");
        check_call(cudaStreamSynchronize(stream_), "copying to it");
    }
    void download(void* to, const void* from, std::size_t bytes) override {
        check_call(cudaMemcpyAsync(to, from, bytes, cudaMemcpyDeviceToHost, stream_), "copying from it");
        check_call(cudaStreamSynchronize(stream_), "copying from it");
    }
    void clear(void* memory, std::size_t bytes) override {
        check_call(cudaMemsetAsync(memory, 0, bytes, stream_), "clearing memory");
    }
    void wait() override { check_call(cudaStreamSynchronize(stream_), "working"); }
    double seconds_of(const std::function<void()>& ask) override {
        check_call(cudaEventRecord(begin_, stream_), "reading its clock");
        ask();
        check_call(cudaEventRecord(end_, stream_), "reading its clock");
        check_call(cudaEventSynchronize(end_), "working");
        float milliseconds = 0;
        check_call(cudaEventElapsedTime(&milliseconds, begin_, end_), "reading its clock");
        return double(milliseconds) / 1000;
    }
    void* stream() const override { return stream_; }
    const accel::Executor& executor() const override { return serial_; }

private:
    std::string name_;
    int multiprocessors_ = 0;
    cudaStream_t stream_ = nullptr;
    cudaEvent_t begin_ = nullptr, end_ = nullptr;
    accel::SerialExecutor serial_;
};

#endif

}  // namespace

std::unique_ptr<Device> open_card(int number) {
    const std::string why = why_no_card(number);
    if (!why.empty()) throw CudaError(why);
#if defined(__CUDACC__)
    return std::make_unique<CardDevice>(number);
#else
    return nullptr;
#endif
}

std::unique_ptr<Device> open_host(const accel::Executor& executor) { return std::make_unique<HostDevice>(executor); }

}  // namespace enfilade::render::cuda
