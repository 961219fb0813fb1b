#include "modeler/catalogue/mtl.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "plans/utf8.h"

namespace enfilade::modeler {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

/// The first word of `text`, which loses it.
std::string_view take_word(std::string_view& text) {
    text = trimmed(text);
    std::size_t end = 0;
    while (end < text.size() && !is_blank(text[end])) ++end;
    const std::string_view word = text.substr(0, end);
    text = trimmed(text.substr(end));
    return word;
}

std::optional<double> number(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

/// r g b, or one number for all three.
std::optional<std::array<double, 3>> colour(std::string_view rest) {
    std::array<double, 3> rgb{};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto value = number(take_word(rest));
        if (!value && k == 0) return std::nullopt;
        rgb[k] = value ? std::clamp(*value, 0.0, 1.0) : rgb[0];
    }
    return rgb;
}

/// The file behind options such as `-s 1 1 1` or `-clamp on`.
std::string image_name(std::string_view rest) {
    while (rest.starts_with('-')) {
        const std::string_view option = take_word(rest);
        const bool takes_vector = option == "-o" || option == "-s" || option == "-t";
        for (int k = 0; k < (option == "-mm" ? 2 : takes_vector ? 3 : 1); ++k) {
            std::string_view ahead = rest;
            const std::string_view value = take_word(ahead);
            if (k > 0 && !number(value)) break;  // vectors may be short
            rest = ahead;
        }
    }
    return plans::to_utf8(rest);
}

}  // namespace

std::map<std::string, MtlMaterial, std::less<>> read_mtl(std::string_view bytes) {
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
    std::map<std::string, MtlMaterial, std::less<>> materials;
    MtlMaterial* material = nullptr;
    double specular = 0;
    bool reflects = false;
    for (std::size_t at = 0; at < bytes.size();) {
        const std::size_t end = std::min(bytes.find_first_of("\r\n", at), bytes.size());
        std::string_view rest = bytes.substr(at, end - at);
        at = end + 1;
        const std::string_view key = take_word(rest);
        if (key == "newmtl") {
            material = &materials[plans::to_utf8(rest.substr(0, 200))];
            *material = {};
            specular = 0;
            reflects = false;
        } else if (material == nullptr) {
            continue;
        } else if (key == "Kd") {
            if (const auto rgb = colour(rest)) material->diffuse = rgb;
        } else if (key == "d") {
            std::string_view word = take_word(rest);
            if (word == "-halo") word = take_word(rest);
            if (const auto value = number(word)) material->opacity = std::clamp(*value, 0.0, 1.0);
        } else if (key == "Tr") {
            if (const auto value = number(take_word(rest))) material->opacity = 1 - std::clamp(*value, 0.0, 1.0);
        } else if (key == "Ks" || key == "illum") {
            if (key == "illum") {
                const auto model = number(take_word(rest));
                reflects = model && (*model == 3 || *model == 5 || *model == 8);
            } else if (const auto rgb = colour(rest)) {
                specular = ((*rgb)[0] + (*rgb)[1] + (*rgb)[2]) / 3;
            }
            material->mirror = reflects ? specular : 0;
        } else if (key == "map_Kd") {
            material->image = image_name(rest);
        }
    }
    return materials;
}

}  // namespace enfilade::modeler
