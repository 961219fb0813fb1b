// Lit pictures: how lamps are found, with the same tracer; lanes and packets against Embree with the same lists.

#include <algorithm>

#include "tools/bench_lights.h"

namespace enfilade::tools {

namespace {

using render::LampSearch;
using render::Tracer;

constexpr std::size_t view_count = 4;

std::vector<PreparedView> views_of(const accel::SceneView& scene, std::size_t count, int side) {
    return prepared(scene, floor_views(scene, count, side));
}

BenchRow on(const LitScene& scene, BenchRow row) {
    row.scene = scene.name;
    return row;
}

/// What pictures of the first view have other than a reference's.
void add_unlike(Bench& bench, const LitScene& scene, const std::string& who, const std::string& whose,
                const render::Framebuffer& a, const render::Framebuffer& b) {
    bench.add(
        on(scene, {.row = who + ": pixels unlike " + whose, .value = unlike_per_million(a, b), .unit = "per million"}));
}

/// Shadow rays and shading alone: a lit picture less the same unlit one, against Embree from known first hits.
void add_shadows(Bench& bench, const LitScene& scene, const LitViews& views, const RayContest& contest, std::size_t lit,
                 std::size_t unlit, std::size_t known, double goal) {
    const double all = views.primary_rays() + views.shadow_rays();
    const double seconds = all / contest.speed(lit) / 1e6 - all / contest.speed(unlit) / 1e6;
    const double theirs = all / contest.speed(known) / 1e6;
    const double ours = std::max(seconds, 1e-9);
    BenchRow row{.row = contest.name(lit) + ", shadow rays and shading",
                 .value = views.shadow_rays() / ours / 1e6,
                 .unit = "Mrays/s",
                 .reference = contest.name(known),
                 .reference_value = views.shadow_rays() / theirs / 1e6,
                 .ratio = theirs / ours};
    if (goal > 0) row.goal = ratio_at_least(goal);
    bench.add(on(scene, std::move(row)));
}

/// Rays with lamps over rays without, of the same tracer.
void add_lit_over_unlit(Bench& bench, const LitScene& scene, const LitViews& views, const RayContest& contest,
                        std::size_t lit, std::size_t unlit) {
    const double rays = views.primary_rays() + views.shadow_rays();
    const double without = contest.speed(unlit) * views.primary_rays() / rays;
    bench.add(on(scene, {.row = contest.name(lit) + ", primary and shadow rays",
                         .value = contest.speed(lit),
                         .unit = "Mrays/s",
                         .reference = contest.name(unlit),
                         .reference_value = without,
                         .ratio = contest.speed(lit) / without,
                         .goal = ratio_at_least(0.8)}));
}

/// All lamps, those of lists, and trees, by one tracer; and whether the pictures are `naive`'s.
void bench_searches_of(Bench& bench, const LitScene& scene, const LitViews& views, Tracer tracer,
                       render::Framebuffer& naive) {
    const int side = views.side();
    render::Framebuffer image(side, side);
    std::vector<render::Lamps> asked;
    for (const LampSearch search : {LampSearch::Naive, LampSearch::Pvs, LampSearch::Tree})
        asked.push_back(scene.asked(search));
    std::vector<Competitor> competitors;
    for (const render::Lamps& lamps : asked)
        competitors.push_back({name_of(tracer, lamps.search), [&] { views.draw(tracer, &lamps, image); }});
    const double rays = views.primary_rays() + views.shadow_rays();
    const RayContest contest(bench.quick() ? 1 : 3, rays, competitors, Clock::Thread);
    for (std::size_t k = 0; k < 3; ++k) {
        // Naive walks trace more rays for the same picture: to every lamp.
        const double own = k == 0 ? views.primary_rays() + views.lit_pixels() * double(scene.lamps.size()) : rays;
        const double pictures = 1e6 * double(views.count()) / rays;
        BenchRow row = on(scene, {.row = contest.name(k) + ", lit pictures",
                                  .value = contest.speed(k) * pictures,
                                  .unit = "pictures/s of " + std::to_string(side) + "^2"});
        if (k > 0) {
            const BenchRow against = contest.row("", k, k - 1);
            row.reference = against.reference;
            row.reference_value = contest.speed(k - 1) * pictures;
            row.ratio = against.ratio;
            row.spread = against.spread;
        }
        if (k == 2) row.goal = ratio_at_least(1.7);
        bench.add(std::move(row));
        bench.add(on(scene, {.row = contest.name(k) + ", rays of these pictures",
                             .value = contest.speed(k) * own / rays,
                             .unit = "Mrays/s"}));
    }
    if (tracer == Tracer::Scalar) views.draw(tracer, &asked[0], naive, 1);
    for (std::size_t k = tracer == Tracer::Scalar ? 1 : 0; k < 3; ++k) {
        views.draw(tracer, &asked[k], image, 1);
        add_unlike(bench, scene, contest.name(k), "scalar naive's", naive, image);
    }
}

}  // namespace

void bench_lit_searches(Bench& bench, const LitScene& scene) {
    const int side = bench.quick() ? 128 : 256;
    // Walks to all lamps are slow: no more of them than take some seconds.
    const double most_walks = bench.quick() ? 1e7 : 1e8;
    const double walks_a_view = double(side) * side * double(scene.lamps.size());
    const auto count = static_cast<std::size_t>(std::clamp(most_walks / walks_a_view, 1.0, 8.0));
    const LitViews views(scene, views_of(scene.view, count, side), side, nullptr);
    bench.add(on(scene, {.row = "light rays that lists remove",
                         .value = 100 * (1 - views.shadow_rays() /
                                                 std::max(1.0, views.lit_pixels() * double(scene.lamps.size()))),
                         .unit = "%"}));
    render::Framebuffer naive(side, side);
    for (const Tracer tracer : {Tracer::Scalar, Tracer::Packet}) bench_searches_of(bench, scene, views, tracer, naive);
}

void bench_lit_pictures(Bench& bench, const LitScene& scene, const render::EmbreeReference& embree, bool has_goals) {
    const int side = bench.quick() ? 256 : 1024;
    const LitViews views(scene, views_of(scene.view, bench.quick() ? 2 : view_count, side), side, nullptr);
    const render::EmbreeLitWay way = fastest_lit_way(views, embree, lit_ways(bench), 1);
    const std::vector<render::SeenPlaces> seen = views.first_hits(embree);
    const render::Lamps tree = scene.asked(LampSearch::Tree), pvs = scene.asked(LampSearch::Pvs);
    render::Framebuffer image(side, side);
    const auto ours = [&](Tracer tracer, const render::Lamps* lamps) {
        return Competitor{lamps == nullptr ? std::string(name_of(tracer)) + " unlit" : name_of(tracer, lamps->search),
                          [&, tracer, lamps] { views.draw(tracer, lamps, image); }};
    };
    enum { ScalarPvs, SimdPvs, SimdTree, PacketTree, SimdUnlit, PacketUnlit, Whole, Known };
    const RayContest contest(
        bench.quick() ? 3 : 5, views.primary_rays() + views.shadow_rays(),
        {ours(Tracer::Scalar, &pvs),
         ours(Tracer::Simd, &pvs),
         ours(Tracer::Simd, &tree),
         ours(Tracer::Packet, &tree),
         ours(Tracer::Simd, nullptr),
         ours(Tracer::Packet, nullptr),
         {"Embree " + text(way), [&] { views.draw_by(embree, way, {}, image); }},
         {"Embree from known hits, " + text(way), [&] { views.draw_by(embree, way, seen, image); }}},
        Clock::Thread);
    bench.add(on(scene, {.row = "shadow rays a pixel",
                         .value = views.shadow_rays() / std::max(1.0, views.lit_pixels()),
                         .unit = "of " + grouped(scene.lamps.size())}));
    for (const std::size_t k : {ScalarPvs, SimdPvs, SimdTree, PacketTree})
        bench.add(on(scene, contest.row(contest.name(k) + ", lit pictures", k, Whole)));
    add_shadows(bench, scene, views, contest, SimdTree, SimdUnlit, Known, has_goals ? 25 : 0);
    add_shadows(bench, scene, views, contest, PacketTree, PacketUnlit, Known, has_goals ? 60 : 0);
    add_lit_over_unlit(bench, scene, views, contest, SimdTree, SimdUnlit);
    add_lit_over_unlit(bench, scene, views, contest, PacketTree, PacketUnlit);

    render::Framebuffer scalar(side, side), other(side, side);
    views.draw(Tracer::Scalar, &tree, scalar, 1);
    for (const Tracer tracer : {Tracer::Simd, Tracer::Packet}) {
        views.draw(tracer, &tree, other, 1);
        add_unlike(bench, scene, name_of(tracer, LampSearch::Tree), "scalar's", scalar, other);
    }
    views.draw_by(embree, way, {}, other, 1);
    // Light from outside comes through glass, which does not tint Embree's.
    if (scene.places != LampPlaces::Outside) add_unlike(bench, scene, "scalar tree", "Embree's", scalar, other);
    views.draw_by(embree, way, seen, image, 1);
    add_unlike(bench, scene, "Embree from known hits", "Embree's", image, other);
}

void bench_lamp_counts(Bench& bench, const std::string& building, const accel::SceneView& scene) {
    const int side = bench.quick() ? 256 : 512;
    const std::vector<std::size_t> counts =
        bench.quick() ? std::vector<std::size_t>{8, 2500} : std::vector<std::size_t>{8, 25, 80, 250, 800, 2500};
    for (const std::size_t count : counts) {
        const LitScene lit(building, scene, count, LampPlaces::Rooms);
        const LitViews views(lit, views_of(scene, bench.quick() ? 2 : view_count, side), side, nullptr);
        const render::Lamps tree = lit.asked(LampSearch::Tree);
        render::Framebuffer image(side, side);
        const RayContest contest(bench.quick() ? 1 : 3, views.primary_rays() + views.shadow_rays(),
                                 {{"packet tree", [&] { views.draw(Tracer::Packet, &tree, image); }},
                                  {"scalar tree", [&] { views.draw(Tracer::Scalar, &tree, image); }}},
                                 Clock::Thread);
        for (std::size_t k = 0; k < 2; ++k)
            bench.add(on(lit, {.row = std::to_string(count) + " lamps: " + contest.name(k),
                               .value = contest.speed(k),
                               .unit = "Mrays/s"}));
    }
}

void bench_lit_furniture(Bench& bench, const TracedFloor& floor, std::size_t lamps) {
    const LitScene scene(floor.name() + " furnished", floor.scene(), lamps, LampPlaces::Rooms);
    const int side = bench.quick() ? 128 : 512;
    const LitViews views(scene, views_of(scene.view, bench.quick() ? 2 : view_count, side), side, &floor.objects);
    std::vector<render::EmbreeLitWay> ways = lit_ways(bench);
    std::erase_if(ways, [](const render::EmbreeLitWay& way) { return way.coherent_shadows; });
    const render::EmbreeLitWay way = fastest_lit_way(views, *floor.embree, ways, 1);
    const std::vector<render::SeenPlaces> seen = views.first_hits(*floor.embree);
    const render::Lamps tree = scene.asked(LampSearch::Tree), pvs = scene.asked(LampSearch::Pvs);
    render::Framebuffer image(side, side);
    const auto ours = [&](Tracer tracer, const render::Lamps& asked) {
        return Competitor{name_of(tracer, asked.search), [&, tracer] { views.draw(tracer, &asked, image); }};
    };
    enum { ScalarPvs, ScalarTree, SimdTree, PacketTree, Whole };
    const RayContest contest(
        bench.quick() ? 1 : 3, views.primary_rays() + views.shadow_rays(),
        {ours(Tracer::Scalar, pvs),
         ours(Tracer::Scalar, tree),
         ours(Tracer::Simd, tree),
         ours(Tracer::Packet, tree),
         {"Embree instanced, " + text(way), [&] { views.draw_by(*floor.embree, way, {}, image); }},
         {"Embree instanced from known hits, " + text(way), [&] { views.draw_by(*floor.embree, way, seen, image); }}},
        Clock::Thread);
    bench.add(on(scene, {.row = "shadow rays a pixel",
                         .value = views.shadow_rays() / std::max(1.0, views.lit_pixels()),
                         .unit = "of " + grouped(scene.lamps.size())}));
    bench.add(on(scene, {.row = "lists and trees, build", .value = scene.tree_seconds, .unit = "s"}));
    for (const std::size_t k : {ScalarPvs, ScalarTree, SimdTree, PacketTree}) {
        BenchRow row = on(scene, contest.row(contest.name(k) + ", lit furnished pictures", k, Whole));
        if (k == PacketTree) row.goal = ratio_at_least(2);
        bench.add(std::move(row));
    }
    bench.add(on(scene, contest.row("Embree from known hits, lit furnished pictures", Whole + 1, Whole)));
    bench.add(on(scene, contest.row("scalar tree against scalar pvs", ScalarTree, ScalarPvs)));
    render::Framebuffer walked(side, side), other(side, side);
    views.draw(Tracer::Scalar, &pvs, walked, 1);
    for (const Tracer tracer : {Tracer::Scalar, Tracer::Simd, Tracer::Packet}) {
        views.draw(tracer, &tree, other, 1);
        add_unlike(bench, scene, name_of(tracer, LampSearch::Tree), "scalar walks'", walked, other);
    }
    views.draw_by(*floor.embree, way, {}, other, 1);
    add_unlike(bench, scene, "scalar walks", "Embree's", walked, other);
}

}  // namespace enfilade::tools
