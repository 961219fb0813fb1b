#include "plans/dxf/wall_masses.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "plans/box_index.h"
#include "plans/dxf/run_parts.h"
#include "plans/dxf/solids.h"
#include "plans/planar_map.h"
#include "plans/vector2.h"

namespace enfilade::plans {
namespace {

constexpr double grid = 0.004;              ///< metres: ends this close are one corner
constexpr std::size_t most_lines = 20'000;  ///< hatches that cross would have millions of corners
constexpr double least_open = 0.06;         ///< m2 that walls leave: less is the drawing's carelessness
constexpr double most_area = 8;
constexpr double into = 0.06;

/// There and back again, as lines that end inside a face make its outline go.
void drop_spikes(std::vector<Point>& ring) {
    for (bool changed = true; changed && ring.size() > 2;) {
        changed = false;
        for (std::size_t k = 0; k < ring.size() && ring.size() > 2; ++k) {
            const std::size_t next = (k + 1) % ring.size(), after = (k + 2) % ring.size();
            if (ring[k] != ring[after]) continue;
            ring.erase(ring.begin() + std::ptrdiff_t(std::max(next, after)));
            ring.erase(ring.begin() + std::ptrdiff_t(std::min(next, after)));
            changed = true;
            break;
        }
    }
}

/// What the lines enclose, with corners where lines meet or cross, the ends of lines as they were drawn.
class Faces {
public:
    explicit Faces(const std::vector<SheetStroke>& strokes) {
        if (strokes.empty()) return;
        origin_ = strokes.front().stroke.a;
        std::vector<Segment> segments;
        for (const SheetStroke& s : strokes) {
            if (s.stroke.bulge != 0 || !on_grid(s.stroke.a) || !on_grid(s.stroke.b)) continue;
            segments.push_back({corner(s.stroke.a), corner(s.stroke.b)});
            heights_.push_back(wall_height(s));
        }
        graph_ = node(segments);
        map_ = planar_map(graph_);
    }

    [[nodiscard]] std::vector<WallMass> list() const {
        std::vector<WallMass> found;
        // Walls around a room are a face with a hole.
        std::vector<double> holes(map_.face_count, 0);
        for (std::size_t l = 0; l < map_.loop_first.size(); ++l)
            if (map_.loop_area2[l] < 0) holes[map_.face_of_loop[l]] -= double(map_.loop_area2[l]) / 2 * grid * grid;
        for (std::size_t l = 0; l < map_.loop_first.size(); ++l) {
            const double area = double(map_.loop_area2[l]) / 2 * grid * grid;
            if (area < least_open || area > most_area || holes[map_.face_of_loop[l]] > least_open) continue;
            WallMass face;
            std::uint32_t h = map_.loop_first[l];
            double low = 0, full = 0;  // metres of outline
            std::optional<double> height;
            do {
                face.polygon.push_back(point(graph_.vertices[origin(graph_, h)]));
                const NodedEdge& edge = graph_.edges[h / 2];
                bool is_full = false;
                for (std::uint32_t u = 0; u < edge.use_count; ++u) {
                    const auto& of_line = heights_[graph_.uses[edge.first_use + u].segment];
                    is_full = is_full || !of_line;
                    height = std::max(height, of_line);
                }
                (is_full ? full : low) += distance(point(graph_.vertices[edge.a]), point(graph_.vertices[edge.b]));
                h = map_.next[h];
            } while (h != map_.loop_first[l]);
            if (low > full) face.height = height;
            drop_spikes(face.polygon);
            if (face.polygon.size() > 2) found.push_back(std::move(face));
        }
        return found;
    }

private:
    [[nodiscard]] bool on_grid(Point p) const {
        return std::abs(p.x - origin_.x) < grid * (1 << 24) && std::abs(p.y - origin_.y) < grid * (1 << 24);
    }
    GridPoint corner(Point p) {
        const GridPoint at{std::int32_t(std::lround((p.x - origin_.x) / grid)),
                           std::int32_t(std::lround((p.y - origin_.y) / grid))};
        drawn_.try_emplace(at, p);
        return at;
    }
    [[nodiscard]] Point point(GridPoint p) const {
        const auto drawn = drawn_.find(p);
        return drawn != drawn_.end() ? drawn->second : origin_ + Point{p.x * grid, p.y * grid};
    }

    Point origin_;
    std::map<GridPoint, Point> drawn_;
    std::vector<std::optional<double>> heights_;  ///< [segments]
    NodedGraph graph_;
    PlanarMap map_;
};

/// Square metres of the inside that are no wall.
double open_inside(const std::vector<Point>& ring, const Solids& in_walls) {
    PlanBox box;
    for (const Point p : ring) box.add(p);
    const auto steps = [](double size) { return std::clamp(int(size / 0.04), 8, 200); };
    const int across = steps(box.max.x - box.min.x), up = steps(box.max.y - box.min.y);
    const double dx = (box.max.x - box.min.x) / across, dy = (box.max.y - box.min.y) / up;
    int open = 0;
    for (int x = 0; x < across; ++x)
        for (int y = 0; y < up; ++y) {
            const Point p{box.min.x + dx * (x + 0.5), box.min.y + dy * (y + 0.5)};
            open += holds(ring, p) && !in_walls(p);
        }
    return open * dx * dy;
}

/// Share of the outline with a wall on its outer side.
double walled_outside(const std::vector<Point>& ring, const Solids& in_walls) {
    double walled = 0, length = 0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Point a = ring[k], b = ring[(k + 1) % ring.size()];
        const double side = distance(a, b);
        const Point out = turned_left(b - a) * (-0.02 / side);
        for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9}) walled += in_walls(a + (b - a) * share + out) * side / 5;
        length += side;
    }
    return walled / length;
}

}  // namespace

std::vector<WallMass> wall_masses(const std::vector<SheetStroke>& strokes, const std::vector<WallRun>& runs) {
    std::vector<SheetStroke> walls = strokes;
    std::erase_if(walls, [](const SheetStroke& s) { return s.role != Role::Wall && s.role != Role::LowWall; });
    std::vector<WallMass> masses;
    if (walls.size() > most_lines) return masses;
    const Solids in_walls(runs);
    for (WallMass& face : Faces(walls).list()) {
        if (open_inside(face.polygon, in_walls) < least_open || walled_outside(face.polygon, in_walls) > 0.3) continue;
        masses.push_back(std::move(face));
    }
    return masses;
}

void lead_into_masses(std::vector<WallRun>& runs, const std::vector<WallMass>& masses, double reach) {
    std::vector<PlanBox> boxes(masses.size());
    for (std::size_t m = 0; m < masses.size(); ++m) {
        for (const Point p : masses[m].polygon) boxes[m].add(p);
        boxes[m] = boxes[m].grown(reach + into);
    }
    const BoxIndex index(boxes);
    for (WallRun& run : runs)
        for (const bool at_end : {false, true}) {
            const double length = distance(run.start, run.end);
            if (length < 1e-6) continue;
            const Point end = at_end ? run.end : run.start;
            const Point ahead = (at_end ? run.end - run.start : run.start - run.end) * (1 / length);
            std::optional<double> step;
            index.near(end, [&](std::uint32_t m) {
                if (step || holds(masses[m].polygon, end - ahead * 0.01)) return;
                for (double s = 0.01; s <= reach && !step; s += 0.02)
                    if (holds(masses[m].polygon, end + ahead * s)) step = s + into;
            });
            if (step) move_end(run, at_end, *step);
        }
}

}  // namespace enfilade::plans
