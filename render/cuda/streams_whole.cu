#include "render/cuda/launch.h"
#include "render/cuda/streams_run.h"

namespace enfilade::render::cuda {
namespace {

/// The whole walk of rays, recoveries and all, by so many threads.
template <class Rooms, class Question>
struct WholeKernel {
    accel::SceneView scene;
    Rooms rooms;
    Question question;
    RayWork work;
    const std::uint32_t* counted;  ///< how many there are, where a kernel has found out; else nullptr
    std::uint32_t threads;

    ENFILADE_HD void operator()(std::uint64_t thread) const {
        const std::uint32_t count = counted != nullptr ? *counted : work.count;
        for (auto k = static_cast<std::uint32_t>(thread); k < count; k += threads)
            question.answer_whole(scene, rooms, work[k]);
    }
};

template <class Question>
void ask(const StreamRun& run, const Question& question, RayWork work, const std::uint32_t* counted,
         std::uint32_t threads) {
    const accel::SceneView& scene = run.scenes.columns;
    const auto among = [&]<class Rooms>(const Rooms& rooms) {
        for_each(run.device, threads, WholeKernel<Rooms, Question>{scene, rooms, question, work, counted, threads});
    };
    const auto among_trees = [&]<class Trees>(const Trees& trees) { among(RoomsWith<Trees>{trees}); };
    if (run.objects == nullptr) among(BareRooms{});
    else if (run.objects->kind() == InsideKind::Octree) among_trees(run.objects->octrees());
    else among_trees(run.objects->bvhs());
}

/// How many threads look whether there are rare rays: a few a multiprocessor, so that it costs little if there are
/// none.
template <class Question>
void ask_listed(const StreamRun& run, const Question& question) {
    const RayList rare = run.room.rare_list();
    const auto threads = static_cast<std::uint32_t>(run.device.multiprocessors()) * 1024;
    ask(run, question, {rare.rays, 0}, rare.count, threads < run.work.count ? threads : run.work.count);
}

}  // namespace

void ask_whole(const StreamRun& run, const NearestQuestion& question) {
    ask(run, question, run.work, nullptr, run.work.count);
}
void ask_whole(const StreamRun& run, const VisibleQuestion& question) {
    ask(run, question, run.work, nullptr, run.work.count);
}
void ask_rare(const StreamRun& run, const NearestQuestion& question) { ask_listed(run, question); }
void ask_rare(const StreamRun& run, const VisibleQuestion& question) { ask_listed(run, question); }

}  // namespace enfilade::render::cuda
