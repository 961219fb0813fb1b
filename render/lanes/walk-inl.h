// Sixteen rays together through the cells: those in one cell leave it together (leave-inl.h), those that go on to
// one neighbour go on together.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

/// Rays that are in one cell.
struct Group {
    std::uint32_t cell;
    Bits rays;
};

/// Where each of sixteen rays is. At most sixteen groups, no ray in two of them.
class Groups {
public:
    HWY_INLINE void add(std::uint32_t cell, Bits rays) {
        for (int i = 0; i < size_; ++i)
            if (groups_[i].cell == cell) {
                groups_[i].rays |= rays;
                return;
            }
        groups_[size_++] = {cell, rays};
    }
    HWY_INLINE void clear() { size_ = 0; }
    [[nodiscard]] HWY_INLINE int size() const { return size_; }
    [[nodiscard]] HWY_INLINE const Group& operator[](int i) const { return groups_[i]; }

private:
    Group groups_[rays_at_once];
    int size_ = 0;
};

/// By which section each ray entered its cell; only asked where rounding leaves several exits or none.
struct Entries {
    std::uint32_t section[rays_at_once];
    std::uint32_t next[rays_at_once];

    HWY_INLINE void clear() {
        for (int i = 0; i < rays_at_once; ++i) section[i] = next[i] = no_section;
    }
    HWY_INLINE void set(Bits rays, std::uint32_t section_, std::uint32_t next_) {
        for (int k = 0; k < vector_count; ++k) {
            const auto mask = hn::RebindMask(DU(), mask_of(rays, k));
            hn::BlendedStore(hn::Set(DU(), section_), mask, DU(), section + k * lane_count);
            hn::BlendedStore(hn::Set(DU(), next_), mask, DU(), next + k * lane_count);
        }
    }
};

/// The products of the tints of the glass that rays crossed; ones until the first pane.
struct Tints {
    bool any = false;
    float rgb[3][rays_at_once];

    HWY_NOINLINE void multiply(Bits rays, Vec3f tint) {
        if (!any)
            for (auto& channel : rgb)
                for (float& value : channel) value = 1;
        any = true;
        for (int i = 0; i < rays_at_once; ++i) {
            if ((rays >> i & 1u) == 0) continue;
            rgb[0][i] *= tint.x;
            rgb[1][i] *= tint.y;
            rgb[2][i] *= tint.z;
        }
    }
};

/// One step of a ray that rounding has left several exits or none, as the scalar walk takes it. Never inlined: rare.
template <class Events>
HWY_NOINLINE WalkEnd<float> leave_alone(const accel::SceneView& scene, const Rays16& rays, int lane, std::uint32_t cell,
                                        const Entries& entries, bool take_farthest, Events& events) {
    WalkEnd<float> end;
    leave_cell(scene, rays.ray(lane), cell, entries.section[lane], entries.next[lane], take_farthest, NoLimit{}, events,
               end);
    return end;
}

/// What a walk has no limit.
struct Unlimited {
    [[nodiscard]] HWY_INLINE Bits before_side(const Crossings16&) const { return 0; }
    [[nodiscard]] HWY_INLINE Bits before_level(const F16&, const Rays16&) const { return 0; }
};

/// Walks at most t times each ray's direction.
struct Limit16 {
    F16 t;
    [[nodiscard]] HWY_INLINE Bits before_side(const Crossings16& at) const {
        return all_bits & ~is_at_most(at.num, t * at.den);
    }
    [[nodiscard]] HWY_INLINE Bits before_level(const F16& rise, const Rays16& rays) const {
        const F16 reach = t * rays.direction.z;
        return all_bits & ((rays.descends & ~is_at_most(reach, rise)) | (~rays.descends & ~is_at_most(rise, reach)));
    }
};

/// Follows the rays of `groups` until faces or limits stop them. Calls sink.hit(way, cell, crossings) for rays that end
/// together at a face, sink.reached(rays, cell) for those whose limit lies in the cell, sink.leaked(rays, cell) for
/// those that do not end (walk.h); sink.enter(rays, cell) as they go on, returning those that need go no further.
template <class Limits, class Sink, class Events>
HWY_INLINE void walk16(const accel::SceneView& scene, const Rays16& rays, Groups& groups, const Limits& limits,
                       Tints& tints, Sink& sink, Events& events) {
    Entries entries;
    entries.clear();
    Groups next;
    Groups* now = &groups;
    Groups* then = &next;
    const std::uint64_t turn_back = scene.cells.count + 16;
    for (std::uint64_t steps = 2 * turn_back; now->size() > 0; --steps) {
        if (steps == 0) {
            for (int g = 0; g < now->size(); ++g) {
                sink.leaked((*now)[g].rays, (*now)[g].cell);
                for (Bits left = (*now)[g].rays; left != 0; left &= left - 1) events.leaked();
            }
            return;
        }
        then->clear();
        for (int g = 0; g < now->size(); ++g) {
            const Group group = (*now)[g];
            const accel::Cell& cell = scene.cells[group.cell];
            const auto visit = [&](const Way& way, const Crossings16& at) {
                Bits going = way.rays;
                Bits reached = 0;
                if (way.exit == Exit::Side) {
                    reached = going & limits.before_side(at);
                } else {
                    const float z = way.exit == Exit::Floor ? cell.z_floor : cell.z_ceiling;
                    reached = going & limits.before_level(broadcast(z) - rays.origin.z, rays);
                }
                if (reached != 0) sink.reached(reached, group.cell);
                going &= ~reached;
                if (going == 0) return;
                Way rest = way;
                rest.rays = going;
                if (!way.target.is_portal()) return sink.hit(rest, group.cell, at);
                if (way.target.is_glass()) {
                    tints.multiply(going, tint_of(scene, group.cell, way.exit, way.face));
                    for (Bits left = going; left != 0; left &= left - 1) events.crossed_glass();
                }
                const auto neighbour = static_cast<std::uint32_t>(way.target.neighbour());
                entries.set(going, way.section, way.next_section);
                going &= ~sink.enter(going, neighbour);
                if (going != 0) then->add(neighbour, going);
            };
            for (Bits left = group.rays; left != 0; left &= left - 1) events.entered_cell(cell.section_count);
            Bits alone = leave_cell16(scene, rays, cell, group.rays, visit);
            for (; HWY_UNLIKELY(alone != 0); alone &= alone - 1) {
                const int lane = static_cast<int>(lowest_bit(alone));
                const WalkEnd<float> end =
                    leave_alone(scene, rays, lane, group.cell, entries, steps > turn_back, events);
                const bool by_side = end.exit == Exit::Side;
                visit(Way{1u << lane, end.exit, by_side ? end.section : no_section,
                          by_side ? end.next_section : no_section, end.face, end.target},
                      Crossings16{broadcast(end.num), broadcast(end.den)});
            }
        }
        Groups* const swapped = now;
        now = then;
        then = swapped;
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
