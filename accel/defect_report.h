#pragma once
// Inside of `validate`: defects as they are found, on any number of threads.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "accel/parallel_for.h"
#include "accel/validate.h"

namespace enfilade::accel::detail {

/// Defects in the order of the elements, whichever chunk was first.
class DefectReport {
public:
    void add(std::size_t order, const char* code, std::string sentence) {
        const std::scoped_lock lock(mutex_);
        if (found_.size() < 4 * defect_limit) found_.push_back({order, {code, std::move(sentence)}});
    }
    [[nodiscard]] bool empty() const { return found_.empty(); }
    std::vector<Defect> take() {
        std::ranges::stable_sort(found_, {}, &Entry::order);
        std::vector<Defect> defects;
        for (Entry& entry : found_)
            if (defects.size() < defect_limit) defects.push_back(std::move(entry.defect));
        found_.clear();
        return defects;
    }

private:
    static constexpr std::size_t defect_limit = 32;
    struct Entry {
        std::size_t order;
        Defect defect;
    };
    std::mutex mutex_;
    std::vector<Entry> found_;
};

inline constexpr std::size_t validate_grain = 16384;  ///< elements a chunk: a few hundred kilobytes

/// Calls is_sound(i) for all i < count; the first failures of each chunk are described.
template <class IsSound, class Describe>
void check_each(const Executor& executor, std::size_t count, const IsSound& is_sound, const Describe& describe) {
    parallel_for(executor, count, validate_grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            if (!is_sound(i)) return describe(i);
    });
}

[[nodiscard]] inline std::string element(const char* array, std::size_t i) {
    return std::string(array) + "[" + std::to_string(i) + "]";
}

[[nodiscard]] inline bool is_finite(float v) { return std::abs(v) <= 3e38f; }  // false for NaN

/// The arrays of furniture: sizes first, the rest only where those fit.
void validate_objects(const SceneView& view, const Executor& executor, DefectReport& report);

/// What materials do besides their colours, and textures: \pre objects and tables were checked.
void validate_looks(const SceneView& view, const Executor& executor, DefectReport& report);

/// Lamps: \pre objects were checked.
void validate_lights(const SceneView& view, const Executor& executor, DefectReport& report);

}  // namespace enfilade::accel::detail
