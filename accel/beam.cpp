#include "accel/beam.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace enfilade::accel {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double far = 0x1p40;  ///< grid units beyond any scene
constexpr HeightBeam any_heights = {{-far, far}, {-infinity, infinity}};

}  // namespace

BeamWalker::BeamWalker(const SceneView& view, const BeamOptions& options)
    : view_(view),
      options_(options),
      per_unit_(1 / view.unit),
      limit_(view.portals.size(), options.max_beams),
      place_on_path_(view.cells.size()) {}

void BeamWalker::start(BeamSource source) {
    source_ = std::move(source);
    source_z_ = {double(source_.z_low), double(source_.z_high)};
    history_.shrink(0);
    limit_.clear();
    pending_.clear();
    path_.clear();
    is_pruned_ = true;
    step_count_ = 0;
    BeamStep step;
    step.cell = source_.cell;
    step.beam.height = {source_z_, {-infinity, infinity}};
    pending_.push_back({step, 0});
}

void BeamWalker::start_mirrored(BeamSource source, const BeamStep& step) {
    const Cell& cell = view_.cells[index(step.cell)];
    const double floor = units(cell.z_floor);
    const auto image = [&](const Interval& z) { return Interval{2 * floor - z.high, 2 * floor - z.low}; };
    corners_.clear();
    for (std::uint32_t i = 0; i < cell.section_count; ++i) corners_.push_back(corner(cell.first_section + i));
    const double from_source = farthest(source, corners_);
    const double from_reference = step.beam.has_gate ? farthest(step.beam.lit, corners_) : from_source;
    const auto margin = double(options_.margin);
    const Interval source_z = {double(source.z_low), double(source.z_high)};
    const std::optional<HeightBeam> down =
        through_level(step.beam.height, source_z, {{0, from_source}, {0, from_reference}}, Level::Floor,
                      {floor - margin, floor + margin});
    source.z_low = static_cast<std::int64_t>(2 * floor - source_z.high);
    source.z_high = static_cast<std::int64_t>(2 * floor - source_z.low);
    start(std::move(source));
    if (!down) return pending_.clear();
    BeamStep& first = pending_.back().step;
    first.cell = step.cell;
    // What came in by a side leaves by another; what came down through the ceiling may rise through it.
    if (!step.is_level) first.portal = step.portal;
    Beam& beam = first.beam;
    if (step.beam.has_gate) {
        beam = step.beam;
        beam.opening = image(beam.opening);
        beam.plan.left_chain = history_.add(UINT32_MAX, beam.gate.left, beam.gate.right, -1);
        beam.plan.right_chain = history_.add(UINT32_MAX, beam.gate.right, beam.gate.left, 1);
    }
    beam.height = {image(down->z), {-down->slope.high, -down->slope.low}};
    pending_.back().history_size = history_.size();
}

const BeamStep* BeamWalker::next() {
    if (!std::exchange(is_pruned_, true)) expand(current_);
    while (!pending_.empty()) {
        Pending pending = std::move(pending_.back());
        pending_.pop_back();
        history_.shrink(pending.history_size);
        BeamStep& step = pending.step;
        if (step.depth > 0) {
            const bool is_front = view_.portals[index(step.portal)].front == step.from;
            if (!limit_.admit(step, is_front, source_, options_.margin, history_)) continue;
        }
        path_.resize(step.depth);
        place_on_path_[index(step.cell)] = step.depth;
        path_.push_back(step.cell);
        path_begin_.resize(step.depth);
        path_begin_.push_back(step.is_widened ? step.depth : step.depth > 0 ? path_begin_.back() : 0);
        step.number = step_count_++;
        if (step.depth == 0) step.parent = step.number;
        current_ = std::move(step);
        is_pruned_ = false;
        return &current_;
    }
    return nullptr;
}

PlanPoint BeamWalker::corner(std::uint32_t section) const {
    // Whole numbers: positions are multiples of the unit.
    return {static_cast<std::int64_t>(units(view_.section_x[section])),
            static_cast<std::int64_t>(units(view_.section_y[section]))};
}

bool BeamWalker::is_on_path(CellId cell) const {
    const std::uint32_t place = place_on_path_[index(cell)];
    if (place >= path_.size() || path_[place] != cell) return false;
    return place == 0 || place >= path_begin_.back();
}

/// A line enters no convex cell twice; if rounding to the grid has bent the cell by a unit and it does, then what it
/// sees beyond is also seen by the beam that went on the first time, which met fewer gates. A widened beam has rays
/// that came another way than its path: they may enter any cell of it but the source's.
bool BeamWalker::is_open(const BeamStep& step, PortalId portal, Target target) const {
    if (!target.is_portal() || portal == step.portal || step.depth >= options_.max_depth) return false;
    if (target.is_glass() && !options_.through_glass) return false;
    if (!options_.closed.empty() && options_.closed[index(portal)] != 0) return false;
    return !is_on_path(target.neighbour());
}

void BeamWalker::enter(const BeamStep& from, PortalId portal, Target target, const Beam& beam, bool is_level) {
    BeamStep step;
    step.cell = target.neighbour();
    step.from = from.cell;
    step.portal = portal;
    step.is_level = is_level;
    step.depth = from.depth + 1;
    step.parent = from.number;
    step.beam = beam;
    pending_.push_back({step, 0});
}

void BeamWalker::expand(const BeamStep& step) {
    const Cell& cell = view_.cells[index(step.cell)];
    const std::size_t first = pending_.size();
    corners_.clear();
    for (std::uint32_t i = 0; i < cell.section_count; ++i) corners_.push_back(corner(cell.first_section + i));
    for (std::uint32_t i = 0; i < cell.section_count; ++i) expand_side(step, cell, i);
    const CellPortals& portals = view_.cell_portals[index(step.cell)];
    expand_level(step, Level::Floor, cell.floor, portals.floor, units(cell.z_floor));
    expand_level(step, Level::Ceiling, cell.ceiling, portals.ceiling, units(cell.z_ceiling));
    for (std::size_t k = first; k < pending_.size(); ++k) pending_[k].history_size = history_.size();
    std::reverse(pending_.begin() + static_cast<std::ptrdiff_t>(first), pending_.end());
}

void BeamWalker::expand_side(const BeamStep& step, const Cell& cell, std::uint32_t i) {
    const std::uint32_t section = cell.first_section + i;
    const auto margin = double(options_.margin);
    const Gate gate = {corners_[i + 1 == cell.section_count ? 0 : i + 1], corners_[i]};
    std::optional<PlanBeam> plan;
    RealSegment lit;
    Ways ways;
    double bottom = units(cell.z_floor);
    for (std::uint32_t f = view_.section_tails[section].first_face; f < view_.section_tails[section + 1].first_face;
         ++f) {
        const SideFace& face = view_.side_faces[f];
        const PortalId portal = view_.side_face_portals[f];
        const double low = std::exchange(bottom, units(face.z_top));
        if (!is_open(step, portal, face.target)) continue;
        if (!plan) {
            // The same for all faces of the section: once, and only where there is a portal.
            plan = cross(source_, step.beam.plan, gate, options_.margin, history_);
            if (!plan) return;
            lit = lit_part(step.beam.plan, gate, options_.margin);
            ways.from_source = distances(source_, lit, options_.margin);
            ways.from_reference =
                step.beam.has_gate ? distances(step.beam.lit, lit, options_.margin) : ways.from_source;
        }
        if (options_.any_height) {
            enter(step, portal, face.target, {*plan, any_heights, true, gate, {-far, far}, lit}, false);
            continue;
        }
        const Interval opening = {low - margin, bottom + margin};
        const std::optional<HeightBeam> height = through_side(step.beam.height, source_z_, ways, opening);
        if (height) enter(step, portal, face.target, {*plan, *height, true, gate, opening, lit}, false);
    }
}

void BeamWalker::expand_level(const BeamStep& step, Level level, Target target, PortalId portal, double z) {
    if (!is_open(step, portal, target)) return;
    if (options_.any_height) return enter(step, portal, target, step.beam, true);
    const double from_source = farthest(source_, corners_);
    const double from_reference = step.beam.has_gate ? farthest(step.beam.lit, corners_) : from_source;
    const auto margin = double(options_.margin);
    const std::optional<HeightBeam> height = through_level(
        step.beam.height, source_z_, {{0, from_source}, {0, from_reference}}, level, {z - margin, z + margin});
    if (!height) return;
    Beam beam = step.beam;
    beam.height = *height;
    enter(step, portal, target, beam, true);
}

std::vector<CellId> reachable_cells(const SceneView& view, std::span<const BeamSource> sources,
                                    const BeamOptions& options) {
    std::vector<char> is_reached(view.cells.size(), 0);
    std::vector<CellId> cells;
    BeamWalker walker(view, options);
    for (const BeamSource& source : sources) {
        walker.start(source);
        while (const BeamStep* step = walker.next())
            if (std::exchange(is_reached[index(step->cell)], char{1}) == 0) cells.push_back(step->cell);
    }
    std::sort(cells.begin(), cells.end());
    return cells;
}

std::vector<CellId> reachable_cells(const SceneView& view, const BeamSource& source, const BeamOptions& options) {
    return reachable_cells(view, std::span<const BeamSource>(&source, 1), options);
}

}  // namespace enfilade::accel
