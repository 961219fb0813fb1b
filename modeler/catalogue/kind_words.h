#pragma once
// What a piece of furniture is for, told by its name and its size.

#include <string>
#include <string_view>

namespace enfilade::modeler {

/// What a library or a plan says of a piece.
struct PieceWords {
    std::string_view name;      ///< "Office chair", "Tavolo da pranzo"; UTF-8
    std::string_view id;        ///< "eTeks#kitchenUpperCabinet": may tell more than the name does; may be empty
    std::string_view category;  ///< "Vehicles" ...: what stands outdoors has no kind; may be empty
    double width = 0;           ///< metres; 0: unknown, nothing is told by size
    double depth = 0;
    double height = 0;
    double elevation = 0;
};

/// The kind (docs/furnishing.md), or empty where words and size tell none. Words are English, German, French, Italian
/// and Spanish, in any case, with or without accents, also run together ("deskLamp"). The longest words that fit
/// decide, then the last (the head of an English name). A piece of a size that the kind never has is not of that kind:
/// a bed of 30 cm is a toy.
[[nodiscard]] std::string kind_of_piece(const PieceWords& piece);

}  // namespace enfilade::modeler
