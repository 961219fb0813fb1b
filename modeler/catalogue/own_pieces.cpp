#include "modeler/catalogue/own_pieces.h"

#include <algorithm>

#include "modeler/catalogue/own/families.h"

namespace enfilade::modeler {
namespace {

std::vector<OwnPiece> all_pieces() {
    own::Pieces pieces;
    own::add_chairs(pieces);
    own::add_sofas(pieces);
    own::add_tables(pieces);
    own::add_leisure(pieces);
    own::add_electronics(pieces);
    own::add_decoration(pieces);
    own::add_lamps(pieces);
    own::add_plants(pieces);
    own::add_kitchen(pieces);
    own::add_bathroom(pieces);
    own::add_storage(pieces);
    own::add_beds(pieces);
    own::add_office(pieces);
    std::ranges::sort(pieces, {}, [](const OwnPiece& piece) -> const std::string& { return piece.entry.id; });
    return pieces;
}

}  // namespace

std::span<const OwnPiece> own_pieces() {
    static const std::vector<OwnPiece> pieces = all_pieces();
    return pieces;
}

}  // namespace enfilade::modeler
