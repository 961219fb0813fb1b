#pragma once
// A frame's kernels as a CUDA graph: recorded once, started again with other arguments as one piece of work.

#include <array>
#include <initializer_list>
#include <memory>

#include "render/cuda/device.h"

namespace enfilade::render::cuda {

/// Of a card alone. The device must outlive it.
class FrameGraph {
public:
    explicit FrameGraph(Device& device);
    FrameGraph(const FrameGraph&) = delete;
    FrameGraph& operator=(const FrameGraph&) = delete;
    ~FrameGraph();

    /// A kernel of two arguments as the runtime counts it. They are read at once.
    struct Node {
        const void* function;
        unsigned blocks, threads_a_block;
        std::array<void*, 2> arguments;
    };

    /// Asks for the kernels, one after the other: records them at first and where their number has changed, else
    /// exchanges their arguments. \throws CudaError
    void start(std::initializer_list<Node> nodes);
    /// How often they were recorded.
    [[nodiscard]] int recordings() const { return recordings_; }

private:
    struct Recorded;
    Device& device_;
    std::unique_ptr<Recorded> recorded_;
    int recordings_ = 0;
};

}  // namespace enfilade::render::cuda
