#pragma once
// How families of pieces enter the list.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "modeler/catalogue/own/shaper.h"
#include "modeler/catalogue/own_pieces.h"

namespace enfilade::modeler::own {

/// A text as an argument of a template.
template <std::size_t count>
struct Text {
    char letters[count];
    consteval Text(const char (&text)[count]) { std::copy_n(text, count, letters); }
};

struct Uses {
    std::optional<double> top = {};  ///< where things may stand on it
    double elevation = 0;            ///< of its bottom above the floor
};

/// A piece from its parts: `shape` is a lambda without captures, called with a Shaper and the size. It is made as it
/// stands; the finished mesh is fitted into the size, so shapes may miss it by a little.
template <Text id, Size size, class Shape>
[[nodiscard]] OwnPiece piece(std::string name, std::string kind, std::string category, Shape, const Uses& uses = {}) {
    OwnPiece made;
    made.entry.id = id.letters;
    made.entry.name = std::move(name);
    made.entry.kind = std::move(kind);
    made.entry.category = std::move(category);
    made.entry.width = size.width;
    made.entry.depth = size.depth;
    made.entry.height = size.height;
    made.entry.elevation = uses.elevation;
    made.entry.top = uses.top;
    made.entry.source = "own";
    made.entry.creator = "Enfilade";
    made.make = [](std::uint32_t detail) {
        Shaper shaper(detail);
        Shape{}(shaper, size);
        return std::move(shaper).finish(id.letters, size);
    };
    return made;
}

using Pieces = std::vector<OwnPiece>;

}  // namespace enfilade::modeler::own
