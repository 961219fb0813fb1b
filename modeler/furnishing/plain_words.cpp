#include "modeler/furnishing/plain_words.h"

#include <array>
#include <cstdint>

#include "plans/utf8.h"

namespace enfilade::modeler {
namespace {

/// U+00C0 ... U+017F without their accents; a dot where it is no letter.
constexpr std::string_view latin =
    "aaaaaaaceeeeiiiidnooooo.ouuuuyts"   // U+00C0 ...
    "aaaaaaaceeeeiiiidnooooo.ouuuuyty"   // U+00E0 ...
    "aaaaaaccccccccddddeeeeeeeeeegggg"   // U+0100 ...
    "gggghhhhiiiiiiiiiiiijjkkklllllll"   // U+0120 ...
    "lllnnnnnnnnnoooooooorrrrrrssssss"   // U+0140 ...
    "ssttttttuuuuuuuuuuuuwwyyyzzzzzzs";  // U+0160 ...

std::uint32_t code_point(std::string_view text, std::size_t at, std::size_t length) {
    const auto byte = [&](std::size_t k) { return std::uint32_t(static_cast<unsigned char>(text[at + k])); };
    if (length == 1) return byte(0);
    std::uint32_t code = byte(0) & (0x7Fu >> length);
    for (std::size_t k = 1; k < length; ++k) code = (code << 6) | (byte(k) & 0x3Fu);
    return code;
}

}  // namespace

std::string plain_words(std::string_view utf8) {
    std::string out;
    bool space = false;  // kept back until a letter follows
    for (std::size_t at = 0; at < utf8.size();) {
        const std::size_t length = plans::utf8_length(utf8, at);
        if (length == 0) {
            ++at;
            space = true;
            continue;
        }
        const std::uint32_t code = code_point(utf8, at, length);
        std::array<char, 1> plain = {'.'};  // a dot: no Latin letter
        if (code < 0x80) {
            const char c = char(code);
            if (c >= 'a' && c <= 'z') plain[0] = c;
            else if (c >= 'A' && c <= 'Z') plain[0] = char(c - 'A' + 'a');
        } else if (code >= 0xC0 && code - 0xC0 < latin.size()) {
            plain[0] = latin[code - 0xC0];
        }
        const bool other = code >= 0x180 && !(code >= 0x2000 && code < 0x2E80) && !(code >= 0x3000 && code < 0x3040) &&
                           !(code >= 0xFF00 && code < 0xFF20);
        // Cyrillic capitals; the small ones follow them.
        const std::uint32_t small = code >= 0x410 && code <= 0x42F ? code + 0x20 : code == 0x401 ? 0x451 : 0;
        const std::array<char, 2> cyrillic = {char(0xC0 | (small >> 6)), char(0x80 | (small & 0x3F))};
        // An apostrophe parts no word: "child's", "l'entree".
        const bool joins = code == '\'' || code == 0x2019;
        if (plain[0] != '.' || other) {
            if (space && !out.empty()) out += ' ';
            space = false;
            if (plain[0] != '.') out += plain[0];
            else if (small != 0) out.append(cyrillic.data(), 2);
            else out += utf8.substr(at, length);
        } else if (!joins) {
            space = true;
        }
        at += length;
    }
    return out;
}

bool holds_words(std::string_view text, std::string_view word) {
    if (word.empty()) return false;
    // From U+2E80 on (three bytes, 0xE2 0xBA ...), scripts write words without spaces.
    const bool unspaced = static_cast<unsigned char>(word.front()) >= 0xE3;
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
        const bool starts = at == 0 || text[at - 1] == ' ';
        const bool ends = at + word.size() == text.size() || text[at + word.size()] == ' ';
        if (unspaced || (starts && ends)) return true;
    }
    return false;
}

}  // namespace enfilade::modeler
