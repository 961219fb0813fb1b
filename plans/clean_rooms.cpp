// Polygons that enclose nothing, say a corner twice or cross themselves; things without a place.

#include <algorithm>
#include <cmath>
#include <numeric>

#include "plans/clean_steps.h"
#include "plans/limits.h"
#include "plans/vector2.h"

namespace enfilade::plans {
namespace {

constexpr double kSmallestArea = 1e-4;  ///< m2

bool finite(Point p) { return std::isfinite(p.x) && std::isfinite(p.y); }

bool one_place(Point a, Point b) { return distance(a, b) < same_length; }

/// Keeps the first of each run of equal corners; the last one may repeat the first.
std::vector<Point> without_repeats(const std::vector<Point>& polygon) {
    std::vector<Point> kept;
    for (const Point p : polygon)
        if (kept.empty() || !one_place(kept.back(), p)) kept.push_back(p);
    while (kept.size() > 1 && one_place(kept.back(), kept.front())) kept.pop_back();
    return kept;
}

double area(const std::vector<Point>& polygon) {
    double twice = 0;  // relative to a corner: far from the origin the products would swallow it
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        twice += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
    return std::abs(twice) / 2;
}

int side(Point a, Point b, Point p) {
    const double turn = cross(b - a, p - a);
    return (turn > 0) - (turn < 0);
}

bool cross_each_other(Point a, Point b, Point c, Point d) {
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

/// Where two sides cross: a sweep over the sides by their least x. Sides that only touch do not cross.
std::optional<Point> self_crossing(const std::vector<Point>& polygon) {
    const std::size_t count = polygon.size();
    const auto from = [&](std::size_t i) { return polygon[i]; };
    const auto to = [&](std::size_t i) { return polygon[(i + 1) % count]; };
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto low = [&](std::size_t i) { return std::min(from(i).x, to(i).x); };
    const auto high = [&](std::size_t i) { return std::max(from(i).x, to(i).x); };
    std::sort(order.begin(), order.end(),
              [&](std::size_t l, std::size_t r) { return low(l) != low(r) ? low(l) < low(r) : l < r; });
    std::vector<std::size_t> active;
    for (const std::size_t i : order) {
        std::erase_if(active, [&](std::size_t j) { return high(j) < low(i); });
        for (const std::size_t j : active) {
            if (!cross_each_other(from(i), to(i), from(j), to(j))) continue;
            const Point along = to(i) - from(i);
            const Point other = to(j) - from(j);
            return from(i) + along * (cross(from(j) - from(i), other) / cross(along, other));
        }
        active.push_back(i);
    }
    return std::nullopt;
}

/// The polygons of one kind of element of a storey.
class Polygons {
public:
    Polygons(const Storey& storey, CleanReport& report) : storey_(storey), report_(report) {}

    template <class Element>
    void clean(std::vector<Element>& elements, const char* kind, const char* title) {
        std::erase_if(elements, [&](Element& element) { return !fit(element, kind, title); });
    }

    void note_repeats() const {
        if (repeats_ == 0) return;
        Finding finding;
        finding.code = "P230";
        finding.severity = Severity::Note;
        finding.storey = storey_.id;
        finding.elements.push_back({"storey", storey_.id, storey_.name});
        finding.sentence = "Storey " + called(storey_) + " has " + std::to_string(repeats_) + " polygon corner" +
                           (repeats_ == 1 ? " that repeats" : "s that repeat") + " the one before; " +
                           (repeats_ == 1 ? "it was" : "they were") + " left out.";
        finding.hint = "Nothing needs to be done.";
        report_.add(std::move(finding));
    }

private:
    template <class Element>
    bool fit(Element& element, const char* kind, const char* title) {
        if (!std::all_of(element.polygon.begin(), element.polygon.end(), finite)) {
            Finding finding = about("P233", Severity::Error, kind, element, storey_, {});
            finding.point.reset();
            finding.sentence =
                named(title, element, storey_) + " has a corner that is not a finite number, and was left out.";
            finding.hint = "Give its corners finite coordinates.";
            report_.add(std::move(finding));
            return false;
        }
        std::vector<Point> polygon = without_repeats(element.polygon);
        const Point at = polygon.empty() ? Point{} : polygon.front();
        if (polygon.size() < 3 || area(polygon) < kSmallestArea) {
            // A figure of eight may enclose as much to its left as to its right.
            if (polygon.size() < 4 || !self_crossing(polygon)) {
                Finding finding = about("P231", Severity::Warning, kind, element, storey_, at);
                if (polygon.empty()) finding.point.reset();
                finding.sentence = named(title, element, storey_) + " encloses no area, and was left out.";
                finding.hint = "Draw its outline with three corners at least, or remove it.";
                report_.add(std::move(finding));
                return false;
            }
        }
        repeats_ += element.polygon.size() - polygon.size();
        if (polygon.size() != element.polygon.size()) element.polygon = std::move(polygon);
        if (const std::optional<Point> crossing = self_crossing(element.polygon)) {
            Finding finding = about("P232", Severity::Warning, kind, element, storey_, *crossing);
            finding.sentence = named(title, element, storey_) + " crosses its own outline at (" +
                               rounded_text(crossing->x, 3) + ", " + rounded_text(crossing->y, 3) + ").";
            finding.hint = "Draw its corners in order around it.";
            report_.add(std::move(finding));
        }
        return true;
    }

    const Storey& storey_;
    CleanReport& report_;
    std::size_t repeats_ = 0;
};

/// Lights and furniture that no model can place.
template <class Element, class Sound>
void drop_unsound(std::vector<Element>& elements, const char* kind, const char* title, const Storey& storey,
                  CleanReport& report, Sound sound) {
    std::erase_if(elements, [&](const Element& element) {
        if (sound(element)) return false;
        Finding finding = about("P240", Severity::Error, kind, element, storey, element.position);
        if (!finite(element.position)) finding.point.reset();
        finding.sentence =
            named(title, element, storey) + " has a place or size that no model can hold, and was left out.";
        finding.hint = "Give it a finite place and positive sizes.";
        report.add(std::move(finding));
        return true;
    });
}

}  // namespace

void clean_rooms(Storey& storey, CleanReport& report) {
    Polygons polygons(storey, report);
    polygons.clean(storey.rooms, "room", "Room");
    polygons.clean(storey.columns, "column", "Column");
    polygons.clean(storey.stairs, "stair", "Stair");
    polygons.clean(storey.shafts, "shaft", "Shaft");
    polygons.note_repeats();
    std::erase_if(storey.columns, [&](const Column& column) {
        if (column.height >= 0 && std::isfinite(column.height)) return false;
        Finding finding = about("P234", Severity::Error, "column", column, storey, column.polygon.front());
        finding.sentence = named("Column", column, storey) + " has a height below 0 or none, and was left out.";
        finding.hint = "Give it a height; 0 reaches to the ceiling.";
        report.add(std::move(finding));
        return true;
    });
    drop_unsound(storey.lights, "light", "Light", storey, report, [](const Light& light) {
        const auto is_share = [](float c) { return c >= 0 && c <= 1; };
        return finite(light.position) && std::isfinite(light.elevation) && light.power_lumen >= 0 &&
               light.power_lumen <= limits::lumen && light.radius >= 0 && light.radius <= limits::thickness &&
               std::ranges::all_of(light.colour, is_share);
    });
    drop_unsound(storey.furniture, "furniture", "Piece of furniture", storey, report, [](const Furniture& piece) {
        const auto positive = [](double size) { return size > 0 && std::isfinite(size); };
        return finite(piece.position) && std::isfinite(piece.elevation) && std::isfinite(piece.angle) &&
               positive(piece.width) && positive(piece.depth) && positive(piece.height);
    });
}

}  // namespace enfilade::plans
