#pragma once
// Inside of accel/octree: memory for arrays that rays read here and there. Where the system can, it comes in pages of
// 2 MB, so that the processor finds where they lie without asking for that, too.

#include <cstddef>
#include <limits>
#include <new>
#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace enfilade::accel {

/// An allocator as std::allocator.
template <class T>
struct LargePages {
    using value_type = T;
    static constexpr std::size_t page = std::size_t{1} << 21;

    LargePages() = default;
    template <class U>
    explicit LargePages(const LargePages<U>&) {}

    [[nodiscard]] T* allocate(std::size_t count) {
        if (count > std::numeric_limits<std::size_t>::max() / 2 / sizeof(T)) throw std::bad_array_new_length();
        const std::size_t bytes = count * sizeof(T);
        void* memory = ::operator new(bytes, alignment(bytes));
#if defined(__linux__)
        // Advice: where it is not followed nothing changes but the speed.
        if (bytes >= page) (void)::madvise(memory, bytes, MADV_HUGEPAGE);
#endif
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t count) { ::operator delete(memory, alignment(count * sizeof(T))); }
    friend bool operator==(const LargePages&, const LargePages&) { return true; }

private:
    static std::align_val_t alignment(std::size_t bytes) { return std::align_val_t{bytes >= page ? page : 64}; }
};

}  // namespace enfilade::accel
