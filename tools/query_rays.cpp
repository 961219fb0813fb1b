#include "tools/query_rays.h"

#include <time.h>

#include <cmath>
#include <memory>
#include <mutex>
#include <utility>

#include "render/crossings.h"
#include "tools/placed_rays.h"
#include "tools/walked_rays.h"

namespace enfilade::tools {

static_assert(std::uint8_t(RayStatus::Leak) + 1 == ray_status_count);
static_assert(offsetof(render::Passage, label) == 40 && offsetof(render::Passage, reserved) == 45);

std::vector<NpyField> hit_fields() {
    return {{"distance", "<f8"}, {"normal", "<f4", 3}, {"face", "<u4"},   {"cell", "<u4"},
            {"space", "<u4"},    {"material", "<u4"},  {"object", "<u4"}, {"triangle", "<u4"},
            {"surface", "|u1"},  {"label", "|u1"},     {"status", "|u1"}, {"", "|V1"}};
}

std::vector<NpyField> passage_fields() {
    return {{"enter", "<f8"},    {"leave", "<f8"},       {"cell", "<u4"},         {"space", "<u4"}, {"face_in", "<u4"},
            {"face_out", "<u4"}, {"material_in", "<u4"}, {"material_out", "<u4"}, {"label", "|u1"}, {"entered", "|u1"},
            {"left", "|u1"},     {"surface_in", "|u1"},  {"surface_out", "|u1"},  {"", "|V3"}};
}

namespace {

/// Seconds that the calling thread kept a core busy: what other programs take meanwhile does not count.
double busy_now() {
    timespec t = {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

constexpr std::uint64_t rays_a_block = 1 << 13;
constexpr std::uint64_t rays_a_passage_block = 1 << 11;
/// Blocks whose passages are held at once.
constexpr std::size_t blocks_a_batch = 32;

/// The work on one block, on one thread.
struct Block {
    std::vector<double> numbers;
    std::vector<PlacedRay> placed;
    QueryReport report;
    double since = busy_now();

    /// Busy seconds since the last call.
    double lap() {
        const double before = std::exchange(since, busy_now());
        return since - before;
    }
};

void add(QueryReport& sum, const QueryReport& part) {
    sum.rays += part.rays;
    for (std::size_t k = 0; k < sum.of_status.size(); ++k) sum.of_status[k] += part.of_status[k];
    sum.in_walls += part.in_walls;
    sum.passages += part.passages;
    sum.solids += part.solids;
    sum.busy.read += part.busy.read;
    sum.busy.locate += part.busy.locate;
    sum.busy.trace += part.busy.trace;
    sum.busy.write += part.busy.write;
}

/// Reads a block and finds out where its rays start.
void begin_block(const accel::SceneView& scene, const accel::PointGrid& grid, const RayFile& rays, std::uint64_t first,
                 std::uint64_t count, Block& block) {
    block.numbers.resize(std::size_t(count) * rays.columns());
    rays.read(first, block.numbers);
    block.report.busy.read = block.lap();
    place_rays(scene, grid, block.numbers, rays.columns(), block.placed);
    block.report.busy.locate = block.lap();
    block.report.rays = count;
    for (const PlacedRay& ray : block.placed) block.report.in_walls += ray.start == Start::Wall;
}

/// Things that threads take, use and give back: as many as work at once. Fresh memory for every block would cost more
/// in page faults than its rays take.
template <class T>
class Pool {
public:
    /// One that was given back, or what `make` makes.
    template <class Make>
    std::unique_ptr<T> take(const Make& make) {
        {
            const std::lock_guard lock(mutex_);
            if (!free_.empty()) {
                std::unique_ptr<T> taken = std::move(free_.back());
                free_.pop_back();
                return taken;
            }
        }
        return std::make_unique<T>(make());
    }
    void give_back(std::unique_ptr<T> thing) {
        const std::lock_guard lock(mutex_);
        free_.push_back(std::move(thing));
    }

private:
    std::mutex mutex_;
    std::vector<std::unique_ptr<T>> free_;
};

template <class Element>
struct AnswerBlock {
    Block work;
    RayWalker walker;
    std::vector<Element> elements;
};

/// Answers all rays, one element each, block by block: `answer(walked, placed, elements)`.
template <class Element, class Answer>
QueryReport answer_each(const accel::SceneView& scene, const RayFile& rays, NpyWriter& elements,
                        const QueryOptions& options, const Answer& answer) {
    const accel::SerialExecutor serial;
    const accel::PointGrid grid(scene);
    QueryReport report;
    std::mutex mutex;
    Pool<AnswerBlock<Element>> pool;
    const auto answer_block = [&](std::size_t begin, std::size_t end) {
        auto block = pool.take([&] {
            return AnswerBlock<Element>{{}, RayWalker(scene, options.tracer, options.precision, options.objects), {}};
        });
        Block& work = block->work;
        work.report = {};
        work.since = busy_now();
        begin_block(scene, grid, rays, begin, end - begin, work);
        const std::span<const WalkedRay> walked = block->walker.walk(work.placed);
        block->elements.resize(walked.size());
        answer(walked, work.placed, std::span<Element>(block->elements));
        work.report.busy.trace = work.lap();
        for (const WalkedRay& ray : walked) ++work.report.of_status[std::size_t(ray.status)];
        elements.write(begin, std::as_bytes(std::span(block->elements)));
        work.report.busy.write = work.lap();
        {
            const std::lock_guard lock(mutex);
            add(report, work.report);
            if (options.progress) options.progress(double(report.rays) / double(rays.count()));
        }
        pool.give_back(std::move(block));
    };
    accel::parallel_for(options.executor != nullptr ? *options.executor : serial, std::size_t(rays.count()),
                        rays_a_block, answer_block);
    return report;
}

/// Towards the light, by Newell's sum. [source_face_count]
std::vector<std::array<float, 3>> normals_of(const accel::SceneView& scene) {
    std::vector<std::array<float, 3>> normals;
    normals.reserve(scene.source_face_count());
    for (std::size_t f = 0; f < scene.source_face_count(); ++f) {
        const std::uint32_t first = scene.source_faces[f].first_vertex;
        const std::uint32_t count = scene.source_faces[f + 1].first_vertex - first;
        const auto at = [&](std::uint32_t i) {
            const accel::Vertex &v = scene.vertices[first + i % count], &base = scene.vertices[first];
            return render::Vec3d{double{v.x} - base.x, double{v.y} - base.y, double{v.z} - base.z};
        };
        render::Vec3d sum = {0, 0, 0};
        for (std::uint32_t i = 1; i + 1 < count; ++i) sum = sum + render::cross(at(i), at(i + 1));
        const double size = render::length(sum);
        const render::Vec3f unit = render::vec_cast<float>(size > 0 ? (1 / size) * sum : sum);
        normals.push_back({unit.x, unit.y, unit.z});
    }
    return normals;
}

/// Of a triangle where its object stands, unit, towards where the ray came from; 0 where it has no area.
std::array<float, 3> normal_of(const accel::SceneView& scene, const accel::PlacedObject& object, std::uint32_t triangle,
                               const render::Vec3d& along) {
    const accel::ObjectMesh& mesh = scene.meshes[index(object.mesh)];
    const std::array<std::uint32_t, 3>& corners = scene.mesh_triangles[mesh.first_triangle + triangle].corners;
    const std::array<float, 12>& rows = object.scene_from_object.rows;
    const auto at = [&](std::uint32_t corner) {
        const accel::Vertex& v = scene.mesh_vertices[mesh.first_vertex + corner];
        const auto row = [&](std::size_t r) {
            return double{rows[4 * r]} * v.x + double{rows[4 * r + 1]} * v.y + double{rows[4 * r + 2]} * v.z;
        };
        return render::Vec3d{row(0), row(1), row(2)};
    };
    const render::Vec3d a = at(corners[0]);
    render::Vec3d n = render::cross(at(corners[1]) - a, at(corners[2]) - a);
    const double size = render::length(n);
    if (!(size > 0)) return {0, 0, 0};
    n = (render::dot(n, along) > 0 ? -1 / size : 1 / size) * n;
    const render::Vec3f unit = render::vec_cast<float>(n);
    return {unit.x, unit.y, unit.z};
}

constexpr std::uint32_t none32 = 0xffffffffu;
constexpr std::uint8_t none8 = 0xff;

/// What is known of the object that a ray has met.
void add_object(const accel::SceneView& scene, const WalkedRay& ray, const render::Vec3d& along, HitRecord& record) {
    const accel::PlacedObject& object = scene.objects[index(ray.object)];
    const accel::ObjectMesh& mesh = scene.meshes[index(object.mesh)];
    record.object = std::uint32_t(index(ray.object));
    record.triangle = ray.triangle;
    record.material = std::uint32_t(index(object.material != none<accel::MaterialId>
                                              ? object.material
                                              : scene.mesh_triangles[mesh.first_triangle + ray.triangle].material));
    record.normal = normal_of(scene, object, ray.triangle, along);
}

}  // namespace

QueryReport query_nearest(const accel::SceneView& scene, const RayFile& rays, NpyWriter& hits,
                          const QueryOptions& options) {
    const std::vector<std::array<float, 3>> normals = normals_of(scene);
    return answer_each<HitRecord>(
        scene, rays, hits, options,
        [&](std::span<const WalkedRay> walked, std::span<const PlacedRay> placed, std::span<HitRecord> records) {
            for (std::size_t i = 0; i < walked.size(); ++i) {
                const WalkedRay& ray = walked[i];
                HitRecord& record = records[i];
                record = {ray.distance, {0, 0, 0}, none32, none32, none32,     none32,
                          none32,       none32,    none8,  none8,  ray.status, 0};
                if (ray.cell != none<accel::CellId>) {
                    const accel::Cell& cell = scene.cells[index(ray.cell)];
                    record.cell = std::uint32_t(index(ray.cell));
                    record.space = std::uint32_t(index(cell.space));
                    record.label = std::uint8_t(cell.label);
                }
                if (ray.face != none<accel::SourceFaceId>) {
                    const accel::SourceFace& face = scene.source_faces[index(ray.face)];
                    record.face = std::uint32_t(index(ray.face));
                    record.material = std::uint32_t(index(face.material));
                    record.surface = std::uint8_t(face.surface);
                    record.normal = normals[index(ray.face)];
                }
                if (ray.object != none<accel::ObjectId>) add_object(scene, ray, placed[i].direction, record);
            }
        });
}

QueryReport query_any(const accel::SceneView& scene, const RayFile& rays, NpyWriter& sights,
                      const QueryOptions& options) {
    return answer_each<SightStatus>(
        scene, rays, sights, options,
        [](std::span<const WalkedRay> walked, std::span<const PlacedRay>, std::span<SightStatus> answers) {
            constexpr std::array<SightStatus, ray_status_count> answer = {SightStatus::Blocked, SightStatus::Free,
                                                                          SightStatus::Free,    SightStatus::Wall,
                                                                          SightStatus::Refused, SightStatus::Leak};
            for (std::size_t i = 0; i < walked.size(); ++i) answers[i] = answer[std::size_t(walked[i].status)];
        });
}

namespace {

/// A block's passages, until it is their turn to be written.
struct PassageBlock {
    Block work;
    render::PassageTable table;
};

void pass_block(const accel::SceneView& scene, const QueryOptions& options, PassageBlock& block) {
    std::vector<render::RayQuery> queries;
    queries.reserve(block.work.placed.size());
    for (const PlacedRay& ray : block.work.placed) {
        // From behind a face the way begins in the solid, however short, so that reversed rays pass the same.
        const bool starts_inside = ray.start == Start::Cell;
        // What is no ray here (beyond 1e12 metres) is none there.
        const double limit = ray.start == Start::Refused ? std::nan("") : ray.max_distance;
        queries.push_back({ray.origin, ray.direction, starts_inside ? ray.cell : none<accel::CellId>, limit});
    }
    block.table = render::all_crossings(scene, queries, {.solids = options.solids});
    QueryReport& report = block.work.report;
    for (const render::PassagesEnd end : block.table.ends) {
        constexpr std::array<RayStatus, 5> status = {RayStatus::Reached, RayStatus::Sky, RayStatus::Wall,
                                                     RayStatus::Refused, RayStatus::Leak};
        ++report.of_status[std::size_t(status[std::size_t(end)])];
    }
    report.passages = block.table.passages.size();
    for (const render::Passage& passage : block.table.passages)
        report.solids += passage.is_solid() && passage.label != accel::Label::Outside;
    report.busy.trace = block.work.lap();
}

}  // namespace

QueryReport query_all(const accel::SceneView& scene, const RayFile& rays, NpyWriter& passages, NpyWriter& offsets,
                      const QueryOptions& options) {
    const accel::SerialExecutor serial;
    const accel::Executor& executor = options.executor != nullptr ? *options.executor : serial;
    const accel::PointGrid grid(scene);
    QueryReport report;
    const std::uint64_t zero = 0;
    offsets.write(0, std::as_bytes(std::span(&zero, 1)));
    constexpr std::uint64_t rays_a_batch = blocks_a_batch * rays_a_passage_block;
    for (std::uint64_t first = 0; first < rays.count(); first += rays_a_batch) {
        const std::uint64_t in_batch = std::min(rays_a_batch, rays.count() - first);
        std::vector<PassageBlock> blocks(std::size_t((in_batch + rays_a_passage_block - 1) / rays_a_passage_block));
        accel::parallel_for(executor, std::size_t(in_batch), rays_a_passage_block,
                            [&](std::size_t begin, std::size_t end) {
                                PassageBlock& block = blocks[begin / rays_a_passage_block];
                                block.work.since = busy_now();
                                begin_block(scene, grid, rays, first + begin, end - begin, block.work);
                                pass_block(scene, options, block);
                            });
        for (std::size_t k = 0; k < blocks.size(); ++k) {
            PassageBlock& block = blocks[k];
            block.work.since = busy_now();
            for (std::uint64_t& offset : block.table.offsets) offset += report.passages;
            offsets.write(first + k * rays_a_passage_block + 1,
                          std::as_bytes(std::span(block.table.offsets).subspan(1)));
            passages.write(report.passages, std::as_bytes(std::span(block.table.passages)));
            block.work.report.busy.write = block.work.lap();
            add(report, block.work.report);
            block = {};
        }
        if (options.progress) options.progress(double(report.rays) / double(rays.count()));
    }
    return report;
}

}  // namespace enfilade::tools
