#include "tools/suggestion.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace enfilade::tools {

namespace {
/// Letters to add, drop or change (Levenshtein).
std::size_t distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t(0));
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({changed, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}
}  // namespace

std::string suggestion(std::string_view word, std::span<const std::string> known) {
    const std::string* nearest = nullptr;
    std::size_t least = word.size() / 3 + 2;
    for (const std::string& candidate : known) {
        const std::size_t far = distance(word, candidate);
        if (far < least) {
            least = far;
            nearest = &candidate;
        }
    }
    return nearest == nullptr ? "" : " (did you mean \"" + *nearest + "\"?)";
}

}  // namespace enfilade::tools
