// The dial's options of the cuda tracer: pixels unlike the scalar tracer's, memory, and on a card the time of a
// picture. Without a card this machine's cores run the same kernels on small pictures: what they err is known, what
// they cost is not.

#include <algorithm>
#include <cstdlib>

#include "plans/generate.h"
#include "render/cuda/pictures.h"
#include "tools/bench_cells.h"
#include "tools/bench_dial.h"
#include "tools/furnished_floor.h"

namespace enfilade::tools {

namespace {

using namespace render::cuda;

struct Setting {
    std::string name;
    PictureOptions options;
};

/// Draws the views of one scene on a device by one setting after the other.
class DeviceDial {
public:
    DeviceDial(Device& device, const accel::SceneView& scene, std::string name)
        : device_(&device),
          scene_(&scene),
          name_(std::move(name)),
          side_(device.is_card() ? 1024 : 128),
          views_(prepared(scene, floor_views(scene, 4, side_))) {}

    void add_rows(Bench& bench, const Setting& setting) const {
        Pictures pictures(*device_, *scene_, setting.options);
        const auto row = [&](const char* what, double value, const char* unit) {
            bench.add({.row = setting.name + ": " + what, .scene = name_, .value = value, .unit = unit});
        };
        const double pixels = double(side_) * side_ * double(views_.size());
        row("pixels unlike the scalar ones", 1e6 * double(others(pictures, setting.options)) / pixels, "per million");
        row("memory", double(pictures.bytes()) / 1e6, "MB");
        if (device_->is_card()) row("time", seconds_a_picture(pictures), "s");
    }

private:
    /// Pixels that differ by more than a step of 255 in some channel.
    std::uint64_t others(Pictures& pictures, const PictureOptions& options) const {
        std::uint64_t count = 0;
        const accel::SerialExecutor one;
        std::unique_ptr<render::ObjectAccel> accel;
        if (scene_->has_objects())
            accel = render::build_object_accel(*scene_, render::ObjectAccelKind::Octree, one, options.octrees);
        const render::ObjectTracer objects = accel ? accel->tracer() : render::ObjectTracer{};
        render::Framebuffer expected(side_, side_), actual;
        for (const PreparedView& view : views_) {
            render::trace_lambert(*scene_, view.frame, view.start,
                                  {.tracer = render::Tracer::Scalar, .objects = accel ? &objects : nullptr}, one,
                                  expected);
            pictures.draw(view.frame, view.start, side_, side_);
            pictures.read(actual);
            for (std::size_t i = 0; i < expected.rgba.size(); ++i) count += differ(expected.rgba[i], actual.rgba[i]);
        }
        return count;
    }

    static bool differ(std::uint32_t a, std::uint32_t b) {
        for (int shift = 0; shift < 24; shift += 8)
            if (std::abs(int(a >> shift & 255u) - int(b >> shift & 255u)) > 1) return true;
        return false;
    }

    double seconds_a_picture(Pictures& pictures) const {
        std::vector<double> seconds;
        for (int round = 0; round < 15; ++round)
            seconds.push_back(device_->seconds_of([&] {
                for (const PreparedView& view : views_) pictures.draw(view.frame, view.start, side_, side_);
            }));
        std::ranges::sort(seconds);
        return seconds[seconds.size() / 2] / double(views_.size());
    }

    Device* device_;
    const accel::SceneView* scene_;
    std::string name_;
    int side_;
    std::vector<PreparedView> views_;
};

std::vector<Setting> schedules() {
    std::vector<Setting> settings;
    const auto add = [&](const char* name, const PictureSchedule& schedule) {
        settings.push_back({name, {.schedule = schedule}});
    };
    add("device-order rows", {.order = PixelOrder::Rows});
    add("device-order tiles", {.order = PixelOrder::Tiles});
    add("device-order morton", {.order = PixelOrder::Morton});
    add("device-work once", {.work = WarpWork::Once});
    add("device-work persistent", {.work = WarpWork::Persistent});
    add("device-start launch", {.start = FrameStart::Launch});
    add("device-start graph", {.start = FrameStart::Graph});
    add("device-shape blocks64", {.shape = KernelShape::Blocks64});
    add("device-shape blocks128", {.shape = KernelShape::Blocks128});
    add("device-shape blocks256", {.shape = KernelShape::Blocks256});
    add("device-shape few-registers", {.shape = KernelShape::FewRegisters});
    add("device-shape least-registers", {.shape = KernelShape::LeastRegisters});
    settings.push_back({"device-packets none", {}});
    for (const PacketTiles tiles : {PacketTiles{8, 4}, PacketTiles{16, 4}, PacketTiles{64, 4}})
        settings.push_back({"device-packets " + std::to_string(tiles.largest) + "-to-" + std::to_string(tiles.smallest),
                            {.packets = tiles}});
    settings.push_back({"device-real float", {.precision = render::Precision::Float}});
    settings.push_back({"device-real double", {.precision = render::Precision::Double}});
    return settings;
}

}  // namespace

void dial_device(Bench& bench, const accel::SceneView& scene, const std::string& name) {
    const std::string why = why_no_card(0);
    if (!why.empty()) bench.remark("The cuda tracer: no time is measured. " + why);
    const accel::SerialExecutor one;
    const std::unique_ptr<Device> device = why.empty() ? open_card(0) : open_host(one);
    const DeviceDial rooms(*device, scene, name);
    for (const Setting& setting : schedules()) rooms.add_rows(bench, setting);
    const FurnishedFloor floor =
        furnished_floor("8 rooms, furnished", plans::generate({.rooms = 8}), {.detail = bench.quick() ? 1u : 4u});
    const DeviceDial furnished(*device, floor.scene.view(), floor.name);
    furnished.add_rows(bench, {"device-inside octree", {.inside = InsideKind::Octree}});
    furnished.add_rows(bench, {"device-inside bvh", {.inside = InsideKind::Bvh}});
}

}  // namespace enfilade::tools
