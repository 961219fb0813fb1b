#include "modeler/exports/energy_model.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "modeler/exports/plan_faces.h"

namespace enfilade::modeler {

namespace {

constexpr double least = 0.001;         ///< metres: narrower faces are rounding's
constexpr double least_area = 1e-4;     ///< square metres
constexpr double least_cosine = 0.985;  ///< of sides that face each other: ten degrees
constexpr double most_thickness = 1.5;  ///< metres of wall between a pair
constexpr std::uint32_t no_index = UINT32_MAX;

struct Rectangle {
    double u_low, u_high, z_low, z_high;
    [[nodiscard]] bool is_something() const { return u_high - u_low >= least && z_high - z_low >= least; }
};

Rectangle of(const WallTile& tile) { return {tile.u_low, tile.u_high, tile.z_low, tile.z_high}; }

class Builder {
public:
    explicit Builder(const Building& building)
        : building_(building), parts_(space_parts(building)), views_(wall_views(building, parts_, most_thickness)) {
        room_of_.assign(parts_.size(), no_index);
        for (std::uint32_t p = 0; p < parts_.size(); ++p) {
            if (!is_room(building, parts_[p])) continue;
            room_of_[p] = std::uint32_t(model_.rooms.size());
            model_.rooms.push_back({parts_[p].space, false, {}});
        }
    }

    EnergyModel run() {
        add_levels();
        add_walls();
        for (EnergyRoom& room : model_.rooms)
            room.has_floor = std::any_of(room.faces.begin(), room.faces.end(), [](const EnergyFace& face) {
                return face.kind == EnergyFaceKind::Floor && !face.is_air;
            });
        return std::move(model_);
    }

private:
    std::uint32_t add(std::uint32_t part, EnergyFace face) {
        std::vector<EnergyFace>& faces = model_.rooms[room_of_[part]].faces;
        faces.push_back(std::move(face));
        return std::uint32_t(faces.size() - 1);
    }
    void pair(std::uint32_t a, EnergyFace face_a, std::uint32_t b, EnergyFace face_b) {
        face_a.across = face_b.across = Across::Part;
        face_a.other_room = room_of_[b], face_b.other_room = room_of_[a];
        const std::uint32_t at_a = add(a, std::move(face_a)), at_b = add(b, std::move(face_b));
        model_.rooms[room_of_[a]].faces[at_a].other_face = at_b;
        model_.rooms[room_of_[b]].faces[at_b].other_face = at_a;
    }

    /// What lies on the other side of a slab: by part and side of it, what is there, and whether there is no slab.
    using LevelKey = std::tuple<std::uint32_t, bool, Across, std::uint32_t, bool>;

    void add_levels() {
        const PlanFaces plan(building_);
        std::vector<std::uint32_t> part_of(building_.volumes.size(), no_index);
        for (std::uint32_t p = 0; p < parts_.size(); ++p)
            for (const std::uint32_t v : parts_[p].volumes) part_of[v] = p;
        std::map<LevelKey, std::vector<std::uint32_t>> groups;
        for (std::uint32_t f = 0; f < plan.count(); ++f) {
            const auto stack = plan.stack(f);
            for (std::size_t k = 0; k < stack.size(); ++k) {
                const std::uint32_t part = part_of[stack[k]];
                if (part == no_index || room_of_[part] == no_index) continue;
                for (const bool up : {false, true}) {
                    const LevelKey key = across_level(stack, k, up, part, part_of);
                    // A pair is found from below; its upper face has the same outline.
                    if (up || std::get<2>(key) != Across::Part) groups[key].push_back(f);
                }
            }
        }
        for (const auto& [key, faces] : groups)
            for (const RegionRings& rings : plan.outlines(faces)) add_level(key, rings);
    }

    LevelKey across_level(std::span<const std::uint32_t> stack, std::size_t k, bool up, std::uint32_t part,
                          const std::vector<std::uint32_t>& part_of) const {
        bool is_air = true;
        const std::size_t end = up ? stack.size() : std::size_t(-1);
        for (std::size_t at = up ? k + 1 : k - 1; at != end; at += up ? 1 : std::size_t(-1)) {
            const std::uint32_t volume = stack[at];
            switch (building_.volumes[volume].label) {
                case Label::Slab: is_air = false; continue;
                case Label::Exterior: return {part, up, Across::Outdoors, no_index, false};
                case Label::Ground: return {part, up, Across::Ground, no_index, false};
                default: break;
            }
            const std::uint32_t other = part_of[volume];
            if (other == no_index || room_of_[other] == no_index) break;
            return {part, up, Across::Part, other, is_air};
        }
        return {part, up, Across::Nothing, no_index, false};
    }

    void add_level(const LevelKey& key, const RegionRings& rings) {
        const auto [part, up, across, other, is_air] = key;
        if (area(rings) < least_area) return;
        EnergyFace face = level_face(rings, part, up);
        face.across = across;
        face.is_air = is_air;
        if (across != Across::Part) {
            add(part, std::move(face));
            return;
        }
        EnergyFace above = level_face(rings, other, false);
        above.is_air = is_air;
        pair(part, std::move(face), other, std::move(above));
    }

    double area(const RegionRings& rings) const {
        double sum = 0;
        const auto add_ring = [&](const std::vector<std::uint32_t>& ring) {
            for (std::size_t k = 1; k + 1 < ring.size(); ++k)
                sum += double(plans::orientation(building_.points[ring[0]], building_.points[ring[k]],
                                                 building_.points[ring[k + 1]]));
        };
        add_ring(rings.outer);
        for (const auto& hole : rings.holes) add_ring(hole);
        return sum / 2 * building_.frame.unit * building_.frame.unit;
    }

    EnergyFace level_face(const RegionRings& rings, std::uint32_t part, bool is_ceiling) const {
        const double z = building_.frame.world_z(is_ceiling ? parts_[part].z_high : parts_[part].z_low);
        const auto lift = [&](const std::vector<std::uint32_t>& ring) {
            std::vector<std::array<double, 3>> up;
            const std::size_t n = ring.size();
            for (std::size_t k = 0; k < n; ++k) {
                const plans::GridPoint p = building_.points[ring[k]];
                const plans::GridPoint before = building_.points[ring[(k + n - 1) % n]];
                if (plans::orientation(before, p, building_.points[ring[(k + 1) % n]]) == 0) continue;
                up.push_back({building_.frame.world_x(p.x), building_.frame.world_y(p.y), z});
            }
            if (!is_ceiling) std::reverse(up.begin(), up.end());
            return up;
        };
        EnergyFace face;
        face.kind = is_ceiling ? EnergyFaceKind::Ceiling : EnergyFaceKind::Floor;
        face.outer = lift(rings.outer);
        for (const auto& hole : rings.holes) face.holes.push_back(lift(hole));
        return face;
    }

    struct TileAt {
        std::uint32_t side = no_index, tile = no_index;
    };

    void add_walls() {
        sides_of_.resize(parts_.size());
        used_.resize(views_.sides.size());
        for (std::uint32_t s = 0; s < views_.sides.size(); ++s) {
            sides_of_[views_.sides[s].part].push_back(s);
            used_[s].assign(views_.sides[s].tiles.size(), false);
        }
        for (std::uint32_t s = 0; s < views_.sides.size(); ++s)
            for (std::uint32_t t = 0; t < views_.sides[s].tiles.size(); ++t) {
                if (used_[s][t]) continue;
                used_[s][t] = true;
                const WallTile& tile = views_.sides[s].tiles[t];
                const TileAt other = tile.across == Across::Part ? partner(s, t) : TileAt{};
                if (other.side != no_index) {
                    used_[other.side][other.tile] = true;
                    add_pair({s, t}, other);
                } else {
                    const bool is_lone = tile.across == Across::Part;
                    add_wall(s, of(tile), is_lone ? Across::Nothing : tile.across, is_lone ? nullptr : &tile);
                }
            }
    }

    std::array<double, 2> direction(std::uint32_t s) const {
        const ViewedSide& side = views_.sides[s];
        const double dx = side.to[0] - side.from[0], dy = side.to[1] - side.from[1], length = std::hypot(dx, dy);
        return {dx / length, dy / length};
    }
    double along(std::uint32_t s, const std::array<double, 2>& p) const {
        const auto d = direction(s);
        return (p[0] - views_.sides[s].from[0]) * d[0] + (p[1] - views_.sides[s].from[1]) * d[1];
    }
    std::array<double, 2> at(std::uint32_t s, double u) const {
        const auto d = direction(s);
        return {views_.sides[s].from[0] + u * d[0], views_.sides[s].from[1] + u * d[1]};
    }
    /// A rectangle of side `from` as it lies before side `to`, which runs against it.
    Rectangle project(std::uint32_t from, const Rectangle& r, std::uint32_t to) const {
        return {along(to, at(from, r.u_high)), along(to, at(from, r.u_low)), r.z_low, r.z_high};
    }
    static Rectangle common(const Rectangle& a, const Rectangle& b) {
        return {std::max(a.u_low, b.u_low), std::min(a.u_high, b.u_high), std::max(a.z_low, b.z_low),
                std::min(a.z_high, b.z_high)};
    }

    /// The free tile that looks back at a tile, over the largest area; best on the very side that the tile sees.
    TileAt partner(std::uint32_t s, std::uint32_t t) const {
        const WallTile& tile = views_.sides[s].tiles[t];
        const std::uint32_t part = views_.sides[s].part;
        TileAt best;
        double most = 0;
        if (tile.part == part) return best;
        for (const std::uint32_t other : sides_of_[tile.part]) {
            const auto a = direction(s), b = direction(other);
            if (a[0] * b[0] + a[1] * b[1] > -least_cosine) continue;
            const double apart = a[1] * (views_.sides[other].from[0] - views_.sides[s].from[0]) -
                                 a[0] * (views_.sides[other].from[1] - views_.sides[s].from[1]);
            if (apart < -least || apart > most_thickness) continue;
            const Rectangle seen = project(s, of(tile), other);
            for (std::uint32_t k = 0; k < views_.sides[other].tiles.size(); ++k) {
                const WallTile& back = views_.sides[other].tiles[k];
                if (used_[other][k] || back.across != Across::Part || back.part != part || back.is_air != tile.is_air)
                    continue;
                const Rectangle both = common(seen, of(back));
                const bool is_seen = other == tile.side && (back.side == s || back.side == no_index);
                const double size = (both.u_high - both.u_low) * (both.z_high - both.z_low) * (is_seen ? 4 : 1);
                if (both.is_something() && size > most) most = size, best = {other, k};
            }
        }
        return best;
    }

    /// Both tiles cut down to what looks at each other, with the same width; what is left over looks at nothing.
    void add_pair(const TileAt& a, const TileAt& b) {
        const WallTile &tile_a = views_.sides[a.side].tiles[a.tile], &tile_b = views_.sides[b.side].tiles[b.tile];
        Rectangle common_a = common(of(tile_a), project(b.side, of(tile_b), a.side));
        Rectangle common_b = common(of(tile_b), project(a.side, of(tile_a), b.side));
        const double width = std::min(common_a.u_high - common_a.u_low, common_b.u_high - common_b.u_low);
        for (Rectangle* r : {&common_a, &common_b}) {
            const double spare = (r->u_high - r->u_low - width) / 2;
            r->u_low += spare, r->u_high -= spare;
        }
        EnergyFace face_a = wall_face(a.side, common_a), face_b = wall_face(b.side, common_b);
        face_a.is_air = face_b.is_air = tile_a.is_air;
        for (const WallOpening& opening : tile_a.openings) {
            const Rectangle in_a = inset({opening.u_low, opening.u_high, opening.z_low, opening.z_high}, common_a);
            if (!in_a.is_something()) continue;
            // The same rectangle, mirrored about the middle of the pair.
            const Rectangle in_b = {common_b.u_low + common_a.u_high - in_a.u_high,
                                    common_b.u_low + common_a.u_high - in_a.u_low, in_a.z_low, in_a.z_high};
            face_a.openings.push_back({parts_[opening.part].space, corners(a.side, in_a)});
            face_b.openings.push_back({parts_[opening.part].space, corners(b.side, in_b)});
        }
        pair(views_.sides[a.side].part, std::move(face_a), views_.sides[b.side].part, std::move(face_b));
        add_rest(a.side, of(tile_a), common_a);
        add_rest(b.side, of(tile_b), common_b);
    }

    void add_rest(std::uint32_t s, const Rectangle& whole, const Rectangle& taken) {
        add_wall(s, {whole.u_low, taken.u_low, whole.z_low, whole.z_high}, Across::Nothing, nullptr);
        add_wall(s, {taken.u_high, whole.u_high, whole.z_low, whole.z_high}, Across::Nothing, nullptr);
        add_wall(s, {taken.u_low, taken.u_high, whole.z_low, taken.z_low}, Across::Nothing, nullptr);
        add_wall(s, {taken.u_low, taken.u_high, taken.z_high, whole.z_high}, Across::Nothing, nullptr);
    }

    void add_wall(std::uint32_t s, const Rectangle& r, Across across, const WallTile* with_openings) {
        if (!r.is_something()) return;
        EnergyFace face = wall_face(s, r);
        face.across = across;
        if (with_openings && across == Across::Outdoors)  // a window into the earth is none
            for (const WallOpening& opening : with_openings->openings) {
                const Rectangle inside = inset({opening.u_low, opening.u_high, opening.z_low, opening.z_high}, r);
                if (inside.is_something()) face.openings.push_back({parts_[opening.part].space, corners(s, inside)});
            }
        add(views_.sides[s].part, std::move(face));
    }

    /// An opening within its face, which it may not fill: a centimetre of frame stays.
    static Rectangle inset(const Rectangle& opening, const Rectangle& face) {
        const Rectangle r = common(opening, face);
        const double filled = (r.u_high - r.u_low) * (r.z_high - r.z_low);
        if (filled < 0.99 * (face.u_high - face.u_low) * (face.z_high - face.z_low)) return r;
        return {r.u_low + 0.01, r.u_high - 0.01, r.z_low + 0.01, r.z_high - 0.01};
    }

    std::array<std::array<double, 3>, 4> corners(std::uint32_t s, const Rectangle& r) const {
        const plans::GridFrame& frame = building_.frame;
        const auto corner = [&](double u, double z) {
            const auto p = at(s, u);
            return std::array{frame.origin_x + p[0], frame.origin_y + p[1], frame.origin_z + z};
        };
        return {corner(r.u_low, r.z_low), corner(r.u_high, r.z_low), corner(r.u_high, r.z_high),
                corner(r.u_low, r.z_high)};
    }
    EnergyFace wall_face(std::uint32_t s, const Rectangle& r) const {
        EnergyFace face;
        const auto points = corners(s, r);
        face.outer.assign(points.begin(), points.end());
        return face;
    }

    const Building& building_;
    std::vector<SpacePart> parts_;
    WallViews views_;
    std::vector<std::uint32_t> room_of_;                ///< [part]
    std::vector<std::vector<std::uint32_t>> sides_of_;  ///< [part]
    std::vector<std::vector<bool>> used_;               ///< [side][tile]
    EnergyModel model_;
};

}  // namespace

EnergyModel energy_model(const Building& building) { return Builder(building).run(); }

}  // namespace enfilade::modeler
