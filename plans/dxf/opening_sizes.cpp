#include "plans/dxf/opening_sizes.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>

#include "plans/box_index.h"
#include "plans/dxf/role.h"
#include "plans/vector2.h"

namespace enfilade::plans {
namespace {

constexpr double foot = 0.3048;
constexpr double inch = 0.0254;
constexpr double reach = 1.2;         ///< metres from a text to its opening
constexpr double door_height = 1.9;   ///< metres: what is lower is a window
constexpr double usual_head = 2.1;    ///< metres, of windows
constexpr double least_width = 0.35;  ///< metres, of what sizes are written at
constexpr double most_width = 6.5;
constexpr double least_height = 0.25;
constexpr double most_height = 4.0;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Reads from the front of a text.
class Scan {
public:
    explicit Scan(std::string_view text) : rest_(text) {}

    void blanks() {
        while (!rest_.empty() && rest_.front() == ' ') rest_.remove_prefix(1);
    }
    bool take(char c) {
        if (rest_.empty() || rest_.front() != c) return false;
        rest_.remove_prefix(1);
        return true;
    }
    std::optional<double> number() {
        double value = 0;
        if (rest_.empty() || !is_digit(rest_.front())) return std::nullopt;
        const auto end =
            std::from_chars(rest_.data(), rest_.data() + rest_.size(), value, std::chars_format::fixed).ptr;
        rest_.remove_prefix(std::size_t(end - rest_.data()));
        if (rest_.size() > 1 && rest_[0] == ',' && is_digit(rest_[1])) {
            double scale = 1;
            for (rest_.remove_prefix(1); !rest_.empty() && is_digit(rest_.front()); rest_.remove_prefix(1))
                value += (rest_.front() - '0') * (scale /= 10);
        }
        return value;
    }
    /// 2'6, 2'-6", 30": metres.
    std::optional<double> feet_and_inches() {
        const auto first = number();
        if (!first) return std::nullopt;
        if (take('"')) return *first * inch;
        if (!take('\'')) return std::nullopt;
        blanks();
        take('-');
        blanks();
        const auto second = number();
        take('"');
        return *first * foot + second.value_or(0) * inch;
    }
    [[nodiscard]] std::string_view rest() const { return rest_; }

private:
    std::string_view rest_;
};

bool between(Scan& scan) {
    scan.blanks();
    const bool found = scan.take('x') || scan.take('X') || scan.take('*') || scan.take('/');
    scan.blanks();
    return found;
}

struct Size {
    double width;
    double height;
};

bool plausible(const Size& size) {
    return size.width >= least_width && size.width <= most_width && size.height >= least_height &&
           size.height <= most_height;
}

/// 2668 is 2'6" by 6'8", 16070 is 16'0" by 7'0".
std::optional<Size> digits_as_feet(Scan& scan) {
    std::size_t count = 0;
    const std::string_view text = scan.rest();
    while (count < text.size() && is_digit(text[count])) ++count;
    if (count < 4 || count > 5 || text[0] == '0' || (count < text.size() && text[count] != ' ')) return std::nullopt;
    const auto value = scan.number();
    const int digits = value ? int(*value) : 0;
    const Size size{digits / 1000 * foot + digits / 100 % 10 * inch, digits / 10 % 10 * foot + digits % 10 * inch};
    if (!plausible(size)) return std::nullopt;
    return size;
}

std::optional<Size> feet_by_feet(Scan& scan) {
    const auto width = scan.feet_and_inches();
    if (!width || !between(scan)) return std::nullopt;
    const auto height = scan.feet_and_inches();
    if (!height || !plausible({*width, *height})) return std::nullopt;
    return Size{*width, *height};
}

/// 90/210, 0.90 x 2.10, 900x2100: of metres, centimetres and millimetres the one that makes sense.
std::optional<Size> metric(Scan& scan) {
    const auto width = scan.number();
    if (!width || !between(scan)) return std::nullopt;
    const auto height = scan.number();
    if (!height) return std::nullopt;
    // Whole metres are rather fractions, dates, or numbers of pages.
    const bool whole = *width == std::floor(*width) && *height == std::floor(*height);
    for (const double unit : {0.01, 0.001, 1.0})
        if (whole && unit == 1.0) break;
        else if (const Size size{*width * unit, *height * unit}; plausible(size)) return size;
    return std::nullopt;
}

std::optional<OpeningKind> kind_in_words(std::string_view words) {
    const std::string text = folded(words);
    const auto has = [&](std::initializer_list<const char*> list) {
        return std::any_of(list.begin(), list.end(),
                           [&](const char* word) { return text.find(word) != std::string::npos; });
    };
    if (has({"door", "s.g.d", "sgd", "slider", "bi fold", "bi-fold", "bifold", "pocket", "tur", "porte"}))
        return OpeningKind::Door;
    if (has({"xo", "ox", " sh", " dh", "fixed", "fxd", "casement", "awning", "window", "fenster", "fenetre"}))
        return OpeningKind::Window;
    return std::nullopt;
}

}  // namespace

std::optional<SizeNote> size_note(std::string_view text, bool feet) {
    Scan start(text);
    start.blanks();
    // "2#6'0X6'8": two of them, side by side or not.
    Scan counted = start;
    if (counted.number() && counted.take('#')) start = counted;
    for (const auto read : {feet_by_feet, digits_as_feet, metric}) {
        if (read == digits_as_feet && !feet) continue;
        Scan scan = start;
        const auto size = read(scan);
        if (!size) continue;
        // A sentence that begins with numbers is none.
        if (scan.rest().size() > 16) return std::nullopt;
        return SizeNote{size->width, size->height, kind_in_words(scan.rest()), {}, 0};
    }
    return std::nullopt;
}

std::vector<SizeNote> size_notes(const Drawing& drawing, double scale) {
    // Only a drawing in inches or feet counts in them.
    const bool feet = std::abs(scale / inch - 1) < 1e-6 || std::abs(scale / foot - 1) < 1e-6;
    std::vector<SizeNote> notes;
    for (const DrawingText& text : drawing.texts) {
        auto note = size_note(text.text, feet);
        if (!note) continue;
        note->at = text.at * scale;
        note->length = 0.7 * text.height * scale * double(text.text.size());
        notes.push_back(*note);
    }
    return notes;
}

void apply_sizes(std::vector<WallRun>& runs, const std::vector<SizeNote>& notes) {
    struct Place {
        RunOpening* opening;
        Point a;
        Point b;
        double nearest = reach;
        const SizeNote* note = nullptr;
    };
    std::vector<Place> places;
    std::vector<PlanBox> boxes;
    for (WallRun& run : runs) {
        const Point dir = (run.end - run.start) * (1 / std::max(1e-9, distance(run.start, run.end)));
        for (RunOpening& opening : run.openings) {
            places.push_back({&opening, run.start + dir * opening.u0, run.start + dir * opening.u1});
            PlanBox box;
            box.add(places.back().a);
            box.add(places.back().b);
            boxes.push_back(box.grown(reach));
        }
    }
    if (places.empty()) return;
    const BoxIndex index(boxes);
    for (const SizeNote& note : notes) {
        Place* best = nullptr;
        double least = reach;
        for (const double shift : {0.0, 0.5, 1.0}) {
            const Point at = note.at + Point{shift * note.length, 0};
            index.near(at, [&](std::uint32_t k) {
                const double width = places[k].opening->u1 - places[k].opening->u0;
                if (std::abs(width - note.width) > std::max(0.05, 0.05 * note.width)) return;
                const double away = distance(at, places[k].a, places[k].b);
                if (away < least) least = away, best = &places[k];
            });
        }
        if (best == nullptr || least >= best->nearest) continue;
        best->nearest = least;
        best->note = &note;
    }
    for (const Place& place : places) {
        if (place.note == nullptr) continue;
        RunOpening& opening = *place.opening;
        const double height = place.note->height;
        if (!opening.swings)
            opening.kind = place.note->kind.value_or(height >= door_height ? OpeningKind::Door : OpeningKind::Window);
        if (!opening.head) opening.head = opening.kind == OpeningKind::Window ? std::max(usual_head, height) : height;
        if (!opening.sill) opening.sill = opening.kind == OpeningKind::Window ? *opening.head - height : 0;
    }
}

}  // namespace enfilade::plans
