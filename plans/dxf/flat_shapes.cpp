#include "plans/dxf/flat_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plans/dxf/curves.h"

namespace enfilade::plans::dxf {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;

double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }

/// Whether circles stay circles where the unit vectors become u and v: far below the chord error.
bool similar(Point u, Point v) {
    const double uu = dot(u, u);
    const double vv = dot(v, v);
    return std::abs(uu - vv) <= 1e-6 * std::max(uu, vv) && std::abs(dot(u, v)) <= 1e-6 * std::max(uu, vv) && uu > 0;
}

/// From start on counter-clockwise to end, in (0, 2 pi].
double turn(double start, double end) {
    const double sweep = std::fmod(end - start, full_turn);
    const double positive = sweep < 0 ? sweep + full_turn : sweep;
    return positive > 1e-12 ? positive : full_turn;
}

}  // namespace

FlatShapes::FlatShapes(Drawing& drawing, const Contents& contents) : drawing_(drawing), contents_(contents) {
    const auto zero = contents.layer_index.find("0");
    if (zero != contents.layer_index.end()) zero_layer_ = zero->second;
}

std::uint32_t FlatShapes::layer_of(const Entity& entity, const Placement& placement) const {
    return entity.layer == zero_layer_ && placement.layer != UINT32_MAX ? placement.layer : entity.layer;
}

bool FlatShapes::within_bounds(Point p) const {
    return std::abs(p.x) <= largest_number && std::abs(p.y) <= largest_number;
}

void FlatShapes::add(const Entity& entity, const Placement& placement) {
    is_raised_ = false;
    const Transform plane = placement.map * entity_frame(entity.normal);
    if (const auto* words = std::get_if<TextEntity>(&entity.shape))
        return text(*words, entity, placement, words->in_space ? placement.map : plane);
    if (const auto* measure = std::get_if<DimensionEntity>(&entity.shape))
        return dimension(*measure, entity, placement);
    if (const auto* straight = std::get_if<LineEntity>(&entity.shape)) {
        begin(ShapeKind::Line, entity, placement);
        line(*straight, placement.map);
    } else if (const auto* many = std::get_if<PathEntity>(&entity.shape)) {
        begin(ShapeKind::Polyline, entity, placement);
        path(*many, many->in_space ? placement.map : plane);
    } else if (const auto* arc = std::get_if<ArcEntity>(&entity.shape)) {
        begin(ShapeKind::Arc, entity, placement);
        const double r = std::abs(arc->radius);
        for (const P3 end : {P3{r, 0, 0}, P3{0, r, 0}}) seen(plane, arc->centre + end);
        round(seen(plane, arc->centre), flat(plane.x * r), flat(plane.y * r), arc->start,
              arc->full ? full_turn : turn(arc->start, arc->end));
    } else if (const auto* ellipse = std::get_if<EllipseEntity>(&entity.shape)) {
        begin(ShapeKind::Ellipse, entity, placement);
        const double size = length(entity.normal);
        const P3 normal = size > 0 ? entity.normal * (1 / size) : P3{0, 0, 1};
        const P3 minor = dxf::cross(normal, ellipse->major) * ellipse->ratio;
        for (const P3 end : {ellipse->major, minor}) seen(placement.map, ellipse->centre + end);
        round(seen(placement.map, ellipse->centre), flat(placement.map.vector(ellipse->major)),
              flat(placement.map.vector(minor)), ellipse->start, turn(ellipse->start, ellipse->end));
    } else if (const auto* spline = std::get_if<SplineEntity>(&entity.shape)) {
        begin(ShapeKind::Spline, entity, placement);
        for (const P3 p : spline->control) seen(placement.map, p);
        chain(spline_chain(*spline, placement.map));
    } else if (const auto* corners = std::get_if<FaceEntity>(&entity.shape)) {
        begin(ShapeKind::Face, entity, placement);
        face(*corners, corners->in_space ? placement.map : plane);
    }
    end(entity);
}

void FlatShapes::begin(ShapeKind kind, const Entity& entity, const Placement& placement) {
    shape_ = {};
    shape_.kind = kind;
    shape_.layer = layer_of(entity, placement);
    shape_.block = placement.insertion;
    shape_.line = entity.line;
    shape_.visible = !placement.frozen && drawing_.layers[shape_.layer].visible;
    shape_.first_stroke = static_cast<std::uint32_t>(drawing_.strokes.size());
}

void FlatShapes::end(const Entity& entity) {
    const auto first = drawing_.strokes.begin() + shape_.first_stroke;
    const bool bounded = std::all_of(first, drawing_.strokes.end(), [&](const Stroke& s) {
        return within_bounds(s.a) && within_bounds(s.b) && std::abs(s.bulge) <= largest_number;
    });
    if (!bounded || first == drawing_.strokes.end()) {
        drawing_.strokes.resize(shape_.first_stroke);
        broken.add(entity.line);
        return;
    }
    if (is_raised_) raised.add(entity.line);
    shape_.stroke_count = static_cast<std::uint32_t>(drawing_.strokes.size()) - shape_.first_stroke;
    drawing_.shapes.push_back(shape_);
    ++drawing_.layers[shape_.layer].shape_count;
}

void FlatShapes::stroke(Point a, Point b, double bulge) { drawing_.strokes.push_back({a, b, bulge}); }

Point FlatShapes::seen(const Transform& map, P3 p) {
    const P3 q = map.point(p);
    if (!(std::abs(q.z) <= 1e-6)) is_raised_ = true;
    return flat(q);
}

void FlatShapes::chain(const std::vector<Point>& points) {
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
        if (!(points[k] == points[k + 1])) stroke(points[k], points[k + 1], 0);
    if (points.size() > 2 && points.front() == points.back()) shape_.closed = true;
}

void FlatShapes::line(const LineEntity& line, const Transform& map) { stroke(seen(map, line.a), seen(map, line.b), 0); }

/// Arcs whose circles become ellipses are drawn as chains. Vertices that repeat the one before are passed over.
void FlatShapes::path(const PathEntity& path, const Transform& map) {
    const std::size_t n = path.vertices.size();
    const Point u = flat(map.x);
    const Point v = flat(map.y);
    const bool round_stays = similar(u, v);
    const double turned = cross(u, v) < 0 ? -1 : 1;
    for (std::size_t k = 0; k < (path.closed ? n : n - std::min<std::size_t>(n, 1)); ++k) {
        const PathVertex& from = path.vertices[k];
        const PathVertex& to = path.vertices[(k + 1) % n];
        const Point a = seen(map, from.at);
        const Point b = seen(map, to.at);
        if (from.at.x == to.at.x && from.at.y == to.at.y && from.at.z == to.at.z) continue;
        if (from.bulge == 0 || round_stays || !within_bounds(a) || !within_bounds(b)) {
            stroke(a, b, from.bulge * turned);
            continue;
        }
        const Point chord = {to.at.x - from.at.x, to.at.y - from.at.y};
        const double aside = (1 - from.bulge * from.bulge) / (4 * from.bulge);
        const Point centre = {(from.at.x + to.at.x) / 2 - aside * chord.y, (from.at.y + to.at.y) / 2 + aside * chord.x};
        const double r = std::hypot(from.at.x - centre.x, from.at.y - centre.y);
        std::vector<Point> points =
            ellipse_chain(flat(map.point({centre.x, centre.y, from.at.z})), {u.x * r, u.y * r}, {v.x * r, v.y * r},
                          std::atan2(from.at.y - centre.y, from.at.x - centre.x), 4 * std::atan(from.bulge));
        points.front() = a;
        points.back() = b;
        for (std::size_t p = 0; p + 1 < points.size(); ++p) stroke(points[p], points[p + 1], 0);
    }
    shape_.closed = path.closed && n > 1;
}

/// The curve centre + u cos t + v sin t: arcs of a circle of at most half a turn each, or chains.
void FlatShapes::round(Point centre, Point u, Point v, double start, double sweep) {
    const bool full = sweep >= full_turn;
    if (!(dot(u, u) > 0) && !(dot(v, v) > 0)) return;
    if (!similar(u, v)) {
        shape_.kind = ShapeKind::Ellipse;
        if (!within_bounds(centre) || !within_bounds(u) || !within_bounds(v)) return;
        chain(ellipse_chain(centre, u, v, start, sweep));
        shape_.closed = full;
        return;
    }
    shape_.kind = full ? ShapeKind::Circle : ShapeKind::Arc;
    shape_.closed = full;
    const auto at = [&](double t) {
        return Point{centre.x + u.x * std::cos(t) + v.x * std::sin(t),
                     centre.y + u.y * std::cos(t) + v.y * std::sin(t)};
    };
    const double turned = cross(u, v) < 0 ? -1 : 1;
    const Point a = at(start);
    if (sweep <= std::numbers::pi * (1 + 1e-12)) return stroke(a, at(start + sweep), turned * std::tan(sweep / 4));
    const Point middle = at(start + sweep / 2);
    stroke(a, middle, turned * std::tan(sweep / 8));
    stroke(middle, full ? a : at(start + sweep), turned * std::tan(sweep / 8));
}

void FlatShapes::face(const FaceEntity& face, const Transform& map) {
    std::vector<Point> corners;
    for (const std::size_t k : {0, 1, 2, 3}) {
        // The corners of a solid go like a Z.
        const Point p = seen(map, face.corners[face.in_space || k < 2 ? k : 5 - k]);
        if (corners.empty() || !(corners.back() == p)) corners.push_back(p);
    }
    if (corners.size() > 1 && corners.back() == corners.front()) corners.pop_back();
    if (corners.size() < 2) return;
    for (std::size_t k = 0; k < corners.size(); ++k) stroke(corners[k], corners[(k + 1) % corners.size()], 0);
    shape_.closed = true;
}

void FlatShapes::text(const TextEntity& text, const Entity& entity, const Placement& placement, const Transform& map) {
    const Point at = flat(map.point(text.at));
    const Point up = flat(map.y);
    const double height = std::abs(text.height) * std::hypot(up.x, up.y);
    if (!within_bounds(at) || !(height <= largest_number)) return broken.add(entity.line);
    if (text.text.empty()) return;
    const std::uint32_t layer = layer_of(entity, placement);
    drawing_.texts.push_back({text.text, at, height, layer, !placement.frozen && drawing_.layers[layer].visible});
    ++drawing_.layers[layer].text_count;
}

void FlatShapes::dimension(const DimensionEntity& dimension, const Entity& entity, const Placement& placement) {
    const Point a = flat(placement.map.point(dimension.a));
    const Point b = flat(placement.map.point(dimension.b));
    if (!within_bounds(a) || !within_bounds(b)) return broken.add(entity.line);
    const P3 along = entity_frame(entity.normal).vector(dimension.direction);
    const Point direction = flat(placement.map.vector(along));
    const double size = std::hypot(direction.x, direction.y);
    const Point across = {b.x - a.x, b.y - a.y};
    const double measured = size > 0 ? std::abs(dot(across, direction)) / size : std::hypot(across.x, across.y);
    if (!(measured <= 4 * largest_number)) return broken.add(entity.line);
    drawing_.dimensions.push_back({measured, dimension.text, a, b, layer_of(entity, placement), written(dimension)});
}

/// The first text of the block that draws the dimension, unless it is longer than any measure.
std::string FlatShapes::written(const DimensionEntity& dimension) const {
    const auto block = contents_.block_index.find(dimension.picture);
    if (block == contents_.block_index.end()) return {};
    for (const Entity& entity : contents_.blocks[block->second].entities)
        if (const auto* text = std::get_if<TextEntity>(&entity.shape); text != nullptr && !text->text.empty())
            return text->text.size() <= 200 ? text->text : std::string();
    return {};
}

}  // namespace enfilade::plans::dxf
