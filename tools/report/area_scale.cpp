#include "tools/report/area_scale.h"

#include <algorithm>

#include "tools/report/html_text.h"

namespace enfilade::tools {
namespace {

using Colours = std::array<const char*, area_classes.size()>;

// OKLCH: lightness 0.82 to 0.30 and 0.46 to 0.92, hue 88 to -70 degrees and back, chroma 0.17 or what sRGB can show.
constexpr Colours on_light = {"#f1bc0c", "#f29304", "#e86b32", "#d14a53", "#b0316a", "#892079", "#5e127f", "#34007a"};
constexpr Colours on_dark = {"#5b3eae", "#8d45ae", "#ba4ea2", "#e15d8c", "#fe746f", "#fe9f6c", "#ffc277", "#ffe47e"};

std::string bound(std::size_t area_class) {
    return decimal(area_classes[area_class], area_classes[area_class] < 1 ? 1 : 0);
}

}  // namespace

std::size_t area_class(double square_metres) {
    if (!(square_metres >= 0)) return 0;
    const auto above = std::upper_bound(area_classes.begin(), area_classes.end(), square_metres);
    return std::size_t(above - area_classes.begin()) - 1;
}

const char* area_colour(std::size_t area_class, Ground ground) {
    return (ground == Ground::Light ? on_light : on_dark)[std::min(area_class, area_classes.size() - 1)];
}

std::string area_style() {
    const auto rules = [](Ground ground) {
        std::string text;
        for (std::size_t k = 0; k < area_classes.size(); ++k)
            text += ".a" + std::to_string(k) + " { --area: " + area_colour(k, ground) + "; } ";
        return text;
    };
    return rules(Ground::Light) + "\n@media (prefers-color-scheme: dark) { " + rules(Ground::Dark) +
           "}\n@media print { " + rules(Ground::Light) + "}\n";
}

std::string plain_area_style() {
    std::string text;
    for (std::size_t k = 0; k < area_classes.size(); ++k)
        text += ".a" + std::to_string(k) + " { stroke: " + area_colour(k, Ground::Light) + "; }\n";
    return text;
}

std::string area_class_text(std::size_t area_class) {
    if (area_class == 0) return "up to " + bound(1);
    if (area_class + 1 >= area_classes.size()) return "over " + bound(area_classes.size() - 1);
    return bound(area_class) + " to " + bound(area_class + 1);
}

}  // namespace enfilade::tools
