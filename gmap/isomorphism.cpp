#include "gmap/isomorphism.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace enfilade::gmap {

namespace {

using Colors = std::vector<std::uint64_t>;

std::uint64_t mixed(std::uint64_t x) {  // the finaliser of splitmix64
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
    return x ^ (x >> 31);
}

Colors first_colors(const Map& map, const DartLabel& label) {
    Colors colors(map.dart_bound(), 0);
    for (const DartId d : map.darts()) {
        std::uint64_t color = label ? mixed(label(d) + 0x9E3779B97F4A7C15u) : 1;
        for (int i = 0; i < 4; ++i) color = mixed(2 * color + (map.alpha(i, d) == d ? 1 : 0));
        colors[index(d)] = color;
    }
    return colors;
}

Colors refined(const Map& map, const Colors& colors) {
    Colors result(colors.size(), 0);
    for (const DartId d : map.darts()) {
        std::uint64_t color = mixed(colors[index(d)] + 1);
        for (int i = 0; i < 4; ++i) color = mixed(3 * color + colors[index(map.alpha(i, d))]);
        result[index(d)] = color;
    }
    return result;
}

/// The colours of the darts in use, sorted: two maps with different ones are different.
Colors histogram(const Map& map, const Colors& colors) {
    Colors sorted;
    sorted.reserve(map.dart_count());
    for (const DartId d : map.darts()) sorted.push_back(colors[index(d)]);
    std::sort(sorted.begin(), sorted.end());
    return sorted;
}

std::size_t class_count(const Colors& sorted) {
    std::size_t count = sorted.empty() ? 0 : 1;
    for (std::size_t k = 1; k < sorted.size(); ++k) count += sorted[k] != sorted[k - 1] ? 1 : 0;
    return count;
}

/// Grows a partial isomorphism piece by piece; a piece that fails is taken back.
class Matcher {
public:
    Matcher(const Map& a, const Map& b)
        : a_(a), b_(b), image_(a.dart_bound(), none<DartId>), origin_(b.dart_bound(), none<DartId>) {}

    bool match_piece(DartId from, DartId to, const Colors* colors_a, const Colors* colors_b) {
        if (image_[index(from)] != none<DartId> || origin_[index(to)] != none<DartId>) return false;
        pairs_.assign(1, {from, to});
        set(from, to);
        bool matches = colors_a == nullptr || (*colors_a)[index(from)] == (*colors_b)[index(to)];
        for (std::size_t k = 0; k < pairs_.size() && matches; ++k) {
            const auto [x, y] = pairs_[k];
            for (int i = 0; i < 4 && matches; ++i) {
                const DartId x2 = a_.alpha(i, x);
                const DartId y2 = b_.alpha(i, y);
                if (image_[index(x2)] == none<DartId> && origin_[index(y2)] == none<DartId>) {
                    matches = colors_a == nullptr || (*colors_a)[index(x2)] == (*colors_b)[index(y2)];
                    set(x2, y2);
                    pairs_.emplace_back(x2, y2);
                } else {
                    matches = image_[index(x2)] == y2;
                }
            }
        }
        if (!matches)
            for (const auto& [x, y] : pairs_) {
                image_[index(x)] = none<DartId>;
                origin_[index(y)] = none<DartId>;
            }
        return matches;
    }

    [[nodiscard]] bool is_matched(DartId d) const { return image_[index(d)] != none<DartId>; }
    [[nodiscard]] std::vector<DartId> take() { return std::move(image_); }

private:
    void set(DartId x, DartId y) {
        image_[index(x)] = y;
        origin_[index(y)] = x;
    }

    const Map& a_;
    const Map& b_;
    std::vector<DartId> image_;
    std::vector<DartId> origin_;
    std::vector<std::pair<DartId, DartId>> pairs_;
};

}  // namespace

std::optional<std::vector<DartId>> find_isomorphism(const Map& a, const Map& b, const DartLabel& label_a,
                                                    const DartLabel& label_b) {
    if (a.dart_count() != b.dart_count()) return std::nullopt;
    Colors colors_a = first_colors(a, label_a);
    Colors colors_b = first_colors(b, label_b);
    for (std::size_t classes = 0;;) {
        const Colors sorted = histogram(a, colors_a);
        if (sorted != histogram(b, colors_b)) return std::nullopt;
        const std::size_t now = class_count(sorted);
        if (now == classes) break;
        classes = now;
        colors_a = refined(a, colors_a);
        colors_b = refined(b, colors_b);
    }
    std::unordered_map<std::uint64_t, std::vector<DartId>> b_darts;
    for (const DartId e : b.darts()) b_darts[colors_b[index(e)]].push_back(e);

    // Rare colours first: they leave the fewest darts to try.
    std::vector<DartId> order;
    for (const DartId d : a.darts()) order.push_back(d);
    std::stable_sort(order.begin(), order.end(), [&](DartId x, DartId y) {
        return b_darts.at(colors_a[index(x)]).size() < b_darts.at(colors_a[index(y)]).size();
    });
    Matcher matcher(a, b);
    for (const DartId d : order) {
        if (matcher.is_matched(d)) continue;
        const std::vector<DartId>& candidates = b_darts.at(colors_a[index(d)]);
        // Isomorphy is an equivalence, so that any piece of b that fits is as good as another.
        if (std::none_of(candidates.begin(), candidates.end(),
                         [&](DartId e) { return matcher.match_piece(d, e, &colors_a, &colors_b); }))
            return std::nullopt;
    }
    return matcher.take();
}

bool is_isomorphic(const Map& a, const Map& b, const DartLabel& label_a, const DartLabel& label_b) {
    return find_isomorphism(a, b, label_a, label_b).has_value();
}

std::optional<std::vector<DartId>> extend_isomorphism(const Map& a, DartId from, const Map& b, DartId to) {
    if (!a.contains(from) || !b.contains(to)) return std::nullopt;
    Matcher matcher(a, b);
    if (!matcher.match_piece(from, to, nullptr, nullptr)) return std::nullopt;
    return matcher.take();
}

}  // namespace enfilade::gmap
