#include "tools/false_colour.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "render/colour_scale.h"
#include "tools/pixel_font.h"

namespace enfilade::tools {

namespace {

constexpr int least_width = 80;
constexpr int least_height = 60;
constexpr render::Vec3f ground = {0.01f, 0.01f, 0.012f};
constexpr render::Vec3f ink = {0.85f, 0.85f, 0.85f};

// Of the bar, in dots of the font.
constexpr int margin = 4;
constexpr int bar_height = 6;
constexpr int gap = 3;
constexpr int band_height = margin + bar_height + gap + glyph_height + margin;

double place_of(double value, ScaleRange range) { return (value - range.least) / (range.most - range.least); }

int dot_size(int width, int height) { return std::max(1, std::min(width, height) / 240); }

void draw_bar(render::Image& image, int rows, ScaleRange range, double largest, const std::string& caption) {
    const int scale = dot_size(image.width, image.height);
    const int top = image.height - rows;
    fill_rectangle(image, 0, top, image.width, rows, ground);
    const int left = scale * 2 * margin;
    const bool has_caption = image.width > 2 * text_width(caption, scale);
    const int right = image.width - left - (has_caption ? text_width(caption, scale) + 2 * left : 0);
    const int bar_top = top + scale * margin, text_top = bar_top + scale * (bar_height + gap);
    for (int x = left; x < right; ++x)
        fill_rectangle(image, x, bar_top, 1, scale * bar_height,
                       render::scale_colour(double(x - left) / (right - left - 1)));
    if (has_caption) draw_text(image, right + 2 * left, bar_top, scale, caption, ink);

    int free_from = 0;
    const std::vector<int> marks = scale_marks(range, std::max(2, (right - left) / (scale * 5 * glyph_step)));
    for (const int mark : marks) {
        std::string text = std::to_string(mark);
        if (mark == marks.back() && largest > range.most) text += '+';
        const int x = left + int(std::lround(place_of(mark, range) * (right - left - 1)));
        fill_rectangle(image, x - scale / 2, bar_top + scale * bar_height, scale, 2 * scale, ink);
        const int width = text_width(text, scale);
        const int begin = std::clamp(x - width / 2, 0, std::max(0, image.width - width));
        if (begin < free_from) continue;
        draw_text(image, begin, text_top, scale, text, ink);
        free_from = begin + width + scale * glyph_step;
    }
}

}  // namespace

ScaleRange range_of(std::span<const render::PixelNumbers> pictures, double share) {
    std::vector<float> all;
    for (const render::PixelNumbers& numbers : pictures)
        std::ranges::copy_if(numbers.of_pixel, std::back_inserter(all), [](float value) { return !std::isnan(value); });
    ScaleRange range;
    if (!all.empty()) range.most = range.least = double{std::ranges::min(all)};
    std::erase(all, 0.0f);
    if (!all.empty()) {
        const auto most =
            all.begin() + std::max(std::ptrdiff_t(std::ceil(share * double(all.size()))), std::ptrdiff_t(1)) - 1;
        std::ranges::nth_element(all, most);
        range.most = double{*most};
    }
    if (!(range.most > range.least)) range.most = range.least + 1;
    return range;
}

std::vector<int> scale_marks(ScaleRange range, int count) {
    const int least = int(std::ceil(range.least)), most = int(std::floor(range.most));
    int step = 1;
    for (int power = 1; (most - least) / step + 1 > std::max(2, count); power *= 10) {
        for (const int digit : {1, 2, 5}) {
            step = digit * power;
            if ((most - least) / step + 1 <= std::max(2, count)) break;
        }
    }
    std::vector<int> marks;
    const int first = least == 0 || step == 1 ? least : (least + step - 1) / step * step;
    for (int mark = first; mark <= most; mark += step) marks.push_back(mark);
    return marks;
}

int bar_rows(int width, int height) {
    return width >= least_width && height >= least_height ? dot_size(width, height) * band_height : 0;
}

render::Image false_colour(const render::PixelNumbers& numbers, ScaleRange range, const std::string& caption,
                           int rows) {
    render::Image image(numbers.width, numbers.height + rows);
    double largest = range.most;
    for (std::size_t k = 0; k < numbers.of_pixel.size(); ++k) {
        const double value = double{numbers.of_pixel[k]};
        const render::Vec3f colour = render::scale_colour(place_of(value, range));
        image.rgb[3 * k] = colour.x;
        image.rgb[3 * k + 1] = colour.y;
        image.rgb[3 * k + 2] = colour.z;
        if (value > largest) largest = value;
    }
    if (rows > 0) draw_bar(image, rows, range, largest, caption);
    return image;
}

}  // namespace enfilade::tools
