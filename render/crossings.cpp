#include "render/crossings.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "render/crossing_cells.h"
#include "render/solids.h"
#include "render/walk.h"

namespace enfilade::render {
namespace {

using accel::Label;
using accel::SourceFaceId;
using accel::Surface;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::size_t rays_a_chunk = 1024;

/// What is behind a face that shows this.
Label label_behind(Surface surface) {
    switch (surface) {
        case Surface::Floor:
        case Surface::Ceiling:
        case Surface::Roof: return Label::Slab;
        case Surface::Leaf: return Label::Door;
        case Surface::Pane: return Label::Window;
        case Surface::Terrain: return Label::Ground;
        case Surface::Sky: return Label::Outside;
        default: return Label::Wall;
    }
}

Border border_of(accel::TargetKind kind) {
    switch (kind) {
        case accel::TargetKind::Clear: return Border::Clear;
        case accel::TargetKind::Virtual: return Border::Virtual;
        case accel::TargetKind::Glass: return Border::Glass;
        case accel::TargetKind::Solid: break;
    }
    return Border::Face;
}

/// What one thread needs for one ray after the other.
struct Scratch {
    std::vector<detail::CellStretch> cells;
    std::vector<SolidStretch> solids;
    RayStats stats;
};

/// One ray on its way through cells and solids.
class Journey {
public:
    Journey(const accel::SceneView& scene, const Solids* solids, const Ray<double>& ray, double limit, Scratch& scratch,
            std::vector<Passage>& passages)
        : scene_(scene),
          solids_(solids),
          ray_(ray),
          metres_(length(ray.direction)),
          limit_(limit),
          scratch_(scratch),
          passages_(passages) {}

    PassagesEnd run(accel::CellId start) {
        chain_begin_ = passages_.size();
        std::optional<PassagesEnd> end;
        if (start != none<accel::CellId>) end = walk_cells(std::uint32_t(index(start)));
        while (!end) {
            const detail::CellStretch* next = next_cell();
            if (next == nullptr) return end_in_solid();
            // Every stretch is entered at most once, as `progress_` grows past its end: this ends.
            const double t = std::max(t_, next->enter);
            progress_ = std::max(progress_, next->leave);
            const accel::Target behind = detail::target_behind(scene_, ray_, *next);
            face_in_ = behind.is_portal() ? none<SourceFaceId> : behind.source_face();
            border_ = Border::Face;
            if (face_out_ != none<SourceFaceId> || t > t_) {
                add_solid(t);
            } else {  // the ray starts on a face
                face_in_ = none<SourceFaceId>;
                border_ = Border::End;
            }
            t_ = t;
            chain_begin_ = passages_.size();
            end = walk_cells(next->cell);
        }
        return *end;
    }

private:
    /// Through portals until a solid ends the light, which leaves it to the caller, or until the ray ends.
    std::optional<PassagesEnd> walk_cells(std::uint32_t cell) {
        std::uint32_t entry = no_section, entry_next = no_section;
        const std::uint64_t turn_back = scene_.cells.count + 16;  // as `walk` does
        scratch_.stats.began_walk();
        for (std::uint64_t steps = 2 * turn_back; steps > 0; --steps) {
            WalkEnd<double> end;
            scratch_.stats.entered_cell(scene_.cells[cell].section_count);
            leave_cell(scene_, ray_, cell, entry, entry_next, steps > turn_back, NoLimit{}, scratch_.stats, end);
            const double t = std::max(t_, parameter(scene_, ray_, end));
            Passage& passage = add(t_, std::min(t, limit_), scene_.cells[cell].label, scene_.cells[cell].space);
            passage.cell = static_cast<accel::CellId>(cell);
            passage.entered = border_;
            set_faces(passage, face_in_, none<SourceFaceId>);
            if (!(t < limit_)) return PassagesEnd::Reached;
            t_ = t;
            border_ = passage.left = border_of(end.target.kind());
            if (!end.target.is_portal()) {
                face_out_ = end.target.source_face();
                set_faces(passage, face_in_, face_out_);
                face_in_ = none<SourceFaceId>;
                return surface_of(face_out_) == Surface::Sky ? std::optional(leave_site()) : std::nullopt;
            }
            if (end.target.is_glass()) scratch_.stats.crossed_glass();
            face_in_ = none<SourceFaceId>;
            entry = end.exit == Exit::Side ? end.section : no_section;
            entry_next = end.next_section;
            cell = std::uint32_t(index(end.target.neighbour()));
        }
        scratch_.stats.leaked();
        return PassagesEnd::Leak;
    }

    /// The cell that the ray enters next behind a solid, or nullptr.
    const detail::CellStretch* next_cell() {
        if (!is_gathered_) {
            detail::cells_along(scene_, ray_, t_, limit_, scratch_.cells);
            is_gathered_ = true;
        }
        while (next_ < scratch_.cells.size()) {
            const detail::CellStretch& stretch = scratch_.cells[next_++];
            if (stretch.leave > std::max(t_, progress_) && !was_just_left(stretch.cell)) return &stretch;
        }
        return nullptr;
    }

    /// Whether rounding offers a cell again that the last walk went through.
    [[nodiscard]] bool was_just_left(std::uint32_t cell) const {
        for (std::size_t i = chain_begin_; i < passages_.size(); ++i)
            if (passages_[i].cell == static_cast<accel::CellId>(cell)) return true;
        return false;
    }

    /// The solids up to where the next cell begins.
    void add_solid(double t) {
        if (solids_ != nullptr && t > t_) {
            solids_->along(ray_, t_, t, scratch_.solids);
            if (!scratch_.solids.empty()) {
                add_known_solids(t, true);
                return;
            }
        }
        add_gap(t, face_in_, Border::Face);
    }

    /// A solid known by its faces alone; none for the ray's ends.
    void add_gap(double t, SourceFaceId next, Border left) {
        const bool has_first = face_out_ != none<SourceFaceId>, has_second = next != none<SourceFaceId>;
        const Label first = has_first ? label_behind(surface_of(face_out_)) : label_of_nothing();
        const Label second = has_second ? label_behind(surface_of(next)) : first;
        Passage& passage = add(t_, t, has_first ? std::max(first, second) : second, none<accel::SpaceId>);
        passage.entered = has_first ? Border::Face : Border::End;
        passage.left = left;
        set_faces(passage, face_out_, next);
        face_out_ = none<SourceFaceId>;
    }

    /// scratch_.solids, which cover [t_, t] but for what lies beyond the site, and for gaps of a few grid units where
    /// rounding bent their sides: those go to the solid behind. `is_closed`: a cell follows.
    void add_known_solids(double t, bool is_closed) {
        const std::size_t first = passages_.size();
        double at = t_;
        const auto append = [&](double to, Label label, accel::SpaceId space) {
            const bool is_more =
                passages_.size() > first && passages_.back().label == label && passages_.back().space == space;
            if (is_more) passages_.back().leave = to * metres_;
            else add(at, to, label, space).entered = passages_.size() == first ? Border::End : Border::Inside;
            at = to;
        };
        for (std::size_t i = 0; i < scratch_.solids.size(); ++i) {
            const SolidStretch& stretch = scratch_.solids[i];
            if (stretch.leave <= at) continue;
            if (stretch.enter > at && is_beyond_site(0.5 * (at + stretch.enter)))
                append(stretch.enter, Label::Outside, none<accel::SpaceId>);
            const SolidPrism& prism = solids_->prisms()[stretch.prism];
            append(stretch.leave, prism.label, prism.space);
        }
        if (at < t && t < infinite) {
            if (is_beyond_site(0.5 * (at + t))) append(t, Label::Outside, none<accel::SpaceId>);
            else passages_.back().leave = t * metres_;
        }
        finish_known_solids(first, is_closed ? face_in_ : none<SourceFaceId>, is_closed);
    }

    [[nodiscard]] bool is_beyond_site(double t) const {
        const Vec3d p = ray_.origin + t * ray_.direction;
        return label_at(p) == Label::Outside && !solids_->are_around(p);
    }

    void finish_known_solids(std::size_t first, SourceFaceId next, bool is_closed) {
        for (std::size_t i = first; i < passages_.size(); ++i) {
            Passage& passage = passages_[i];
            const bool is_first = i == first, is_last = i + 1 == passages_.size();
            passage.entered = !is_first ? Border::Inside : face_out_ != none<SourceFaceId> ? Border::Face : Border::End;
            passage.left = !is_last ? Border::Inside : is_closed ? Border::Face : Border::End;
            set_faces(passage, is_first ? face_out_ : none<SourceFaceId>, is_last ? next : none<SourceFaceId>);
        }
        face_out_ = none<SourceFaceId>;
    }

    /// No cell follows: the ray ends in a solid, or beyond the site.
    PassagesEnd end_in_solid() {
        if (solids_ == nullptr) {
            add_gap(limit_, none<SourceFaceId>, Border::End);
            if (passages_.back().label == Label::Outside) {
                if (!(limit_ < infinite)) passages_.pop_back();
                return PassagesEnd::Left;
            }
            return limit_ < infinite ? PassagesEnd::Reached : PassagesEnd::Buried;
        }
        solids_->along(ray_, t_, limit_, scratch_.solids);
        if (scratch_.solids.empty()) return leave_site();
        add_known_solids(limit_, false);
        return passages_.back().label == Label::Outside || !(limit_ < infinite) ? PassagesEnd::Left
                                                                                : PassagesEnd::Reached;
    }

    PassagesEnd leave_site() {
        if (limit_ < infinite) {
            Passage& passage = add(t_, limit_, Label::Outside, none<accel::SpaceId>);
            passage.entered = face_out_ != none<SourceFaceId> ? Border::Face : Border::End;
            set_faces(passage, face_out_, none<SourceFaceId>);
        }
        return PassagesEnd::Left;
    }

    /// Where the ray meets no cell at all, and solids are not known.
    [[nodiscard]] Label label_of_nothing() const { return label_at(ray_.origin); }
    [[nodiscard]] Label label_at(const Vec3d& p) const {
        if (scene_.locator_nodes.empty()) return Label::Outside;
        const accel::LocatorNode& site = scene_.locator_nodes[0];
        const bool is_on_site = p.x >= site.low[0] && p.x <= site.high[0] && p.y >= site.low[1] &&
                                p.y <= site.high[1] && p.z <= site.high[2];
        return !is_on_site ? Label::Outside : p.z < site.low[2] ? Label::Ground : Label::Wall;
    }

    Passage& add(double from, double to, Label label, accel::SpaceId space) {
        passages_.push_back({from * metres_,
                             to * metres_,
                             none<accel::CellId>,
                             space,
                             none<SourceFaceId>,
                             none<SourceFaceId>,
                             none<accel::MaterialId>,
                             none<accel::MaterialId>,
                             label,
                             Border::End,
                             Border::End,
                             no_surface,
                             no_surface,
                             {}});
        return passages_.back();
    }

    void set_faces(Passage& passage, SourceFaceId in, SourceFaceId out) const {
        passage.face_in = in;
        passage.face_out = out;
        if (in != none<SourceFaceId>) {
            passage.material_in = scene_.source_faces[index(in)].material;
            passage.surface_in = std::uint8_t(surface_of(in));
        }
        if (out != none<SourceFaceId>) {
            passage.material_out = scene_.source_faces[index(out)].material;
            passage.surface_out = std::uint8_t(surface_of(out));
        }
    }

    [[nodiscard]] Surface surface_of(SourceFaceId face) const { return scene_.source_faces[index(face)].surface; }

    const accel::SceneView& scene_;
    const Solids* solids_;
    const Ray<double>& ray_;
    double metres_;  ///< of one unit of the parameter
    double limit_;   ///< parameter
    Scratch& scratch_;
    std::vector<Passage>& passages_;

    double t_ = 0;
    double progress_ = 0;          ///< ends of the stretches that began a walk
    std::size_t chain_begin_ = 0;  ///< the last walk's first passage
    std::size_t next_ = 0;         ///< of the cells gathered
    bool is_gathered_ = false;
    Border border_ = Border::End;                 ///< by which the next cell is entered
    SourceFaceId face_in_ = none<SourceFaceId>;   ///< by which light begins again
    SourceFaceId face_out_ = none<SourceFaceId>;  ///< by which light ended
};

PassagesEnd pass(const accel::SceneView& scene, const Solids* solids, const RayQuery& query, Scratch& scratch,
                 std::vector<Passage>& passages) {
    Ray<double> ray;
    if (!make_ray(query.origin, query.direction, ray) || !(query.max_distance >= 0)) return PassagesEnd::Refused;
    const double limit = query.max_distance / length(ray.direction);
    return Journey(scene, solids, ray, limit < 1e30 ? limit : infinite, scratch, passages).run(query.cell);
}

}  // namespace

PassageTable all_crossings(const accel::SceneView& scene, std::span<const RayQuery> rays,
                           const CrossingOptions& options) {
    PassageTable table;
    table.offsets.assign(rays.size() + 1, 0);
    table.ends.resize(rays.size());
    const std::size_t chunks = (rays.size() + rays_a_chunk - 1) / rays_a_chunk;
    std::vector<std::vector<Passage>> of_chunk(chunks);
    std::vector<RayStats> stats_of_chunk(chunks);
    const accel::SerialExecutor serial;
    const accel::Executor& executor = options.executor != nullptr ? *options.executor : serial;
    accel::parallel_for(executor, rays.size(), rays_a_chunk, [&](std::size_t begin, std::size_t end) {
        Scratch scratch;
        std::vector<Passage>& passages = of_chunk[begin / rays_a_chunk];
        for (std::size_t i = begin; i < end; ++i) {
            const std::size_t before = passages.size();
            table.ends[i] = pass(scene, options.solids, rays[i], scratch, passages);
            table.offsets[i + 1] = passages.size() - before;
        }
        stats_of_chunk[begin / rays_a_chunk] = scratch.stats;
    });
    for (std::size_t i = 0; i < rays.size(); ++i) table.offsets[i + 1] += table.offsets[i];
    table.passages.resize(table.offsets.back());
    accel::parallel_for(executor, chunks, 1, [&](std::size_t chunk, std::size_t) {
        std::copy(of_chunk[chunk].begin(), of_chunk[chunk].end(),
                  table.passages.begin() + std::ptrdiff_t(table.offsets[chunk * rays_a_chunk]));
        of_chunk[chunk] = {};
    });
    if (options.stats != nullptr)
        for (const RayStats& one : stats_of_chunk) options.stats->add(one);
    return table;
}

bool first_entry(const accel::SceneView& scene, Vec3d origin, Vec3d direction, FirstEntry& entry) {
    Ray<double> ray;
    if (!make_ray(origin, direction, ray)) return false;
    std::vector<detail::CellStretch> cells;
    detail::cells_along(scene, ray, 0, infinite, cells);
    if (cells.empty()) return false;
    const detail::CellStretch& first = cells.front();
    const accel::Target behind = detail::target_behind(scene, ray, first);
    entry.cell = static_cast<accel::CellId>(first.cell);
    entry.distance = std::max(0.0, first.enter) * length(ray.direction);
    entry.depth = std::max(0.0, detail::depth_behind(scene, ray, first));
    entry.through_sky = !behind.is_portal() && scene.source_faces[index(behind.source_face())].surface == Surface::Sky;
    return true;
}

}  // namespace enfilade::render
