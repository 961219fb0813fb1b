#include "render/cuda/streams_bare.h"

namespace enfilade::render::cuda {
namespace {

template <class Scene, class Question>
void ask(const StreamRun& run, const Scene& scene, const Question& question) {
    const RayList rare = run.room.rare_list();
    if (run.options.schedule == StreamSchedule::Deferred) {
        for_each(run.device, run.work.count, DeferringKernel<Scene, Question>{scene, question, run.work, rare});
        return;
    }
    const auto refill = static_cast<std::uint32_t>(run.options.refill);
    for_each_warp(run.device, staying_warps(run),
                  FetchingKernel<Scene, Question>{scene, question, run.work, rare, run.room.next(), refill});
}

template <class Question>
void ask_in_layout(const StreamRun& run, const Question& question) {
    switch (run.scenes.layout) {
        case SectionLayout::Columns: return ask(run, run.scenes.columns, question);
        case SectionLayout::Points: return ask(run, run.scenes.points, question);
        case SectionLayout::Pairs: return ask(run, run.scenes.pairs, question);
    }
}

}  // namespace

void ask_bare(const StreamRun& run, const NearestQuestion& question) { ask_in_layout(run, question); }
void ask_bare(const StreamRun& run, const VisibleQuestion& question) { ask_in_layout(run, question); }

}  // namespace enfilade::render::cuda
