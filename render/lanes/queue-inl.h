// Rays that wait for others in the same cell: when as many wait as a register holds, they leave it together.
// No include guard: lanes.cpp includes it once for every instruction set.

#include <cstdlib>

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

/// What is kept of a ray that waits: its line, its limit, and which one it is.
struct Waiting {
    V ox, oy, oz, dx, dy, dz;
    V limit;     ///< parameter
    Numbers id;  ///< `Queues::ray_bits` bits of its place in the stream, and the number of cells it has crossed
};

/// A queue for each of some cells. A cell whose queue another one holds has none.
class Queues {
public:
    static constexpr std::uint32_t ray_bits = 18;
    static constexpr std::uint32_t slots = 1024;

    Queues() : memory_(static_cast<Memory*>(std::aligned_alloc(64, sizeof(Memory)))) {
        if (memory_ == nullptr) return;
        for (Slot& slot : memory_->slot) slot = {0, 0};
    }
    ~Queues() { std::free(memory_); }
    Queues(const Queues&) = delete;
    Queues& operator=(const Queues&) = delete;

    /// Without memory there are no queues at all.
    [[nodiscard]] bool exist() const { return memory_ != nullptr; }

    /// Puts the rays of some lanes into the queues of their cells. Returns those for which there was no room.
    HWY_INLINE Bits push(const Waiting& rays, Numbers cells, Bits lanes) {
        HWY_ALIGN float first[4 * lane_count];
        HWY_ALIGN float second[4 * lane_count];
        HWY_ALIGN std::int32_t cell[lane_count];
        hn::StoreInterleaved4(rays.ox, rays.oy, rays.oz, rays.dx, D(), first);
        hn::StoreInterleaved4(rays.dy, rays.dz, rays.limit, hn::BitCast(D(), rays.id), D(), second);
        hn::Store(cells, DI(), cell);
        const hn::Full128<float> four;
        Bits refused = 0;
        for (; lanes != 0; lanes &= lanes - 1) {
            const std::uint32_t lane = lowest_bit(lanes);
            const auto here = static_cast<std::uint32_t>(cell[lane]);
            const std::uint32_t s = here % slots;
            Slot& slot = memory_->slot[s];
            if (slot.count == 0) slot.cell = here;
            const std::uint32_t n = slot.count;
            if (HWY_UNLIKELY(slot.cell != here || n == capacity)) {
                refused |= Bits(1) << lane;
                continue;
            }
            hn::Store(hn::Load(four, first + 4 * lane), four, memory_->first[s][n]);
            hn::Store(hn::Load(four, second + 4 * lane), four, memory_->second[s][n]);
            slot.count = n + 1;
            if (n + 1 == lane_count) ready_[ready_count_++] = static_cast<std::uint16_t>(s);
        }
        return refused;
    }

    /// Calls walk.step(rays, cell, mask) for the rays of queues that fill a register, until there is none.
    template <class Walk>
    HWY_INLINE void serve_full(Walk& walk) {
        while (ready_count_ > 0) serve(ready_[--ready_count_], walk);
    }
    /// The same until nobody waits.
    template <class Walk>
    HWY_NOINLINE void serve_all(Walk& walk) {
        for (bool any = true; any;) {
            any = false;
            for (std::uint32_t s = 0; s < slots; ++s) {
                if (memory_->slot[s].count == 0) continue;
                any = true;
                serve(s, walk);
                serve_full(walk);
            }
        }
    }

private:
    template <class Walk>
    HWY_INLINE void serve(std::uint32_t s, Walk& walk) {
        Waiting rays;
        const std::uint32_t cell = memory_->slot[s].cell;
        const std::uint32_t count = take(s, rays);
        walk.step(rays, cell, hn::FirstN(D(), count));
    }
    /// Takes the last ones of a queue, as many as a register holds. Returns how many.
    HWY_INLINE std::uint32_t take(std::uint32_t s, Waiting& rays) {
        Slot& slot = memory_->slot[s];
        const std::uint32_t taken = slot.count < lane_count ? slot.count : lane_count;
        slot.count -= taken;
        V id;
        hn::LoadInterleaved4(D(), memory_->first[s][slot.count], rays.ox, rays.oy, rays.oz, rays.dx);
        hn::LoadInterleaved4(D(), memory_->second[s][slot.count], rays.dy, rays.dz, rays.limit, id);
        rays.id = hn::BitCast(DI(), id);
        if (slot.count >= lane_count) ready_[ready_count_++] = static_cast<std::uint16_t>(s);
        return taken;
    }

    static constexpr std::uint32_t capacity = 3 * lane_count;
    struct Slot {
        std::uint32_t cell, count;
    };
    struct Memory {
        float first[slots][capacity][4];
        float second[slots][capacity][4];
        float behind[lane_count][4];  // a register is read at once, whatever waits
        Slot slot[slots];
    };
    Memory* memory_;
    std::uint32_t ready_count_ = 0;
    std::uint16_t ready_[slots];  // those with a register's number or more, each once
};

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
