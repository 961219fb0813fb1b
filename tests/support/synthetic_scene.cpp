#include "tests/support/synthetic_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>

namespace enfilade::test {
namespace {

using accel::InputTarget;
using accel::Label;
using accel::PortalKind;
using accel::Surface;
using Point = std::pair<std::int32_t, std::int32_t>;
using Edge = std::pair<Point, Point>;

class SceneBuilder {
public:
    SceneBuilder(const std::vector<Plot>& plots, double turn) : plots_(plots), turn_(turn) {}

    accel::SceneInput build() {
        find_rings();
        number_cells();
        for (std::uint32_t p = 0; p < plots_.size(); ++p)
            for (std::uint32_t l = 0; l < plots_[p].layers.size(); ++l) add_cell(p, l);
        add_level_faces();
        add_tables();
        return std::move(scene_);
    }

private:
    [[nodiscard]] Point turned(Point p) const {
        if (turn_ == 0) return p;
        const double c = std::cos(turn_), s = std::sin(turn_);
        return {static_cast<std::int32_t>(std::lround(c * p.first - s * p.second)),
                static_cast<std::int32_t>(std::lround(s * p.first + c * p.second))};
    }

    /// Each plot's ring with the corners of the others that lie on its sides.
    void find_rings() {
        std::map<std::int32_t, std::set<std::int32_t>> on_x, on_y;
        for (const Plot& plot : plots_)
            for (const Point& corner :
                 {Point{plot.x0, plot.y0}, {plot.x1, plot.y0}, {plot.x1, plot.y1}, {plot.x0, plot.y1}}) {
                on_x[corner.first].insert(corner.second);
                on_y[corner.second].insert(corner.first);
            }
        for (std::uint32_t p = 0; p < plots_.size(); ++p) {
            const Plot& plot = plots_[p];
            std::vector<Point> ring;
            const auto between = [](const std::set<std::int32_t>& all, std::int32_t low, std::int32_t high) {
                return std::vector<std::int32_t>(all.lower_bound(low), all.upper_bound(high));
            };
            const auto south = between(on_y[plot.y0], plot.x0, plot.x1);
            const auto east = between(on_x[plot.x1], plot.y0, plot.y1);
            const auto north = between(on_y[plot.y1], plot.x0, plot.x1);
            const auto west = between(on_x[plot.x0], plot.y0, plot.y1);
            for (std::size_t i = 0; i + 1 < south.size(); ++i) ring.push_back(turned({south[i], plot.y0}));
            for (std::size_t i = 0; i + 1 < east.size(); ++i) ring.push_back(turned({plot.x1, east[i]}));
            for (std::size_t i = north.size() - 1; i > 0; --i) ring.push_back(turned({north[i], plot.y1}));
            for (std::size_t i = west.size() - 1; i > 0; --i) ring.push_back(turned({plot.x0, west[i]}));
            for (std::size_t i = 0; i < ring.size(); ++i) plot_of_edge_[{ring[i], ring[(i + 1) % ring.size()]}] = p;
            rings_.push_back(std::move(ring));
        }
    }

    void number_cells() {
        std::uint32_t next = 0;
        for (const Plot& plot : plots_) {
            first_cell_.push_back(next);
            next += static_cast<std::uint32_t>(plot.layers.size());
        }
    }

    InputTarget portal_between(std::uint32_t a, std::uint32_t b, const Layer& la, const Layer& lb, std::int64_t where) {
        const auto key = std::tuple(std::min(a, b), std::max(a, b), where);
        const auto [found, is_new] = portals_.try_emplace(key, static_cast<std::uint32_t>(scene_.portals.size()));
        if (is_new) {
            accel::InputPortal portal{std::min(a, b), std::max(a, b), PortalKind::Clear, {1, 1, 1}};
            const auto is = [&](Label x, Label y) {
                return (la.label == x && lb.label == y) || (la.label == y && lb.label == x);
            };
            if (la.space == lb.space) portal.kind = PortalKind::Virtual;
            if (is(Label::Window, Label::Exterior)) {
                portal.kind = PortalKind::Glass;
                portal.tint = {0.75f, 0.875f, 0.8125f};
            }
            scene_.portals.push_back(portal);
        }
        return {true, found->second};
    }

    InputTarget solid(Surface surface, std::uint32_t space, const std::vector<std::array<std::int32_t, 3>>& ring) {
        scene_.source_faces.push_back(
            {surface, space, static_cast<std::uint32_t>(surface), static_cast<std::uint32_t>(scene_.vertices.size())});
        scene_.vertices.insert(scene_.vertices.end(), ring.begin(), ring.end());
        return {false, static_cast<std::uint32_t>(scene_.source_faces.size() - 1)};
    }

    static Surface side_surface(Label label, bool at_border) {
        if (label == Label::Exterior) return at_border ? Surface::Sky : Surface::Facade;
        return label == Label::Room || label == Label::Stair ? Surface::WallPaper : Surface::Jamb;
    }

    void add_cell(std::uint32_t p, std::uint32_t l) {
        const Layer& layer = plots_[p].layers[l];
        const std::vector<Layer>& stack = plots_[p].layers;
        const std::uint32_t cell = first_cell_[p] + l;
        accel::InputCell out{layer.label,
                             layer.space,
                             cell,
                             layer.z_floor,
                             layer.z_ceiling,
                             static_cast<std::uint32_t>(scene_.sections.size()),
                             {},
                             {}};
        if (l > 0 && stack[l - 1].z_ceiling == layer.z_floor)
            out.floor = portal_between(cell, cell - 1, layer, stack[l - 1], -1);
        else levels_[{layer.space, layer.z_floor, true}].push_back(cell);
        if (l + 1 < stack.size() && stack[l + 1].z_floor == layer.z_ceiling)
            out.ceiling = portal_between(cell, cell + 1, layer, stack[l + 1], -1);
        else levels_[{layer.space, layer.z_ceiling, false}].push_back(cell);
        scene_.cells.push_back(out);
        plot_of_cell_.push_back(p);
        const std::vector<Point>& ring = rings_[p];
        for (std::size_t i = 0; i < ring.size(); ++i) add_section(cell, layer, {ring[i], ring[(i + 1) % ring.size()]});
    }

    void add_section(std::uint32_t cell, const Layer& layer, const Edge& edge) {
        scene_.sections.push_back(
            {edge.first.first, edge.first.second, static_cast<std::uint32_t>(scene_.side_faces.size())});
        const auto neighbour = plot_of_edge_.find({edge.second, edge.first});
        std::set<std::int32_t> levels = {layer.z_floor, layer.z_ceiling};
        if (neighbour != plot_of_edge_.end())
            for (const Layer& other : plots_[neighbour->second].layers)
                for (const std::int32_t z : {other.z_floor, other.z_ceiling})
                    if (z > layer.z_floor && z < layer.z_ceiling) levels.insert(z);
        for (auto z = levels.begin(); std::next(z) != levels.end(); ++z) {
            const std::int32_t low = *z, high = *std::next(z);
            InputTarget target;
            std::optional<std::uint32_t> behind;
            if (neighbour != plot_of_edge_.end())
                for (std::uint32_t k = 0; k < plots_[neighbour->second].layers.size(); ++k) {
                    const Layer& other = plots_[neighbour->second].layers[k];
                    if (other.z_floor <= low && high <= other.z_ceiling) behind = k;
                }
            if (behind) {
                const std::uint32_t other = first_cell_[neighbour->second] + *behind;
                const Edge key = std::min(edge, Edge{edge.second, edge.first});
                const std::int64_t where =
                    edge_number_.try_emplace({key, low}, std::int64_t(edge_number_.size())).first->second;
                target = portal_between(cell, other, layer, plots_[neighbour->second].layers[*behind], where);
            } else {
                const auto [a, b] = edge;
                target = solid(side_surface(layer.label, neighbour == plot_of_edge_.end()), layer.space,
                               {{b.first, b.second, low},
                                {a.first, a.second, low},
                                {a.first, a.second, high},
                                {b.first, b.second, high}});
            }
            scene_.side_faces.push_back({high, target});
        }
    }

    /// The border of these cells' floor polygons, if it is one ring that visits no corner twice.
    std::optional<std::vector<Point>> border(const std::vector<std::uint32_t>& cells) const {
        std::set<Edge> edges;
        for (const std::uint32_t cell : cells) {
            const std::vector<Point>& ring = rings_[plot_of_cell_[cell]];
            for (std::size_t i = 0; i < ring.size(); ++i) edges.insert({ring[i], ring[(i + 1) % ring.size()]});
        }
        std::map<Point, Point> next;
        for (const Edge& edge : edges)
            if (!edges.contains({edge.second, edge.first}) && !next.emplace(edge).second) return std::nullopt;
        std::vector<Point> ring = {next.begin()->first};
        while (next.at(ring.back()) != ring.front()) ring.push_back(next.at(ring.back()));
        if (ring.size() != next.size()) return std::nullopt;
        return ring;
    }

    void add_level_faces() {
        for (const auto& [key, cells] : levels_) {
            const auto [space, z, is_floor] = key;
            const auto face = [&, z = z, space = space, is_floor = is_floor](std::vector<Point> ring, Label label) {
                if (!is_floor) std::ranges::reverse(ring);
                std::vector<std::array<std::int32_t, 3>> ring3;
                for (const Point& p : ring) ring3.push_back({p.first, p.second, z});
                Surface surface = is_floor ? Surface::Floor : Surface::Ceiling;
                if (label == Label::Exterior)
                    surface = !is_floor ? Surface::Sky : z < 0 ? Surface::Terrain : Surface::Roof;
                return solid(surface, space, ring3);
            };
            const Label label = scene_.cells[cells.front()].label;
            const std::optional<std::vector<Point>> whole = border(cells);
            const InputTarget shared = whole ? face(*whole, label) : InputTarget{};
            for (const std::uint32_t cell : cells) {
                const InputTarget target = whole ? shared : face(rings_[plot_of_cell_[cell]], label);
                (is_floor ? scene_.cells[cell].floor : scene_.cells[cell].ceiling) = target;
            }
        }
    }

    void add_tables() {
        for (int s = 0; s < accel::surface_count; ++s) {
            const float shade = 0.5f + 0.04f * static_cast<float>(s);
            scene_.materials.push_back({"material " + std::to_string(s), {shade, 0.9f * shade, 0.8f}});
        }
        std::uint32_t space_count = 0;
        for (const accel::InputCell& cell : scene_.cells) space_count = std::max(space_count, cell.space + 1);
        scene_.spaces.resize(space_count);
        for (std::uint32_t i = 0; i < space_count; ++i) scene_.spaces[i].id = "space-" + std::to_string(i);
        for (const accel::InputCell& cell : scene_.cells) {
            accel::InputSpace& space = scene_.spaces[cell.space];
            space.label = cell.label;
            space.name = std::string(accel::name_of(cell.label)) + " " + std::to_string(cell.space);
            space.storey = "ground";
            space.storey_index = 0;
        }
    }

    const std::vector<Plot>& plots_;
    double turn_;
    std::vector<std::vector<Point>> rings_;
    std::vector<std::uint32_t> first_cell_;
    std::vector<std::uint32_t> plot_of_cell_;
    std::map<Edge, std::uint32_t> plot_of_edge_;
    std::map<std::pair<Edge, std::int32_t>, std::int64_t> edge_number_;
    std::map<std::tuple<std::uint32_t, std::uint32_t, std::int64_t>, std::uint32_t> portals_;
    std::map<std::tuple<std::uint32_t, std::int32_t, bool>, std::vector<std::uint32_t>> levels_;
    accel::SceneInput scene_;
};

}  // namespace

accel::SceneInput scene_from_plots(const std::vector<Plot>& plots, double turn) {
    return SceneBuilder(plots, turn).build();
}

}  // namespace enfilade::test
