#include "tools/report/cut_sheet.h"

#include <algorithm>
#include <cmath>

#include "plans/utf8.h"
#include "tools/report/cut_legend.h"
#include "tools/report/html_text.h"
#include "tools/report/scene_drawing.h"

namespace enfilade::tools {
namespace {

constexpr double gap = 28, title_height = 34, panel_title = 24, line_height = 18, legend_height = 64;

/// Pixels of a panel's plan and where panels stand.
struct Layout {
    double pixels_per_mm = 0.1;
    double width = 0, height = 0;  ///< of a panel's plan
    std::size_t columns = 1, rows = 1, lines = 0;

    [[nodiscard]] double step_x() const { return width + gap; }
    [[nodiscard]] double step_y() const { return panel_title + height + double(lines) * line_height + gap; }
    [[nodiscard]] double sheet_width() const {
        return std::max(gap + double(columns) * step_x(), legend_width + 2 * gap);
    }
    [[nodiscard]] double sheet_height() const { return gap + title_height + double(rows) * step_y() + legend_height; }
    /// Where panels begin: a single narrow one stands in the middle of the legend's width.
    [[nodiscard]] double left() const { return (sheet_width() - double(columns) * step_x() + gap) / 2; }
};

Layout layout_of(const MmBox& box, std::span<const CutPanel> panels) {
    Layout layout;
    layout.columns = panels.size() == 4 ? 2 : std::clamp<std::size_t>(panels.size(), 1, 3);
    layout.rows = (panels.size() + layout.columns - 1) / layout.columns;
    for (const CutPanel& panel : panels) layout.lines = std::max(layout.lines, panel.lines.size());
    const double width = double(box.high.x - box.low.x), height = double(box.high.y - box.low.y);
    // A metre has 24 pixels, but a plan fills the page's width with what stands beside it, and has an end.
    const double least = layout.columns == 1 ? 900 : layout.columns == 2 ? 560 : 380;
    const double most = layout.columns == 1 ? 4000 : 2000;
    const double longest = std::max(width, height);
    layout.pixels_per_mm = std::clamp(0.024 * longest, least, most) / longest;
    layout.width = width * layout.pixels_per_mm, layout.height = height * layout.pixels_per_mm;
    return layout;
}

/// `words` or as much of them as is about that wide, at 0.62 of the font's size a letter.
std::string shortened(const std::string& words, double width, double size) {
    const auto most = std::size_t(std::max(8.0, width / (0.62 * size)));
    if (words.size() <= most) return words;
    std::string text;
    for (std::size_t k = 0; k < words.size() && text.size() + 3 <= most;) {
        const std::size_t bytes = std::max<std::size_t>(1, plans::utf8_length(words, k));
        text += words.substr(k, bytes);
        k += bytes;
    }
    return text + "…";
}

std::string text_tag(const char* classes, double x, double y, const std::string& words) {
    return std::string("<text class=\"") + classes + "\" x=\"" + decimal(x, 1) + "\" y=\"" + decimal(y, 1) + "\">" +
           escaped(words) + "</text>\n";
}

std::string panel_tags(const CutPanel& panel, const ScenePlan& plan, const MmBox& box, const Layout& layout,
                       std::size_t number) {
    const double x = layout.left() + double(number % layout.columns) * layout.step_x();
    const double y = gap + title_height + double(number / layout.columns) * layout.step_y();
    const std::string id = "frame-" + std::to_string(number);
    const std::string size = "width=\"" + decimal(layout.width, 1) + "\" height=\"" + decimal(layout.height, 1) + "\"";
    const double k = layout.pixels_per_mm;
    std::string text = "<g class=\"panel\" transform=\"translate(" + decimal(x, 1) + " " + decimal(y, 1) + ")\">\n";
    text += text_tag("panel-title", 0, 14, shortened(panel.title, layout.width, 15));
    text += "<g transform=\"translate(0 " + decimal(panel_title, 1) + ")\">\n<clipPath id=\"" + id + "\"><rect " +
            size + "/></clipPath>\n<rect class=\"" + (plan.is_underground ? "ground" : "outdoors") + "\" " + size +
            "/>\n<g clip-path=\"url(#" + id + ")\">\n<g transform=\"translate(" + decimal(-double(box.low.x) * k, 3) +
            " " + decimal(double(box.high.y) * k, 3) + ") scale(" + decimal(1000 * k, 6) + ")\">\n";
    text += scene_drawing(*panel.scene, plan, panel.storey.index);
    text += "</g>\n</g>\n</g>\n";
    double line = panel_title + layout.height;
    for (const std::string& words : panel.lines)
        text += text_tag("line", 0, line += line_height, shortened(words, layout.width, 13));
    return text + "</g>\n";
}

}  // namespace

std::string cut_sheet(const std::string& title, std::span<const CutPanel> panels) {
    std::vector<ScenePlan> plans;
    MmBox box;
    for (const CutPanel& panel : panels) {
        plans.push_back(scene_plan(*panel.scene, panel.storey.level));
        if (plans.back().box.empty()) continue;
        box.add(plans.back().box.low), box.add(plans.back().box.high);
    }
    if (box.empty()) box = {{0, 0}, {1000, 1000}};
    const std::int64_t margin = 1000 + std::max(box.high.x - box.low.x, box.high.y - box.low.y) / 40;
    box = {{box.low.x - margin, box.low.y - margin}, {box.high.x + margin, box.high.y + margin}};

    const Layout layout = layout_of(box, panels);
    const std::string width = decimal(layout.sheet_width(), 0), height = decimal(layout.sheet_height(), 0);
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
                      "\" viewBox=\"0 0 " + width + " " + height + "\" role=\"img\">\n<title>" + escaped(title) +
                      "</title>\n<style>\n" + scene_style(layout.pixels_per_mm) +
                      "</style>\n<rect class=\"paper\" width=\"" + width + "\" height=\"" + height + "\"/>\n";
    svg +=
        text_tag("sheet-title", layout.left(), gap + 8, shortened(title, layout.sheet_width() - 2 * layout.left(), 18));
    for (std::size_t k = 0; k < panels.size(); ++k) svg += panel_tags(panels[k], plans[k], box, layout, k);
    return svg + cut_legend(layout.left(), layout.sheet_height() - legend_height, layout.pixels_per_mm) + "</svg>\n";
}

}  // namespace enfilade::tools
