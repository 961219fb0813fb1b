#include "render/cuda/frame_graph.h"

#if defined(__CUDACC__)
#include <vector>

#include "render/cuda/check_call.h"
#endif

namespace enfilade::render::cuda {

#if defined(__CUDACC__)

/// The graph, its kernels in their order, and what runs it.
struct FrameGraph::Recorded {
    cudaGraph_t graph = nullptr;
    std::vector<cudaGraphNode_t> kernels;
    cudaGraphExec_t executable = nullptr;

    ~Recorded() {
        if (executable != nullptr) cudaGraphExecDestroy(executable);
        if (graph != nullptr) cudaGraphDestroy(graph);
    }
};

namespace {

/// The runtime reads arguments through a pointer that is not const.
cudaKernelNodeParams parameters_of(FrameGraph::Node& node) {
    cudaKernelNodeParams parameters = {};
    parameters.func = const_cast<void*>(node.function);
    parameters.gridDim = dim3(node.blocks);
    parameters.blockDim = dim3(node.threads_a_block);
    parameters.kernelParams = node.arguments.data();
    return parameters;
}

}  // namespace

void FrameGraph::start(std::initializer_list<Node> nodes) {
    std::vector<Node> calls = nodes;
    if (recorded_ == nullptr || recorded_->kernels.size() != calls.size()) {
        auto recorded = std::make_unique<Recorded>();
        check_call(cudaGraphCreate(&recorded->graph, 0), "recording a frame");
        for (Node& call : calls) {
            const cudaKernelNodeParams parameters = parameters_of(call);
            const cudaGraphNode_t* before = recorded->kernels.empty() ? nullptr : &recorded->kernels.back();
            cudaGraphNode_t kernel = nullptr;
            check_call(cudaGraphAddKernelNode(&kernel, recorded->graph, before, before != nullptr ? 1 : 0, &parameters),
                       "recording a frame");
            recorded->kernels.push_back(kernel);
        }
        check_call(cudaGraphInstantiate(&recorded->executable, recorded->graph, 0), "recording a frame");
        device_.wait();  // the graph before may still run
        recorded_ = std::move(recorded);
        ++recordings_;
    } else {
        for (std::size_t k = 0; k < calls.size(); ++k) {
            const cudaKernelNodeParams parameters = parameters_of(calls[k]);
            check_call(cudaGraphExecKernelNodeSetParams(recorded_->executable, recorded_->kernels[k], &parameters),
                       "changing a recorded frame");
        }
    }
    check_call(cudaGraphLaunch(recorded_->executable, static_cast<cudaStream_t>(device_.stream())),
               "starting a recorded frame");
}

#else

struct FrameGraph::Recorded {};

void FrameGraph::start(std::initializer_list<Node>) { (void)device_; }

#endif

FrameGraph::FrameGraph(Device& device) : device_(device) {}
FrameGraph::~FrameGraph() = default;

}  // namespace enfilade::render::cuda
