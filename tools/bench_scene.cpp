// Opening a scene file of 100 MB: mapping it and validating every index in it, against merely reading its bytes.

#include <unistd.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <thread>

#include "accel/assemble.h"
#include "accel/scene_file.h"
#include "modeler/build.h"
#include "modeler/convexify.h"
#include "modeler/export_scene.h"
#include "plans/generate.h"
#include "tools/bench.h"

namespace enfilade::tools {

namespace {

namespace fs = std::filesystem;

void shift(accel::InputTarget& target, std::uint32_t portals, std::uint32_t faces) {
    target.index += target.is_portal ? portals : faces;
}

/// Puts a copy of `part`, moved by `offset` grid units, beside what `whole` holds.
void append(accel::SceneInput& whole, const accel::SceneInput& part, const std::array<std::int32_t, 2>& offset) {
    const auto cells = std::uint32_t(whole.cells.size());
    const auto sections = std::uint32_t(whole.sections.size());
    const auto sides = std::uint32_t(whole.side_faces.size());
    const auto portals = std::uint32_t(whole.portals.size());
    const auto faces = std::uint32_t(whole.source_faces.size());
    const auto vertices = std::uint32_t(whole.vertices.size());
    const auto spaces = std::uint32_t(whole.spaces.size());
    const std::uint32_t volumes = whole.cells.empty() ? 0 : whole.cells.back().volume + 1;
    for (accel::InputCell cell : part.cells) {
        cell.space += spaces;
        cell.volume += volumes;
        cell.first_section += sections;
        shift(cell.floor, portals, faces);
        shift(cell.ceiling, portals, faces);
        whole.cells.push_back(cell);
    }
    for (accel::InputSection section : part.sections) {
        section.x += offset[0];
        section.y += offset[1];
        section.first_face += sides;
        whole.sections.push_back(section);
    }
    for (accel::InputSideFace side : part.side_faces) {
        shift(side.target, portals, faces);
        whole.side_faces.push_back(side);
    }
    for (accel::InputPortal portal : part.portals) {
        portal.front += cells;
        portal.back += cells;
        whole.portals.push_back(portal);
    }
    for (accel::InputSourceFace face : part.source_faces) {
        face.space += spaces;
        face.first_vertex += vertices;
        whole.source_faces.push_back(face);
    }
    for (const auto& [x, y, z] : part.vertices) whole.vertices.push_back({x + offset[0], y + offset[1], z});
    whole.spaces.insert(whole.spaces.end(), part.spaces.begin(), part.spaces.end());
}

/// Buildings side by side until the trace group holds `bytes`.
accel::Scene large_scene(std::size_t bytes) {
    modeler::Building building = modeler::convexify(modeler::build(plans::generate({.rooms = 1000})));
    const accel::SceneInput part = modeler::scene_input(building);
    const std::size_t part_bytes = accel::assemble(part).bytes().size();
    const std::size_t copies = bytes / part_bytes + 1;
    // Sites lie from site_min to site_max: the next one begins where the last one ends, in a square around the origin.
    const auto columns = std::int32_t(std::ceil(std::sqrt(double(copies))));
    const std::int32_t step_x = building.site_max[0] - building.site_min[0] + 1;
    const std::int32_t step_y = building.site_max[1] - building.site_min[1] + 1;
    accel::SceneInput whole;
    whole.unit = part.unit;
    whole.origin = part.origin;
    whole.materials = part.materials;
    whole.certificate = part.certificate;
    for (std::int32_t copy = 0; copy < std::int32_t(copies); ++copy)
        append(whole, part, {step_x * (copy % columns - columns / 2), step_y * (copy / columns - columns / 2)});
    return accel::assemble(whole);
}

/// Every byte of the file, through read(2): what loading costs where nothing is checked.
void read_plainly(const fs::path& file, std::vector<char>& buffer) {
    std::ifstream stream(file, std::ios::binary);
    stream.rdbuf()->pubsetbuf(nullptr, 0);
    stream.read(buffer.data(), std::streamsize(buffer.size()));
}

}  // namespace

void bench_scene(Bench& bench) {
    const fs::path file = fs::temp_directory_path() / ("enfilade-bench-" + std::to_string(getpid()) + ".enf");
    double bytes = 0;
    {
        const accel::Scene scene = large_scene(bench.quick() ? 20'000'000 : 100'000'000);
        bytes = double(scene.bytes().size());
        accel::write(scene, file);
    }
    const std::string name = byte_text(bytes);
    const int runs = bench.quick() ? 5 : 9;
    std::vector<char> buffer(static_cast<std::size_t>(bytes));

    const Duel all_cores = duel(
        runs, [&] { (void)accel::open(file); }, [&] { read_plainly(file, buffer); });
    bench.add({.row = "open and validate",
               .scene = name,
               .threads = std::max(1u, std::thread::hardware_concurrency()),
               .value = bytes / all_cores.a_seconds / 1e9,
               .unit = "GB/s",
               .reference = "read(2)",
               .reference_value = bytes / all_cores.b_seconds / 1e9,
               .ratio = all_cores.b_over_a,
               .goal = value_at_least(1)});
    const accel::SerialExecutor serial;
    const double one = median_seconds(runs, [&] { (void)accel::open(file, {.executor = &serial}); });
    bench.add({.row = "open and validate", .scene = name, .value = bytes / one / 1e9, .unit = "GB/s"});
    const double hashed =
        median_seconds(bench.quick() ? 1 : 3, [&] { (void)accel::open(file, {.verify_hashes = true}); });
    bench.add({.row = "open, validate and compare SHA-256",
               .scene = name,
               .threads = std::max(1u, std::thread::hardware_concurrency()),
               .value = bytes / hashed / 1e9,
               .unit = "GB/s"});
    std::error_code ignored;
    fs::remove(file, ignored);
}

}  // namespace enfilade::tools
