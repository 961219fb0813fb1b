#include "tools/walkways.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace enfilade::tools {

namespace {

using accel::Cell;
using accel::CellId;
using accel::Label;
using render::Vec3d;

constexpr double least_height = 1.8;
constexpr double highest_sill = 0.45;    ///< one step over
constexpr double least_head_room = 0.1;  ///< above the eyes
constexpr double easy_width = 0.6;
constexpr double detour = 6;  ///< metres that the narrowest gate counts for

bool is_walked(Label label) {
    return label == Label::Room || label == Label::Door || label == Label::Opening || label == Label::Stair;
}

double height_of(const Cell& cell) { return double(cell.z_ceiling) - cell.z_floor; }

std::uint32_t next_section(const Cell& cell, std::uint32_t section) {
    return section + 1 == cell.first_section + cell.section_count ? cell.first_section : section + 1;
}

/// Area-weighted middle of the cell's floor.
Vec3d centroid(const accel::SceneView& scene, const Cell& cell) {
    const double x0 = scene.section_x[cell.first_section], y0 = scene.section_y[cell.first_section];
    double area = 0, x = 0, y = 0;
    for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s) {
        const std::uint32_t next = next_section(cell, s);
        const double px = scene.section_x[s] - x0, py = scene.section_y[s] - y0;
        const double qx = scene.section_x[next] - x0, qy = scene.section_y[next] - y0;
        const double part = px * qy - qx * py;
        area += part;
        x += part * (px + qx) / 3;
        y += part * (py + qy) / 3;
    }
    return {x0 + x / area, y0 + y / area, cell.z_floor + std::min(walking_eye_height, 0.8 * height_of(cell))};
}

}  // namespace

Walkways::Walkways(const accel::SceneView& scene) : scene_(scene) {
    for (const Cell& cell : scene.cells) middles_.push_back(centroid(scene, cell));
    for (std::size_t c = 0; c < scene.cells.size(); ++c) {
        offsets_.push_back(std::uint32_t(gates_.size()));
        if (!is_walkable(CellId(c))) continue;
        add_side_gates(CellId(c));
        const Cell& cell = scene.cells[c];
        add_level_gate(CellId(c), cell.floor, cell.z_floor);
        add_level_gate(CellId(c), cell.ceiling, cell.z_ceiling);
    }
    offsets_.push_back(std::uint32_t(gates_.size()));
}

bool Walkways::is_walkable(CellId id) const {
    const Cell& cell = scene_.cells[index(id)];
    // The part of a stairwell that lies in a slab is low, but nobody stands in it.
    return is_walked(cell.label) && (height_of(cell) >= least_height || cell.label == Label::Stair);
}

double Walkways::room_around(CellId id) const {
    const Cell& cell = scene_.cells[index(id)];
    const Vec3d p = middle(id);
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s) {
        const std::uint32_t next = next_section(cell, s);
        const double dx = double(scene_.section_x[next]) - scene_.section_x[s];
        const double dy = double(scene_.section_y[next]) - scene_.section_y[s];
        const double twice_area = dx * (p.y - scene_.section_y[s]) - dy * (p.x - scene_.section_x[s]);
        least = std::min(least, twice_area / std::hypot(dx, dy));
    }
    return least;
}

double Walkways::depth(CellId id, Vec3d p, Vec3d direction) const {
    const Cell& cell = scene_.cells[index(id)];
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s) {
        const std::uint32_t next = next_section(cell, s);
        const double dx = double(scene_.section_x[next]) - scene_.section_x[s];
        const double dy = double(scene_.section_y[next]) - scene_.section_y[s];
        const double nearing = dy * direction.x - dx * direction.y;
        if (!(nearing > 0)) continue;
        const double away = dx * (p.y - scene_.section_y[s]) - dy * (p.x - scene_.section_x[s]);
        least = std::min(least, std::max(0.0, away) / nearing);
    }
    return least;
}

void Walkways::add_side_gates(CellId id) {
    const Cell& cell = scene_.cells[index(id)];
    for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s) {
        const std::uint32_t next = next_section(cell, s);
        double low = cell.z_floor;
        for (std::uint32_t f = scene_.section_tails[s].first_face; f < scene_.section_tails[s + 1].first_face; ++f) {
            const accel::SideFace& face = scene_.side_faces[f];
            const double sill = std::exchange(low, double(face.z_top));
            if (!face.target.is_portal() || face.target.is_glass() || !is_walkable(face.target.neighbour())) continue;
            const Cell& other = scene_.cells[index(face.target.neighbour())];
            const double floor = std::max(double(cell.z_floor), double(other.z_floor));
            const double eye = floor + walking_eye_height;
            const bool is_passage = sill <= floor + highest_sill && face.z_top >= eye + least_head_room &&
                                    other.z_ceiling >= eye + least_head_room &&
                                    std::abs(double(cell.z_floor) - other.z_floor) <= highest_sill;
            if (!is_passage) continue;
            const Vec3d a = {scene_.section_x[s], scene_.section_y[s], eye};
            const Vec3d b = {scene_.section_x[next], scene_.section_y[next], eye};
            const double width = render::length(b - a);
            const Vec3d outward = {(b.y - a.y) / width, (a.x - b.x) / width, 0};
            gates_.push_back({id, face.target.neighbour(), 0.5 * (a + b), outward, width, false});
        }
    }
}

void Walkways::add_level_gate(CellId id, accel::Target target, double z) {
    if (!target.is_portal() || target.is_glass()) return;
    const Cell& cell = scene_.cells[index(id)];
    const Cell& other = scene_.cells[index(target.neighbour())];
    // The top of a flight is a room, or a stair again.
    if ((cell.label != Label::Stair && other.label != Label::Stair) || !is_walkable(target.neighbour())) return;
    // The middle of the smaller of the two holes.
    const CellId narrower = room_around(id) <= room_around(target.neighbour()) ? id : target.neighbour();
    Vec3d eye = middle(narrower);
    eye.z = z;
    gates_.push_back({id, target.neighbour(), eye, {0, 0, 0}, 2 * room_around(narrower), true});
}

bool Walkways::leads_outdoors(CellId id) const {
    const Cell& cell = scene_.cells[index(id)];
    const std::uint32_t end = scene_.section_tails[cell.first_section + cell.section_count].first_face;
    for (std::uint32_t f = scene_.section_tails[cell.first_section].first_face; f < end; ++f) {
        const accel::SideFace& face = scene_.side_faces[f];
        if (!face.target.is_portal() || face.target.is_glass()) continue;
        const Cell& other = scene_.cells[index(face.target.neighbour())];
        if (other.label == Label::Exterior && double(face.z_top) >= cell.z_floor + walking_eye_height &&
            std::abs(double(other.z_floor) - cell.z_floor) <= highest_sill)
            return true;
    }
    return false;
}

std::vector<std::uint32_t> Walkways::parts() const {
    std::vector<std::uint32_t> parts(scene_.cells.size(), UINT32_MAX);
    std::vector<std::uint32_t> open;
    for (std::uint32_t start = 0; start < parts.size(); ++start) {
        if (parts[start] != UINT32_MAX) continue;
        parts[start] = start;
        open.push_back(start);
        while (!open.empty()) {
            const std::uint32_t cell = open.back();
            open.pop_back();
            for (std::uint32_t g = offsets_[cell]; g < offsets_[cell + 1]; ++g) {
                const std::size_t to = index(gates_[g].to);
                if (parts[to] != UINT32_MAX) continue;
                parts[to] = start;
                open.push_back(std::uint32_t(to));
            }
        }
    }
    return parts;
}

Walkways::Ways Walkways::ways_from(CellId start) const {
    Ways ways;
    ways.metres.assign(scene_.cells.size(), std::numeric_limits<double>::infinity());
    ways.last_gates.assign(scene_.cells.size(), UINT32_MAX);
    using Entry = std::pair<double, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    ways.metres[index(start)] = 0;
    open.emplace(0, index(start));
    while (!open.empty()) {
        const auto [metres, cell] = open.top();
        open.pop();
        if (metres > ways.metres[cell]) continue;
        // Where one came in; in the first cell its middle.
        const std::uint32_t entry = ways.last_gates[cell];
        const Vec3d from = entry == UINT32_MAX ? middles_[cell] : gates_[entry].eye;
        for (std::uint32_t g = offsets_[cell]; g < offsets_[cell + 1]; ++g) {
            const Gate& gate = gates_[g];
            const double narrow = std::max(0.0, 1 - gate.width / easy_width);
            const double there = metres + render::length(gate.eye - from) + detour * narrow;
            if (!(there < ways.metres[index(gate.to)])) continue;
            ways.metres[index(gate.to)] = there;
            ways.last_gates[index(gate.to)] = g;
            open.emplace(there, index(gate.to));
        }
    }
    return ways;
}

std::vector<Gate> Walkways::gates_to(const Ways& ways, CellId cell) const {
    std::vector<Gate> gates;
    for (std::uint32_t g = ways.last_gates[index(cell)]; g != UINT32_MAX; g = ways.last_gates[index(gates.back().from)])
        gates.push_back(gates_[g]);
    std::ranges::reverse(gates);
    return gates;
}

}  // namespace enfilade::tools
