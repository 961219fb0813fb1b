#include "modeler/constraints/star_blame.h"

#include <algorithm>
#include <cstdio>

#include "modeler/place.h"

namespace enfilade::modeler {
namespace {

/// What a person looks for first.
int rank(Label label) {
    switch (label) {
        case Label::Outside: return 4;
        case Label::Exterior:
        case Label::Ground: return 3;
        case Label::Slab: return 2;
        case Label::Wall: return 1;
        default: return 0;
    }
}

}  // namespace

std::span<const std::uint32_t> StarBlame::faces_at(std::uint32_t vertex) {
    if (!stars_) stars_.emplace(subject_.rings);
    return stars_->faces_at(vertex);
}

void StarBlame::blame(std::span<const std::uint32_t> vertices) {
    for (const std::uint32_t v : vertices) {
        if (v < blame_.vertex.size()) blame_.vertex[v] = true;
        for (const std::uint32_t f : faces_at(v)) {
            if (f < blame_.face.size()) blame_.face[f] = true;
            for (const std::uint32_t volume : subject_.rings.volumes(f))
                if (volume < blame_.volume.size()) blame_.volume[volume] = true;
        }
    }
}

std::vector<std::uint32_t> StarBlame::spaces_at(std::uint32_t vertex) {
    const Building& building = subject_.building;
    std::vector<std::uint32_t> spaces;
    for (const std::uint32_t f : faces_at(vertex))
        for (const std::uint32_t v : subject_.rings.volumes(f))
            if (v < building.volumes.size()) spaces.push_back(building.volumes[v].space);
    std::sort(spaces.begin(), spaces.end());
    spaces.erase(std::unique(spaces.begin(), spaces.end()), spaces.end());
    const auto rank_of = [&](std::uint32_t s) { return rank(building.spaces[s].label); };
    std::stable_sort(spaces.begin(), spaces.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return rank_of(a) < rank_of(b); });
    while (spaces.size() > 1 && rank_of(spaces.back()) >= 3 && rank_of(spaces.back()) > rank_of(spaces.front()))
        spaces.pop_back();
    return spaces;
}

void StarBlame::place(std::uint32_t vertex, Finding& finding) {
    place_at_vertex(subject_.building, vertex, finding);
    for (const std::uint32_t space : spaces_at(vertex)) place_at_space(subject_.building, space, finding);
}

std::string StarBlame::names(std::uint32_t vertex) {
    std::vector<std::uint32_t> spaces = spaces_at(vertex);
    if (spaces.size() > 3) spaces.resize(3);
    std::string text;
    for (std::size_t k = 0; k < spaces.size(); ++k)
        text += (k == 0 ? "" : k + 1 < spaces.size() ? ", " : " and ") + title(subject_.building.spaces[spaces[k]]);
    return text;
}

std::string millimetres(const Building& building, double units) {
    char text[48];
    std::snprintf(text, sizeof text, "%.3g mm", 1000 * building.frame.unit * units);
    return text;
}

}  // namespace enfilade::modeler
