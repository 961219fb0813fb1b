#include "gmap/sew.h"

#include <cstdlib>
#include <unordered_map>
#include <utility>
#include <vector>

#include "gmap/access.h"
#include "gmap/orbit.h"
#include "gmap/update.h"

namespace enfilade::gmap::detail {

namespace {

/// Involutions that commute with alpha_i: those at a distance of two or more.
unsigned commuting_generators(int i) {
    unsigned result = 0;
    for (int j = 0; j < 4; ++j)
        if (std::abs(i - j) >= 2) result |= 1u << j;
    return result;
}

/// The pairs that alpha_i would have to link; nothing where they do not match. It is a walk of both orbits at once,
/// kept as one involution so that an orbit sewn to itself cannot be matched two ways.
std::optional<std::vector<std::pair<DartId, DartId>>> matching(const Map& map, int i, DartId d, DartId e) {
    if (!map.contains(d) || !map.contains(e)) return std::nullopt;
    const unsigned generators = commuting_generators(i);
    for (const DartId x : Orbit(map, d, generators))
        if (x == e) return std::nullopt;
    std::unordered_map<std::uint32_t, std::uint32_t> partner;
    std::vector<std::pair<DartId, DartId>> pairs;
    bool matches = true;
    const auto match = [&](DartId x, DartId y) {
        if (map.alpha(i, x) != x || map.alpha(i, y) != y) return matches = false;
        const auto [at_x, x_is_new] = partner.try_emplace(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
        const auto [at_y, y_is_new] = partner.try_emplace(static_cast<std::uint32_t>(y), static_cast<std::uint32_t>(x));
        if (x_is_new != y_is_new || partner.at(static_cast<std::uint32_t>(x)) != static_cast<std::uint32_t>(y))
            return matches = false;
        if (x_is_new) pairs.emplace_back(x, y);
        return true;
    };
    if (!match(d, e)) return std::nullopt;
    for (std::size_t next = 0; next < pairs.size() && matches; ++next) {
        const auto [x, y] = pairs[next];
        for (int j = 0; j < 4 && matches; ++j)
            if ((generators >> j) & 1u) match(map.alpha(j, x), map.alpha(j, y));
    }
    if (!matches) return std::nullopt;
    return pairs;
}

void update_other_dimensions(Map& map, int i, const std::vector<DartId>& touched, Changes& changes) {
    for (int j = 0; j < 4; ++j)
        if (j != i) update_cells(map, j, touched, changes);
}

}  // namespace

bool is_sewable(const Map& map, int i, DartId d, DartId e) { return matching(map, i, d, e).has_value(); }

std::optional<Changes> sew(Map& map, int i, DartId d, DartId e) {
    const auto pairs = matching(map, i, d, e);
    if (!pairs) return std::nullopt;
    Changes changes;
    changes.dart = d;
    std::vector<DartId> touched;
    for (const auto& [x, y] : *pairs) {
        MapAccess::link(map, i, x, y);
        touched.push_back(x);
    }
    update_other_dimensions(map, i, touched, changes);
    return changes;
}

std::optional<Changes> unsew(Map& map, int i, DartId d) {
    if (!map.contains(d) || map.alpha(i, d) == d) return std::nullopt;
    Changes changes;
    changes.dart = d;
    std::vector<DartId> touched;
    std::vector<DartId> images;
    for (const DartId x : Orbit(map, d, commuting_generators(i))) {
        touched.push_back(x);
        images.push_back(map.alpha(i, x));
    }
    for (std::size_t k = 0; k < images.size(); ++k) {
        MapAccess::link(map, i, touched[k], touched[k]);
        MapAccess::link(map, i, images[k], images[k]);
    }
    touched.insert(touched.end(), images.begin(), images.end());
    update_other_dimensions(map, i, touched, changes);
    return changes;
}

}  // namespace enfilade::gmap::detail
