// Columns of rays, sixteen at a time.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

/// Rays of a stream that are walked together.
inline constexpr int stream_rays = 16;
using Lanes = Floats<stream_rays>;

/// Some of them, by their places in it.
struct Batch {
    std::uint64_t index[stream_rays];
    int size;
};

template <class Job>
HWY_INLINE Batch batch_at(const Job& job, std::uint64_t k) {
    Batch batch;
    batch.size = static_cast<int>(job.end - k < stream_rays ? job.end - k : stream_rays);
    for (int i = 0; i < stream_rays; ++i) {
        const std::uint64_t place = k + static_cast<std::uint64_t>(i < batch.size ? i : 0);
        batch.index[i] = job.order != nullptr ? job.order[place] : place;
    }
    return batch;
}

template <class Job>
HWY_INLINE Lanes column(const Job& job, const float* values, const Batch& batch) {
    if (job.order == nullptr && batch.size == stream_rays) return load<stream_rays>(values + batch.index[0]);
    HWY_ALIGN float lanes[stream_rays];
    for (int i = 0; i < stream_rays; ++i) lanes[i] = values[batch.index[i]];
    return load<stream_rays>(lanes);
}

template <class Job>
HWY_INLINE Points<stream_rays> columns(const Job& job, const float* const* values, const Batch& batch) {
    return {column(job, values[0], batch), column(job, values[1], batch), column(job, values[2], batch)};
}

/// Directions for which no scaling is needed (make_ray), and origins that are finite; the others go one by one.
HWY_INLINE Bits plain_rays(const Points<stream_rays>& o, const Points<stream_rays>& d) {
    const Lanes longest = largest(largest(magnitude_of(d.x), magnitude_of(d.y)), magnitude_of(d.z));
    const Lanes level = largest(magnitude_of(d.x), magnitude_of(d.y));
    const Lanes place = largest(largest(magnitude_of(o.x), magnitude_of(o.y)), magnitude_of(o.z));
    const Lanes sum = d.x + d.y + d.z + o.x + o.y + o.z;  // NaN if one of them is; Max may lose it
    return is_at_most(longest, Lanes(0x1p20f)) & is_at_most(Lanes(0x1p-20f), longest) &
           is_at_most(longest * Lanes(0x1p-30f), level) & is_at_most(place, Lanes(1e12f)) & is_equal(sum, sum);
}

/// The places in the stream of some lanes of a batch.
struct Places {
    std::uint32_t index[stream_rays];
    std::uint32_t count = 0;

    Places(const Batch& batch, Bits lanes) {
        for (; lanes != 0; lanes &= lanes - 1)
            index[count++] = static_cast<std::uint32_t>(batch.index[lowest_bit(lanes)]);
    }
};

/// Lanes of a batch that are walked one by one, by the scalar kernel.
template <class Job>
HWY_NOINLINE void walk_alone(const Job& job, const Batch& batch, Bits lanes, void (*kernel)(const Job&)) {
    const Places places(batch, lanes);
    Job part = job;
    part.order = places.index;
    part.begin = 0;
    part.end = places.count;
    kernel(part);
}

/// Lanes by the cells in which they start. Where they are spread over many cells they share nothing: returns false.
HWY_INLINE bool group_by_cell(const accel::CellId* cells, const Batch& batch, Bits lanes, Groups& groups) {
    constexpr int most_groups = 6;
    for (; lanes != 0; lanes &= lanes - 1) {
        const std::uint32_t lane = lowest_bit(lanes);
        groups.add(static_cast<std::uint32_t>(cells[batch.index[lane]]), 1u << lane);
        if (groups.size > most_groups) return false;
    }
    return true;
}

/// Shadow rays: they end where they enter their goal's cell, for cells are convex.
struct Sight {
    const std::uint32_t* goal;
    Bits seen = 0;

    HWY_INLINE void hit(const Way&, std::uint32_t, const Crossings<stream_rays>&) {}
    HWY_INLINE void reached(Bits which, std::uint32_t) { seen |= which; }
    HWY_INLINE void leaked(Bits, std::uint32_t) {}
    HWY_INLINE Bits enter(Bits which, std::uint32_t cell) {
        Bits there = 0;
        for (int k = 0; k < Lanes::vectors; ++k)
            there |= bits_of(hn::RebindMask(D(), hn::Eq(hn::Load(DU(), goal + k * lane_count), hn::Set(DU(), cell))))
                     << (k * lane_count);
        there &= which;
        seen |= there;
        return there;
    }
};

template <class Events>
void visible_segments(const detail::SegmentJob& job, Events& events) {
    const accel::SceneView scene = *job.scene;
    for (std::uint64_t k = job.begin; k < job.end; k += stream_rays) {
        const Batch batch = batch_at(job, k);
        const Bits present = all_bits<stream_rays> >> (stream_rays - batch.size);
        const Points<stream_rays> p = columns(job, job.from, batch), q = columns(job, job.to, batch);
        const Points<stream_rays> d = {q.x - p.x, q.y - p.y, q.z - p.z};
        Bits lanes = present & plain_rays(p, d);
        HWY_ALIGN std::uint32_t goal[stream_rays];
        Bits same = 0;
        for (int i = 0; i < stream_rays; ++i) {
            goal[i] = job.to_cell != nullptr ? static_cast<std::uint32_t>(job.to_cell[batch.index[i]]) : no_section;
            same |= static_cast<Bits>(static_cast<std::uint32_t>(job.from_cell[batch.index[i]]) == goal[i]) << i;
        }
        Sight sight{goal, same & lanes};
        Groups groups;
        Bits walking = lanes & ~same;
        if (!group_by_cell(job.from_cell, batch, walking, groups)) {
            lanes &= ~walking;
            walking = 0;
        }
        if (lanes != present) walk_alone(job, batch, present & ~lanes, detail::kernels().visible);
        if (walking != 0) {
            for (Bits left = walking; left != 0; left &= left - 1) events.began_walk();
            Tints<stream_rays> tints;
            walk_together(scene, make_rays(p, d), groups, Limits<stream_rays>{Lanes(1)}, tints, sight, events);
        }
        for (Bits left = lanes; left != 0; left &= left - 1) {
            const std::uint32_t lane = lowest_bit(left);
            job.visible[batch.index[lane]] = static_cast<std::uint8_t>(sight.seen >> lane & 1u);
        }
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
