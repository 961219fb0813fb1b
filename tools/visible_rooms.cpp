#include "tools/visible_rooms.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <random>

#include "accel/beam.h"
#include "base/error.h"
#include "render/walk.h"
#include "tools/console.h"
#include "tools/suggestion.h"

namespace enfilade::tools {

namespace {

using accel::Label;
using accel::SpaceId;
using render::Vec3d;

constexpr std::size_t sample_count = 20000;

bool is_opening(Label label) { return label == Label::Door || label == Label::Window || label == Label::Opening; }

/// Places spread evenly over the volume of some cells.
class PlacesIn {
public:
    PlacesIn(const accel::SceneView& scene, const std::vector<accel::BeamSource>& sources) : scene_(scene) {
        double sum = 0;
        for (const accel::BeamSource& source : sources) {
            const accel::Cell& cell = scene.cells[index(source.cell)];
            for (std::uint32_t k = 1; k + 1 < cell.section_count; ++k) {
                const std::uint32_t a = cell.first_section, b = a + k, c = b + 1;
                const double area = cross(a, b, c);
                sum += std::max(0.0, area) * (double{cell.z_ceiling} - double{cell.z_floor});
                parts_.push_back({sum, source.cell, b});
            }
        }
    }

    /// A line of sight: where it starts, and its cell.
    template <class Random>
    std::pair<Vec3d, accel::CellId> next(Random& random) const {
        const double at = random() * parts_.back().sum;
        const auto part =
            std::lower_bound(parts_.begin(), parts_.end() - 1, at, [](const Part& p, double v) { return p.sum < v; });
        const accel::Cell& cell = scene_.cells[index(part->cell)];
        double s = random(), t = random();
        if (s + t > 1) s = 1 - s, t = 1 - t;
        const Vec3d a = corner(cell.first_section), b = corner(part->section), c = corner(part->section + 1);
        Vec3d p = a + s * (b - a) + t * (c - a);
        p.z = double{cell.z_floor} + random() * (double{cell.z_ceiling} - double{cell.z_floor});
        return {p, part->cell};
    }

private:
    struct Part {
        double sum;  ///< of the volumes up to this one
        accel::CellId cell;
        std::uint32_t section;  ///< second corner of its triangle
    };
    [[nodiscard]] Vec3d corner(std::uint32_t s) const { return {scene_.section_x[s], scene_.section_y[s], 0}; }
    [[nodiscard]] double cross(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        const Vec3d u = corner(b) - corner(a), v = corner(c) - corner(a);
        return u.x * v.y - u.y * v.x;
    }

    const accel::SceneView& scene_;
    std::vector<Part> parts_;
};

struct CrossedCells : render::NoEvents {
    std::vector<std::uint32_t>* cells = nullptr;
    void crossed(std::uint32_t cell) { cells->push_back(cell); }
};

/// [space] the share of lines of sight that get there.
std::vector<double> view_shares(const accel::SceneView& scene, const std::vector<accel::BeamSource>& sources) {
    std::vector<double> shares(scene.spaces.size(), 0);
    std::vector<std::size_t> last_ray(scene.spaces.size(), 0);
    const PlacesIn places(scene, sources);
    std::mt19937_64 bits(8191);
    const auto random = [&] { return double(bits() >> 11) * 0x1p-53; };
    std::vector<std::uint32_t> cells;
    CrossedCells events;
    events.cells = &cells;
    for (std::size_t ray_number = 1; ray_number <= sample_count; ++ray_number) {
        const auto [place, cell] = places.next(random);
        const double z = 2 * random() - 1, angle = 2 * std::numbers::pi * random(), flat = std::sqrt(1 - z * z);
        render::Ray<double> ray;
        if (!render::make_ray(place, Vec3d{flat * std::cos(angle), flat * std::sin(angle), z}, ray)) continue;
        cells.clear();
        render::Vec3f throughput = {1, 1, 1};
        static_cast<void>(
            render::walk(scene, ray, static_cast<std::uint32_t>(cell), render::NoLimit{}, throughput, events));
        for (const std::uint32_t c : cells) {
            const std::size_t space = index(scene.cells[c].space);
            if (std::exchange(last_ray[space], ray_number) != ray_number) shares[space] += 1;
        }
    }
    for (double& share : shares) share /= double(sample_count);
    return shares;
}

std::string name_of(const accel::SceneView& scene, const accel::Space& space) {
    const std::string_view name = scene.string(space.name);
    return std::string(name.empty() ? scene.string(space.id) : name);
}

std::string place_of(const accel::SceneView& scene, const accel::Space& space) {
    if (space.label == Label::Exterior) return "outdoors";
    const std::string_view storey = scene.string(space.storey);
    const std::string kind = space.label == Label::Room ? "" : accel::name_of(space.label) + std::string(" ");
    return kind + name_of(scene, space) + (storey.empty() ? "" : "  (storey " + std::string(storey) + ")");
}

}  // namespace

SpaceId room_by_name(const accel::SceneView& scene, const std::string& room) {
    std::vector<std::string> known;
    for (std::size_t s = 0; s < scene.spaces.size(); ++s) {
        const accel::Space& space = scene.spaces[s];
        if (space.label != Label::Room) continue;
        if (scene.string(space.name) == room || scene.string(space.id) == room) return SpaceId(s);
        for (const accel::TextId text : {space.name, space.id}) known.emplace_back(scene.string(text));
    }
    throw InputError("F109", "",
                     "There is no room \"" + room + '"' + suggestion(room, known) +
                         ": \"enfilade info SCENE.enf\" lists the rooms.");
}

RoomSight visible_from(const accel::SceneView& scene, SpaceId room) {
    constexpr std::uint32_t unseen = std::numeric_limits<std::uint32_t>::max();
    const std::vector<accel::BeamSource> sources = accel::sources_of_space(scene, room);
    std::vector<std::uint32_t> openings(scene.spaces.size(), unseen);
    std::vector<char> is_seen(scene.cells.size(), 0);
    accel::BeamWalker walker(scene);
    std::vector<std::uint32_t> crossed;  // [step]
    for (const accel::BeamSource& source : sources) {
        walker.start(source);
        crossed.clear();
        while (const accel::BeamStep* step = walker.next()) {
            is_seen[index(step->cell)] = 1;
            const accel::Cell& cell = scene.cells[index(step->cell)];
            std::uint32_t count = 0;
            if (step->depth > 0) {
                count = crossed[step->parent];
                const accel::Cell& from = scene.cells[index(step->from)];
                if (is_opening(from.label) && from.space != cell.space) ++count;
            }
            crossed.push_back(count);
            std::uint32_t& least = openings[index(cell.space)];
            least = std::min(least, count);
        }
    }
    RoomSight sight{room, {}, 0, sample_count};
    std::vector<VisibleSpace> spaces(scene.spaces.size());
    for (std::size_t c = 0; c < scene.cells.size(); ++c) {
        VisibleSpace& space = spaces[index(scene.cells[c].space)];
        ++space.cells;
        space.cells_seen += is_seen[c] != 0;
        sight.cells_seen += is_seen[c] != 0;
    }
    const std::vector<double> shares =
        sources.empty() ? std::vector<double>(spaces.size(), 0) : view_shares(scene, sources);
    for (std::size_t s = 0; s < spaces.size(); ++s) {
        if (spaces[s].cells_seen == 0 || SpaceId(s) == room) continue;
        spaces[s].space = SpaceId(s);
        spaces[s].openings = openings[s];
        spaces[s].view_share = shares[s];
        sight.spaces.push_back(spaces[s]);
    }
    std::ranges::stable_sort(sight.spaces, [](const VisibleSpace& a, const VisibleSpace& b) {
        return a.view_share != b.view_share ? a.view_share > b.view_share : a.openings < b.openings;
    });
    return sight;
}

std::string sight_text(const accel::SceneView& scene, const RoomSight& sight) {
    std::string table;
    std::size_t rooms = 0, opening_count = 0;
    bool sees_outdoors = false;
    for (const VisibleSpace& seen : sight.spaces) {
        const accel::Space& space = scene.spaces[index(seen.space)];
        if (is_opening(space.label)) {
            ++opening_count;
            continue;
        }
        rooms += space.label == Label::Room;
        sees_outdoors |= space.label == Label::Exterior;
        char line[96];
        if (seen.view_share > 0) std::snprintf(line, sizeof line, "  %6.2f %%", 100 * seen.view_share);
        else std::snprintf(line, sizeof line, "  < %4.2f %%", 100.0 / double(sight.sample_count));
        table += line;
        std::snprintf(line, sizeof line, " %9u %7zu of %-6zu ", seen.openings, seen.cells_seen, seen.cells);
        table += line + place_of(scene, space) + '\n';
    }
    std::size_t all_rooms = 0;
    for (const accel::Space& space : scene.spaces) all_rooms += space.label == Label::Room;
    std::string text = place_of(scene, scene.spaces[index(sight.room)]) + " sees " + grouped(rooms) + " of " +
                       counted(all_rooms - 1, "other room") + ", " +
                       counted(opening_count, "door, window or opening", "doors, windows and openings") +
                       (sees_outdoors ? ", and the outdoors" : ", and nothing outdoors") + "\n";
    if (!table.empty()) text += "\n    view   openings     cells       what\n" + table;
    return text;
}

nlohmann::ordered_json sight_json(const accel::SceneView& scene, const RoomSight& sight) {
    const accel::Space& room = scene.spaces[index(sight.room)];
    nlohmann::ordered_json json = {
        {"id", scene.string(room.id)}, {"name", scene.string(room.name)}, {"storey", scene.string(room.storey)}};
    json["cells_seen"] = sight.cells_seen;
    json["sample_count"] = sight.sample_count;
    json["spaces"] = nlohmann::ordered_json::array();
    for (const VisibleSpace& seen : sight.spaces) {
        const accel::Space& space = scene.spaces[index(seen.space)];
        json["spaces"].push_back({{"id", scene.string(space.id)},
                                  {"name", scene.string(space.name)},
                                  {"label", accel::name_of(space.label)},
                                  {"storey", scene.string(space.storey)},
                                  {"cells_seen", seen.cells_seen},
                                  {"cells", seen.cells},
                                  {"openings", seen.openings},
                                  {"view_share", seen.view_share}});
    }
    return json;
}

}  // namespace enfilade::tools
