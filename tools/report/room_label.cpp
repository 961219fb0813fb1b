#include "tools/report/room_label.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "plans/utf8.h"

namespace enfilade::tools {
namespace {

constexpr double line_height = 1.2;  ///< of the font's size
constexpr double area_size = 0.78;   ///< of the name's

/// About how wide a text is, for a font of size 1: no font is at hand here, so rather too wide than too narrow.
double width_of(const std::string& text) {
    double width = 0;
    for (std::size_t k = 0; k < text.size();) {
        const std::size_t bytes = std::max<std::size_t>(1, plans::utf8_length(text, k));
        const char c = text[k];
        if (bytes >= 3) width += 1.05;  // ideographs, emoji
        else if (bytes == 2) width += 0.66;
        else if (c == ' ' || c == '.' || c == ',' || c == 'i' || c == 'l' || c == 'j' || c == '\'') width += 0.3;
        else if (c == 'm' || c == 'w' || c == 'M' || c == 'W') width += 0.9;
        else if (c >= 'A' && c <= 'Z') width += 0.7;
        else width += 0.57;
        k += bytes;
    }
    return width;
}

/// The text in two lines of about one width, or empty where it has no space.
std::vector<std::string> in_two(const std::string& text) {
    std::vector<std::string> best;
    double least = INFINITY;
    for (std::size_t k = text.find(' '); k != std::string::npos; k = text.find(' ', k + 1)) {
        const std::string first = text.substr(0, k), second = text.substr(k + 1);
        const double width = std::max(width_of(first), width_of(second));
        if (width < least) least = width, best = {first, second};
    }
    return best;
}

struct Box {
    double low_x, low_y, high_x, high_y;
};

/// Whether some point of a segment lies in the box (Liang and Barsky 1984).
bool meets(Mm a, Mm b, const Box& box) {
    double from = 0, to = 1;
    const double dx = double(b.x - a.x), dy = double(b.y - a.y);
    const auto clip = [&](double p, double q) {
        if (p == 0) return q >= 0;
        if (p < 0) from = std::max(from, q / p);
        else to = std::min(to, q / p);
        return from <= to;
    };
    return clip(-dx, double(a.x) - box.low_x) && clip(dx, box.high_x - double(a.x)) &&
           clip(-dy, double(a.y) - box.low_y) && clip(dy, box.high_y - double(a.y));
}

bool is_inside(const std::vector<std::vector<Mm>>& rings, Mm at) {
    bool inside = false;
    for (const std::vector<Mm>& ring : rings)
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const Mm a = ring[k], b = ring[(k + 1) % ring.size()];
            if ((a.y > at.y) == (b.y > at.y)) continue;
            if (double(at.x) < double(b.x - a.x) * double(at.y - a.y) / double(b.y - a.y) + double(a.x))
                inside = !inside;
        }
    return inside;
}

/// `at` moved to the middle of what is free to its left and right (or below and above).
Mm centred(const std::vector<std::vector<Mm>>& rings, Mm at, bool sideways) {
    double before = -INFINITY, behind = INFINITY;
    const auto u = [&](Mm p) { return double(sideways ? p.x : p.y); };
    const auto v = [&](Mm p) { return double(sideways ? p.y : p.x); };
    for (const std::vector<Mm>& ring : rings)
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const Mm a = ring[k], b = ring[(k + 1) % ring.size()];
            if ((v(a) > v(at)) == (v(b) > v(at))) continue;
            const double cut = u(a) + (u(b) - u(a)) * (v(at) - v(a)) / (v(b) - v(a));
            if (cut <= u(at)) before = std::max(before, cut);
            else behind = std::min(behind, cut);
        }
    if (!std::isfinite(before) || !std::isfinite(behind)) return at;
    const std::int64_t middle = std::llround((before + behind) / 2);
    return sideways ? Mm{middle, at.y} : Mm{at.x, middle};
}

/// Where a name may go: in the middle first, then ever further from it.
std::vector<Mm> places(const std::vector<std::vector<Mm>>& rings, Mm at) {
    std::vector<Mm> all = {at, centred(rings, at, true), centred(rings, at, false),
                           centred(rings, centred(rings, at, true), false)};
    MmBox box;
    for (const Mm p : rings[0]) box.add(p);
    const std::int64_t dx = (box.high.x - box.low.x) / 10, dy = (box.high.y - box.low.y) / 10;
    for (const std::int64_t ring : {1, 2, 3})
        for (std::int64_t i = -ring; i <= ring; ++i)
            for (std::int64_t j = -ring; j <= ring; ++j)
                if (std::max(std::abs(i), std::abs(j)) == ring) all.push_back({at.x + i * dx, at.y + j * dy});
    return all;
}

struct Fitter {
    const std::vector<std::vector<Mm>>& rings;
    const std::string& area;
    std::vector<MmBox> obstacles;  ///< emptied where nothing fits between them

    [[nodiscard]] bool fits(const RoomLabel& label) const {
        double width = 0, height = line_height * double(label.lines.size()) * label.size;
        for (const std::string& line : label.lines) width = std::max(width, width_of(line) * label.size);
        if (label.with_area) {
            width = std::max(width, width_of(area) * area_size * label.size);
            height += line_height * area_size * label.size;
        }
        // Some air around it.
        width += 0.9 * label.size, height += 0.5 * label.size;
        if (label.upright) std::swap(width, height);
        const double x = double(label.at.x), y = double(label.at.y);
        const Box box = {x - width / 2, y - height / 2, x + width / 2, y + height / 2};
        for (const MmBox& o : obstacles)
            if (box.low_x < double(o.high.x) && box.high_x > double(o.low.x) && box.low_y < double(o.high.y) &&
                box.high_y > double(o.low.y))
                return false;
        for (const std::vector<Mm>& ring : rings)
            for (std::size_t k = 0; k < ring.size(); ++k)
                if (meets(ring[k], ring[(k + 1) % ring.size()], box)) return false;
        return is_inside(rings, label.at);
    }
};

}  // namespace

RoomLabel fit_label(const std::vector<std::vector<Mm>>& rings, Mm at, const std::string& name, const std::string& area,
                    std::span<const MmBox> obstacles) {
    Fitter fitter{rings, area, {}};
    MmBox box;
    for (const Mm p : rings[0]) box.add(p);
    for (const MmBox& o : obstacles)
        if (o.low.x < box.high.x && o.high.x > box.low.x && o.low.y < box.high.y && o.high.y > box.low.y)
            fitter.obstacles.push_back(o);
    const std::vector<Mm> candidates = places(rings, at);
    std::vector<std::vector<std::string>> wordings(1);
    if (!name.empty()) wordings[0] = {name};
    if (name.find(' ') != std::string::npos) wordings.push_back(in_two(name));
    const auto fit = [&](int size, bool upright, bool with_area) -> RoomLabel {
        for (const auto& lines : wordings)
            for (const Mm place : candidates) {
                RoomLabel label{place, size, upright, lines, with_area};
                if (fitter.fits(label)) return label;
            }
        return {};
    };
    if (!fitter.obstacles.empty())
        for (const int size : {340, 280, 230, 190})
            if (RoomLabel label = fit(size, false, true); label.size > 0) return label;
    fitter.obstacles.clear();
    struct Try {
        int size;
        bool upright;
    };
    for (const auto& [size, upright] :
         {Try{340, false}, Try{280, false}, Try{230, false}, Try{230, true}, Try{190, false}, Try{190, true},
          Try{160, false}, Try{160, true}, Try{130, false}, Try{130, true}})
        if (RoomLabel label = fit(size, upright, true); label.size > 0) return label;
    if (name.empty()) return {};
    for (const int size : {160, 130, 110, 90})
        for (const bool upright : {false, true})
            if (RoomLabel label = fit(size, upright, false); label.size > 0) return label;
    return {};
}

}  // namespace enfilade::tools
