#include "tools/report/svg_path.h"

#include <algorithm>

namespace enfilade::tools {

void MmBox::add(Mm at) {
    low = {std::min(low.x, at.x), std::min(low.y, at.y)};
    high = {std::max(high.x, at.x), std::max(high.y, at.y)};
}

void SvgPath::command(char letter) {
    // A letter that repeats may be left out, but for moves, after which numbers are lines.
    if (letter != last_ || letter == 'm') text_ += letter;
    last_ = letter;
}

void SvgPath::number(std::int64_t value) {
    const char before = text_.empty() ? 'm' : text_.back();
    if (value >= 0 && before >= '0' && before <= '9') text_ += ' ';
    text_ += std::to_string(value);
}

void SvgPath::move(Mm to) {
    command('m');
    number(to.x - at_.x);
    number(to.y - at_.y);
    at_ = start_ = to;
}

void SvgPath::line(Mm to) {
    if (to == at_) return;
    if (to.y == at_.y) {
        command('h');
        number(to.x - at_.x);
    } else if (to.x == at_.x) {
        command('v');
        number(to.y - at_.y);
    } else {
        command('l');
        number(to.x - at_.x);
        number(to.y - at_.y);
    }
    at_ = to;
}

void SvgPath::close() {
    command('z');
    at_ = start_;
}

void SvgPath::ring(std::span<const Mm> points) {
    polyline(points);
    if (!points.empty()) close();
}

void SvgPath::polyline(std::span<const Mm> points) {
    for (std::size_t k = 0; k < points.size(); ++k) k == 0 ? move(points[k]) : line(points[k]);
}

void SvgPath::segment(Mm from, Mm to) {
    if (!(from == at_) || empty()) move(from);
    line(to);
}

void SvgPath::arc(std::int64_t radius, bool counter_clockwise, Mm to) {
    command('a');
    number(radius);
    number(radius);
    text_ += counter_clockwise ? " 0 0 1" : " 0 0 0";
    number(to.x - at_.x);
    number(to.y - at_.y);
    at_ = to;
}

void SvgPath::dot(Mm at) {
    move(at);
    text_ += "h0";
    last_ = 'h';
}

std::string path_tag(const std::string& classes, const SvgPath& path) {
    if (path.empty()) return "";
    return "<path class=\"" + classes + "\" d=\"" + path.text() + "\"/>\n";
}

}  // namespace enfilade::tools
