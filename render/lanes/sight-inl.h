// Shadow rays. Neighbours mostly leave their cell by one section, and most of those are walls: one ray is asked for
// its section, and the others whether it is theirs, too. What is left waits in queues, as nearest-inl.h.
// No include guard: lanes.cpp includes it once for every instruction set.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

/// One section of a cell.
struct Wall {
    float px, py, qx, qy;
    std::uint32_t first_face, top_face;

    HWY_INLINE Wall(const accel::SceneView& scene, const accel::Cell& cell, std::uint32_t i) {
        const std::uint32_t p = cell.first_section + i;
        const std::uint32_t q = i + 1 == cell.section_count ? cell.first_section : p + 1;
        px = scene.section_x[p];
        py = scene.section_y[p];
        qx = scene.section_x[q];
        qy = scene.section_y[q];
        first_face = scene.section_tails[p].first_face;
        top_face = scene.section_tails[p + 1].first_face - 1;
    }
    /// Whether nothing passes the prism there.
    [[nodiscard]] HWY_INLINE bool is_closed(const accel::SceneView& scene, const accel::Cell& cell) const {
        std::uint32_t targets = cell.floor.bits | cell.ceiling.bits;
        for (std::uint32_t face = first_face; face <= top_face; ++face) targets |= scene.side_faces[face].target.bits;
        return targets <= accel::Target::index_mask;
    }
};

template <class Events>
class Sights {
public:
    Sights(const detail::SegmentJob& job, Events& events)
        : job_(job),
          columns_{job.order},
          scene_(*job.scene),
          events_(events),
          extent_(extent_of(scene_)),
          noise_(noise_of(extent_)),
          margin_(noise_ + 2 * static_cast<float>(scene_.unit)),
          alone_(job, detail::kernels().visible) {}

    void run() { serve_stream(*this); }

    /// Rays of the mask leave their cell, each by its own section.
    HWY_INLINE void step(const Waiting& rays, std::uint32_t cell, Mask mask) {
        const accel::Cell& c = scene_.cells[cell];
        const Beams beams(rays.ox, rays.oy, rays.oz, rays.dx, rays.dy, rays.dz, noise_);
        const Departure to = leave_prism(scene_, c, beams, mask);
        const Mask reached = hn::And(to.sure, is_end_before(to));
        const Mask passes = hn::AndNot(reached, hn::And(to.sure, is_portal(to.target)));
        const Numbers next = neighbours(to.target);
        const Mask arrives = hn::And(passes, as_mask(hn::Eq(next, goal_of(rays))));
        const Bits sure = bits_of(to.sure), seen = bits_of(hn::Or(reached, arrives)), going = bits_of(passes) & ~seen;
        count_steps(c, sure, sure & ~going);
        count_glass(to.target, bits_of(passes));
        const Bits doubtful = bits_of(mask) & ~sure;
        if (HWY_UNLIKELY(doubtful != 0)) leave_alone(rays.id, doubtful);
        HWY_ALIGN std::int32_t id[lane_count];
        hn::Store(rays.id, DI(), id);
        for (Bits left = sure & ~going; left != 0; left &= left - 1) {
            const std::uint32_t lane = lowest_bit(left);
            job_.visible[ray_of(id[lane])] = static_cast<std::uint8_t>(seen >> lane & 1u);
        }
        if (going != 0) push(rays, next, going);
    }

private:
    template <class Walk>
    friend void serve_stream(Walk& walk);

    HWY_INLINE static Numbers neighbours(Numbers target) {
        return hn::And(target, hn::Set(DI(), static_cast<std::int32_t>(accel::Target::index_mask)));
    }
    HWY_INLINE static Numbers goal_of(const Waiting& rays) { return hn::BitCast(DI(), rays.limit); }
    [[nodiscard]] HWY_INLINE std::uint64_t ray_of(std::int32_t id) const {
        return columns_.ray_at(first_ + (static_cast<std::uint32_t>(id) & ((1u << Queues::ray_bits) - 1)));
    }
    HWY_NOINLINE void leave_alone(Numbers ids, Bits lanes) {
        HWY_ALIGN std::int32_t id[lane_count];
        hn::Store(ids, DI(), id);
        for (; lanes != 0; lanes &= lanes - 1) alone_.add(ray_of(id[lowest_bit(lanes)]));
    }
    HWY_NOINLINE void push(Waiting rays, Numbers cells, Bits lanes) {
        rays.id = hn::Add(rays.id, hn::Set(DI(), 1 << Queues::ray_bits));
        const Bits turning = lanes & bits_of(as_mask(hn::Lt(rays.id, hn::Zero(DI()))));
        const Bits refused = queues_.push(rays, cells, lanes & ~turning);
        if (HWY_UNLIKELY((refused | turning) != 0)) leave_alone(rays.id, refused | turning);
    }

    HWY_INLINE void count_steps(const accel::Cell& cell, Bits steps, Bits ends) {
        for (; steps != 0; steps &= steps - 1) events_.entered_cell(cell.section_count);
        for (; ends != 0; ends &= ends - 1) events_.began_walk();  // once a ray
    }
    HWY_INLINE void count_glass(Bits passing) {
        for (; passing != 0; passing &= passing - 1) events_.crossed_glass();
    }
    HWY_INLINE void count_glass(Numbers targets, Bits passing) {
        if constexpr (!std::is_same_v<Events, NoEvents>) {
            HWY_ALIGN std::int32_t target[lane_count];
            hn::Store(targets, DI(), target);
            for (; passing != 0; passing &= passing - 1)
                if (accel::Target{static_cast<std::uint32_t>(target[lowest_bit(passing)])}.is_glass())
                    events_.crossed_glass();
        } else {
            (void)targets, (void)passing;
        }
    }

    /// Rays that start together. What becomes of those that are not answered at once is done after the answers of all
    /// were written.
    struct Batch {
        Waiting rays;
        Bits seen = 0, doubtful = 0, waiting = 0;
        HWY_ALIGN std::int32_t cell[lane_count];  // of those that wait

        HWY_INLINE void wait(Bits lanes, std::uint32_t in) {
            waiting |= lanes;
            for (; lanes != 0; lanes &= lanes - 1) cell[lowest_bit(lanes)] = static_cast<std::int32_t>(in);
        }
    };

    HWY_INLINE void begin(std::uint64_t k, std::uint32_t count) {
        for (int axis = 0; axis < 3; ++axis) {
            columns_.ask_for(job_.from[axis], k);
            columns_.ask_for(job_.to[axis], k);
        }
        columns_.ask_for(job_.from_cell, k);
        if (job_.to_cell != nullptr) columns_.ask_for(job_.to_cell, k);
        Batch batch;
        Waiting& rays = batch.rays;
        rays.ox = columns_.column(job_.from[0], k, count);
        rays.oy = columns_.column(job_.from[1], k, count);
        rays.oz = columns_.column(job_.from[2], k, count);
        const V qx = columns_.column(job_.to[0], k, count), qy = columns_.column(job_.to[1], k, count);
        const V qz = columns_.column(job_.to[2], k, count);
        rays.dx = hn::Sub(qx, rays.ox);
        rays.dy = hn::Sub(qy, rays.oy);
        rays.dz = hn::Sub(qz, rays.oz);
        rays.id = numbers_from(k - first_);
        const Numbers cells = columns_.cells(job_.from_cell, k, count);
        const Numbers goals = job_.to_cell != nullptr ? columns_.cells(job_.to_cell, k, count) : hn::Set(DI(), -1);
        rays.limit = hn::BitCast(D(), goals);
        const Mask present = count == lane_count ? hn::FirstN(D(), lane_count) : hn::FirstN(D(), count);
        const Mask near = hn::And(present, are_places(rays, qx, qy, qz));
        const Mask same = hn::And(near, as_mask(hn::Eq(cells, goals)));
        const Mask walks = hn::AndNot(same, hn::And(near, are_level(rays)));
        batch.seen = bits_of(same);
        const Bits walking = bits_of(walks);
        batch.doubtful = bits_of(present) & ~batch.seen & ~walking;
        if (walking != 0) {
            const auto cell = static_cast<std::uint32_t>(hn::GetLane(cells));
            const Bits here = bits_of(as_mask(hn::Eq(cells, hn::Set(DI(), static_cast<std::int32_t>(cell)))));
            hn::Store(cells, DI(), batch.cell);
            batch.waiting = walking & ~here;
            if ((walking & here) != 0) follow(batch, qx, qy, cell, walking & here);
        }
        answer(k, count, batch.seen);
        if (HWY_UNLIKELY(batch.doubtful != 0)) leave_alone(rays.id, batch.doubtful);
        if (batch.waiting != 0) push(rays, hn::Load(DI(), batch.cell), batch.waiting);
    }

    /// Points about the scene. NaN fails.
    HWY_INLINE Mask are_places(const Waiting& rays, V qx, V qy, V qz) const {
        const V plan = hn::MulAdd(rays.ox, rays.ox, hn::MulAdd(rays.oy, rays.oy, hn::MulAdd(qx, qx, hn::Mul(qy, qy))));
        const V heights = hn::MulAdd(rays.oz, rays.oz, hn::Mul(qz, qz));
        const V most = hn::Set(D(), 4 * extent_ * extent_);
        return hn::Le(hn::MulAdd(heights, hn::Set(D(), 4e-12f * extent_ * extent_), plan), most);
    }
    /// Directions of which no product is lost.
    HWY_INLINE static Mask are_level(const Waiting& rays) {
        const V flat = hn::MulAdd(rays.dx, rays.dx, hn::Mul(rays.dy, rays.dy)), least = hn::Set(D(), 0x1p-30f);
        return hn::Le(hn::MulAdd(hn::Mul(rays.dz, rays.dz), least, least), flat);
    }

    HWY_INLINE void answer(std::uint64_t k, std::uint32_t count, Bits seen) {
        if (columns_.are_neighbours(count)) {
            using D8 = hn::CappedTag<std::uint8_t, lane_count>;
            std::uint8_t bytes[8];
            const std::uint64_t part = seen;
            std::memcpy(bytes, &part, 8);
            hn::StoreU(hn::IfThenElseZero(hn::LoadMaskBits(D8(), bytes), hn::Set(D8(), 1)), D8(), job_.visible + k);
        } else {
            for (std::uint32_t i = 0; i < count; ++i)
                job_.visible[columns_.ray_at(k + i)] = static_cast<std::uint8_t>(seen >> i & 1u);
        }
    }

    /// The section by which one ray leaves a cell, counted from the cell's first: all lines at once. `no_section`
    /// if there is none. Behind a cell's lines come others, and zeros behind the scene's.
    HWY_INLINE static std::uint32_t section_of(const accel::SceneView& scene, const accel::Cell& cell,
                                               const Beams& beams, std::uint32_t lane) {
        const auto number = hn::IndicesFromVec(D(), hn::Set(DI(), static_cast<std::int32_t>(lane)));
        const V dx = hn::TableLookupLanes(beams.dx, number), minus_dy = hn::TableLookupLanes(beams.minus_dy, number);
        const V moment = hn::TableLookupLanes(beams.moment, number);
        const std::uint32_t count = cell.section_count;
        std::uint32_t first_left = 0, before = 1;
        for (std::uint32_t begin = 0; begin < count; begin += 64) {
            const std::uint32_t size = count - begin < 64 ? count - begin : 64;
            const float* xs = scene.section_x.first + cell.first_section + begin;
            const float* ys = scene.section_y.first + cell.first_section + begin;
            std::uint64_t left = 0;
            for (std::uint32_t i = 0; i < size; i += lane_count) {
                const V side =
                    hn::MulAdd(hn::LoadU(D(), ys + i), dx, hn::MulAdd(hn::LoadU(D(), xs + i), minus_dy, moment));
                left |= std::uint64_t(bits_of(hn::Gt(side, hn::Zero(D())))) << i;
            }
            if (before == 0 && (left & 1u) != 0) return begin - 1;
            if (begin == 0) first_left = left & 1u;
            const std::uint64_t accepting = ~left & left >> 1 & (~std::uint64_t(0) >> (64 - size) >> 1);
            if (accepting != 0) return begin + static_cast<std::uint32_t>(__builtin_ctzll(accepting));
            before = static_cast<std::uint32_t>(left >> (size - 1)) & 1u;
        }
        return before == 0 && first_left != 0 ? count - 1 : no_section;
    }

    /// Neighbours from one cell to their goals.
    HWY_INLINE void follow(Batch& batch, V qx, V qy, std::uint32_t cell, Bits walking) {
        const Waiting& rays = batch.rays;
        const Beams beams(rays.ox, rays.oy, rays.oz, rays.dx, rays.dy, rays.dz, margin_);
        constexpr int few = 3;             // so many are cheaper in a queue
        constexpr int most_sections = 24;  // of all cells together
        struct {
            std::uint32_t cell;
            Bits rays;
        } group[most_sections + 2];
        int size = 1;
        group[0] = {cell, walking};
        // Neighbours towards the same room before these left by the section that these leave by, more often than not.
        Guess& guess = guesses_[(cell + 7 * static_cast<std::uint32_t>(hn::GetLane(goal_of(rays)))) % guess_count];
        bool is_guessed = guess.cell == cell;
        for (int asked = 0; size > 0;) {
            const std::uint32_t in = group[size - 1].cell;
            const accel::Cell& c = scene_.cells[in];
            Bits left = group[--size].rays;
            while (left != 0) {
                if (asked == most_sections || HWY_UNLIKELY(__builtin_popcount(left) < few)) {
                    batch.wait(left, in);
                    break;
                }
                ++asked;
                const bool was_guessed = is_guessed;
                const std::uint32_t section =
                    is_guessed ? guess.section : section_of(scene_, c, beams, lowest_bit(left));
                is_guessed = false;
                if (HWY_UNLIKELY(section == no_section)) {
                    batch.wait(left, in);
                    break;
                }
                const Wall wall(scene_, c, section);
                const Bits through = pass(batch, beams, qx, qy, c, wall, left, [&](std::uint32_t next, Bits going) {
                    group[size++] = {next, going};
                });
                if (!was_guessed) guess = {in, section};
                if (through == 0 && !was_guessed) {
                    batch.wait(left, in);
                    break;
                }
                left &= ~through;
            }
        }
    }

    /// Those that surely leave the cell by a section are answered or go on. Returns them.
    template <class GoOn>
    HWY_INLINE Bits pass(Batch& batch, const Beams& beams, V qx, V qy, const accel::Cell& cell, const Wall& wall,
                         Bits rays, const GoOn& go_on) {
        const V wall_px = hn::Set(D(), wall.px), wall_py = hn::Set(D(), wall.py);
        const V p_side = beams.side(wall_px, wall_py);
        const V q_side = beams.side(hn::Set(D(), wall.qx), hn::Set(D(), wall.qy));
        const Bits sure = rays & bits_of(hn::And(hn::Lt(p_side, hn::Neg(beams.noise)), hn::Gt(q_side, beams.noise)));
        if (wall.is_closed(scene_, cell)) {
            // Whoever ends behind its plane is stopped by it, or by a floor or ceiling before it.
            const float nx = wall.qy - wall.py, ny = wall.px - wall.qx;
            const float noise = noise_ * ((nx < 0 ? -nx : nx) + (ny < 0 ? -ny : ny));
            const V behind =
                hn::MulAdd(hn::Sub(qx, wall_px), hn::Set(D(), nx), hn::Mul(hn::Sub(qy, wall_py), hn::Set(D(), ny)));
            const Bits stopped = sure & bits_of(hn::Gt(behind, hn::Set(D(), noise)));
            if (HWY_LIKELY(stopped == sure)) {
                count_steps(cell, stopped, stopped);
                return stopped;
            }
        }
        return pass_faces(batch, beams, p_side, q_side, cell, wall, sure, go_on);
    }

    template <class GoOn>
    HWY_INLINE Bits pass_faces(Batch& batch, const Beams& beams, V p_side, V q_side, const accel::Cell& cell,
                               const Wall& wall, Bits sure, const GoOn& go_on) {
        const V zero = hn::Zero(D());
        const V flat = hn::Add(hn::Mul(beams.dx, beams.dx), hn::Mul(beams.dy, beams.dy));
        const V num = hn::Sub(hn::Mul(q_side, beams.along(hn::Set(D(), wall.px), hn::Set(D(), wall.py))),
                              hn::Mul(p_side, beams.along(hn::Set(D(), wall.qx), hn::Set(D(), wall.qy))));
        const V den = hn::Mul(hn::Sub(q_side, p_side), flat);
        const V scaled_dz = hn::Mul(num, beams.dz);
        const Mask descends = hn::Lt(beams.dz, zero), climbs = hn::Lt(zero, beams.dz);
        const V level = hn::IfThenElse(descends, hn::Set(D(), cell.z_floor), hn::Set(D(), cell.z_ceiling));
        const V rise = hn::Sub(level, beams.oz);
        const Mask is_below = hn::Lt(scaled_dz, hn::Mul(rise, den));
        const Mask down = hn::And(descends, is_below), up = hn::AndNot(is_below, climbs);
        // Few branches: which of the faces rays meet is hard to guess.
        const Bits by_floor = sure & bits_of(down), by_ceiling = sure & bits_of(up);
        const Bits past_wall = bits_of(hn::Lt(num, den));  // else the end lies before
        const Bits past_level =
            bits_of(hn::Or(hn::And(descends, hn::Gt(rise, beams.dz)), hn::And(climbs, hn::Lt(rise, beams.dz))));
        count_steps(cell, sure, 0);
        const auto leave = [&](Bits lanes, Bits past, accel::Target target) HWY_ATTR {
            batch.seen |= lanes & ~past;
            Bits going = 0;
            if (target.is_portal()) {
                going = lanes & past;
                if (target.is_glass()) count_glass(going);
                const auto next = static_cast<std::uint32_t>(target.neighbour());
                const Numbers goal = hn::Set(DI(), static_cast<std::int32_t>(next));
                const Bits arriving = going & bits_of(as_mask(hn::Eq(goal_of(batch.rays), goal)));
                batch.seen |= arriving;
                going &= ~arriving;
                if (going != 0) go_on(next, going);
            }
            count_steps(cell, 0, lanes & ~going);
        };
        leave(by_floor, past_level, cell.floor);
        leave(by_ceiling, past_level, cell.ceiling);
        Bits left = sure & ~(by_floor | by_ceiling);
        for (std::uint32_t face = wall.first_face; face < wall.top_face; ++face) {
            const accel::SideFace& side = scene_.side_faces[face];
            const V top = hn::Sub(hn::Set(D(), side.z_top), beams.oz);
            const Bits here = left & bits_of(hn::Lt(scaled_dz, hn::Mul(top, den)));
            leave(here, past_wall, side.target);
            left &= ~here;
        }
        leave(left, past_wall, scene_.side_faces[wall.top_face].target);
        return sure;
    }

    /// Where the point at parameter 1 lies before the departures, or on them: as ToPoint.
    HWY_INLINE static Mask is_end_before(const Departure& to) {
        const Mask descends = hn::Lt(to.den, hn::Zero(D()));
        return hn::Or(hn::AndNot(descends, hn::Ge(to.num, to.den)), hn::And(descends, hn::Le(to.num, to.den)));
    }

    const detail::SegmentJob job_;
    const Columns columns_;
    const accel::SceneView scene_;
    Events& events_;
    const float extent_, noise_;
    const float margin_;  ///< of sides by which a section is surely the only one: the grid may bend a wall inwards
    struct Guess {
        std::uint32_t cell = no_cell, section = 0;
    };
    static constexpr std::uint32_t guess_count = 64;
    std::uint64_t first_ = 0;
    Guess guesses_[guess_count];
    Queues queues_;
    Alone<detail::SegmentJob> alone_;
};

template <class Events>
void visible_segments(const detail::SegmentJob& job, Events& events) {
    Sights<Events>(job, events).run();
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
