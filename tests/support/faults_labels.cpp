// S1 and D1.

#include <algorithm>

#include "tests/support/fault_place.h"
#include "tests/support/faults_semantics.h"

namespace enfilade::testing {

using modeler::Building;
using modeler::Direction;
using modeler::Face;
using modeler::Label;
using modeler::Volume;

namespace {

bool is_solid(const Building& building, std::uint32_t v) { return !carries_light(building.volumes[v].label); }

ElementRef element(const Building& building, std::uint32_t volume) {
    return {"", building.spaces[building.volumes[volume].space].id, ""};
}

std::optional<InjectedFault> another_label(Building& building, plans::Random& random) {
    const auto v = pick(building, random, [&](std::uint32_t u) { return u + 1 < building.volumes.size(); });
    InjectedFault fault = fault_at(building, "S1", *v);
    Volume& volume = building.volumes[*v];
    fault.elements = {element(building, *v)};
    if (random.chance(0.5)) {
        Label label = volume.label;
        while (label == volume.label) label = Label(random.below(std::uint32_t(accel::label_count)));
        volume.label = label;
    } else {
        std::uint32_t space = volume.space;
        while (building.spaces[space].label == volume.label)
            space = random.below(std::uint32_t(building.spaces.size()));
        volume.space = space;
        fault.elements = {element(building, *v)};
    }
    return fault;
}

/// A whole space is labelled anew, its volumes are not.
std::optional<InjectedFault> another_space_label(Building& building, plans::Random& random) {
    const auto v = pick(building, random, [&](std::uint32_t u) { return building.volumes[u].label == Label::Room; });
    if (!v) return std::nullopt;
    InjectedFault fault = fault_at(building, "S1", *v);
    fault.reach = site_diagonal(building);
    fault.elements = {element(building, *v)};
    building.spaces[building.volumes[*v].space].label = Label::Shaft;
    return fault;
}

/// Of three or more pieces of one volume, one belongs to another space with the same label.
std::optional<InjectedFault> another_parent(Building& building, plans::Random& random) {
    std::vector<std::uint32_t> pieces(building.volumes.size(), 0);
    for (const Volume& volume : building.volumes) ++pieces[volume.parent];
    const auto v = pick(building, random, [&](std::uint32_t u) {
        return building.volumes[u].label == Label::Room && pieces[building.volumes[u].parent] >= 3;
    });
    if (!v) return std::nullopt;
    const auto other = pick(building, random, [&](std::uint32_t u) {
        return building.volumes[u].label == Label::Room && building.volumes[u].space != building.volumes[*v].space;
    });
    if (!other) return std::nullopt;
    InjectedFault fault = fault_at(building, "S1", *v);
    building.volumes[*v].space = building.volumes[*other].space;
    return fault;
}

/// A face that is no portal, and its row changed.
std::optional<InjectedFault> another_row(Building& building, plans::Random& random) {
    std::vector<std::uint32_t> solid;
    for (std::uint32_t f = 0; f < building.faces.size(); ++f)
        if (is_solid(building, building.faces[f].front) && is_solid(building, building.faces[f].back))
            solid.push_back(f);
    if (solid.empty()) return std::nullopt;
    Face& row = building.faces[solid[random.below(std::uint32_t(solid.size()))]];
    const auto other = pick(building, random,
                            [&](std::uint32_t u) { return is_solid(building, u) && u != row.front && u != row.back; });
    const std::uint32_t inner = row.front + 1 < building.volumes.size() ? row.front : row.back;
    InjectedFault fault = fault_at(building, "S1", inner);
    fault.elements = {element(building, row.front), element(building, row.back)};
    switch (random.below(4)) {
        case 0: (random.chance(0.5) ? row.front : row.back) = *other; break;
        case 1: row.z_high += 1; break;
        case 2: std::swap(row.front, row.back); break;
        default: row.direction = row.direction == Direction::Up ? Direction::Side : Direction::Up; break;
    }
    return fault;
}

}  // namespace

std::optional<InjectedFault> inject_s1(Building& building, plans::Random& random) {
    switch (random.below(4)) {
        case 0: return another_label(building, random);
        case 1: return another_space_label(building, random);
        case 2: return another_parent(building, random);
        default: return another_row(building, random);
    }
}

std::optional<InjectedFault> inject_d1(Building& building, plans::Random& random) {
    const auto area2 = [&](std::uint32_t piece) {
        const modeler::Piece& p = building.pieces[piece];
        const auto point = [&](std::uint32_t k) {
            return building.points[building.corners[p.first_corner + k % p.corner_count].vertex];
        };
        std::int64_t sum = 0;
        for (std::uint32_t k = 0; k < p.corner_count; ++k) sum += orientation(point(0), point(k), point(k + 1));
        return sum;
    };
    // Whole rooms alone: pieces of one would no longer sum to it, which is G8.
    std::vector<std::uint32_t> pieces(building.volumes.size(), 0);
    for (const Volume& volume : building.volumes) ++pieces[volume.parent];
    const auto v = pick(building, random, [&](std::uint32_t u) {
        return building.volumes[u].label == Label::Room && pieces[building.volumes[u].parent] == 1;
    });
    if (!v) return std::nullopt;
    const std::uint32_t own = building.volumes[*v].piece;
    // Where it lies nowhere over its own polygon, its node lies outside.
    const auto lies_apart = [&](std::uint32_t p) {
        const auto [low, high] = box_of(building, p);
        const auto [own_low, own_high] = box_of(building, own);
        return low.x >= own_high.x || own_low.x >= high.x || low.y >= own_high.y || own_low.y >= high.y;
    };
    std::vector<std::uint32_t> others;
    for (std::uint32_t p = 0; p < building.pieces.size(); ++p)
        if (lies_apart(p) && (!building.convex || area2(p) == area2(own))) others.push_back(p);
    if (others.empty()) return std::nullopt;
    InjectedFault fault = fault_at(building, "D1", *v);
    fault.elements = {element(building, *v)};
    building.volumes[*v].piece = others[random.below(std::uint32_t(others.size()))];
    return fault;
}

}  // namespace enfilade::testing
