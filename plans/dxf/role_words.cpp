#include "plans/dxf/role_words.h"

namespace enfilade::plans::dxf {
namespace {

using Entry = std::string_view;

constexpr Entry writing[] = {"iden", "anno", "text", "anntext", "note"};
constexpr Entry places[] = {"room", "raum", "flor", "area", "space"};
constexpr Entry low[] = {"=low", "=half", "prht", "parapet", "brustung", "=niedrig", "=bajo", "=bas", "muret"};

/// What is written or hatched, built-in services, what is above or below, the world outside.
constexpr Entry ignored[] = {
    // clang-format off
    "dim", "dims", "dimen", "*bemas", "cota", "cotes", "cotation", "quote", "maatv", "wymiar", "размер", "标注", "尺寸",
    "寸法", "hatch", "*schraff", "arcering", "patt", "штрих", "填充", "iden", "anno", "text", "anntext", "note", "текст",
    "文字", "title", "border", "=nplt", "elec", "elektr", "light", "lamp", "*leuchte", "*lampe", "plumb", "hvac", "grid",
    "raster", "achse", "轴线", "=cntr", "topo", "=plant", "plants", "planting", "projection", "footer", "footing",
    "stem", "header", "=head", "beam", "querbalken", "roof", "dach", "ceil", "clng", "defpoints", "viewport", "hide",
    "texture",
    // clang-format on
};
constexpr Entry doors[] = {
    // clang-format off
    "door", "drs", "djamb", "tur", "turen", "turblatt", "tuer", "*tueren", "innentur", "aussentur", "ausentur", "haustur",
    "zimmertur", "schiebetur", "balkontur", "wohnungstur", "porte", "puerta", "porta", "deur", "binnendeur",
    "buitendeur", "schuifdeur", "voordeur", "drzwi", "dvere", "dorr", "dor", "ovet", "kapi", "двер", "门", "門", "ドア",
    // clang-format on
};
constexpr Entry windows[] = {
    "window", "wind", "glaz", "glass",   "*fenster", "fenetre", "ventana", "finestr", "raam", "ramen",
    "janela", "okno", "okna", "fonster", "vindu",    "ikkuna",  "pencere", "окн",     "窗",   "窓",
};
constexpr Entry openings[] = {
    "opening", "offnung", "ouverture", "apertura", "doorswindows", "doorwindow", "jamb", "проем", "洞口", "建具",
};
constexpr Entry columns[] = {
    "column", "cols",    "pillar", "stutze", "stuetze", "pfeiler", "poteau",
    "pilar",  "pilastr", "kolom",  "slup",   "колонн",  "柱",
};
constexpr Entry stairs[] = {
    "stair", "strs",   "*trepp", "escalier", "escalera", "scala", "scale",
    "trap",  "escada", "schod",  "лестн",    "楼梯",     "階段",
};
constexpr Entry furniture[] = {
    "furn",  "mobel", "moebel", "mobilier", "meuble", "mueble", "mobil", "arredo", "meubel", "*schrank", "meble",
    "мебел", "家具",  "fixt",   "flor",     "case",   "equip",  "eqpm",  "shel",   "table",  "couch",    "sofa",
};
constexpr Entry walls[] = {
    // clang-format off
    "wall", "*wand", "wande", "*waende", "*mauer", "mur", "murs", "muret", "cloison", "muro", "muri", "pared", "paret",
    "tabique", "*muur", "muren", "scian", "stena", "steny", "vagg", "vegg", "seina", "duvar", "стен", "墙", "牆", "壁",
    // clang-format on
};
constexpr Entry names[] = {"room", "raum", "names", "area", "space"};

constexpr RoleWords rows[] = {
    {Role::Ignored, ignored},     {Role::Door, doors},     {Role::Window, windows},
    {Role::Opening, openings},    {Role::Column, columns}, {Role::Stair, stairs},
    {Role::Furniture, furniture}, {Role::Wall, walls},     {Role::RoomName, names},
};

bool is_ideograph(char first) { return static_cast<unsigned char>(first) >= 0xE0; }

}  // namespace

std::span<const RoleWords> role_words() { return rows; }
std::span<const std::string_view> writing_words() { return writing; }
std::span<const std::string_view> place_words() { return places; }
std::span<const std::string_view> low_words() { return low; }

bool stands_for(std::string_view entry, std::string_view word) {
    if (entry.starts_with('=')) return word == entry.substr(1);
    if (entry.starts_with('*')) return word.find(entry.substr(1)) != std::string_view::npos;
    if (is_ideograph(entry[0])) return word.find(entry) != std::string_view::npos;
    const bool is_latin = static_cast<unsigned char>(entry[0]) < 0x80;
    return is_latin && entry.size() <= 3 ? word == entry : word.starts_with(entry);
}

}  // namespace enfilade::plans::dxf
