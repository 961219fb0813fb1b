#pragma once
// The families of our own pieces; each adds its own.

#include "modeler/catalogue/own/piece.h"

namespace enfilade::modeler::own {

void add_chairs(Pieces& pieces);
void add_sofas(Pieces& pieces);
void add_tables(Pieces& pieces);
void add_leisure(Pieces& pieces);
void add_electronics(Pieces& pieces);
void add_decoration(Pieces& pieces);
void add_lamps(Pieces& pieces);
void add_plants(Pieces& pieces);
void add_kitchen(Pieces& pieces);
void add_bathroom(Pieces& pieces);
void add_storage(Pieces& pieces);
void add_beds(Pieces& pieces);
void add_office(Pieces& pieces);

}  // namespace enfilade::modeler::own
