// Openings that reach beyond their wall, over its top, or into each other.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "plans/clean_steps.h"

namespace enfilade::plans {
namespace {

/// The openings of one wall, as spans of its axis.
class WallOpenings {
public:
    WallOpenings(Storey& storey, const Wall& wall, std::vector<bool>& keep, CleanReport& report)
        : storey_(storey), wall_(wall), axis_(axis_of(wall)), keep_(keep), report_(report) {}

    void run(std::vector<std::uint32_t>& openings) {
        for (const std::uint32_t o : openings) fit(o);
        std::erase_if(openings, [&](std::uint32_t o) { return !keep_[o]; });
        std::sort(openings.begin(), openings.end(), [&](std::uint32_t l, std::uint32_t r) {
            const Opening& a = storey_.openings[l];
            const Opening& b = storey_.openings[r];
            return a.offset != b.offset ? a.offset < b.offset : a.id < b.id;
        });
        const std::uint32_t* last = nullptr;  // the kept one that reaches farthest
        for (const std::uint32_t& o : openings) {
            if (last != nullptr) part(o, *last);
            if (keep_[o] && (last == nullptr || to(storey_.openings[o]) > to(storey_.openings[*last]))) last = &o;
        }
    }

private:
    static double from(const Opening& opening) { return opening.offset - opening.width / 2; }
    static double to(const Opening& opening) { return opening.offset + opening.width / 2; }
    static void set(Opening& opening, double from, double to) {
        opening.offset = (from + to) / 2;
        opening.width = to - from;
    }

    Finding about_opening(const char* code, Severity severity, const Opening& opening) const {
        const double share = std::clamp(opening.offset / axis_.length(), 0.0, 1.0);
        Finding finding = about(code, severity, "opening", opening, storey_, axis_.at(share));
        finding.elements.push_back({"wall", wall_.id, wall_.name});
        finding.sentence = named("Opening", opening, storey_);
        return finding;
    }

    void leave_out(std::uint32_t o, const char* code, Severity severity, const std::string& why, const char* hint) {
        Finding finding = about_opening(code, severity, storey_.openings[o]);
        finding.sentence += " " + why + ", and was left out.";
        finding.hint = hint;
        report_.add(std::move(finding));
        keep_[o] = false;
    }

    void fit(std::uint32_t o) {
        Opening& opening = storey_.openings[o];
        if (!(opening.width >= narrowest_opening - 1e-9)) {
            leave_out(o, "P225", Severity::Error, "is " + millimetres_text(opening.width) + " wide",
                      "Openings must be at least 10 mm wide: check the units of the plan.");
            return;
        }
        if (!(opening.head > opening.sill)) {
            leave_out(
                o, "P224", Severity::Error,
                "has its head at " + metres_text(opening.head) + ", not above its sill at " + metres_text(opening.sill),
                "Give it a head above its sill.");
            return;
        }
        fit_along(o);
        if (keep_[o]) fit_upright(o);
    }

    void fit_along(std::uint32_t o) {
        Opening& opening = storey_.openings[o];
        const double length = axis_.length();
        const double inside = std::min(to(opening), length) - std::max(from(opening), 0.0);
        if (!(inside >= narrowest_opening - 1e-9)) {
            leave_out(o, "P222", Severity::Error,
                      "lies beyond the ends of its wall " + called(wall_) + " (" + metres_text(length) + " long)",
                      "Move it along its wall, or bind it to the wall that it stands in.");
            return;
        }
        const bool before = from(opening) < -same_length;
        const bool behind = to(opening) > length + same_length;
        if (!before && !behind) return;
        const double margins = end_margin * (int(before) + int(behind));
        const double margin = inside - margins >= inside / 2 ? end_margin : 0;
        const double was = opening.width;
        const double low = before ? margin : from(opening);
        const double high = behind ? length - margin : to(opening);
        Finding finding = about_opening("P221", Severity::Warning, opening);
        finding.moved_mm = 1000 * std::max(low - from(opening), to(opening) - high);
        set(opening, low, high);
        finding.sentence += " reaches beyond " + std::string(before && behind ? "both ends" : "the end") +
                            " of its wall " + called(wall_) + ": it was cut from " + metres_text(was) + " to " +
                            metres_text(opening.width) + " wide.";
        finding.hint = "Move it along its wall, or make it narrower.";
        report_.add(std::move(finding));
    }

    void fit_upright(std::uint32_t o) {
        Opening& opening = storey_.openings[o];
        const double top = std::max(wall_.height_at_start, wall_.height_at_end);
        const bool over = opening.head > top + same_length;
        const bool under = opening.sill < -same_length;
        if (!over && !under) return;
        const double sill = under ? 0 : opening.sill;
        const double head = over ? top : opening.head;
        if (!(head - sill >= narrowest_opening)) {
            leave_out(o, "P224", Severity::Error,
                      over ? "begins at " + metres_text(opening.sill) + ", over the top of its wall " + called(wall_) +
                                 " at " + metres_text(top)
                           : "ends at " + metres_text(opening.head) + ", under the floor",
                      "Lower its sill, or make the wall higher.");
            return;
        }
        Finding finding = about_opening("P223", Severity::Warning, opening);
        finding.moved_mm = 1000 * std::max(sill - opening.sill, opening.head - head);
        finding.sentence +=
            (over ? " is higher than its wall " + called(wall_) : std::string(" begins under the floor")) +
            ": it was cut to stand from " + metres_text(sill) + " to " + metres_text(head) + ".";
        finding.hint = over ? "Lower its head, or make the wall higher." : "Raise its sill.";
        opening.sill = sill;
        opening.head = head;
        report_.add(std::move(finding));
    }

    /// Takes from `o` what `last`, which comes before it, holds already.
    void part(std::uint32_t o, std::uint32_t last) {
        Opening& opening = storey_.openings[o];
        const Opening& first = storey_.openings[last];
        const double overlap = to(first) - from(opening);
        if (overlap <= same_length) return;
        const double rest = to(opening) - to(first);
        Finding finding = about_opening(rest < end_margin ? "P227" : "P226", Severity::Warning, opening);
        finding.elements.push_back({"opening", first.id, first.name});
        finding.hint = "Draw openings of one wall side by side; one above the other is not modelled.";
        if (rest < end_margin) {
            finding.sentence += " lies within " + called(first) + ", and was left out.";
            keep_[o] = false;
        } else {
            finding.sentence += " overlaps " + called(first) + " by " + metres_text(overlap) + ": it was cut from " +
                                metres_text(opening.width) + " to " + metres_text(rest) + " wide.";
            finding.moved_mm = overlap * 1000;
            set(opening, to(first), to(opening));
        }
        report_.add(std::move(finding));
    }

    Storey& storey_;
    const Wall& wall_;
    WallAxis axis_;
    std::vector<bool>& keep_;
    CleanReport& report_;
};

bool numbers(const Opening& o) {
    return std::isfinite(o.offset) && std::isfinite(o.width) && std::isfinite(o.sill) && std::isfinite(o.head) &&
           std::isfinite(o.open_angle) && o.depth_left >= 0 && std::isfinite(o.depth_left) && o.depth_right >= 0 &&
           std::isfinite(o.depth_right);
}

}  // namespace

void clean_openings(Storey& storey, CleanReport& report) {
    std::unordered_map<std::string, std::uint32_t> wall_by_id;
    for (std::uint32_t w = 0; w < storey.walls.size(); ++w) wall_by_id.emplace(storey.walls[w].id, w);
    std::vector<std::vector<std::uint32_t>> openings_of(storey.walls.size());
    std::vector<bool> keep(storey.openings.size(), true);
    std::vector<std::uint32_t> order(storey.openings.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t l, std::uint32_t r) { return storey.openings[l].id < storey.openings[r].id; });
    for (const std::uint32_t o : order) {
        const Opening& opening = storey.openings[o];
        const auto host = wall_by_id.find(opening.wall);
        if (host != wall_by_id.end() && numbers(opening)) {
            openings_of[host->second].push_back(o);
            continue;
        }
        keep[o] = false;
        const bool lost = host == wall_by_id.end();
        Finding finding = about(lost ? "P220" : "P228", Severity::Error, "opening", opening, storey, {});
        finding.point.reset();
        finding.sentence = named("Opening", opening, storey) +
                           (lost ? " stands in the wall \"" + opening.wall + "\", which is not built"
                                 : std::string(" has a size that is negative or not a number")) +
                           ": it was left out.";
        finding.hint = lost ? "Bind it to a wall of its storey." : "Give it finite numbers.";
        report.add(std::move(finding));
    }
    std::vector<std::uint32_t> walls(storey.walls.size());
    std::iota(walls.begin(), walls.end(), 0u);
    std::sort(walls.begin(), walls.end(),
              [&](std::uint32_t l, std::uint32_t r) { return storey.walls[l].id < storey.walls[r].id; });
    for (const std::uint32_t w : walls)
        if (!openings_of[w].empty()) WallOpenings(storey, storey.walls[w], keep, report).run(openings_of[w]);
    std::size_t k = 0;
    std::erase_if(storey.openings, [&](const Opening&) { return !keep[k++]; });
}

}  // namespace enfilade::plans
