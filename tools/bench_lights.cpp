// Pictures lit by many lamps: walks to all of them, to those of lists, and light trees, against Embree with the same
// lists.

#include "tools/bench_lights.h"

#include "render/executor.h"
#include "tools/examples.h"

namespace enfilade::tools {

namespace {

/// What the issue asks of lists and trees.
constexpr double most_seconds = 1, most_seconds_outside = 10;
constexpr std::size_t lamps_outside = 2500;

struct Example {
    const char* name;
    std::uint32_t rooms;
    std::size_t lamps;  ///< the paper's MAISON, BAT-1 and BAT-2
};
constexpr std::array examples = {Example{"townhouse", 9, 8}, Example{"office-46", 46, 55},
                                 Example{"office-135", 135, 200}};

void bench_building(Bench& bench, const TracedBuilding& building, std::size_t lamps, LampPlaces places) {
    const LitScene lit(building.name, building.scene.view(), lamps, places);
    if (lit.lamps.empty()) {
        bench.remark(building.name + " has no place for such lamps.");
        return;
    }
    const bool is_outside = places == LampPlaces::Outside;
    bench_lamp_lists(bench, lit, is_outside ? most_seconds_outside : most_seconds);
    bench_lit_searches(bench, lit);
    bench_lit_pictures(bench, lit, building.embree, lamps == 200);
}

}  // namespace

LitScene::LitScene(const std::string& building, const accel::SceneView& scene, std::size_t count, LampPlaces where)
    : name(building + ", " + grouped(count) + " lamps" + (where == LampPlaces::Outside ? " outside" : "")),
      places(where),
      lamps(spread_lamps(scene, count, where)),
      view(with_lamps(scene, lamps)) {
    const std::unique_ptr<accel::Executor> cores = render::make_executor();
    tree_seconds = seconds_of([&] { trees = accel::build_light_trees(view, {}, *cores); });
    lists = render::lamp_lists(trees.view());
}

render::Lamps LitScene::asked(render::LampSearch search) const { return {trees.view(), search, exposure}; }

LitViews::LitViews(const LitScene& scene, const std::vector<PreparedView>& views, int side,
                   const render::ObjectTracer* objects)
    : scene_(&scene), views_(views), side_(side), objects_(objects) {
    for (const PreparedView& view : views_) look(view);
}

void LitViews::look(const PreparedView& view) {
    const auto pixels = static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_);
    std::vector<float> origin[3], direction[3];
    for (int y = 0; y < side_; ++y)
        for (int x = 0; x < side_; ++x) {
            const render::Vec3f d = view.frame.direction(float(x) + 0.5f, float(y) + 0.5f), o = view.frame.origin;
            origin[0].push_back(o.x), origin[1].push_back(o.y), origin[2].push_back(o.z);
            direction[0].push_back(d.x), direction[1].push_back(d.y), direction[2].push_back(d.z);
        }
    const std::vector<accel::CellId> start(pixels, view.start);
    std::vector<accel::CellId> end(pixels);
    std::vector<accel::SourceFaceId> face(pixels);
    std::vector<render::WalkStatus> status(pixels);
    render::nearest(scene_->view,
                    {origin[0], origin[1], origin[2], direction[0], direction[1], direction[2], start, {}},
                    {{}, face, end, status, {}, {}}, {.objects = objects_});
    cells_.emplace_back(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        const auto cell = static_cast<std::uint32_t>(end[i]);
        cells_.back()[i] = cell < scene_->view.cells.size() ? cell : 0;
        const bool is_face = status[i] == render::WalkStatus::Hit &&
                             scene_->view.source_faces[index(face[i])].surface != accel::Surface::Sky;
        if (!is_face && status[i] != render::WalkStatus::Object) continue;
        ++lit_pixels_;
        shadow_rays_ += double(scene_->lists.offsets[cell + 1] - scene_->lists.offsets[cell]);
    }
}

void LitViews::draw(render::Tracer tracer, const render::Lamps* lamps, render::Framebuffer& image,
                    std::size_t count) const {
    render::LambertOptions options;
    options.tracer = tracer;
    options.objects = objects_;
    options.lamps = lamps;
    for (std::size_t k = 0; k < std::min(count, views_.size()); ++k)
        render::trace_lambert(scene_->view, views_[k].frame, views_[k].start, options, one_, image);
}

std::vector<render::EmbreeLitWay> lit_ways(const Bench& bench) {
    std::vector<render::EmbreeLitWay> ways = render::embree_lit_ways();
    if (bench.quick())
        std::erase_if(ways, [](const render::EmbreeLitWay& way) { return way.primary.lanes < 8 || way.from_lamps; });
    return ways;
}

std::string name_of(render::Tracer tracer, render::LampSearch search) {
    const char* names[] = {" naive", " pvs", " tree"};
    return name_of(tracer) + std::string(names[static_cast<std::size_t>(search)]);
}

double unlike_per_million(const render::Framebuffer& a, const render::Framebuffer& b) {
    return 1e6 * double(unlike_pixels(a, b)) / double(a.rgba.size());
}

void bench_lights(Bench& bench) {
    for (const Example& example : examples) {
        if (bench.quick() && example.lamps != 200) continue;
        const TracedBuilding building = example_building(bench, example.name, example.rooms);
        bench_building(bench, building, example.lamps, LampPlaces::Rooms);
        if (example.lamps != 200) continue;
        if (!bench.quick()) bench_building(bench, building, lamps_outside, LampPlaces::Outside);
        bench_lamp_counts(bench, building.name, building.scene.view());
    }
    bench_lamp_growth(bench);
    const ExamplePlan large = example_plan(bench, bench.quick() ? "office-46" : "office-135", bench.quick() ? 46 : 135);
    const FurnishedFloor floor = furnished_floor(large.name, large.plan, {});
    bench_lit_furniture(bench, TracedFloor(floor, true), 200);
}

}  // namespace enfilade::tools
