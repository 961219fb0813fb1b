#pragma once
// The `d` of an SVG path, short: whole millimetres, each point relative to the one before.

#include <cstdint>
#include <span>
#include <string>

namespace enfilade::tools {

/// A place of a drawing: millimetres from its origin, y up.
struct Mm {
    std::int64_t x = 0;
    std::int64_t y = 0;
    friend bool operator==(const Mm&, const Mm&) = default;
};

/// A rectangle in millimetres.
struct MmBox {
    Mm low = {INT64_MAX, INT64_MAX};
    Mm high = {INT64_MIN, INT64_MIN};
    void add(Mm at);
    [[nodiscard]] bool empty() const { return low.x > high.x; }
};

class SvgPath {
public:
    void move(Mm to);
    /// Nothing where the point is the current one.
    void line(Mm to);
    void close();
    /// A closed polygon.
    void ring(std::span<const Mm> points);
    void polyline(std::span<const Mm> points);
    void segment(Mm from, Mm to);
    /// Part of a circle around a point that is `radius` away from both ends, less than half a turn.
    void arc(std::int64_t radius, bool counter_clockwise, Mm to);
    /// A dot: to be stroked with round caps.
    void dot(Mm at);

    [[nodiscard]] const std::string& text() const { return text_; }
    [[nodiscard]] bool empty() const { return text_.empty(); }
    [[nodiscard]] std::size_t size() const { return text_.size(); }

private:
    void number(std::int64_t value);
    void command(char letter);

    std::string text_;
    Mm at_;
    Mm start_;
    char last_ = 0;
};

/// `<path class="CLASSES" d="..."/>` with a line end; nothing for an empty path.
[[nodiscard]] std::string path_tag(const std::string& classes, const SvgPath& path);

}  // namespace enfilade::tools
