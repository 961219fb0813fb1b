// Steps, and the arrow that goes up them.

#include <algorithm>
#include <cmath>

#include "plans/vector2.h"
#include "tools/report/plan_symbols.h"

namespace enfilade::tools {
namespace {

using modeler::Label;
using plans::Point;

/// The rectangle around a footprint that lies along its longest side.
struct Footprint {
    Point low, along, across;  ///< a corner, and unit vectors
    double length = 0, width = 0;

    explicit Footprint(const std::vector<Mm>& ring) {
        double longest = 0;
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const Mm a = ring[k], b = ring[(k + 1) % ring.size()];
            const Point side = {double(b.x - a.x), double(b.y - a.y)};
            if (const double d = plans::norm(side); d > longest) longest = d, along = side * (1 / d);
        }
        across = plans::turned_left(along);
        double min_u = INFINITY, max_u = -INFINITY, min_v = INFINITY, max_v = -INFINITY;
        for (const Mm at : ring) {
            const Point p = {double(at.x), double(at.y)};
            min_u = std::min(min_u, plans::dot(p, along)), max_u = std::max(max_u, plans::dot(p, along));
            min_v = std::min(min_v, plans::dot(p, across)), max_v = std::max(max_v, plans::dot(p, across));
        }
        low = along * min_u + across * min_v;
        length = max_u - min_u, width = max_v - min_v;
        if (length >= width) return;
        low = low + across * width;
        std::swap(length, width);
        const Point turned = across * -1;
        across = along;
        along = turned;
    }
    [[nodiscard]] Mm at(double u, double v) const {
        const Point p = low + along * u + across * v;
        return {std::llround(p.x), std::llround(p.y)};
    }
};

/// How much more of a footprint's border is open to the storey near its end (u = 1) than near its start.
double open_end(const PlanView& view, const modeler::SpacePart& part, const Footprint& footprint) {
    const modeler::Building& building = view.building();
    double sum = 0;
    for (const std::uint32_t h : part.outer) {
        const Mm a = view.mm(building.points[building.edges[h / 2].a]);
        const Mm b = view.mm(building.points[building.edges[h / 2].b]);
        const Point middle = {double(a.x + b.x) / 2, double(a.y + b.y) / 2};
        const double u = plans::dot(middle - footprint.low, footprint.along) / footprint.length;
        const std::span<const std::uint32_t> faces = view.side_faces(h / 2);
        const bool open = std::any_of(faces.begin(), faces.end(), [&](std::uint32_t f) {
            const modeler::Volume& front = building.volumes[building.faces[f].front];
            const modeler::Volume& back = building.volumes[building.faces[f].back];
            return front.space != back.space && carries_light(front.label) && carries_light(back.label) &&
                   front.z_low < part.z_high && front.z_high > part.z_low;
        });
        if (open && (u < 0.4 || u > 0.6)) sum += std::hypot(double(b.x - a.x), double(b.y - a.y)) * (u - 0.5);
    }
    return sum;
}

/// The parts of the line across a footprint at `u` that lie inside it: cross lines of an L are shorter.
void add_tread(const std::vector<Mm>& ring, const Footprint& footprint, double u, SvgPath& path) {
    std::vector<double> cuts;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Point a = Point{double(ring[k].x), double(ring[k].y)} - footprint.low;
        const Mm next = ring[(k + 1) % ring.size()];
        const Point b = Point{double(next.x), double(next.y)} - footprint.low;
        const double ua = plans::dot(a, footprint.along), ub = plans::dot(b, footprint.along);
        if ((ua > u) == (ub > u)) continue;
        const double t = (u - ua) / (ub - ua);
        cuts.push_back(plans::dot(a + (b - a) * t, footprint.across));
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t k = 0; k + 1 < cuts.size(); k += 2)
        path.segment(footprint.at(u, cuts[k]), footprint.at(u, cuts[k + 1]));
}

}  // namespace

StairPaths stair_paths(const PlanView& view, std::uint32_t storey) {
    StairPaths paths;
    const modeler::Building& building = view.building();
    const modeler::StoreyInfo& info = building.storeys[storey];
    const std::int32_t top =
        storey + 1 < building.storeys.size() ? building.storeys[storey + 1].z_floor : info.z_ceiling;
    const int steps = std::max(2, int(std::ceil((top - info.z_floor) * building.frame.unit / 0.19)));
    for (const modeler::SpacePart& part : view.parts(storey)) {
        if (view.space(part.space).label != Label::Stair) continue;
        const std::vector<Mm> ring = view.ring(part.outer);
        const Footprint footprint(ring);
        if (footprint.length < 300 || footprint.width < 200) continue;
        // Treads narrower than a foot would be a grey field: as many as are 20 cm apart.
        const int drawn = std::min(steps, std::max(2, int(footprint.length / 200)));
        for (int k = 1; k < drawn; ++k) add_tread(ring, footprint, footprint.length * k / drawn, paths.treads);
        const bool backwards = open_end(view, part, footprint) > 1;
        const auto at = [&](double u, double v) {
            return footprint.at(backwards ? footprint.length - u : u, footprint.width / 2 + v);
        };
        const double margin = footprint.length / drawn / 2, head = std::min(180.0, footprint.width / 5);
        paths.arrows.segment(at(margin, 0), at(footprint.length - margin, 0));
        paths.arrows.move(at(footprint.length - margin - head, -head * 0.6));
        paths.arrows.line(at(footprint.length - margin, 0));
        paths.arrows.line(at(footprint.length - margin - head, head * 0.6));
        paths.arrows.move(at(margin, -head / 2));
        paths.arrows.line(at(margin, head / 2));
    }
    return paths;
}

}  // namespace enfilade::tools
