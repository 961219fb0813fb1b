#include "tools/report/cut_legend.h"

#include "tools/report/area_scale.h"
#include "tools/report/html_text.h"
#include "tools/report/scale_bar.h"

namespace enfilade::tools {
namespace {

std::string label(double x, double y, const std::string& words, const char* classes = "key") {
    return std::string("<text class=\"") + classes + "\" x=\"" + decimal(x, 1) + "\" y=\"" + decimal(y, 1) + "\">" +
           words + "</text>\n";
}

std::string line(double x, double y, double length, const std::string& classes) {
    return "<path class=\"" + classes + "\" d=\"M" + decimal(x, 1) + " " + decimal(y, 1) + "h" + decimal(length, 1) +
           "\"/>\n";
}

/// One swatch a class, its bounds under it.
std::string area_swatches() {
    constexpr double swatch = 34;
    std::string text = label(0, 10, "Cuts by the area of their portal, m²");
    for (std::size_t k = 0; k < area_classes.size(); ++k) {
        const double x = double(k) * swatch;
        text += "<g><title>" + area_class_text(k) + " m²</title>" +
                line(x, 22, swatch, "swatch a" + std::to_string(k)) + "</g>\n";
        if (k > 0) text += label(x, 42, decimal(area_classes[k], area_classes[k] < 1 ? 1 : 0), "key bound");
    }
    return text;
}

std::string keys() {
    struct Key {
        double x;
        const char* classes;
        const char* words;
    };
    constexpr Key all[] = {{320, "portal clear", "door, opening"},
                           {430, "portal glass", "window"},
                           {505, "portal border", "border of two rooms"},
                           {655, "portal shut", "shut door"}};
    std::string text;
    for (const auto& [x, classes, words] : all)
        text += line(x, 22, 24, std::string("legend-line ") + classes) + label(x, 42, words);
    return text;
}

std::string scale(double pixels_per_mm) {
    const double metres = round_length(140 / (1000 * pixels_per_mm)), pixels = metres * 1000 * pixels_per_mm;
    return "<g class=\"scalebar\"><path d=\"M" + decimal(legend_width - pixels, 1) + " 16v6h" + decimal(pixels, 1) +
           "v-6\"/>\n" + label(legend_width - pixels, 42, length_text(metres)) + "</g>\n";
}

}  // namespace

std::string cut_legend(double x, double y, double pixels_per_mm) {
    return "<g class=\"legend\" transform=\"translate(" + decimal(x, 1) + " " + decimal(y, 1) + ")\">\n" +
           area_swatches() + keys() + scale(pixels_per_mm) + "</g>\n";
}

}  // namespace enfilade::tools
