#include "render/cuda/compaction.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "render/cuda/launch.h"
#include "render/cuda/streams_run.h"

namespace enfilade::render::cuda {
namespace {

/// A thread a ray of a round: from its start, or on from its answer, to its end or its next question.
template <class Scene, class Question>
struct CellsKernel {
    static constexpr LaunchShape shape = {128, 6};
    Scene scene;
    Question question;
    RayWork work;  ///< of the first round; later ones take `questions` as they lie
    bool goes_on;
    const ObjectQuestion* questions;
    const WalkSoFar* walks;
    const ObjectAnswer* answers;
    RayList rare;
    ObjectQuestion* next_questions;
    WalkSoFar* next_walks;
    std::uint32_t* waiting;

    ENFILADE_HD void operator()(Warp warp, std::uint64_t w) const {
        PerLane<ObjectQuestion> asked;
        PerLane<WalkSoFar> so_far;
        PerLane<bool> waits;
        for (int lane : warp.lanes()) {
            const std::uint64_t k = w * warp_size + static_cast<std::uint64_t>(lane);
            waits[lane] = k < work.count && to_question(static_cast<std::uint32_t>(k), asked[lane], so_far[lane]);
        }
        const std::uint32_t takers = warp.ballot(waits);
        if (takers == 0) return;
        const PerLane<std::uint32_t> places = take_numbers(warp, takers, waiting);
        for (int lane : warp.lanes()) {
            if (!waits[lane]) continue;
            next_questions[places[lane]] = asked[lane];
            next_walks[places[lane]] = so_far[lane];
        }
    }

private:
    ENFILADE_HD bool to_question(std::uint32_t k, ObjectQuestion& asked, WalkSoFar& so_far) const {
        const ObjectWalk<Scene, Question> walk = {scene, question};
        typename Question::Traveller t;
        if (goes_on) {
            asked = questions[k];
            so_far = walks[k];
            if (!question.again(asked.ray, t) || walk.take(answers[k], t, asked, so_far)) return false;
        } else {
            const std::uint32_t i = work[k];
            if (!question.begin(i, true, t)) return false;
            walk.start(i, t, asked, so_far);
        }
        const Outcome outcome = walk.on(t, goes_on, asked, so_far);
        if (outcome == Outcome::Rare) rare.add(asked.ray);
        return outcome == Outcome::Waits;
    }
};

/// A question's key: the mesh.
struct MeshKernel {
    accel::SceneView scene;
    const ObjectQuestion* questions;
    std::uint32_t* keys;
    std::uint32_t* numbers;

    ENFILADE_HD void operator()(std::uint64_t k) const {
        const auto object = static_cast<std::uint32_t>(scene.cell_objects[questions[k].place]);
        keys[k] = static_cast<std::uint32_t>(scene.objects[object].mesh);
        numbers[k] = static_cast<std::uint32_t>(k);
    }
};

/// A thread a question.
template <class Trees, class Question>
struct ObjectsKernel {
    accel::SceneView scene;
    Trees trees;
    Question question;
    RayWork work;
    const ObjectQuestion* questions;
    ObjectAnswer* answers;

    ENFILADE_HD void operator()(std::uint64_t k) const {
        const std::uint32_t place = work[static_cast<std::uint32_t>(k)];
        const ObjectQuestion asked = questions[place];
        typename Question::Traveller t;
        if (!question.again(asked.ray, t)) return;  // it could before
        answers[place] = answer_object<Question::asked>(scene, trees, t.ray, asked);
    }
};

/// Warps in which each lane walks to its next question, then all that have one ask; idle lanes fetch rays.
template <class Scene, class Trees, class Question>
struct AskingKernel {
    Scene scene;
    Trees trees;
    Question question;
    RayWork work;
    RayList rare;
    std::uint32_t* next;
    std::uint32_t refill;

    struct Lane {
        typename Question::Traveller t;
        ObjectQuestion asked;
        WalkSoFar so_far;
        bool has_question;
    };

    ENFILADE_HD void operator()(Warp warp, std::uint64_t) const {
        PerLane<Lane> lanes;
        PerLane<bool> idle;
        for (int lane : warp.lanes()) idle[lane] = true;
        bool has_more = true;
        while (true) {
            const std::uint32_t free = warp.ballot(idle);
            if (free == ~0u && !has_more) return;
            if (has_more && (free == ~0u || count_bits(free) >= refill)) has_more = fetch(warp, free, lanes, idle);
            for (int lane : warp.lanes())
                if (!idle[lane]) idle[lane] = !goes_on(lanes[lane]);
            for (int lane : warp.lanes())
                if (!idle[lane]) idle[lane] = is_answered(lanes[lane]);
        }
    }

private:
    /// False: there are no more.
    ENFILADE_HD bool fetch(Warp warp, std::uint32_t free, PerLane<Lane>& lanes, PerLane<bool>& idle) const {
        const PerLane<std::uint32_t> numbers = take_numbers(warp, free, next);
        for (int lane : warp.lanes()) {
            if (!idle[lane] || numbers[lane] >= work.count) continue;
            Lane& l = lanes[lane];
            const std::uint32_t i = work[numbers[lane]];
            if (!question.begin(i, true, l.t)) continue;
            ObjectWalk<Scene, Question>{scene, question}.start(i, l.t, l.asked, l.so_far);
            l.has_question = false;
            idle[lane] = false;
        }
        return warp.of_lane(numbers, 0) + count_bits(free) < work.count;
    }
    /// To the next question; false: the ray has ended.
    ENFILADE_HD bool goes_on(Lane& l) const {
        const ObjectWalk<Scene, Question> walk = {scene, question};
        const Outcome outcome = walk.on(l.t, l.has_question, l.asked, l.so_far);
        if (outcome == Outcome::Rare) rare.add(l.asked.ray);
        l.has_question = true;
        return outcome == Outcome::Waits;
    }
    ENFILADE_HD bool is_answered(Lane& l) const {
        const ObjectAnswer answer = answer_object<Question::asked>(scene, trees, l.t.ray, l.asked);
        return ObjectWalk<Scene, Question>{scene, question}.take(answer, l.t, l.asked, l.so_far);
    }
};

/// Calls body(scene). Lines apart by one or by two: for furnished rooms there are kernels for two alone.
template <class Body>
void in_layout(const SceneCopies& scenes, const Body& body) {
    if (scenes.layout == SectionLayout::Columns) body(scenes.columns);
    else body(scenes.pairs);
}

template <class Body>
void with_trees(const DeviceObjects& objects, const Body& body) {
    if (objects.kind() == InsideKind::Octree) body(objects.octrees());
    else body(objects.bvhs());
}

/// Answers `count` questions, those of one mesh together.
template <class Question>
void answer_questions(const StreamRun& run, const Question& question, const ObjectQuestion* questions,
                      std::uint32_t count) {
    const accel::SceneView& scene = run.scenes.columns;
    RayWork work = {nullptr, count};
    if (run.options.sorts_questions && scene.meshes.size() > 1) {
        run.sorter.reserve(count);
        for_each(run.device, count, MeshKernel{scene, questions, run.sorter.keys(), run.sorter.numbers()});
        work.order = run.sorter.sort(count, std::bit_width(static_cast<std::uint32_t>(scene.meshes.size() - 1)));
    }
    with_trees(*run.objects, [&]<class Trees>(const Trees& trees) {
        for_each(run.device, count,
                 ObjectsKernel<Trees, Question>{scene, trees, question, work, questions, run.room.answers.data()});
    });
}

template <class Question>
void compact(const StreamRun& run, const Question& question) {
    StreamRoom& room = run.room;
    const auto walk = [&](RayWork work, bool goes_on, int from) {
        run.device.clear(room.waiting(), sizeof(std::uint32_t));
        in_layout(run.scenes, [&]<class Scene>(const Scene& scene) {
            const CellsKernel<Scene, Question> kernel = {scene,
                                                         question,
                                                         work,
                                                         goes_on,
                                                         room.questions[from].data(),
                                                         room.walks[from].data(),
                                                         room.answers.data(),
                                                         room.rare_list(),
                                                         room.questions[1 - from].data(),
                                                         room.walks[1 - from].data(),
                                                         room.waiting()};
            for_each_warp(run.device, (std::uint64_t{work.count} + warp_size - 1) / warp_size, kernel);
        });
        std::uint32_t waiting = 0;
        run.device.download(&waiting, room.waiting(), sizeof waiting);
        return waiting;
    };
    int to = 1;
    std::uint32_t count = walk(run.work, false, 0);
    while (count > 0) {
        answer_questions(run, question, room.questions[to].data(), count);
        count = walk({nullptr, count}, true, to);
        to = 1 - to;
    }
}

template <class Question>
void ask(const StreamRun& run, const Question& question) {
    const bool stays = run.options.schedule == StreamSchedule::Persistent;
    const std::uint64_t warps =
        stays ? staying_warps(run) : (std::uint64_t{run.work.count} + warp_size - 1) / warp_size;
    const auto refill = static_cast<std::uint32_t>(stays ? run.options.refill : warp_size);
    in_layout(run.scenes, [&]<class Scene>(const Scene& scene) {
        with_trees(*run.objects, [&]<class Trees>(const Trees& trees) {
            for_each_warp(run.device, warps,
                          AskingKernel<Scene, Trees, Question>{scene, trees, question, run.work, run.room.rare_list(),
                                                               run.room.next(), refill});
        });
    });
}

}  // namespace

void ask_compacted(const StreamRun& run, const NearestQuestion& question) { compact(run, question); }
void ask_compacted(const StreamRun& run, const VisibleQuestion& question) { compact(run, question); }
void ask_furnished(const StreamRun& run, const NearestQuestion& question) { ask(run, question); }
void ask_furnished(const StreamRun& run, const VisibleQuestion& question) { ask(run, question); }

}  // namespace enfilade::render::cuda
