// Storeys by ascending elevation, each with a height of its own and something to build.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "plans/clean_steps.h"

namespace enfilade::plans {
namespace {

constexpr double kLeastRise = 1.0;  ///< m between the floors of two storeys
constexpr double kUsualHeight = 2.5;
constexpr double kUsualSlab = 0.2;

bool below(const Storey& l, const Storey& r) {
    return l.elevation != r.elevation ? l.elevation < r.elevation : l.id < r.id;
}

bool builds(const Storey& storey) { return !storey.walls.empty() || !storey.rooms.empty(); }

Finding about_storey(const char* code, Severity severity, const Storey& storey) {
    Finding finding;
    finding.code = code;
    finding.severity = severity;
    finding.storey = storey.id;
    finding.elements.push_back({"storey", storey.id, storey.name});
    finding.sentence = "Storey " + called(storey);
    return finding;
}

/// The storey that says where the ground is, where the plan does not.
const Storey* ground_storey(const std::vector<Storey>& storeys) {
    for (const Storey& storey : storeys)
        if (storey.elevation >= 0) return &storey;
    return storeys.empty() ? nullptr : &storeys.back();
}

void drop_placeless(std::vector<Storey>& storeys, CleanReport& report) {
    std::erase_if(storeys, [&](const Storey& storey) {
        if (std::isfinite(storey.elevation)) return false;
        Finding finding = about_storey("P200", Severity::Error, storey);
        finding.sentence += " has an elevation that is not a finite number, and was left out.";
        finding.hint = "Give the elevation of its floor in metres.";
        report.add(std::move(finding));
        return true;
    });
}

void repair_sizes(std::vector<Storey>& storeys, CleanReport& report) {
    for (std::size_t k = 0; k < storeys.size(); ++k) {
        Storey& storey = storeys[k];
        if (!(storey.slab_thickness >= 0) || !std::isfinite(storey.slab_thickness)) {
            Finding finding = about_storey("P203", Severity::Warning, storey);
            finding.sentence +=
                " has a slab of negative or unknown thickness: " + metres_text(kUsualSlab) + " is taken.";
            finding.hint = "Give the thickness of the slab under its floor.";
            storey.slab_thickness = kUsualSlab;
            report.add(std::move(finding));
        }
        if (storey.height > 0 && std::isfinite(storey.height)) continue;
        double height = kUsualHeight;
        if (k + 1 < storeys.size()) {
            const double slab = storeys[k + 1].slab_thickness;
            const double room = storeys[k + 1].elevation - storey.elevation - (slab >= 0 ? slab : kUsualSlab);
            if (room >= kLeastRise && std::isfinite(room)) height = room;
        }
        Finding finding = about_storey("P203", Severity::Warning, storey);
        finding.sentence += " has no height: " + metres_text(height) + " is taken.";
        finding.hint = "Give its height from floor to ceiling.";
        storey.height = height;
        report.add(std::move(finding));
    }
}

template <class Element>
void append(std::vector<Element>& to, std::vector<Element>& from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
    from.clear();
}

std::string count_text(std::size_t count, const std::string& one, const std::string& more) {
    return std::to_string(count) + " " + (count == 1 ? one : more);
}

std::string count_text(std::size_t count, const std::string& one) { return count_text(count, one, one + "s"); }

/// Drops what would end under the floor of the storey that the level joins (false ceilings): its walls, and its
/// rooms where all of it lies there. Returns how many.
std::size_t drop_buried(Storey& level, double rise) {
    const auto under = [&](double top) { return top + rise <= level_tops; };
    std::size_t count = 0;
    if (rise < 0)
        count += std::erase_if(
            level.walls, [&](const Wall& wall) { return under(std::max(wall.height_at_start, wall.height_at_end)); });
    if (rise < 0 && under(level.height)) {
        count += level.rooms.size();
        level.rooms.clear();
    }
    std::unordered_set<std::string> walls;
    for (const Wall& wall : level.walls) walls.insert(wall.id);
    if (count > 0) count += std::erase_if(level.openings, [&](const Opening& o) { return !walls.contains(o.wall); });
    return count;
}

/// Joins `level` to the floor of `base`. Tops of walls stay where they are; openings, lights and furniture keep
/// their height above the floor on which they stand.
void merge(Storey& base, Storey& level, CleanReport& report) {
    const double rise = level.elevation - base.elevation;
    Finding finding = about_storey("P201", Severity::Warning, level);
    finding.storey = base.id;
    finding.elements.push_back({"storey", base.id, base.name});
    finding.sentence += (rise == 0 ? std::string(" lies at the same elevation as")
                                   : " lies " + metres_text(std::abs(rise)) + (rise > 0 ? " above" : " below")) +
                        " storey " + called(base) + ", with no room between them: they were made one storey at " +
                        metres_text(base.elevation) + ".";
    const std::size_t buried = drop_buried(level, rise);
    if (buried > 0) {
        finding.sentence.pop_back();
        finding.sentence += "; " + count_text(buried, "element", "elements") + " under that floor " +
                            (buried == 1 ? "was" : "were") + " left out.";
    }
    finding.hint =
        "Give the two storeys elevations at least " + metres_text(kLeastRise) + " apart, or draw them as one.";
    finding.moved_mm = std::abs(rise) * 1000;
    report.add(std::move(finding));

    const double top = std::max(base.elevation + base.height, level.elevation + level.height);
    base.height = std::max(base.height, top - base.elevation);
    for (Wall& wall : level.walls) {
        wall.height_at_start = std::max(0.0, wall.height_at_start + rise);
        wall.height_at_end = std::max(0.0, wall.height_at_end + rise);
    }
    append(base.walls, level.walls);
    append(base.openings, level.openings);
    append(base.rooms, level.rooms);
    append(base.columns, level.columns);
    append(base.stairs, level.stairs);
    append(base.shafts, level.shafts);
    append(base.lights, level.lights);
    append(base.furniture, level.furniture);
}

/// The floor at which two levels become one: that of more walls, then the lower.
bool is_base(const Storey& l, const Storey& r) {
    return l.walls.size() != r.walls.size() ? l.walls.size() > r.walls.size() : below(l, r);
}

/// Merges the first two levels that are too close; false where there are none. Levels that build nothing take no
/// part: they are dropped later.
bool merge_two(std::vector<Storey>& storeys, std::string& ground, CleanReport& report) {
    Storey* lower = nullptr;
    for (std::size_t k = 0; k < storeys.size(); ++k) {
        if (!builds(storeys[k])) continue;
        if (lower == nullptr || storeys[k].elevation - lower->elevation >= kLeastRise) {
            lower = &storeys[k];
            continue;
        }
        Storey& upper = storeys[k];
        const bool keep_lower = is_base(*lower, upper);
        Storey& base = keep_lower ? *lower : upper;
        Storey& level = keep_lower ? upper : *lower;
        if (ground == level.id) ground = base.id;
        merge(base, level, report);
        storeys.erase(storeys.begin() + (&level - storeys.data()));
        return true;
    }
    return false;
}

/// What stands on a level that builds nothing goes to the storey in which it hangs.
void rescue(Storey& level, std::vector<Storey>& storeys) {
    Storey* host = nullptr;
    for (Storey& storey : storeys)
        if (builds(storey) && (host == nullptr || storey.elevation <= level.elevation)) host = &storey;
    if (host == nullptr) return;
    const double rise = level.elevation - host->elevation;
    for (Light& light : level.lights) light.elevation += rise;
    for (Furniture& piece : level.furniture) piece.elevation += rise;
    append(host->lights, level.lights);
    append(host->furniture, level.furniture);
}

}  // namespace

void clean_storeys(Plan& plan, CleanReport& report) {
    std::vector<Storey>& storeys = plan.storeys;
    drop_placeless(storeys, report);
    std::sort(storeys.begin(), storeys.end(), below);
    repair_sizes(storeys, report);
    const Storey* ground = ground_storey(storeys);
    if (ground == nullptr) return;
    // The ground stays with its storey, wherever merging puts that.
    std::string ground_id = ground->id;
    while (merge_two(storeys, ground_id, report)) {
    }
    if (!plan.ground_level && ground_storey(storeys)->id != ground_id)
        for (const Storey& storey : storeys)
            if (storey.id == ground_id) plan.ground_level = storey.elevation;
}

void drop_empty_storeys(Plan& plan, CleanReport& report) {
    std::vector<Storey>& storeys = plan.storeys;
    if (std::all_of(storeys.begin(), storeys.end(), builds)) return;
    const double ground = ground_storey(storeys)->elevation;
    for (Storey& storey : storeys) {
        if (builds(storey)) continue;
        Finding finding = about_storey("P202", Severity::Note, storey);
        finding.sentence += " holds neither walls nor rooms, and was left out";
        std::string lost;
        for (const auto& [count, what] :
             {std::pair(storey.openings.size(), "opening"), std::pair(storey.columns.size(), "column"),
              std::pair(storey.stairs.size(), "stair"), std::pair(storey.shafts.size(), "shaft")})
            if (count > 0) lost += (lost.empty() ? "" : ", ") + count_text(count, what);
        if (!lost.empty()) finding.sentence += " with " + lost;
        const std::size_t pieces = storey.lights.size() + storey.furniture.size();
        const bool hosted = std::any_of(storeys.begin(), storeys.end(), builds);
        if (pieces > 0)
            finding.sentence += (hosted ? "; the storey below keeps its " : "; so were its ") +
                                count_text(storey.lights.size(), "light") + " and " +
                                count_text(storey.furniture.size(), "piece") + " of furniture";
        finding.sentence += ".";
        finding.hint = "Draw walls on it if it is meant to be built.";
        report.add(std::move(finding));
        rescue(storey, storeys);
    }
    std::erase_if(storeys, [](const Storey& storey) { return !builds(storey); });
    if (!plan.ground_level && !storeys.empty() && ground_storey(storeys)->elevation != ground)
        plan.ground_level = ground;
}

}  // namespace enfilade::plans
