#include <algorithm>
#include <string>

#include "modeler/catalogue/mtl.h"
#include "modeler/catalogue/name_index.h"

namespace enfilade::modeler {
namespace {

struct ColourWord {
    const char* word;
    std::array<double, 3> colour;  ///< sRGB
};

/// Longer words stand before those that they hold.
constexpr ColourWord words[] = {
    {"redorange", {0.85, 0.30, 0.10}}, {"yelloworng", {0.95, 0.70, 0.10}}, {"aluminium", {0.75, 0.76, 0.78}},
    {"aluminum", {0.75, 0.76, 0.78}},  {"lavendar", {0.55, 0.40, 0.75}},   {"lavender", {0.55, 0.40, 0.75}},
    {"charcoal", {0.20, 0.20, 0.21}},  {"sapphire", {0.10, 0.25, 0.70}},   {"emerald", {0.10, 0.55, 0.30}},
    {"leather", {0.40, 0.26, 0.18}},   {"redwood", {0.50, 0.24, 0.16}},    {"ceramic", {0.92, 0.92, 0.90}},
    {"chrome", {0.78, 0.79, 0.81}},    {"silver", {0.75, 0.76, 0.78}},     {"yellow", {0.95, 0.85, 0.20}},
    {"orange", {0.90, 0.50, 0.10}},    {"purple", {0.50, 0.20, 0.55}},     {"violet", {0.50, 0.25, 0.65}},
    {"blonde", {0.85, 0.75, 0.50}},    {"rubber", {0.16, 0.16, 0.16}},     {"walnut", {0.36, 0.25, 0.18}},
    {"cherry", {0.50, 0.23, 0.15}},    {"marble", {0.88, 0.87, 0.84}},     {"bronze", {0.55, 0.42, 0.22}},
    {"copper", {0.72, 0.45, 0.30}},    {"white", {0.93, 0.93, 0.92}},      {"black", {0.08, 0.08, 0.08}},
    {"brown", {0.42, 0.28, 0.18}},     {"green", {0.25, 0.55, 0.25}},      {"amber", {0.78, 0.55, 0.15}},
    {"flesh", {0.90, 0.72, 0.60}},     {"beige", {0.88, 0.83, 0.72}},      {"cream", {0.93, 0.90, 0.80}},
    {"ivory", {0.93, 0.91, 0.84}},     {"peach", {0.93, 0.73, 0.58}},      {"brass", {0.70, 0.58, 0.30}},
    {"steel", {0.65, 0.66, 0.68}},     {"metal", {0.62, 0.63, 0.65}},      {"stone", {0.62, 0.60, 0.56}},
    {"glass", {0.82, 0.88, 0.90}},     {"grass", {0.30, 0.50, 0.20}},      {"grey", {0.55, 0.55, 0.55}},
    {"gray", {0.55, 0.55, 0.55}},      {"blue", {0.20, 0.35, 0.70}},       {"pink", {0.90, 0.62, 0.68}},
    {"gold", {0.80, 0.65, 0.25}},      {"iris", {0.35, 0.40, 0.75}},       {"navy", {0.10, 0.13, 0.35}},
    {"ruby", {0.60, 0.08, 0.15}},      {"bone", {0.88, 0.85, 0.76}},       {"ship", {0.35, 0.36, 0.38}},
    {"wood", {0.60, 0.44, 0.28}},      {"pine", {0.78, 0.62, 0.40}},       {"teak", {0.52, 0.35, 0.20}},
    {"sand", {0.80, 0.72, 0.56}},      {"sky", {0.55, 0.75, 0.90}},        {"oak", {0.66, 0.50, 0.32}},
    {"tan", {0.80, 0.68, 0.50}},       {"red", {0.75, 0.15, 0.13}},
};

constexpr std::string_view dark_words[] = {"dark", "dk"};
constexpr std::string_view light_words[] = {"light", "lt", "pale"};

/// How often one of the words stands right before `end`, one behind the other ("dkdkgrey").
template <class Words>
int count_before(std::string_view name, std::size_t end, const Words& list) {
    int count = 0;
    for (bool found = true; found;) {
        found = false;
        while (end > 0 && (name[end - 1] == '_' || name[end - 1] == ' ' || name[end - 1] == '-')) --end;
        for (const std::string_view word : list)
            if (!found && name.substr(0, end).ends_with(word)) {
                end -= word.size();
                found = true;
                ++count;
            }
    }
    return count;
}

}  // namespace

std::optional<std::array<double, 3>> colour_of_name(std::string_view name) {
    const std::string lower = in_lower_case(name);
    for (const ColourWord& entry : words) {
        const std::size_t at = lower.find(entry.word);
        if (at == std::string::npos) continue;
        std::array<double, 3> colour = entry.colour;
        const int dark = count_before(lower, at, dark_words);
        const int light = count_before(lower, at, light_words);
        for (double& c : colour) {
            for (int k = 0; k < dark; ++k) c *= 0.55;
            for (int k = 0; k < light; ++k) c += (1 - c) * 0.45;
        }
        return colour;
    }
    return std::nullopt;
}

}  // namespace enfilade::modeler
