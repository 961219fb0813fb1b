#include "modeler/export_scene.h"

#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

#include "accel/assemble.h"
#include "base/check.h"
#include "base/error.h"
#include "modeler/cutting/polygon.h"
#include "modeler/face_label.h"
#include "modeler/lighting/scene_lights.h"
#include "modeler/materials.h"
#include "modeler/model_group.h"
#include "modeler/objects/scene_objects.h"
#include "modeler/outline.h"
#include "modeler/surface_textures.h"

namespace enfilade::modeler {
namespace {

constexpr std::uint32_t no_index = UINT32_MAX;

/// What one edge of a cell's floor shows between two levels: a portal, or a solid of one surface and material.
struct SideRun {
    std::int32_t z_low, z_high;
    std::uint32_t neighbour = no_index;  ///< cell behind a portal
    PortalKind portal = PortalKind::Clear;
    Surface surface = Surface::WallPaper;  ///< of a solid, like `material`
    std::uint32_t material = 0;
    std::uint32_t textured_wall = SurfaceTextures::no_wall;  ///< whose texture the solid shows
    std::uint32_t source = no_index;                         ///< source face of a solid

    [[nodiscard]] bool is_portal() const { return neighbour != no_index; }
    /// Whether both show the same: one face where they touch.
    [[nodiscard]] bool like(const SideRun& other) const {
        return neighbour == other.neighbour && portal == other.portal && surface == other.surface &&
               material == other.material && textured_wall == other.textured_wall && source == other.source;
    }
};

/// Solid runs with equal keys, one starting where the other ends, are one face of the building before its cuts.
struct ChainKey {
    std::uint32_t parent, line, material, textured_wall, start;
    std::int32_t z_low, z_high;
    Surface surface;
    friend bool operator==(const ChainKey&, const ChainKey&) = default;
};
struct ChainHash {
    std::size_t operator()(const ChainKey& key) const {
        std::uint64_t h = 0x9e3779b97f4a7c15u;
        for (const std::uint64_t part :
             {std::uint64_t(key.parent), std::uint64_t(key.line), std::uint64_t(key.material),
              std::uint64_t(key.textured_wall), std::uint64_t(key.start), std::uint64_t(std::uint32_t(key.z_low)),
              std::uint64_t(std::uint32_t(key.z_high)), std::uint64_t(key.surface)})
            h = (h ^ part) * 0xbf58476d1ce4e5b9u, h ^= h >> 29;
        return std::size_t(h);
    }
};

class SceneExporter {
public:
    explicit SceneExporter(const Building& building)
        : building_(building), openings_(building), materials_(building), textures_(building) {}

    accel::SceneInput run() {
        const plans::GridFrame& frame = building_.frame;
        input_.unit = frame.unit;
        input_.origin = {frame.origin_x, frame.origin_y, frame.origin_z};
        number_cells();
        index_edges();
        find_horizontal_faces();
        add_floors_and_ceilings();
        find_side_runs();
        chain_solid_runs();
        join_sections();
        add_sections();
        add_spaces();
        input_.materials = materials_.take();
        input_.textures = building_.pictures;
        add_objects(building_, input_);
        add_lights(building_, input_);
        return std::move(input_);
    }

private:
    [[noreturn]] static void refuse(const std::string& what) {
        throw InputError(
            "F22", "",
            "The model cannot become a scene: " + what + ". Check the plan and mend what is reported first.");
    }

    void number_cells() {
        cell_of_.assign(building_.volumes.size(), no_index);
        for (std::uint32_t v = 0; v < building_.volumes.size(); ++v) {
            const Volume& volume = building_.volumes[v];
            if (!carries_light(volume.label)) continue;
            cell_of_[v] = std::uint32_t(input_.cells.size());
            volume_of_.push_back(v);
            input_.cells.push_back({volume.label, volume.space, v, volume.z_low, volume.z_high, 0, {}, {}});
        }
    }

    /// Side faces stand first in `faces`, by edge, then upward.
    void index_edges() {
        first_face_.assign(building_.edges.size() + 1, 0);
        for (const Face& face : building_.faces)
            if (face.direction == Direction::Side) ++first_face_[face.edge + 1];
        for (std::size_t e = 1; e < first_face_.size(); ++e) first_face_[e] += first_face_[e - 1];
    }

    /// The portal of a face between two cells, the same number from both sides: `key` says which face.
    std::uint32_t portal(std::uint64_t key, std::uint32_t a, std::uint32_t b, PortalKind kind) {
        const auto [at, is_new] = portal_ids_.try_emplace(key, std::uint32_t(input_.portals.size()));
        if (is_new)
            input_.portals.push_back(
                {std::min(a, b), std::max(a, b), kind, kind == PortalKind::Glass ? glass_tint : clear_tint});
        return at->second;
    }

    /// Per cell, what its floor and ceiling show. A region's places are alike in what carries light above and below
    /// (stack.h), so a floor is wholly solid or one portal; of several solids behind it the terrain names the surface.
    void find_horizontal_faces() {
        floor_.assign(input_.cells.size(), no_index);
        ceiling_.assign(input_.cells.size(), no_index);
        const auto consider = [&](std::uint32_t& known, std::uint32_t f, std::uint32_t behind) {
            if (known == no_index || building_.volumes[behind].label == Label::Ground) known = f;
        };
        for (std::uint32_t f = 0; f < building_.faces.size(); ++f) {
            const Face& face = building_.faces[f];
            if (face.direction != Direction::Up) continue;
            if (cell_of_[face.front] != no_index) consider(floor_[cell_of_[face.front]], f, face.back);
            if (cell_of_[face.back] != no_index) consider(ceiling_[cell_of_[face.back]], f, face.front);
        }
    }

    void add_floors_and_ceilings() {
        std::map<std::uint32_t, std::vector<std::uint32_t>> members;  // parent -> volumes
        for (const std::uint32_t v : volume_of_) members[building_.volumes[v].parent].push_back(v);
        std::vector<std::uint32_t> scratch(2 * building_.edges.size(), no_index);
        for (const auto& [parent, volumes] : members) {
            std::vector<std::uint32_t> ring;
            for (const bool is_floor : {true, false}) {
                std::uint32_t source = no_index;
                for (const std::uint32_t v : volumes) {
                    const std::uint32_t f = (is_floor ? floor_ : ceiling_)[cell_of_[v]];
                    if (f == no_index) refuse("a cell has no floor or no ceiling");
                    const Face& face = building_.faces[f];
                    const std::uint32_t behind = is_floor ? face.back : face.front;
                    accel::InputTarget& target =
                        is_floor ? input_.cells[cell_of_[v]].floor : input_.cells[cell_of_[v]].ceiling;
                    if (const FaceKind kind = face_kind(building_, openings_, face); kind.is_portal) {
                        target = {true, portal(level_key | f, cell_of_[v], cell_of_[behind], kind.portal)};
                        continue;
                    }
                    if (source == no_index) {
                        if (ring.empty()) ring = corners_of(building_, outline(building_, volumes, scratch));
                        source = add_level_face(ring, v, behind, is_floor);
                    }
                    target = {false, source};
                }
            }
        }
    }

    /// Walls and floors around an object look as they do around its room.
    [[nodiscard]] Label label_seen(const Volume& volume) const {
        if (volume.label != Label::Object) return volume.label;
        return building_.spaces[place_of(building_, volume.space)].label;
    }

    std::uint32_t add_level_face(const std::vector<std::uint32_t>& ring, std::uint32_t viewer, std::uint32_t behind,
                                 bool is_floor) {
        const Volume& volume = building_.volumes[viewer];
        const Volume& back = building_.volumes[behind];
        const std::uint32_t place = place_of(building_, volume.space);
        const Surface shown = surface(label_seen(volume), back.label, is_floor ? Looking::Down : Looking::Up);
        const PlanTexture* texture = shown == Surface::Floor     ? textures_.of_floor(place)
                                     : shown == Surface::Ceiling ? textures_.of_ceiling(place)
                                                                 : nullptr;
        input_.source_faces.push_back(
            {shown, volume.space,
             texture != nullptr ? materials_.of(shown, *texture) : materials_.of(shown, place, back.space, no_index),
             std::uint32_t(input_.vertices.size())});
        if (texture != nullptr) input_.source_faces.back().frame = textures_.level_frame();
        const auto add = [&](std::uint32_t point) {
            const plans::GridPoint p = building_.points[point];
            input_.vertices.push_back({p.x, p.y, is_floor ? volume.z_low : volume.z_high});
        };
        if (is_floor) std::for_each(ring.begin(), ring.end(), add);
        else std::for_each(ring.rbegin(), ring.rend(), add);
        return std::uint32_t(input_.source_faces.size() - 1);
    }

    [[nodiscard]] const Piece& piece_of(std::uint32_t cell) const {
        return building_.pieces[building_.volumes[volume_of_[cell]].piece];
    }
    [[nodiscard]] const Corner& corner_of(std::uint32_t cell, std::uint32_t k) const {
        const Piece& piece = piece_of(cell);
        return building_.corners[piece.first_corner + k % piece.corner_count];
    }
    [[nodiscard]] std::uint32_t line_of(std::uint32_t cell, std::uint32_t k) const { return corner_of(cell, k).line; }

    void find_side_runs() {
        for (std::uint32_t cell = 0; cell < input_.cells.size(); ++cell) {
            first_corner_.push_back(std::uint32_t(first_run_.size()));
            for (std::uint32_t k = 0; k < piece_of(cell).corner_count; ++k) {
                first_run_.push_back(std::uint32_t(runs_.size()));
                add_runs(cell, corner_of(cell, k), corner_of(cell, k + 1).vertex);
            }
        }
        first_corner_.push_back(std::uint32_t(first_run_.size()));
        first_run_.push_back(std::uint32_t(runs_.size()));
    }

    void add_runs(std::uint32_t cell, const Corner& corner, std::uint32_t end) {
        const std::uint32_t half_edge = corner.half_edge;
        const std::uint32_t v = volume_of_[cell], edge = half_edge / 2;
        const std::size_t first = runs_.size();
        for (std::uint32_t f = first_face_[edge]; f < first_face_[edge + 1]; ++f) {
            const Face& face = building_.faces[f];
            if ((half_edge % 2 == 0 ? face.front : face.back) != v) continue;
            const std::uint32_t behind = half_edge % 2 == 0 ? face.back : face.front;
            const FaceKind kind = face_kind(building_, openings_, face);
            SideRun run{face.z_low, face.z_high};
            if (kind.is_portal) {
                run.neighbour = cell_of_[behind];
                run.portal = kind.portal;
            } else {
                const Volume& viewer = building_.volumes[v];
                const Volume& back = building_.volumes[behind];
                run.surface = kind.forced.value_or(surface(label_seen(viewer), back.label, Looking::Sideways));
                lay_material(run, place_of(building_, viewer.space), back.space, corner, end);
            }
            if (runs_.size() > first && runs_.back().like(run)) runs_.back().z_high = run.z_high;
            else runs_.push_back(run);
        }
        if (runs_.size() == first) refuse("a cell has a side without a face");
    }

    /// Of a solid over the edge from `corner` to the point `end`.
    void lay_material(SideRun& run, std::uint32_t place, std::uint32_t behind, const Corner& corner,
                      std::uint32_t end) {
        const plans::GridPoint a = building_.points[corner.vertex], b = building_.points[end];
        if (run.surface == Surface::WallPaper || run.surface == Surface::Facade)
            run.textured_wall = textures_.wall_behind(behind, a, b);
        run.material = run.textured_wall != SurfaceTextures::no_wall
                           ? materials_.of(run.surface, textures_.of_wall(run.textured_wall, a, b))
                           : materials_.of(run.surface, place, behind, corner.line);
    }

    void chain_solid_runs() {
        struct Place {
            std::uint32_t run, end;
        };
        std::unordered_map<ChainKey, Place, ChainHash> starting;
        const auto for_each_solid = [&](auto visit) {
            for (std::uint32_t cell = 0; cell < input_.cells.size(); ++cell)
                for (std::uint32_t k = 0; k < piece_of(cell).corner_count; ++k) {
                    const std::uint32_t at = first_corner_[cell] + k;
                    for (std::uint32_t r = first_run_[at]; r < first_run_[at + 1]; ++r) {
                        const SideRun& run = runs_[r];
                        if (run.is_portal()) continue;
                        const std::uint32_t parent = building_.volumes[volume_of_[cell]].parent;
                        visit(cell, r,
                              ChainKey{parent, line_of(cell, k), run.material, run.textured_wall,
                                       corner_of(cell, k).vertex, run.z_low, run.z_high, run.surface},
                              corner_of(cell, k + 1).vertex);
                    }
                }
        };
        for_each_solid([&](std::uint32_t, std::uint32_t r, const ChainKey& key, std::uint32_t end) {
            starting.emplace(key, Place{r, end});
        });
        const auto follower = [&](ChainKey key, std::uint32_t end) {
            const std::uint32_t begin = std::exchange(key.start, end);
            const auto next = starting.find(key);
            if (next == starting.end()) return Place{no_index, no_index};
            const auto point = [&](std::uint32_t p) { return building_.points[p]; };
            const bool straight = goes_straight(point(begin), point(end), point(next->second.end), key.line, key.line);
            return straight ? next->second : Place{no_index, no_index};
        };
        std::vector<bool> has_before(runs_.size(), false);
        for_each_solid([&](std::uint32_t, std::uint32_t, const ChainKey& key, std::uint32_t end) {
            if (const Place next = follower(key, end); next.run != no_index) has_before[next.run] = true;
        });
        for_each_solid([&](std::uint32_t cell, std::uint32_t r, ChainKey key, std::uint32_t end) {
            if (has_before[r]) return;
            const std::uint32_t source = std::uint32_t(input_.source_faces.size()), begin = key.start;
            runs_[r].source = source;
            for (Place next = follower(key, end); next.run != no_index; next = follower(key, end)) {
                if (runs_[next.run].source != no_index) refuse("its faces run in circles");
                runs_[next.run].source = source;
                key.start = std::exchange(end, next.end);
            }
            add_side_face(building_.volumes[volume_of_[cell]].space, runs_[r], begin, end);
        });
    }

    void add_side_face(std::uint32_t space, const SideRun& run, std::uint32_t from, std::uint32_t to) {
        input_.source_faces.push_back({run.surface, space, run.material, std::uint32_t(input_.vertices.size())});
        const plans::GridPoint a = building_.points[from], b = building_.points[to];
        if (run.textured_wall != SurfaceTextures::no_wall)
            input_.source_faces.back().frame = textures_.wall_frame(run.textured_wall, a, b);
        input_.vertices.push_back({a.x, a.y, run.z_low});
        input_.vertices.push_back({a.x, a.y, run.z_high});
        input_.vertices.push_back({b.x, b.y, run.z_high});
        input_.vertices.push_back({b.x, b.y, run.z_low});
    }

    [[nodiscard]] std::span<const SideRun> runs_of(std::uint32_t cell, std::uint32_t k) const {
        const std::uint32_t at = first_corner_[cell] + k % piece_of(cell).corner_count;
        return std::span(runs_).subspan(first_run_[at], first_run_[at + 1] - first_run_[at]);
    }

    [[nodiscard]] std::uint32_t before(std::uint32_t cell, std::uint32_t k) const {
        const std::uint32_t n = piece_of(cell).corner_count;
        return (k + n - 1) % n;
    }

    /// Whether side k shows what side k - 1 shows, along one line.
    [[nodiscard]] bool looks_alike(std::uint32_t cell, std::uint32_t k) const {
        const auto point = [&](std::uint32_t i) { return building_.points[corner_of(cell, i).vertex]; };
        if (!goes_straight(point(before(cell, k)), point(k), point(k + 1), line_of(cell, before(cell, k)),
                           line_of(cell, k)))
            return false;
        const auto a = runs_of(cell, before(cell, k)), b = runs_of(cell, k);
        return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                          [](const SideRun& x, const SideRun& y) { return x.z_high == y.z_high && x.like(y); });
    }

    /// The corner of a cell from which a half-edge leaves.
    [[nodiscard]] std::uint32_t corner_leaving(std::uint32_t cell, std::uint32_t half_edge) const {
        const std::uint32_t count = piece_of(cell).corner_count;
        for (std::uint32_t k = 0; k < count; ++k)
            if (corner_of(cell, k).half_edge == half_edge) return k;
        refuse("a portal is no side of the cell behind it");  // tables of a file may say so
    }

    /// Side k goes on where side k - 1 ends, as one section, where both look alike and so they do from behind each of
    /// their portals: both cells of a portal are cut at the same vertical lines.
    void join_sections() {
        goes_on_.resize(first_corner_.back());
        std::vector<std::array<std::uint32_t, 2>> refused;
        for (std::uint32_t cell = 0; cell < input_.cells.size(); ++cell)
            for (std::uint32_t k = 0; k < piece_of(cell).corner_count; ++k) {
                goes_on_[first_corner_[cell] + k] = looks_alike(cell, k);
                if (!looks_alike(cell, k)) refused.push_back({cell, k});
            }
        for (std::uint32_t cell = 0; cell < input_.cells.size(); ++cell) keep_three_sections(cell, refused);
        while (!refused.empty()) {
            const auto [cell, k] = refused.back();
            refused.pop_back();
            for (const SideRun& run : runs_of(cell, k)) {
                if (!run.is_portal()) continue;
                // Behind a portal the sides run the other way: the corner after ours is theirs before.
                const std::uint32_t behind = corner_leaving(run.neighbour, corner_of(cell, k).half_edge ^ 1);
                const std::uint32_t joint = (behind + 1) % piece_of(run.neighbour).corner_count;
                const auto at = goes_on_.begin() + std::ptrdiff_t(first_corner_[run.neighbour] + joint);
                if (!*at) continue;
                *at = false;
                refused.push_back({run.neighbour, joint});
            }
        }
    }

    /// A sliver as wide as the grid may have all its sides on two lines: it keeps them apart.
    void keep_three_sections(std::uint32_t cell, std::vector<std::array<std::uint32_t, 2>>& refused) {
        const auto first = goes_on_.begin() + std::ptrdiff_t(first_corner_[cell]);
        const auto last = first + std::ptrdiff_t(piece_of(cell).corner_count);
        if (std::count(first, last, false) >= 3) return;
        std::fill(first, last, false);
        for (std::uint32_t k = 0; k < piece_of(cell).corner_count; ++k) refused.push_back({cell, k});
    }

    void add_sections() {
        for (std::uint32_t cell = 0; cell < input_.cells.size(); ++cell) {
            input_.cells[cell].first_section = std::uint32_t(input_.sections.size());
            const std::uint32_t n = piece_of(cell).corner_count;
            for (std::uint32_t k = 0; k < n; ++k) {
                if (goes_on_[first_corner_[cell] + k]) continue;
                const plans::GridPoint p = building_.points[corner_of(cell, k).vertex];
                input_.sections.push_back({p.x, p.y, std::uint32_t(input_.side_faces.size())});
                // A section is known from both sides by the least edge under it.
                std::uint32_t edge = corner_of(cell, k).half_edge / 2;
                for (std::uint32_t j = (k + 1) % n; goes_on_[first_corner_[cell] + j]; j = (j + 1) % n)
                    edge = std::min(edge, corner_of(cell, j).half_edge / 2);
                for (const SideRun& run : runs_of(cell, k))
                    input_.side_faces.push_back({run.z_high, target_of(cell, edge, run)});
            }
        }
    }

    accel::InputTarget target_of(std::uint32_t cell, std::uint32_t edge, const SideRun& run) {
        if (!run.is_portal()) return {false, run.source};
        const std::uint64_t key = std::uint64_t(edge) << 32 | std::uint32_t(run.z_low);
        return {true, portal(key, cell, run.neighbour, run.portal)};
    }

    void add_spaces() {
        for (const Space& space : building_.spaces) {
            const bool has_storey = space.storey < building_.storeys.size();
            input_.spaces.push_back({space.label, space.id, space.name,
                                     has_storey ? building_.storeys[space.storey].id : "",
                                     has_storey ? space.storey : no_index, space.area_m2});
        }
    }

    static constexpr std::uint64_t level_key = std::uint64_t(no_index) << 32;  ///< beyond all edges
    static constexpr std::array<float, 3> glass_tint = {0.92f, 0.96f, 0.97f};
    static constexpr std::array<float, 3> clear_tint = {1, 1, 1};

    const Building& building_;
    OpeningFaces openings_;
    Materials materials_;
    SurfaceTextures textures_;
    accel::SceneInput input_;
    std::vector<std::uint32_t> cell_of_;                           ///< [volume]
    std::vector<std::uint32_t> volume_of_;                         ///< [cell]
    std::vector<std::uint32_t> first_face_;                        ///< [edge + 1] side faces over an edge
    std::vector<std::uint32_t> floor_, ceiling_;                   ///< [cell] a face of the map
    std::unordered_map<std::uint64_t, std::uint32_t> portal_ids_;  ///< by edge and level, or by horizontal face
    std::vector<SideRun> runs_;
    std::vector<std::uint32_t> first_run_;     ///< [corner + 1]
    std::vector<std::uint32_t> first_corner_;  ///< [cell + 1] into first_run_
    std::vector<bool> goes_on_;                ///< [corner] its side is part of the section before it
};

}  // namespace

accel::SceneInput scene_input(const Building& building) {
    ENFILADE_CHECK(building.convex);
    return SceneExporter(building).run();
}

accel::Scene export_scene(const Building& building, const CheckReport& report, const std::string& options_json) {
    accel::SceneInput input = scene_input(building);
    input.model = model_group(building);
    input.certificate.program_version = ENFILADE_VERSION;
    input.certificate.options = options_json;
    for (const std::string& code : report.codes_checked)
        input.certificate.code_counts.emplace_back(code, report.count(code));
    return accel::assemble(input);
}

}  // namespace enfilade::modeler
