// The faces that rays of a stream meet. Neighbours that start in one cell leave it together, as they come; all others,
// and those that go on, wait in the queues of their cells until a register is full. Every ray is decided by its own
// numbers alone: its neighbours do not change its answer.
// No include guard: lanes.cpp includes it once for every instruction set.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

template <class Events>
class NearestRays {
public:
    NearestRays(const detail::StreamJob& job, Events& events)
        : job_(job),
          columns_{job.order},
          scene_(*job.scene),
          events_(events),
          noise_(noise_of(extent_of(scene_))),
          farthest_(2 * extent_of(scene_)),
          alone_(job, detail::kernels().nearest) {}

    void run() { serve_stream(*this); }

    /// Rays that waited leave their cell.
    HWY_INLINE void step(const Waiting& rays, std::uint32_t cell, Mask mask) { step(rays, cell, mask, {false, 0}); }

private:
    template <class Walk>
    friend void serve_stream(Walk& walk);

    /// Where answers go: to neighbours in the stream, or to each ray's place.
    struct Places {
        bool are_neighbours;
        std::uint64_t first;
    };

    /// Directions of which no product is lost, and origins about the scene: the others go alone. NaN fails.
    HWY_INLINE Mask are_plain(const Waiting& rays) const {
        const V level = hn::Max(hn::Abs(rays.dx), hn::Abs(rays.dy)), steep = hn::Abs(rays.dz);
        const V most = hn::Set(D(), 0x1p20f), least = hn::Set(D(), 0x1p-20f), place = hn::Set(D(), farthest_);
        const V longest = hn::Max(level, steep);
        const V sum = hn::Add(hn::Add(rays.dx, rays.dy), rays.dz);  // NaN where Max lost one
        const Mask size = hn::And(hn::And(hn::Le(longest, most), hn::Le(least, longest)), hn::Eq(sum, sum));
        const Mask lean = hn::Le(hn::Mul(longest, hn::Set(D(), 0x1p-30f)), level);
        const Mask near = hn::And(hn::Le(hn::Abs(rays.ox), place), hn::Le(hn::Abs(rays.oy), place));
        return hn::And(hn::And(size, lean), hn::And(near, hn::Le(hn::Abs(rays.oz), hn::Set(D(), 1e12f))));
    }

    HWY_INLINE void begin(std::uint64_t k, std::uint32_t count) {
        Waiting rays;
        rays.ox = columns_.column(job_.origin[0], k, count);
        rays.oy = columns_.column(job_.origin[1], k, count);
        rays.oz = columns_.column(job_.origin[2], k, count);
        rays.dx = columns_.column(job_.direction[0], k, count);
        rays.dy = columns_.column(job_.direction[1], k, count);
        rays.dz = columns_.column(job_.direction[2], k, count);
        rays.id = numbers_from(k - first_);
        rays.limit = hn::Zero(D());
        const Mask present = hn::FirstN(D(), count);
        Mask plain = hn::And(present, are_plain(rays));
        if (job_.max_distance != nullptr) {
            const V distance = columns_.column(job_.max_distance, k, count);
            const V large = hn::Set(D(), 1e30f);
            plain = hn::And(plain, hn::Le(hn::Abs(distance), large));
            rays.limit = hn::Div(distance, metres_of(rays));
        }
        const Numbers cells = columns_.cells(job_.start, k, count);
        const std::uint32_t cell = static_cast<std::uint32_t>(hn::GetLane(cells));
        if (HWY_UNLIKELY(!hn::AllTrue(D(), plain))) leave_alone(rays.id, bits_of(hn::AndNot(plain, present)));
        const Mask other = hn::AndNot(as_mask(hn::Eq(cells, hn::Set(DI(), static_cast<std::int32_t>(cell)))), plain);
        if (hn::AllFalse(D(), other)) {
            step(rays, cell, plain, {columns_.are_neighbours(count), k});
        } else {
            push(rays, cells, bits_of(plain));
        }
    }

    HWY_INLINE static V metres_of(const Waiting& rays) {
        return hn::Sqrt(
            hn::Add(hn::Add(hn::Mul(rays.dx, rays.dx), hn::Mul(rays.dy, rays.dy)), hn::Mul(rays.dz, rays.dz)));
    }

    HWY_NOINLINE void leave_alone(Numbers ids, Bits lanes) {
        HWY_ALIGN std::int32_t id[lane_count];
        hn::Store(ids, DI(), id);
        for (; lanes != 0; lanes &= lanes - 1) alone_.add(ray_of(id[lowest_bit(lanes)]));
    }
    [[nodiscard]] HWY_INLINE std::uint64_t ray_of(std::int32_t id) const {
        return columns_.ray_at(first_ + (static_cast<std::uint32_t>(id) & ((1u << Queues::ray_bits) - 1)));
    }

    HWY_INLINE void push(const Waiting& rays, Numbers cells, Bits lanes) {
        const Bits refused = queues_.push(rays, cells, lanes);
        if (HWY_UNLIKELY(refused != 0)) leave_alone(rays.id, refused);
    }

    /// Rays of the mask leave their cell.
    HWY_INLINE void step(const Waiting& rays, std::uint32_t cell, Mask mask, Places places) {
        const accel::Cell& c = scene_.cells[cell];
        const Beams beams(rays.ox, rays.oy, rays.oz, rays.dx, rays.dy, rays.dz, noise_);
        const Departure to = leave_prism(scene_, c, beams, mask);
        const Mask reached = job_.max_distance != nullptr ? hn::And(to.sure, is_limit_before(to, rays.limit))
                                                          : hn::MaskFromVec(hn::Zero(D()));
        const Mask go = hn::AndNot(reached, hn::And(to.sure, is_portal(to.target)));
        const Mask ends = hn::AndNot(go, to.sure);
        const Bits going = bits_of(go);
        count(to, c, bits_of(to.sure), going);
        const Bits doubtful = bits_of(hn::AndNot(to.sure, mask));
        if (HWY_UNLIKELY(doubtful != 0)) leave_alone(rays.id, doubtful);
        answer(rays, to, cell, ends, reached, places);
        if (going != 0) go_on(rays, to.target, going);
    }

    HWY_INLINE void go_on(Waiting rays, Numbers target, Bits going) {
        rays.id = hn::Add(rays.id, hn::Set(DI(), 1 << Queues::ray_bits));
        const Bits turning = going & bits_of(as_mask(hn::Lt(rays.id, hn::Zero(DI()))));
        if (HWY_UNLIKELY(turning != 0)) leave_alone(rays.id, turning);
        push(rays, hn::And(target, hn::Set(DI(), static_cast<std::int32_t>(accel::Target::index_mask))),
             going & ~turning);
    }

    HWY_INLINE void count(const Departure& to, const accel::Cell& cell, Bits sure, Bits going) {
        if constexpr (!std::is_same_v<Events, NoEvents>) {
            HWY_ALIGN std::int32_t target[lane_count];
            hn::Store(to.target, DI(), target);
            for (Bits left = sure; left != 0; left &= left - 1) events_.entered_cell(cell.section_count);
            for (Bits left = sure & ~going; left != 0; left &= left - 1) events_.began_walk();  // once a ray
            for (Bits left = going; left != 0; left &= left - 1)
                if (accel::Target{static_cast<std::uint32_t>(target[lowest_bit(left)])}.is_glass())
                    events_.crossed_glass();
        } else {
            (void)to, (void)cell, (void)sure, (void)going;
        }
    }

    HWY_INLINE void answer(const Waiting& rays, const Departure& to, std::uint32_t cell, Mask ends, Mask reached,
                           Places places) {
        const V zero = hn::Zero(D());
        const V distance = hn::Mul(hn::Max(hn::Div(to.num, to.den), zero), metres_of(rays));
        const Numbers none = hn::Set(DI(), -1);
        const Numbers face = hn::IfThenElse(hn::RebindMask(DI(), reached), none, to.target);
        if (places.are_neighbours) {
            answer_neighbours(distance, face, cell, ends, reached, places.first);
        } else {
            answer_each(rays.id, distance, face, cell, bits_of(ends), bits_of(reached));
        }
    }

    HWY_INLINE void answer_neighbours(V distance, Numbers face, std::uint32_t cell, Mask ends, Mask reached,
                                      std::uint64_t first) {
        const hn::Mask<DI> numbers = hn::RebindMask(DI(), ends);
        if (job_.distance != nullptr) {
            if (job_.max_distance != nullptr)
                distance = hn::IfThenElse(reached, hn::LoadU(D(), job_.max_distance + first), distance);
            hn::BlendedStore(distance, ends, D(), job_.distance + first);
        }
        if (job_.source_face != nullptr)
            hn::BlendedStore(face, numbers, DI(), reinterpret_cast<std::int32_t*>(job_.source_face + first));
        if (job_.cell != nullptr)
            hn::BlendedStore(hn::Set(DI(), static_cast<std::int32_t>(cell)), numbers, DI(),
                             reinterpret_cast<std::int32_t*>(job_.cell + first));
        if (job_.status != nullptr) {
            static_assert(static_cast<int>(WalkStatus::Hit) == 0 && static_cast<int>(WalkStatus::Reached) == 1);
            const Numbers status = hn::IfThenElseZero(hn::RebindMask(DI(), reached), hn::Set(DI(), 1));
            hn::BlendedStore(status, numbers, DI(), reinterpret_cast<std::int32_t*>(job_.status + first));
        }
    }

    HWY_INLINE void answer_each(Numbers ids, V distances, Numbers faces, std::uint32_t cell, Bits ends, Bits reached) {
        HWY_ALIGN std::int32_t id[lane_count], face[lane_count];
        HWY_ALIGN float distance[lane_count];
        hn::Store(ids, DI(), id);
        hn::Store(faces, DI(), face);
        hn::Store(distances, D(), distance);
        for (Bits left = ends; left != 0; left &= left - 1) {
            const std::uint32_t lane = lowest_bit(left);
            const std::uint64_t ray = ray_of(id[lane]);
            const bool is_reached = (reached >> lane & 1u) != 0;
            if (job_.distance != nullptr) job_.distance[ray] = is_reached ? job_.max_distance[ray] : distance[lane];
            if (job_.source_face != nullptr)
                job_.source_face[ray] = static_cast<accel::SourceFaceId>(static_cast<std::uint32_t>(face[lane]));
            if (job_.cell != nullptr) job_.cell[ray] = static_cast<accel::CellId>(cell);
            if (job_.status != nullptr) job_.status[ray] = is_reached ? WalkStatus::Reached : WalkStatus::Hit;
        }
    }

    const detail::StreamJob job_;
    const Columns columns_;
    const accel::SceneView scene_;
    Events& events_;
    const float noise_, farthest_;
    std::uint64_t first_ = 0;
    Queues queues_;
    Alone<detail::StreamJob> alone_;
};

template <class Events>
void nearest_rays(const detail::StreamJob& job, Events& events) {
    NearestRays<Events>(job, events).run();
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
