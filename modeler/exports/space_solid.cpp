#include "modeler/exports/space_solid.h"

#include <algorithm>
#include <map>
#include <unordered_map>

#include "base/disjoint_sets.h"
#include "modeler/exports/level_faces.h"
#include "modeler/exports/part_sides.h"
#include "modeler/exports/ring_trace.h"
#include "modeler/outline.h"

namespace enfilade::modeler {

namespace {

using Node = std::array<std::int64_t, 2>;

/// What a face is open to: space and part.
using Open = std::pair<std::uint32_t, std::uint32_t>;

/// A piece of a side: what stands over one strip between two levels.
struct SideTile {
    std::uint32_t column = 0;  ///< the strip, in its straight side
    std::int32_t z_low = 0;
    std::int32_t z_high = 0;
    Open behind;
    std::uint32_t material = 0;
};

class Builder {
public:
    explicit Builder(const Building& building) : building_(building), sides_(building), levels_(building) {}

    SpaceSolids run(const std::vector<Label>& labels) {
        result_.parts = space_parts(building_);
        part_of_.assign(building_.volumes.size(), SolidFace::no_part);
        for (std::uint32_t p = 0; p < result_.parts.size(); ++p)
            for (const std::uint32_t v : result_.parts[p].volumes) part_of_[v] = p;
        for (std::uint32_t p = 0; p < result_.parts.size(); ++p) {
            const Label label = building_.spaces[result_.parts[p].space].label;
            if (std::find(labels.begin(), labels.end(), label) != labels.end()) add(p);
        }
        renumber();
        return std::move(result_);
    }

private:
    /// What a volume is to a face that it lies behind: nothing where it belongs to the building's body, else its space
    /// (light or earth) and, indoors, its part.
    Open open(std::uint32_t volume) const {
        const Volume& v = building_.volumes[volume];
        if (v.label == Label::Exterior || v.label == Label::Ground) return {v.space, SolidFace::no_part};
        if (accel::carries_light(v.label)) return {v.space, part_of_[volume]};
        return {SolidFace::solid, SolidFace::no_part};
    }

    void add(std::uint32_t p) {
        const SpacePart& part = result_.parts[p];
        SpaceSolid solid{p, {}};
        add_level(part, SolidFaceKind::Floor, solid);
        add_level(part, SolidFaceKind::Ceiling, solid);
        for (const RingSides& ring : sides_.of(part)) add_ring(ring, solid);
        drop_straight_points(solid);
        result_.solids.push_back(std::move(solid));
    }

    std::uint32_t vertex(std::uint32_t point, std::int32_t z) {
        const auto [at, is_new] = vertex_ids_.try_emplace(std::uint64_t(point) << 32 | std::uint32_t(z),
                                                          std::uint32_t(result_.vertices.size()));
        if (is_new) result_.vertices.push_back({building_.points[point].x, building_.points[point].y, z});
        return at->second;
    }

    void add_level(const SpacePart& part, SolidFaceKind kind, SpaceSolid& solid) {
        const bool is_floor = kind == SolidFaceKind::Floor;
        const std::int32_t z = is_floor ? part.z_low : part.z_high;
        struct Group {
            std::uint32_t material = 0;
            std::vector<std::uint32_t> faces;
        };
        std::map<Open, Group> groups;
        for (const std::uint32_t v : part.volumes)
            for (const LevelFace& face : is_floor ? levels_.floors(v) : levels_.ceilings(v)) {
                Group& group = groups[open(face.behind)];
                if (group.faces.empty()) group.material = building_.volumes[face.behind].space;
                group.faces.push_back(face.face);
            }
        for (const auto& [behind, group] : groups)
            for (const RegionRings& rings : levels_.outlines(group.faces))
                add_level_face(rings, kind, z, behind, group.material, solid);
    }

    void add_level_face(const RegionRings& rings, SolidFaceKind kind, std::int32_t z, const Open& behind,
                        std::uint32_t material, SpaceSolid& solid) {
        const auto lift = [&](const std::vector<std::uint32_t>& ring) {
            std::vector<std::uint32_t> up;
            for (const std::uint32_t point : ring) up.push_back(vertex(point, z));
            if (kind == SolidFaceKind::Floor) std::reverse(up.begin(), up.end());
            return up;
        };
        SolidFace face{kind, behind.first, behind.second, material, lift(rings.outer), {}};
        for (const auto& hole : rings.holes) face.holes.push_back(lift(hole));
        solid.faces.push_back(std::move(face));
    }

    void add_ring(const RingSides& ring, SpaceSolid& solid) {
        const std::size_t n = ring.sides.size();
        for (std::size_t s = 0; s < n; ++s) {
            // Points over the ends of a side carry the levels of the sides next to it, too.
            const SideStrip& before = ring.sides[(s + n - 1) % n].strips.back();
            const SideStrip& after = ring.sides[(s + 1) % n].strips.front();
            add_side(ring.sides[s].strips, before, after, solid);
        }
    }

    static void add_levels(const SideStrip& strip, std::vector<std::int32_t>& levels) {
        for (const SideInterval& interval : strip.intervals) {
            levels.push_back(interval.z_low);
            levels.push_back(interval.z_high);
        }
    }

    void add_side(const std::vector<SideStrip>& strips, const SideStrip& before, const SideStrip& after,
                  SpaceSolid& solid) {
        const std::size_t columns = strips.size();
        std::vector<std::vector<std::int32_t>> levels(columns + 1);  // over each point, ascending
        for (std::size_t c = 0; c <= columns; ++c) {
            add_levels(c == 0 ? before : strips[c - 1], levels[c]);
            add_levels(c == columns ? after : strips[c], levels[c]);
            std::sort(levels[c].begin(), levels[c].end());
            levels[c].erase(std::unique(levels[c].begin(), levels[c].end()), levels[c].end());
        }
        std::vector<Node> nodes;  // column, level
        std::vector<std::uint32_t> first_node;
        for (std::size_t c = 0; c <= columns; ++c) {
            first_node.push_back(std::uint32_t(nodes.size()));
            for (const std::int32_t z : levels[c]) nodes.push_back({std::int64_t(c), z});
        }
        const std::vector<SideTile> tiles = tiles_of(strips);
        DisjointSets components(tiles.size());
        join_tiles(tiles, components);
        std::map<std::uint32_t, std::vector<BorderSegment>> borders;
        for (std::uint32_t t = 0; t < tiles.size(); ++t) {
            const SideTile& tile = tiles[t];
            const auto node = [&](std::size_t column, std::int32_t z) {
                const auto at = std::lower_bound(levels[column].begin(), levels[column].end(), z);
                return first_node[column] + std::uint32_t(at - levels[column].begin());
            };
            const std::uint32_t left_low = node(tile.column, tile.z_low), left_high = node(tile.column, tile.z_high);
            const std::uint32_t right_low = node(tile.column + 1, tile.z_low),
                                right_high = node(tile.column + 1, tile.z_high);
            std::vector<BorderSegment>& border = borders[components.find(t)];
            border.push_back({left_low, right_low});
            for (std::uint32_t k = right_low; k < right_high; ++k) border.push_back({k, k + 1});
            border.push_back({right_high, left_high});
            for (std::uint32_t k = left_high; k > left_low; --k) border.push_back({k, k - 1});
        }
        const auto lift = [&](const std::vector<std::uint32_t>& ring) {
            std::vector<std::uint32_t> up;
            for (const std::uint32_t k : ring) {
                const auto column = std::size_t(nodes[k][0]);
                const std::uint32_t point = column < columns ? start_of(building_, strips[column].half_edge)
                                                             : start_of(building_, strips.back().half_edge ^ 1);
                up.push_back(vertex(point, std::int32_t(nodes[k][1])));
            }
            return up;
        };
        for (auto& [root, border] : borders) {
            const RegionRings rings = trace_rings(std::move(border), nodes);
            const SideTile& tile = tiles[root];
            SolidFace face{SolidFaceKind::Side, tile.behind.first, tile.behind.second,
                           tile.material,       lift(rings.outer), {}};
            for (const auto& hole : rings.holes) face.holes.push_back(lift(hole));
            solid.faces.push_back(std::move(face));
        }
    }

    std::vector<SideTile> tiles_of(const std::vector<SideStrip>& strips) const {
        std::vector<SideTile> tiles;
        for (std::uint32_t c = 0; c < strips.size(); ++c)
            for (const SideInterval& interval : strips[c].intervals) {
                const Open behind = open(interval.behind);
                const bool goes_on = !tiles.empty() && tiles.back().column == c && tiles.back().behind == behind;
                if (goes_on) tiles.back().z_high = interval.z_high;
                else
                    tiles.push_back(
                        {c, interval.z_low, interval.z_high, behind, building_.volumes[interval.behind].space});
            }
        return tiles;
    }

    /// Tiles side by side with the same behind them hang together; those above each other never have the same.
    static void join_tiles(const std::vector<SideTile>& tiles, DisjointSets& components) {
        std::uint32_t left = 0;
        for (std::uint32_t right = 0; right < tiles.size(); ++right) {
            if (tiles[right].column == 0) continue;
            while (tiles[left].column + 1 < tiles[right].column) ++left;
            for (std::uint32_t t = left; t < tiles.size() && tiles[t].column + 1 == tiles[right].column; ++t)
                if (tiles[t].behind == tiles[right].behind && tiles[t].z_low < tiles[right].z_high &&
                    tiles[right].z_low < tiles[t].z_high)
                    components.join(t, right);
        }
    }

    /// Takes out the points that two edges share which go exactly straight on: no other edge of the solid ends there.
    void drop_straight_points(SpaceSolid& solid) const {
        std::unordered_map<std::uint32_t, std::array<std::uint32_t, 2>> neighbours;
        std::unordered_map<std::uint32_t, bool> keep;
        const auto see = [&](std::uint32_t at, std::uint32_t next) {
            auto [found, is_new] = neighbours.try_emplace(at, std::array{next, next});
            if (is_new || found->second[0] == next || found->second[1] == next) return;
            if (found->second[0] == found->second[1]) found->second[1] = next;
            else keep[at] = true;
        };
        for_each_ring(solid, [&](const std::vector<std::uint32_t>& ring) {
            for (std::size_t k = 0; k < ring.size(); ++k) {
                see(ring[k], ring[(k + 1) % ring.size()]);
                see(ring[(k + 1) % ring.size()], ring[k]);
            }
        });
        const auto is_straight = [&](std::uint32_t at) {
            if (keep.contains(at)) return false;
            const auto [p, q] = neighbours.at(at);
            const auto& a = result_.vertices[p];
            const auto& b = result_.vertices[at];
            const auto& c = result_.vertices[q];
            if (a[2] != b[2] || b[2] != c[2]) return a[0] == b[0] && b[0] == c[0] && a[1] == b[1] && b[1] == c[1];
            return plans::orientation({a[0], a[1]}, {b[0], b[1]}, {c[0], c[1]}) == 0;
        };
        for_each_ring(solid, [&](std::vector<std::uint32_t>& ring) { std::erase_if(ring, is_straight); });
    }

    /// Keeps the vertices that some ring still visits.
    void renumber() {
        std::vector<std::uint32_t> number(result_.vertices.size(), UINT32_MAX);
        std::vector<std::array<std::int32_t, 3>> kept;
        for (SpaceSolid& solid : result_.solids)
            for_each_ring(solid, [&](std::vector<std::uint32_t>& ring) {
                for (std::uint32_t& vertex : ring) {
                    if (number[vertex] == UINT32_MAX) {
                        number[vertex] = std::uint32_t(kept.size());
                        kept.push_back(result_.vertices[vertex]);
                    }
                    vertex = number[vertex];
                }
            });
        result_.vertices = std::move(kept);
    }

    template <class Visit>
    static void for_each_ring(SpaceSolid& solid, Visit visit) {
        for (SolidFace& face : solid.faces) {
            visit(face.outer);
            for (auto& hole : face.holes) visit(hole);
        }
    }

    const Building& building_;
    PartSides sides_;
    LevelFaces levels_;
    std::vector<std::uint32_t> part_of_;  ///< [volume]
    std::unordered_map<std::uint64_t, std::uint32_t> vertex_ids_;
    SpaceSolids result_;
};

}  // namespace

SpaceSolids space_solids(const Building& building, const std::vector<Label>& labels) {
    return Builder(building).run(labels);
}

}  // namespace enfilade::modeler
