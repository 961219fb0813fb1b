// What it costs to put boxes into the rooms of a building, against building it again.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "modeler/build.h"
#include "modeler/convexify.h"
#include "modeler/editing/edit.h"
#include "modeler/editing/place_boxes.h"
#include "modeler/editing/reuse_cuts.h"
#include "modeler/realise.h"
#include "plans/generate.h"
#include "tools/bench.h"

namespace enfilade::tools {

namespace {

/// A box of about 30 cm in the middle of the first cell of each of `count` rooms, spread over the building.
std::vector<modeler::Box> some_boxes(const modeler::Building& building, std::size_t count) {
    std::vector<bool> has_box(building.spaces.size(), false);
    std::vector<modeler::Box> boxes;
    for (const modeler::Volume& volume : building.volumes) {
        if (volume.label != accel::Label::Room || has_box[volume.space]) continue;
        has_box[volume.space] = true;
        const modeler::Piece& piece = building.pieces[volume.piece];
        std::int64_t x = 0, y = 0;
        for (std::uint32_t k = 0; k < piece.corner_count; ++k) {
            const plans::GridPoint p = building.points[building.corners[piece.first_corner + k].vertex];
            x += p.x;
            y += p.y;
        }
        const std::int32_t half = std::int32_t(0.15 / building.frame.unit);
        const std::int32_t cx = std::int32_t(x / piece.corner_count), cy = std::int32_t(y / piece.corner_count);
        modeler::Box box;
        box.space = volume.space;
        box.id = "box " + std::to_string(boxes.size());
        box.footprint = {
            {cx - half, cy - half}, {cx + half, cy - half}, {cx + half, cy + half}, {cx - half, cy + half}};
        box.z_low = volume.z_low;
        box.z_high = volume.z_low + std::int32_t(0.75 / building.frame.unit);
        boxes.push_back(std::move(box));
    }
    if (count >= boxes.size()) return boxes;
    std::vector<modeler::Box> chosen;
    for (std::size_t k = 0; k < count; ++k) chosen.push_back(boxes[k * boxes.size() / count]);
    return chosen;
}

template <class T>
std::size_t heap_of(const std::vector<T>& list) {
    return list.capacity() * sizeof(T);
}

/// Bytes that a building keeps so that edits need not cut all its regions again.
double kept_bytes(const modeler::Building& building) {
    std::size_t bytes = heap_of(building.cuts);
    for (const modeler::RegionCut& cut : building.cuts)
        bytes += heap_of(cut.points) + heap_of(cut.new_points) + heap_of(cut.sides) + heap_of(cut.first_side) +
                 heap_of(cut.disc) + heap_of(cut.disc_cuts);
    return double(bytes);
}

void bench_size(Bench& bench, std::uint32_t rooms, int runs) {
    const modeler::Building before =
        modeler::convexify(modeler::build(plans::generate({.rooms = rooms, .curved = 0.3})));
    const std::string scene = std::to_string(rooms) + " rooms, 30 % curved";
    const std::vector<modeler::Box> one = some_boxes(before, 1), ten = some_boxes(before, 10);
    const auto add = [&](const char* row, double seconds) {
        bench.add({.row = row, .scene = scene, .value = seconds * 1e3, .unit = "ms"});
    };

    modeler::EditCount count;
    modeler::Building after;
    const accel::SerialExecutor serial;
    const Duel edit = duel(
        runs, [&] { after = modeler::insert_boxes(before, one, serial, &count); },
        [&] { after = modeler::realise(after.stack, after.cut_options); });
    bench.add({.row = "put in a box",
               .scene = scene,
               .value = edit.a_seconds * 1e3,
               .unit = "ms",
               .reference = "cut and raise all again",
               .reference_value = edit.b_seconds * 1e3,
               .ratio = edit.b_over_a});
    bench.add({.row = "regions cut again",
               .scene = scene,
               .value = double(count.cut_again),
               .unit = "regions",
               .reference = "regions of the building",
               .reference_value = double(count.regions)});

    const auto bare = std::make_shared<const modeler::Stack>(before.stack);
    modeler::Stack stack;
    const double place = median_seconds(runs, [&] { stack = modeler::place_boxes(bare, one); });
    const Duel cutting = duel(
        runs, [&] { (void)modeler::reuse_cuts(before.stack, before.cuts, stack, before.cut_options, serial); },
        [&] { (void)modeler::cut_regions(stack, before.cut_options, serial); });
    add("of it: the box in its room", place);
    bench.add({.row = "of it: cuts",
               .scene = scene,
               .value = cutting.a_seconds * 1e3,
               .unit = "ms",
               .reference = "cut all regions",
               .reference_value = cutting.b_seconds * 1e3,
               .ratio = cutting.b_over_a});
    add("of it: put together and raised", edit.a_seconds - place - cutting.a_seconds);
    bench.add({.row = "cutting, of a rebuild",
               .scene = scene,
               .value = 100 * cutting.b_seconds / edit.b_seconds,
               .unit = "%"});
    add("put in ten boxes in ten rooms", median_seconds(runs, [&] { after = modeler::insert_boxes(before, ten); }));
    add("take one of the ten out", median_seconds(runs, [&] { (void)modeler::remove_box(after, ten.front().id); }));
    bench.add({.row = "cuts kept for edits", .scene = scene, .value = kept_bytes(before) / 1e6, .unit = "MB"});
}

}  // namespace

void bench_edit(Bench& bench) {
    const OneCore one_core;
    bench_size(bench, 135, bench.quick() ? 5 : 11);
    bench_size(bench, 1000, bench.quick() ? 1 : 5);
    if (!bench.quick()) bench_size(bench, 5000, 3);
}

}  // namespace enfilade::tools
