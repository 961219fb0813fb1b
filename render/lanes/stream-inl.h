// Columns of rays, a register at a time, and those that are left to the scalar kernel.
// No include guard: lanes.cpp includes it once for every instruction set.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

/// first, first + 1... By a constant, for Highway's Iota writes and reads memory.
HWY_INLINE Numbers numbers_from(std::uint64_t first) {
    HWY_ALIGN static constexpr std::int32_t places[16] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
    return hn::Add(hn::Load(DI(), places), hn::Set(DI(), static_cast<std::int32_t>(first)));
}

/// Rays of a stream in their order.
struct Columns {
    const std::uint32_t* order;  ///< nullptr: 0, 1, 2...

    [[nodiscard]] HWY_INLINE std::uint64_t ray_at(std::uint64_t k) const { return order != nullptr ? order[k] : k; }
    /// Whether `count` rays fill a register and stand side by side.
    [[nodiscard]] HWY_INLINE bool are_neighbours(std::uint32_t count) const {
        return HWY_LIKELY(order == nullptr && count == lane_count);
    }
    /// Of rays k, k + 1... Behind the last one the first is repeated. 0 < count <= lane_count
    [[nodiscard]] HWY_INLINE V column(const float* values, std::uint64_t k, std::uint32_t count) const {
        if (are_neighbours(count)) return hn::LoadU(D(), values + k);
        HWY_ALIGN float lanes[lane_count];
        fetch(values, k, count, lanes);
        return hn::Load(D(), lanes);
    }
    [[nodiscard]] HWY_INLINE Numbers cells(const accel::CellId* ids, std::uint64_t k, std::uint32_t count) const {
        const auto* numbers = reinterpret_cast<const std::int32_t*>(ids);
        if (are_neighbours(count)) return hn::LoadU(DI(), numbers + k);
        HWY_ALIGN std::int32_t lanes[lane_count];
        fetch(numbers, k, count, lanes);
        return hn::Load(DI(), lanes);
    }

    /// Asks for numbers that are read soon. Columns of one length often begin at the same place of a page, and share
    /// few places of the first cache: they are brought to the second.
    template <class T>
    HWY_INLINE void ask_for(const T* values, std::uint64_t k) const {
        constexpr std::uint64_t ahead = 1536;
        if (order == nullptr) __builtin_prefetch(values + k + ahead, 0, 2);
    }

private:
    template <class T>
    HWY_NOINLINE void fetch(const T* values, std::uint64_t k, std::uint32_t count, T* lanes) const {
        for (std::uint32_t i = 0; i < lane_count; ++i) lanes[i] = values[ray_at(k + (i < count ? i : 0))];
    }
};

/// Rays that are walked one by one, by the scalar kernel: kept until they are worth a call.
template <class Job>
class Alone {
public:
    Alone(const Job& job, void (*kernel)(const Job&)) : job_(job), kernel_(kernel) {}
    HWY_INLINE void add(std::uint64_t ray) {
        rays_[count_++] = static_cast<std::uint32_t>(ray);
        if (HWY_UNLIKELY(count_ == most)) flush();
    }
    HWY_NOINLINE void flush() {
        Job part = job_;
        part.order = rays_;
        part.begin = 0;
        part.end = count_;
        if (count_ > 0) kernel_(part);
        count_ = 0;
    }

private:
    static constexpr std::uint32_t most = 256;
    const Job& job_;
    void (*kernel_)(const Job&);
    std::uint32_t count_ = 0;
    std::uint32_t rays_[most];
};

/// All rays of a walk's stream: as many as its queues number at a time, a register after the other. Those that wait are
/// served when a register is full of them, and at the end.
template <class Walk>
void serve_stream(Walk& walk) {
    constexpr std::uint64_t most = std::uint64_t(1) << Queues::ray_bits;
    for (walk.first_ = walk.job_.begin; walk.first_ < walk.job_.end; walk.first_ += most) {
        const std::uint64_t end = walk.job_.end - walk.first_ < most ? walk.job_.end : walk.first_ + most;
        if (!walk.queues_.exist()) {
            for (std::uint64_t k = walk.first_; k < end; ++k) walk.alone_.add(walk.columns_.ray_at(k));
            continue;
        }
        for (std::uint64_t k = walk.first_; k < end; k += lane_count) {
            walk.begin(k, end - k < lane_count ? static_cast<std::uint32_t>(end - k) : lane_count);
            walk.queues_.serve_full(walk);
        }
        walk.queues_.serve_all(walk);
    }
    walk.alone_.flush();
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
