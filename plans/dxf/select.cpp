#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "plans/dxf/drawing.h"
#include "plans/dxf/entities.h"
#include "plans/dxf/stroke_box.h"
#include "plans/dxf/words.h"
#include "plans/number_text.h"

namespace enfilade::plans {
namespace {

/// Whether the name matches, `*` standing for any characters and `?` for one (of UTF-8).
bool matches(std::string_view pattern, std::string_view name) {
    const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u; };
    std::size_t p = 0;
    std::size_t n = 0;
    std::size_t star = std::string_view::npos;
    std::size_t resume = 0;
    while (n < name.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            resume = n;
        } else if (p < pattern.size() && pattern[p] == '?') {
            ++p;
            do ++n;
            while (n < name.size() && continues(name[n]));
        } else if (p < pattern.size() && pattern[p] == name[n]) {
            ++p;
            ++n;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            n = ++resume;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

std::string names_of(const std::vector<Layer>& layers) {
    constexpr std::size_t most = 40;
    std::string list;
    for (std::size_t k = 0; k < std::min(layers.size(), most); ++k)
        list += (k == 0 ? "\"" : ", \"") + dxf::shortened(layers[k].name) + "\"";
    if (layers.size() > most) list += " and " + std::to_string(layers.size() - most) + " more";
    return list;
}

std::vector<bool> wanted_layers(const Drawing& drawing, const std::vector<std::string>& names,
                                const std::string& file) {
    std::vector<bool> wanted(drawing.layers.size(), names.empty());
    for (const std::string& name : names) {
        bool any = false;
        for (std::size_t k = 0; k < wanted.size(); ++k)
            if (matches(dxf::folded(name), dxf::folded(drawing.layers[k].name))) wanted[k] = any = true;
        if (!any)
            throw InputError("P710", file,
                             "No layer is called \"" + name + "\"; the layers are: " + names_of(drawing.layers) + ".");
    }
    return wanted;
}

bool inside(Point p, const DrawingBox& box) { return p.x >= box.x0 && p.x <= box.x1 && p.y >= box.y0 && p.y <= box.y1; }

/// Whether a straight line meets the box: what is left of it between the four sides.
bool meets(Point a, Point b, const DrawingBox& box) {
    double from = 0;
    double to = 1;
    const auto clip = [&](double start, double step, double low, double high) {
        if (step == 0) return start >= low && start <= high;
        const double t0 = (low - start) / step;
        const double t1 = (high - start) / step;
        from = std::max(from, std::min(t0, t1));
        to = std::min(to, std::max(t0, t1));
        return from <= to;
    };
    return clip(a.x, b.x - a.x, box.x0, box.x1) && clip(a.y, b.y - a.y, box.y0, box.y1);
}

/// Arcs as sixteen chords: the box is a person's, drawn around whole plans.
bool meets(const Stroke& stroke, const DrawingBox& box) {
    if (stroke.bulge == 0) return meets(stroke.a, stroke.b, box);
    const std::array<double, 4> around = dxf::box_of(stroke);
    if (around[0] > box.x1 || around[2] < box.x0 || around[1] > box.y1 || around[3] < box.y0) return false;
    const double aside = (1 - stroke.bulge * stroke.bulge) / (4 * stroke.bulge);
    const Point a = stroke.a;
    const Point b = stroke.b;
    const Point centre = {(a.x + b.x) / 2 - aside * (b.y - a.y), (a.y + b.y) / 2 + aside * (b.x - a.x)};
    const double sweep = 4 * std::atan(stroke.bulge);
    Point before = a;
    for (int k = 1; k <= 16; ++k) {
        const double c = std::cos(sweep * k / 16);
        const double s = std::sin(sweep * k / 16);
        const Point r = {a.x - centre.x, a.y - centre.y};
        const Point next = {centre.x + c * r.x - s * r.y, centre.y + s * r.x + c * r.y};
        if (meets(before, next, box)) return true;
        before = next;
    }
    return false;
}

/// Takes from one drawing what stays into another.
class Selection {
public:
    Selection(const Drawing& from, std::vector<bool> layers, const std::optional<DrawingBox>& crop)
        : from_(from), layers_(std::move(layers)), crop_(crop), insertions_(from.insertions.size(), false) {
        if (crop_)
            crop_ = DrawingBox{std::min(crop->x0, crop->x1), std::min(crop->y0, crop->y1), std::max(crop->x0, crop->x1),
                               std::max(crop->y0, crop->y1)};
    }

    Drawing run() {
        to_.layers = from_.layers;
        for (Layer& layer : to_.layers) layer.shape_count = layer.text_count = 0;
        to_.declared_unit = from_.declared_unit;
        to_.linear_format = from_.linear_format;
        to_.metric = from_.metric;
        to_.findings = from_.findings;
        for (const Shape& shape : from_.shapes)
            if (layers_[shape.layer] && touches(shape)) take(shape);
        for (const DrawingText& text : from_.texts)
            if (layers_[text.layer] && (!crop_ || inside(text.at, *crop_))) {
                to_.texts.push_back(text);
                ++to_.layers[text.layer].text_count;
            }
        for (const Dimension& dimension : from_.dimensions)
            if (layers_[dimension.layer] && (!crop_ || meets(dimension.a, dimension.b, *crop_)))
                to_.dimensions.push_back(dimension);
        take_insertions();
        to_.bounds = dxf::bounds_of(to_.strokes);
        return std::move(to_);
    }

private:
    bool touches(const Shape& shape) const {
        if (!crop_) return true;
        const auto first = from_.strokes.begin() + shape.first_stroke;
        return std::any_of(first, first + shape.stroke_count, [&](const Stroke& s) { return meets(s, *crop_); });
    }

    void take(const Shape& shape) {
        const auto first = from_.strokes.begin() + shape.first_stroke;
        Shape taken = shape;
        taken.first_stroke = static_cast<std::uint32_t>(to_.strokes.size());
        to_.strokes.insert(to_.strokes.end(), first, first + shape.stroke_count);
        to_.shapes.push_back(taken);
        ++to_.layers[shape.layer].shape_count;
        if (shape.block != UINT32_MAX) insertions_[shape.block] = true;
    }

    /// Those with shapes left in them, those on a chosen layer in the box, and those around them.
    void take_insertions() {
        const std::vector<Insertion>& all = from_.insertions;
        for (std::size_t k = all.size(); k-- > 0;) {
            if (layers_[all[k].layer] && (!crop_ || inside(all[k].at, *crop_))) insertions_[k] = true;
            if (insertions_[k] && all[k].parent != UINT32_MAX) insertions_[all[k].parent] = true;
        }
        std::vector<std::uint32_t> place(all.size(), UINT32_MAX);
        for (std::size_t k = 0; k < all.size(); ++k) {
            if (!insertions_[k]) continue;
            place[k] = static_cast<std::uint32_t>(to_.insertions.size());
            to_.insertions.push_back(all[k]);
            std::uint32_t& parent = to_.insertions.back().parent;
            if (parent != UINT32_MAX) parent = place[parent];
        }
        for (Shape& shape : to_.shapes)
            if (shape.block != UINT32_MAX) shape.block = place[shape.block];
    }

    const Drawing& from_;
    std::vector<bool> layers_;
    std::optional<DrawingBox> crop_;
    std::vector<bool> insertions_;
    Drawing to_;
};

}  // namespace

Drawing select(const Drawing& drawing, const std::vector<std::string>& layers, const std::optional<DrawingBox>& crop,
               const std::string& file_name) {
    if (layers.empty() && !crop) return drawing;
    Drawing left = Selection(drawing, wanted_layers(drawing, layers, file_name), crop).run();
    if (left.shapes.empty() && left.texts.empty() && left.insertions.empty()) {
        const auto range = [](double from, double to) { return rounded_text(from, 2) + " to " + rounded_text(to, 2); };
        throw InputError("P711", file_name,
                         "Nothing of the drawing is left by the layers and the box asked for; it reaches in x from " +
                             range(drawing.bounds[0], drawing.bounds[2]) + " and in y from " +
                             range(drawing.bounds[1], drawing.bounds[3]) + ".");
    }
    return left;
}

}  // namespace enfilade::plans
