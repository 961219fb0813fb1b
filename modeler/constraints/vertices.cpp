// G1: no two vertices of the map at one point.

#include <bit>
#include <map>

#include "modeler/constraints/star_blame.h"

namespace enfilade::modeler {
namespace {

std::size_t hash(const Point3& p) {
    std::uint64_t h = 0x9E3779B97F4A7C15u;
    for (const std::int32_t x : p) {
        h = (h ^ std::uint32_t(x)) * 0xBF58476D1CE4E5B9u;
        h ^= h >> 29;
    }
    return std::size_t(h);
}

/// The vertices that share a point with another one, by the first vertex there.
std::map<std::uint32_t, std::vector<std::uint32_t>> coincident(const FaceRings& rings) {
    std::vector<bool> used(rings.points().size(), false);
    for (std::uint32_t f = 0; f < rings.size(); ++f)
        for (const std::uint32_t v : rings.ring(f)) used[v] = true;
    std::map<std::uint32_t, std::vector<std::uint32_t>> groups;
    std::vector<std::uint32_t> table(std::bit_ceil(2 * used.size() + 2), UINT32_MAX);
    for (std::uint32_t v = 0; v < used.size(); ++v) {
        if (!used[v]) continue;
        const Point3& p = rings.point(v);
        std::size_t slot = hash(p) & (table.size() - 1);
        while (table[slot] != UINT32_MAX && rings.point(table[slot]) != p) slot = (slot + 1) & (table.size() - 1);
        if (table[slot] == UINT32_MAX) {
            table[slot] = v;
            continue;
        }
        auto& group = groups[table[slot]];
        if (group.empty()) group.push_back(table[slot]);
        group.push_back(v);
    }
    return groups;
}

/// Vertices that follow themselves in a ring: edges without length.
void add_loops(const FaceRings& rings, std::map<std::uint32_t, std::vector<std::uint32_t>>& groups) {
    for (std::uint32_t f = 0; f < rings.size(); ++f) {
        const auto ring = rings.ring(f);
        for (std::size_t k = 0; k < ring.size(); ++k)
            if (ring[k] == ring[k + 1 < ring.size() ? k + 1 : 0]) groups.try_emplace(ring[k], 1, ring[k]);
    }
}

}  // namespace

void check_vertices(const Subject& subject, Blame& blame, CheckReport& report) {
    report.codes_checked.emplace_back("G1");
    if (blame.whole_map) {
        ++report.suppressed;
        return;
    }
    auto groups = coincident(subject.rings);
    add_loops(subject.rings, groups);
    StarBlame stars(subject, blame);
    std::vector<std::uint32_t> blamed;
    for (const auto& [first, group] : groups) {
        bool known = true;
        for (const std::uint32_t v : group)
            for (const std::uint32_t f : stars.faces_at(v)) known = known && f < blame.face.size() && blame.face[f];
        if (known) {
            ++report.suppressed;
            continue;
        }
        Finding finding{.code = "G1", .severity = Severity::Error};
        finding.sentence =
            (group.size() > 1 ? std::to_string(group.size()) + " vertices of the model lie at one point, at "
                              : "An edge of the model begins and ends in one vertex, at ") +
            stars.names(first) + ".";
        finding.hint = "Look for walls that end within a grid unit of each other here; a finer --snap-mm parts them.";
        for (const std::uint32_t v : group) stars.place(v, finding);
        blamed.insert(blamed.end(), group.begin(), group.end());
        report.findings.push_back(std::move(finding));
    }
    stars.blame(blamed);
}

}  // namespace enfilade::modeler
