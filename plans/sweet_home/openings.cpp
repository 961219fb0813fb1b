// Which wall a door stands in (docs/sweet-home.md).
#include <algorithm>
#include <cmath>
#include <numbers>

#include "plans/limits.h"
#include "plans/number_text.h"
#include "plans/sweet_home/bodies.h"
#include "plans/sweet_home/gaps.h"
#include "plans/sweet_home/parts.h"
#include "plans/vector2.h"

namespace enfilade::plans {
namespace {

constexpr double cos_agrees = 0.93969;    // 20 degrees between door and wall
constexpr double cos_parallel = 0.98481;  // 10 degrees between walls
constexpr double area_epsilon = 1e-6;     // m2
constexpr double far_reach = 0.60;        // m, from a door to the wall it is moved into
constexpr double off_body = 0.10;         // m, how far outside a wall a door across it may have its middle
constexpr double against = 0.02;          // m between faces of walls that lie against each other
constexpr double cavity = 0.15;           // m between faces of two walls that a door is drawn through
constexpr double all_depths = 1.5;        // m, how far beyond a face further walls are looked for

const char* word(OpeningKind kind) {
    switch (kind) {
        case OpeningKind::Door: return "door";
        case OpeningKind::Window: return "window";
        case OpeningKind::Opening: return "opening";
    }
    return "opening";
}

/// How well a wall fits a door.
struct Candidate {
    std::size_t wall = 0;
    double part = 0;      ///< m2 of that part of the door that is meant to stand in the wall
    double box = 0;       ///< m2 of the whole door
    double distance = 0;  ///< m from the door's middle to the axis
    double cosine = 0;    ///< between the directions, 0..1
    bool beside = false;  ///< the middle is not beyond the wall's ends

    [[nodiscard]] bool agrees() const { return cosine >= cos_agrees; }
    [[nodiscard]] bool overlaps() const { return box > area_epsilon; }
};

/// Whether a is the better host of two that a door overlaps.
bool fits_better(const Candidate& a, const Candidate& b) {
    const bool a_part = a.part > area_epsilon;
    const bool b_part = b.part > area_epsilon;
    if (a_part != b_part) return a_part;
    const double area_a = a_part ? a.part : a.box;
    const double area_b = a_part ? b.part : b.box;
    if (std::abs(area_a - area_b) > area_epsilon) return area_a > area_b;
    return a.distance < b.distance;
}

class Binder {
public:
    Binder(Storey& storey, const std::vector<PlacedOpening>& doors, Home& home)
        : storey_(storey), home_(home), bodies_(storey, reach(doors)) {}

    void bind(PlacedOpening door) {
        const std::vector<Candidate> candidates = candidates_for(door);
        if (const auto* host = best(candidates, [](const Candidate& c) { return c.agrees() && c.beside; }))
            return place(door, *host);
        const bool blocked = std::any_of(candidates.begin(), candidates.end(), [&](const Candidate& c) {
            return c.beside && c.distance <= bodies_[c.wall].half + 0.01;
        });
        if (!blocked) {
            if (const auto gap = close_gap(door, storey_, bodies_)) return place_in_gap(door, *gap);
        }
        if (const auto* host = best(candidates, [](const Candidate& c) { return c.agrees(); }))
            return place(door, *host);
        if (const auto* host = crossed(candidates)) return place_across(door, *host);
        if (const auto* host = nearest(candidates)) return move_into(door, *host);
        leave_out(door, candidates);
    }

private:
    static double reach(const std::vector<PlacedOpening>& doors) {
        double reach = far_reach + all_depths;
        for (const PlacedOpening& door : doors) reach = std::max(reach, reach_of(door));
        return reach;
    }

    [[nodiscard]] std::vector<Candidate> candidates_for(const PlacedOpening& door) const {
        const Point along{std::cos(door.angle), std::sin(door.angle)};
        const PlanRectangle box{door.middle, along, door.width, door.depth};
        const PlanRectangle part{door.wall_middle, along, door.wall_width, door.wall_depth};
        std::vector<Candidate> candidates;
        for (const std::size_t wall : bodies_.near(door.middle)) {
            const WallBody& body = bodies_[wall];
            if (body.height <= door.opening.sill) continue;  // the hole would lie above it
            Candidate candidate;
            candidate.wall = wall;
            candidate.part = body.overlap(part);
            candidate.box = body.overlap(box);
            candidate.distance = body.distance_of(door.wall_middle);
            candidate.cosine = std::abs(dot(body.along(body.axis.nearest(door.wall_middle)), along));
            candidate.beside = body.beside(door.wall_middle, 0.01);
            candidates.push_back(candidate);
        }
        return candidates;
    }

    /// Of the walls that the door overlaps, the one that fits best.
    template <class Condition>
    [[nodiscard]] const Candidate* best(const std::vector<Candidate>& candidates, Condition condition) const {
        const Candidate* best = nullptr;
        for (const Candidate& candidate : candidates) {
            if (!candidate.overlaps() || !condition(candidate)) continue;
            if (best == nullptr || fits_better(candidate, *best) ||
                (!fits_better(*best, candidate) && before(candidate.wall, best->wall)))
                best = &candidate;
        }
        return best;
    }

    /// The wall that a door across all walls has its middle in, or almost.
    [[nodiscard]] const Candidate* crossed(const std::vector<Candidate>& candidates) const {
        const Candidate* best = nullptr;
        for (const Candidate& candidate : candidates) {
            if (!candidate.overlaps() || !candidate.beside) continue;
            if (candidate.distance > bodies_[candidate.wall].half + off_body) continue;
            if (best == nullptr || closer(candidate, *best)) best = &candidate;
        }
        return best;
    }

    /// The wall in the door's direction that it was probably meant for.
    [[nodiscard]] const Candidate* nearest(const std::vector<Candidate>& candidates) const {
        const Candidate* best = nullptr;
        for (const Candidate& candidate : candidates) {
            if (!candidate.agrees() || !candidate.beside || candidate.distance > far_reach) continue;
            if (best == nullptr || closer(candidate, *best)) best = &candidate;
        }
        return best;
    }

    [[nodiscard]] bool closer(const Candidate& a, const Candidate& b) const {
        if (std::abs(a.distance - b.distance) > 1e-6) return a.distance < b.distance;
        return before(a.wall, b.wall);
    }
    /// An order of walls that does not depend on their order in the file.
    [[nodiscard]] bool before(std::size_t a, std::size_t b) const { return storey_.walls[a].id < storey_.walls[b].id; }

    void place(PlacedOpening& door, const Candidate& candidate) {
        const WallBody& host = bodies_[candidate.wall];
        Opening& opening = door.opening;
        opening.wall = storey_.walls[candidate.wall].id;
        opening.offset = std::clamp(host.offset_of(door.wall_middle), -limits::coordinate, limits::coordinate);
        go_through(door, candidate.wall);
        storey_.openings.push_back(std::move(opening));
    }

    void place_in_gap(PlacedOpening& door, const ClosedGap& gap) {
        Wall wall = gap.wall;
        wall.id = home_.ids.take(door.opening.id + "/wall", "wall");
        wall.name = door.opening.name;
        Finding finding = said(door, "P174", Severity::Warning,
                               " stands in a gap of " + rounded_text(gap.clear, 2) +
                                   " m between walls; the gap is closed by a wall that holds it" +
                                   (gap.width < door.opening.width - 1e-6
                                        ? ", and it is made " + rounded_text(gap.width, 2) + " m wide to fit."
                                        : "."),
                               "Draw one wall over the gap in Sweet Home 3D and put the " +
                                   std::string(word(door.opening.kind)) + " into it.");
        finding.elements.push_back({"wall", wall.id, wall.name});
        finding.moved_mm = gap.moved * 1000;
        home_.report(std::move(finding));
        door.opening.wall = wall.id;
        door.opening.offset = gap.offset;
        door.opening.width = gap.width;
        storey_.openings.push_back(std::move(door.opening));
        storey_.walls.push_back(std::move(wall));
        bodies_.add(storey_.walls.back());
    }

    void place_across(PlacedOpening& door, const Candidate& candidate) {
        const double degrees = std::acos(std::min(1.0, candidate.cosine)) * 180 / std::numbers::pi;
        Finding finding = said(door, "P173", Severity::Warning,
                               " is turned by " + rounded_text(degrees, 0) +
                                   " degrees against the wall it stands in; it is turned into the wall.",
                               "Turn it in Sweet Home 3D so that it lies along its wall.");
        finding.elements.push_back({"wall", storey_.walls[candidate.wall].id, ""});
        home_.report(std::move(finding));
        place(door, candidate);
    }

    void move_into(PlacedOpening& door, const Candidate& candidate) {
        Finding finding = said(door, "P178", Severity::Warning,
                               " stands beside its wall, not in it; it is moved by " +
                                   rounded_text(candidate.distance * 1000, 0) + " mm into the nearest wall.",
                               "Move it into its wall in Sweet Home 3D.");
        finding.elements.push_back({"wall", storey_.walls[candidate.wall].id, ""});
        finding.moved_mm = candidate.distance * 1000;
        home_.report(std::move(finding));
        place(door, candidate);
    }

    void leave_out(const PlacedOpening& door, const std::vector<Candidate>& candidates) {
        double distance = HUGE_VAL;
        for (const Candidate& candidate : candidates) distance = std::min(distance, candidate.distance);
        std::string near = " stands in no wall and is left out; ";
        near += distance < HUGE_VAL ? "the nearest wall is " + rounded_text(distance, 2) + " m away."
                                    : std::string("there is none near it.");
        home_.report(said(door, "P172", Severity::Error, near,
                          "Move it into a wall in Sweet Home 3D, or delete it if it is only a drawing."));
    }

    [[nodiscard]] Finding said(const PlacedOpening& door, const char* code, Severity severity,
                               const std::string& predicate, std::string hint) const {
        const Opening& opening = door.opening;
        const std::string level = storey_.name.empty() ? "" : " on level \"" + storey_.name + "\"";
        Finding finding = finding_at(storey_, code, severity,
                                     "The " + std::string(word(opening.kind)) + " \"" +
                                         (opening.name.empty() ? opening.id : opening.name) + "\" at " +
                                         place_text(door.middle) + level + predicate,
                                     std::move(hint), {"opening", opening.id, opening.name}, door.middle);
        if (finding.point) (*finding.point)[2] = storey_.elevation + opening.sill;
        return finding;
    }

    /// Makes the hole go on through walls that lie against the host, as people draw thick walls.
    void go_through(PlacedOpening& door, std::size_t host_index) {
        const WallBody& host = bodies_[host_index];
        Opening& opening = door.opening;
        const double share = std::clamp(opening.offset / host.axis.length(), 0.0, 1.0);
        const PlanRectangle across{host.axis.at(share), host.along(share), opening.width, 2 * (host.half + all_depths)};
        const PlanRectangle part{
            door.wall_middle, {std::cos(door.angle), std::sin(door.angle)}, door.wall_width, door.wall_depth};
        struct Layer {
            double low;
            double high;
            double gap;  ///< how far from what is already cut it may begin
        };
        std::vector<Layer> layers;
        for (const std::size_t wall : bodies_.near(door.middle)) {
            const WallBody& body = bodies_[wall];
            if (wall == host_index || body.height <= opening.sill) continue;
            const Point along = body.along(body.axis.nearest(across.middle));
            if (std::abs(dot(along, across.along)) < cos_parallel) continue;
            const LocalBox extent = body.extent_in(across);
            if (extent.empty() || extent.max.x - extent.min.x < opening.width / 2) continue;
            layers.push_back({extent.min.y, extent.max.y, body.overlap(part) > area_epsilon ? cavity : against});
        }
        double left = host.half;
        double right = -host.half;
        for (bool grown = true; grown;) {
            grown = false;
            for (const Layer& layer : layers) {
                if (layer.high > left + 1e-3 && layer.low <= left + layer.gap) {
                    left = layer.high;
                    grown = true;
                }
                if (layer.low < right - 1e-3 && layer.high >= right - layer.gap) {
                    right = layer.low;
                    grown = true;
                }
            }
        }
        opening.depth_left = left - host.half;
        opening.depth_right = -host.half - right;
    }

    Storey& storey_;
    Home& home_;
    StoreyBodies bodies_;
};

}  // namespace

void bind_openings(Storey& storey, std::vector<PlacedOpening> placed, Home& home) {
    if (placed.empty()) return;
    // A gap closed for one door is a wall for the next: the order of the file must not decide.
    std::stable_sort(placed.begin(), placed.end(),
                     [](const PlacedOpening& a, const PlacedOpening& b) { return a.opening.id < b.opening.id; });
    Binder binder(storey, placed, home);
    for (PlacedOpening& door : placed) binder.bind(std::move(door));
}

}  // namespace enfilade::plans
