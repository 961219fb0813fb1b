#include "plans/sweet_home/words.h"

#include <initializer_list>
#include <utility>

namespace enfilade::plans {
namespace {

/// ASCII, Latin-1 and Cyrillic letters in lower case; all others as they are.
std::string lower_case(std::string_view text) {
    std::string out(text);
    for (std::size_t k = 0; k < out.size(); ++k) {
        const auto byte = static_cast<unsigned char>(out[k]);
        const auto next = k + 1 < out.size() ? static_cast<unsigned char>(out[k + 1]) : 0u;
        if (byte >= 'A' && byte <= 'Z') {
            out[k] = static_cast<char>(byte + 32);
        } else if (byte == 0xC3 && next >= 0x80 && next <= 0x9E) {
            out[k + 1] = static_cast<char>(next + 32);
        } else if (byte == 0xD0 && next >= 0x90 && next <= 0x9F) {
            out[k + 1] = static_cast<char>(next + 32);
        } else if (byte == 0xD0 && next >= 0xA0 && next <= 0xAF) {
            out[k] = static_cast<char>(0xD1);
            out[k + 1] = static_cast<char>(next - 32);
        }
    }
    return out;
}

bool has_any(const std::string& text, std::initializer_list<std::string_view> words) {
    for (const std::string_view word : words)
        if (text.find(word) != std::string::npos) return true;
    return false;
}

}  // namespace

std::string room_kind(std::string_view name) {
    const std::string text = lower_case(name);
    if (has_any(text, {"stair", "treppe", "escalier", "escalera", "scala", "лестниц", "楼梯"})) return "stairwell";
    if (has_any(text, {"corridor", "hallway", "hall", "landing", "passage", "flur", "diele", "couloir", "pasillo",
                       "corridoio", "коридор", "прихож", "走廊", "过道", "玄关"}))
        return "corridor";
    if (has_any(text, {"bath", "shower", "toilet", "washroom", "restroom", "bad", "dusche", "salle de bain", "baño",
                       "bagno", "ванн", "туалет", "санузел", "卫", "浴"}))
        return "bathroom";
    if (text == "wc" || text == "w.c.") return "bathroom";
    if (has_any(text, {"kitchen", "küche", "cuisine", "cocina", "cucina", "кухн", "厨"})) return "kitchen";
    if (has_any(text, {"bed", "schlafzimmer", "chambre", "dormitorio", "camera da letto", "спальн", "卧"}))
        return "bedroom";
    return "room";
}

OpeningWord opening_word(std::string_view words) {
    const std::string text = lower_case(words);
    if (has_any(text, {"doorframe", "door frame", "door_frame", "archway", "türrahmen", "encadrement"}))
        return OpeningWord::Frame;
    if (has_any(text, {"frenchwindow", "french window", "sliderwindow", "slider window", "slidingwindow",
                       "sliding window", "porte-fenêtre", "fenstertür", "puertaventana", "portafinestra"}))
        return OpeningWord::WindowDoor;
    const bool window = has_any(text, {"window", "fenster", "fenêtre", "ventana", "finestra", "janela", "venster",
                                       "okno", "окно", "окна", "窗"});
    const bool door = has_any(text, {"door", "tür", "porte", "puerta", "porta", "deur", "drzwi", "gate", "двер", "门"});
    if (window && door) return OpeningWord::WindowDoor;
    if (window) return OpeningWord::Window;
    if (door) return OpeningWord::Door;
    if (has_any(text, {"opening", "passthrough", "öffnung", "ouverture"})) return OpeningWord::Frame;
    return OpeningWord::None;
}

}  // namespace enfilade::plans
