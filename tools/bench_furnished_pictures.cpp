// Pictures of furnished floors with Lambert's shading into the same framebuffer: every tracer against Embree's
// instances, and the ways in which cells know their objects.

#include <algorithm>
#include <cstdlib>

#include "render/trace.h"
#include "tools/bench_furnished.h"
#include "tools/examples.h"
#include "tools/view_file.h"

namespace enfilade::tools {

namespace {

constexpr int side = 1024;
constexpr std::size_t view_count = 8;
/// The most instanced triangles of which Embree gets a structure without instances: some 100 bytes each.
constexpr std::size_t most_flattened = 10'000'000;

/// The pictures of all views by whoever draws them.
class FurnishedPictures {
public:
    FurnishedPictures(const TracedFloor& traced, std::vector<PreparedView> views)
        : traced_(&traced), views_(std::move(views)) {}

    [[nodiscard]] Competitor ours(render::Tracer tracer) { return ours(tracer, *traced_, name_of(tracer)); }
    /// In another scene of the same floor.
    [[nodiscard]] Competitor ours(render::Tracer tracer, const TracedFloor& traced, std::string name) {
        return {std::move(name), [this, tracer, &traced] { draw(tracer, traced, image_); }};
    }
    [[nodiscard]] Competitor embree(const render::EmbreeInstances& instances, render::EmbreeWay way,
                                    const char* how = "instanced") {
        return {std::string("Embree ") + how + ", " + text(way), [this, &instances, way] {
                    for (const PreparedView& view : views_) instances.trace_lambert(view.frame, way, one_, image_);
                }};
    }
    [[nodiscard]] RayContest contest(int rounds, std::vector<Competitor> competitors) const {
        return {rounds, double(side) * side * double(views_.size()), std::move(competitors), Clock::Thread};
    }
    [[nodiscard]] const std::vector<PreparedView>& views() const { return views_; }

    /// The first view's.
    void draw_first(render::Tracer tracer, const TracedFloor& traced, render::Framebuffer& image) const {
        draw_view(tracer, traced, views_.front(), image);
    }

private:
    void draw_view(render::Tracer tracer, const TracedFloor& traced, const PreparedView& view,
                   render::Framebuffer& image) const {
        render::LambertOptions options;
        options.tracer = tracer;
        options.objects = &traced.objects;
        // Cut rooms have other cells.
        const accel::CellId start = &traced == traced_ ? view.start : render::start_cell(traced.scene(), view.frame);
        render::trace_lambert(traced.scene(), view.frame, start, options, one_, image);
    }
    void draw(render::Tracer tracer, const TracedFloor& traced, render::Framebuffer& image) const {
        for (const PreparedView& view : views_) draw_view(tracer, traced, view, image);
    }

    const TracedFloor* traced_;
    std::vector<PreparedView> views_;
    render::Framebuffer image_{side, side};
    accel::SerialExecutor one_;
};

BenchRow on(const TracedFloor& traced, BenchRow row) {
    row.scene = traced.name();
    return row;
}

/// The share of pixels that show an object.
double furnished_share(const TracedFloor& traced, const std::vector<PreparedView>& views) {
    constexpr int step = 4;
    std::vector<float> origin[3], direction[3];
    for (const PreparedView& view : views)
        for (int y = 0; y < side; y += step)
            for (int x = 0; x < side; x += step) {
                const render::Vec3f d = view.frame.direction(float(x) + 0.5f, float(y) + 0.5f);
                const render::Vec3f o = view.frame.origin;
                origin[0].push_back(o.x), origin[1].push_back(o.y), origin[2].push_back(o.z);
                direction[0].push_back(d.x), direction[1].push_back(d.y), direction[2].push_back(d.z);
            }
    std::vector<render::WalkStatus> status(origin[0].size());
    traced.embree->nearest({origin[0], origin[1], origin[2], direction[0], direction[1], direction[2], {}, {}},
                           {{}, {}, {}, status, {}, {}}, {.lanes = 16}, accel::SerialExecutor());
    return double(std::ranges::count(status, render::WalkStatus::Object)) / double(status.size());
}

/// Embree's ways, each beside the one that counts: a row each. The fastest 16 coherent one.
render::EmbreeWay bench_ways(Bench& bench, const TracedFloor& traced, FurnishedPictures& pictures) {
    std::vector<render::EmbreeWay> ways(render::embree_ways.begin(), render::embree_ways.end());
    if (bench.quick()) ways = ways_where(is_sixteen_coherent);
    std::vector<Competitor> competitors;
    for (const render::EmbreeWay way : ways) competitors.push_back(pictures.embree(*traced.embree, way));
    const RayContest contest = pictures.contest(bench.quick() ? 1 : 2, std::move(competitors));
    std::size_t best = ways.size();
    for (std::size_t k = 0; k < ways.size(); ++k)
        if (is_sixteen_coherent(ways[k]) && (best == ways.size() || contest.speed(k) > contest.speed(best))) best = k;
    if (!bench.quick())
        for (std::size_t k = 0; k < ways.size(); ++k) {
            BenchRow row = on(traced, {.row = contest.name(k), .value = contest.speed(k), .unit = "Mrays/s"});
            bench.add(std::move(row));
        }
    return ways[best];
}

/// Embree without instances, beside Embree with them.
void bench_flattened(Bench& bench, const TracedFloor& traced, FurnishedPictures& pictures, render::EmbreeWay way) {
    if (bench.quick() || traced.floor->instanced_triangles() > most_flattened) return;
    const render::EmbreeInstances flat(traced.scene(), render::EmbreeObjects::Flattened);
    const RayContest contest =
        pictures.contest(3, {pictures.embree(flat, way, "flattened"), pictures.embree(*traced.embree, way)});
    bench.add(on(traced, contest.row("Embree flattened, primary rays", 0, 1)));
    bench.add(on(traced, {.row = "Embree flattened, all it holds", .value = double(flat.bytes()) / 1e6, .unit = "MB"}));
}

/// The tour that is saved beside an example, as somebody walks it.
void bench_tour(Bench& bench, const TracedFloor& traced, render::EmbreeWay way) {
    const auto file = example_file(traced.name() + ".views.json");
    if (!file) return;
    std::vector<PreparedView> views;
    for (SavedView& view : read_views(*file, traced.scene()).views) {
        view.camera.width = view.camera.height = side;
        views.push_back({render::make_frame(view.camera), view.cell});
    }
    const std::string count = std::to_string(views.size());
    FurnishedPictures pictures(traced, std::move(views));
    const RayContest contest = pictures.contest(
        bench.quick() ? 1 : 3, {pictures.ours(render::Tracer::Packet), pictures.embree(*traced.embree, way)});
    bench.add(on(traced, contest.row("packet, tour of " + count + " views", 0, 1)));
}

/// Octrees inside of objects, against Embree's instances and against Embree inside of objects.
void bench_octrees(Bench& bench, const TracedFloor& traced, const TracedFloor& octrees, FurnishedPictures& pictures,
                   render::EmbreeWay way) {
    const RayContest contest = pictures.contest(
        bench.quick() ? 3 : 7, {pictures.ours(render::Tracer::Packet, octrees, "packet through octrees"),
                                pictures.embree(*traced.embree, way), pictures.ours(render::Tracer::Packet)});
    BenchRow row = on(traced, contest.row("packet through octrees, primary rays and Lambert", 0, 1));
    row.goal = ratio_at_least(2);
    bench.add(std::move(row));
    bench.add(on(traced, contest.row("packet through octrees, against trees of boxes", 0, 2)));
    render::Framebuffer boxes(side, side), through(side, side);
    pictures.draw_first(render::Tracer::Packet, traced, boxes);
    pictures.draw_first(render::Tracer::Packet, octrees, through);
    bench.add(on(traced, {.row = "octrees inside objects: pixels unlike those of trees of boxes",
                          .value = 1e6 * double(unlike_pixels(boxes, through)) / (double(side) * side),
                          .unit = "per million"}));
}

/// Objects as volumes against lists of objects.
void bench_cut(Bench& bench, const TracedFloor& traced, const TracedFloor& cut, FurnishedPictures& pictures) {
    for (const render::Tracer tracer : tracers) {
        const RayContest contest = pictures.contest(
            tracer == render::Tracer::Scalar ? 1 : 5,
            {pictures.ours(tracer, cut, "objects cut out"), pictures.ours(tracer, traced, "objects listed")});
        bench.add(on(traced, contest.row(std::string(name_of(tracer)) + ", objects cut out of their rooms", 0, 1)));
    }
    render::Framebuffer listed(side, side), as_volumes(side, side);
    pictures.draw_first(render::Tracer::Packet, traced, listed);
    pictures.draw_first(render::Tracer::Packet, cut, as_volumes);
    bench.add(on(traced, {.row = "objects cut out: pixels unlike those of listed ones",
                          .value = 1e6 * double(unlike_pixels(listed, as_volumes)) / (double(side) * side),
                          .unit = "per million"}));
    bench.add(on(traced, {.row = "objects cut out: cells",
                          .value = double(cut.scene().cells.size()),
                          .unit = "cells",
                          .reference = "listed",
                          .reference_value = double(traced.scene().cells.size())}));
}

}  // namespace

std::uint64_t unlike_pixels(const render::Framebuffer& a, const render::Framebuffer& b) {
    std::uint64_t unlike = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i)
        for (int shift = 0; shift < 24; shift += 8)
            if (std::abs(int(a.rgba[i] >> shift & 255u) - int(b.rgba[i] >> shift & 255u)) > 1) {
                ++unlike;
                break;
            }
    return unlike;
}

void bench_furnished_pictures(Bench& bench, const TracedFloor& traced, const TracedFloor& octrees,
                              const TracedFloor* cut) {
    FurnishedPictures pictures(traced, prepared(traced.scene(), floor_views(traced.scene(), view_count, side)));
    bench.add(
        on(traced,
           {.row = "pixels that show objects", .value = 100 * furnished_share(traced, pictures.views()), .unit = "%"}));
    const render::EmbreeWay way = bench_ways(bench, traced, pictures);
    const RayContest slow =
        pictures.contest(1, {pictures.ours(render::Tracer::Scalar),
                             pictures.embree(*traced.embree, {.lanes = 1, .faces = render::EmbreeFaces::Triangles})});
    bench.add(on(traced, slow.row("scalar, primary rays and Lambert", 0, 1)));
    const RayContest contest = pictures.contest(
        bench.quick() ? 3 : 9, {pictures.ours(render::Tracer::Simd), pictures.ours(render::Tracer::Packet),
                                pictures.embree(*traced.embree, way)});
    bench.add(on(traced, contest.row("simd, primary rays and Lambert", 0, 2)));
    BenchRow packet = on(traced, contest.row("packet, primary rays and Lambert", 1, 2));
    packet.goal = ratio_at_least(3.5);
    bench.add(std::move(packet));
    bench_octrees(bench, traced, octrees, pictures, way);
    bench_flattened(bench, traced, pictures, way);
    bench_tour(bench, traced, way);
    if (cut != nullptr) bench_cut(bench, traced, *cut, pictures);
}

}  // namespace enfilade::tools
