#include "tools/report/name_layer.h"

#include "tools/report/html_text.h"
#include "tools/report/room_label.h"

namespace enfilade::tools {

void NameLayer::add(const std::vector<std::vector<Mm>>& rings, Mm at, const RoomNote& note,
                    std::span<const MmBox> obstacles) {
    const RoomLabel label = fit_label(rings, at, note.name, note.measure, obstacles);
    if (label.size == 0) return;
    const double lines = double(label.lines.size()) + (label.with_area ? 0.78 : 0);
    const std::int64_t x = label.upright ? 0 : label.at.x, middle = label.upright ? 0 : -label.at.y;
    double y = double(middle) - lines * 1.2 * label.size / 2;
    const auto line = [&](const std::string& words, double size, const std::string& classes) {
        return "<text" + classes + " x=\"" + std::to_string(x) + "\" y=\"" + decimal(y - 0.32 * size, 0) + "\">" +
               escaped(words) + "</text>";
    };
    std::string text = "<g";
    if (label.upright)
        text += " transform=\"translate(" + std::to_string(label.at.x) + " " + std::to_string(-label.at.y) +
                ") rotate(-90)\"";
    text += ">";
    for (const std::string& words : label.lines) {
        y += 1.2 * label.size;
        text += line(words, label.size, "");
    }
    if (label.with_area) {
        const double size = 0.78 * label.size;
        y += 1.2 * size;
        text += line(note.measure, size, " class=\"area\"");
        if (!note.count.empty()) text += line(note.count, size, " class=\"area count\"");
    }
    by_size_[label.size] += text + "</g>\n";
}

std::string NameLayer::text() const {
    std::string all = "<g class=\"layer layer-names\" transform=\"scale(.001)\">\n";
    for (const auto& [size, texts] : by_size_)
        all += "<g class=\"names\" data-size=\"" + decimal(size / 1000.0, 2) + "\" font-size=\"" +
               std::to_string(size) + "\" style=\"--size:" + std::to_string(size) + "px\">\n" + texts + "</g>\n";
    return all + "</g>\n";
}

}  // namespace enfilade::tools
