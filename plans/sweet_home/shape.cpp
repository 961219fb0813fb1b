#include "plans/sweet_home/shape.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include "plans/vector2.h"

namespace enfilade::plans {
namespace {

constexpr std::size_t max_corners = 4096;
constexpr int curve_chords = 12;
constexpr double largest = 1e3;  // in squares: no shape reaches out farther

class PathReader {
public:
    explicit PathReader(std::string_view text) : text_(text) {}

    std::optional<std::vector<std::vector<Point>>> run() {
        char command = 0;
        for (skip(); at_ < text_.size(); skip()) {
            if (std::isalpha(static_cast<unsigned char>(text_[at_])) != 0) {
                command = text_[at_++];
                if (command == 'z' || command == 'Z') {
                    close();
                    continue;
                }
            } else if (command == 'M') {
                command = 'L';
            } else if (command == 'm') {
                command = 'l';
            }
            if (!step(command) || corners_ > max_corners) return {};
        }
        finish();
        return std::move(rings_);
    }

private:
    void skip() {
        while (at_ < text_.size() && std::string_view(" \t\r\n,").find(text_[at_]) != std::string_view::npos) ++at_;
    }

    bool number(double& value) {
        skip();
        if (at_ < text_.size() && text_[at_] == '+') ++at_;
        const auto result = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
        if (result.ec != std::errc() || !(std::abs(value) <= largest)) return false;
        at_ = std::size_t(result.ptr - text_.data());
        return true;
    }
    /// Flags of arcs may stand together: "01".
    bool flag(bool& value) {
        skip();
        if (at_ >= text_.size() || (text_[at_] != '0' && text_[at_] != '1')) return false;
        value = text_[at_++] == '1';
        return true;
    }
    bool point(Point& p, bool relative) {
        if (!number(p.x) || !number(p.y)) return false;
        if (relative) p = p + here_;
        return true;
    }

    bool step(char command) {
        const bool relative = command >= 'a';
        Point p = here_;
        switch (command & ~0x20) {
            case 'M':
                if (!point(p, relative)) return false;
                finish();
                start_ = p;
                break;
            case 'L':
            case 'T':
                if (!point(p, relative)) return false;
                break;
            case 'H':
                if (!number(p.x)) return false;
                if (relative) p.x += here_.x;
                break;
            case 'V':
                if (!number(p.y)) return false;
                if (relative) p.y += here_.y;
                break;
            case 'A': return arc(relative);
            case 'C': return curve(relative, 3);
            case 'S':
            case 'Q': return curve(relative, 2);
            default: return false;
        }
        add(p);
        return true;
    }

    /// Béziers by their control points; smooth ones begin in their first point, which is near enough for a hole.
    bool curve(bool relative, int count) {
        Point c[4] = {here_};
        for (int k = 1; k <= count; ++k)
            if (!point(c[k], relative)) return false;
        for (int k = 1; k <= curve_chords; ++k) {
            const double t = double(k) / curve_chords;
            Point level[4] = {c[0], c[1], c[2], c[3]};
            for (int size = count; size > 0; --size)
                for (int i = 0; i < size; ++i) level[i] = level[i] * (1 - t) + level[i + 1] * t;
            add(k == curve_chords ? c[count] : level[0]);
        }
        return true;
    }

    /// From end points to the centre (SVG 1.1, appendix F.6.5).
    bool arc(bool relative) {
        double rx = 0, ry = 0, degrees = 0;
        bool large = false, sweep = false;
        Point end;
        if (!number(rx) || !number(ry) || !number(degrees) || !flag(large) || !flag(sweep) || !point(end, relative))
            return false;
        rx = std::abs(rx);
        ry = std::abs(ry);
        if (rx < 1e-9 || ry < 1e-9 || distance(here_, end) < 1e-9) {
            add(end);
            return true;
        }
        const double turn = degrees * std::numbers::pi / 180;
        const auto turned = [](Point p, double angle) {
            return Point{p.x * std::cos(angle) - p.y * std::sin(angle), p.x * std::sin(angle) + p.y * std::cos(angle)};
        };
        const Point half = turned((here_ - end) * 0.5, -turn);
        const double reach = std::hypot(half.x / rx, half.y / ry);
        if (reach > 1) {
            rx *= reach;
            ry *= reach;
        }
        const double square = half.x * half.x / (rx * rx) + half.y * half.y / (ry * ry);
        const double away = std::sqrt(std::max(0.0, 1 / square - 1)) * (large == sweep ? -1 : 1);
        const Point middle{away * rx * half.y / ry, -away * ry * half.x / rx};
        const double from = std::atan2((half.y - middle.y) / ry, (half.x - middle.x) / rx);
        double extent = std::atan2((-half.y - middle.y) / ry, (-half.x - middle.x) / rx) - from;
        if (sweep && extent < 0) extent += 2 * std::numbers::pi;
        if (!sweep && extent > 0) extent -= 2 * std::numbers::pi;
        const Point centre = turned(middle, turn) + (here_ + end) * 0.5;
        const int chords = std::max(1, int(std::ceil(std::abs(extent) / (std::numbers::pi / 16))));
        for (int k = 1; k < chords; ++k) {
            const double angle = from + extent * k / chords;
            add(centre + turned({rx * std::cos(angle), ry * std::sin(angle)}, turn));
        }
        add(end);
        return true;
    }

    void add(Point p) {
        here_ = p;
        ++corners_;
        if (ring_.empty() || distance(ring_.back(), p) > 1e-9) ring_.push_back(p);
    }
    void close() {
        finish();
        here_ = start_;
    }
    void finish() {
        while (ring_.size() > 1 && distance(ring_.front(), ring_.back()) <= 1e-9) ring_.pop_back();
        if (ring_.size() >= 3) rings_.push_back(std::move(ring_));
        ring_.clear();
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t corners_ = 0;
    Point here_;
    Point start_;
    std::vector<Point> ring_;
    std::vector<std::vector<Point>> rings_;
};

}  // namespace

std::optional<std::vector<std::vector<Point>>> path_rings(std::string_view path) { return PathReader(path).run(); }

double signed_area(const std::vector<Point>& ring) {
    double twice = 0;
    for (std::size_t k = 0; k < ring.size(); ++k) twice += cross(ring[k], ring[(k + 1) % ring.size()]);
    return twice / 2;
}

}  // namespace enfilade::plans
