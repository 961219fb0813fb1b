#include "modeler/objects/lit_region.h"

#include <algorithm>
#include <cmath>

namespace enfilade::modeler {
namespace {

using accel::BeamSource;
using accel::BeamStep;
using accel::CellId;
using accel::PlanLine;
using accel::PlanPoint;

constexpr double spare = 4;  ///< grid units: roundings of clipping, and cells that the grid has bent by a unit

struct Place {
    double x, y;
};

/// What lies on the side of the line that `side` says, or not farther than `spare` beyond it.
std::vector<Place> clipped(const std::vector<Place>& ring, const PlanLine& line, int side) {
    const double dx = double(line.to.x - line.from.x), dy = double(line.to.y - line.from.y);
    const double length = std::hypot(dx, dy);
    const auto inside = [&](const Place& p) {
        return side * (dx * (p.y - double(line.from.y)) - dy * (p.x - double(line.from.x))) / length + spare;
    };
    std::vector<Place> kept;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Place& a = ring[i];
        const Place& b = ring[i + 1 == ring.size() ? 0 : i + 1];
        const double at_a = inside(a), at_b = inside(b);
        if (at_a >= 0) kept.push_back(a);
        if ((at_a < 0) == (at_b < 0)) continue;
        const double t = at_a / (at_a - at_b);
        kept.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
    }
    return kept;
}

std::vector<PlanPoint> rounded_outward(const std::vector<Place>& ring) {
    std::vector<PlanPoint> corners;
    for (const Place& p : ring)
        for (const double x : {std::floor(p.x), std::ceil(p.x)})
            for (const double y : {std::floor(p.y), std::ceil(p.y)})
                corners.push_back({std::int64_t(x), std::int64_t(y)});
    return accel::convex_hull(std::move(corners));
}

/// Whether the point lies in the ring, or on it.
bool holds(const std::vector<PlanPoint>& ring, const PlanPoint& p) {
    for (std::size_t i = 0; i < ring.size(); ++i)
        if (accel::turn(ring[i], ring[i + 1 == ring.size() ? 0 : i + 1], p) < 0) return false;
    return ring.size() > 2;
}

}  // namespace

LitRegions::LitRegions(const accel::SceneView& scene) : scene_(scene), parts_(scene.cells.size()) {}

void LitRegions::add(const BeamSource& whole, std::vector<PlanPoint> corners, std::int64_t z_low, std::int64_t z_high) {
    Part& part = parts_[index(whole.cell)];
    if (part.corners.empty()) {
        part.z_low = z_low;
        part.z_high = z_high;
    }
    part.z_low = std::min(part.z_low, z_low);
    part.z_high = std::max(part.z_high, z_high);
    corners.insert(corners.end(), part.corners.begin(), part.corners.end());
    part.corners = accel::convex_hull(std::move(corners));
    if (part.z_low <= whole.z_low && part.z_high >= whole.z_high &&
        std::ranges::all_of(whole.corners, [&](const PlanPoint& p) { return holds(part.corners, p); }))
        part.is_whole = true;
}

void LitRegions::add_cell(CellId cell) {
    if (parts_[index(cell)].is_whole) return;
    const BeamSource whole = accel::source_of_cell(scene_, cell);
    parts_[index(cell)] = {whole.corners, whole.z_low, whole.z_high, true};
}

void LitRegions::add(const BeamStep& step) {
    if (parts_[index(step.cell)].is_whole) return;
    if (!step.beam.has_gate) return add_cell(step.cell);
    const BeamSource whole = accel::source_of_cell(scene_, step.cell);
    std::vector<Place> ring;
    for (const PlanPoint& p : whole.corners) ring.push_back({double(p.x), double(p.y)});
    if (step.beam.plan.left.exists()) ring = clipped(ring, step.beam.plan.left, -1);
    if (step.beam.plan.right.exists()) ring = clipped(ring, step.beam.plan.right, 1);
    if (ring.empty()) return add_cell(step.cell);  // a beam as thin as roundings: rather too much than too little
    std::int64_t z_low = whole.z_low, z_high = whole.z_high;
    const double way = accel::farthest(step.beam.lit, whole.corners);
    const auto end = [&](double z, double slope) { return slope == 0 ? z : z + slope * way; };
    const double low = std::min(step.beam.height.z.low, end(step.beam.height.z.low, step.beam.height.slope.low));
    const double high = std::max(step.beam.height.z.high, end(step.beam.height.z.high, step.beam.height.slope.high));
    if (low > double(z_low)) z_low = std::min(z_high, std::int64_t(std::floor(low - spare)));
    if (high < double(z_high)) z_high = std::max(z_low, std::int64_t(std::ceil(high + spare)));
    add(whole, rounded_outward(ring), z_low, z_high);
}

void LitRegions::merge(const LitRegions& other) {
    for (std::size_t c = 0; c < parts_.size(); ++c) {
        const Part& part = other.parts_[c];
        if (part.corners.empty() || parts_[c].is_whole) continue;
        if (part.is_whole) parts_[c] = part;
        else add(accel::source_of_cell(scene_, CellId(c)), part.corners, part.z_low, part.z_high);
    }
}

std::vector<CellId> LitRegions::cells() const {
    std::vector<CellId> lit;
    for (std::size_t c = 0; c < parts_.size(); ++c)
        if (!parts_[c].corners.empty()) lit.push_back(CellId(c));
    return lit;
}

BeamSource LitRegions::region(CellId cell) const {
    const Part& part = parts_[index(cell)];
    return {cell, part.corners, part.z_low, part.z_high};
}

}  // namespace enfilade::modeler
