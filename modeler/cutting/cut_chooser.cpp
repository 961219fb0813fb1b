#include "modeler/cutting/cut_chooser.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace enfilade::modeler {

using plans::GridPoint;

namespace {

constexpr double unreachable = 1e18;
/// In a polygon with more corners than this, only every so many of them look far, and the others end after so many
/// triangles; what a new cut changes for long looks is found out when it is their turn. The time stays n log n.
constexpr std::size_t many_corners = 128;
constexpr std::uint32_t near_limit = 48, far_limit = 1024, eager_limit = 16;
/// Corners beyond this number find partners only among their neighbours.
constexpr std::size_t pair_limit = 64;

Direction turned_left(Direction d) { return {-d.y, d.x}; }
Direction reversed(Direction d) { return {-d.x, -d.y}; }
double length(Direction d) { return std::hypot(double(d.x), double(d.y)); }

}  // namespace

CutChooser::CutChooser(std::span<const GridPoint> points, std::span<const PolygonSide> sides, CutPrice price,
                       bool exact)
    : sides_(sides),
      price_(price),
      exact_(exact),
      sight_(points, sides),
      before_(sight_.corners_before()),
      subdivision_(points, sides, before_) {
    seen_from_.resize(sight_.triangles().triangle_count());
    first_corner_.assign(points.size(), no_index);
    find_corners(before_);
    find_dominant_direction();
    find_arcs();
}

bool CutChooser::is_small() const { return corners_.size() <= many_corners; }

void CutChooser::find_corners(std::span<const std::uint32_t> before) {
    // Straight runs: the chord of a run tells its direction, whatever rounding did to its sides.
    const auto goes_on = [&](std::uint32_t k) { return subdivision_.is_straight(before[k], k); };
    std::vector<std::uint32_t> run_first(sides_.size(), no_index), run_last(sides_.size(), no_index);
    for (std::uint32_t k = 0; k < sides_.size(); ++k) {
        if (goes_on(k)) continue;
        std::uint32_t last = k;
        while (subdivision_.next(last) != k && goes_on(subdivision_.next(last))) last = subdivision_.next(last);
        for (std::uint32_t s = k;; s = subdivision_.next(s)) {
            run_first[s] = k;
            run_last[s] = last;
            if (s == last) break;
        }
    }
    for (std::uint32_t k = 0; k < sides_.size(); ++k) {
        const std::uint32_t in = before[k];
        if (goes_on(k) || run_first[in] == no_index) continue;
        const GridPoint start = at(sides_[run_first[in]].from), v = at(sides_[k].from),
                        end = at(sides_[run_last[k]].to);
        if (!turns_right(start, at(sides_[in].from), v, at(sides_[k].to), end)) continue;
        const std::uint32_t id = std::uint32_t(corners_.size());
        corners_.push_back({sides_[k].from,
                            sight_.along(k),
                            direction(start, v),
                            direction(v, end),
                            sides_[in].line,
                            sides_[k].line,
                            true,
                            unreachable,
                            {}});
        next_corner_.push_back(first_corner_[sides_[k].from]);
        first_corner_[sides_[k].from] = id;
    }
    stamp_.assign(corners_.size(), 0);
    extra_.resize(corners_.size());
}

/// The direction in which most of the polygon's sides run, up to quarter turns.
void CutChooser::find_dominant_direction() {
    std::vector<std::array<double, 2>> turns;  // angle within a quarter turn, length
    for (const PolygonSide& side : sides_) {
        const Direction d = direction(at(side.from), at(side.to));
        double angle = std::fmod(std::atan2(double(d.y), double(d.x)) + 2 * M_PI, M_PI / 2);
        turns.push_back({angle, length(d)});
    }
    double best = 0;
    std::vector<double> of_bin(90, 0);
    for (const auto& [angle, weight] : turns) of_bin[std::size_t(angle / (M_PI / 2) * 90) % 90] += weight;
    const std::size_t bin = std::size_t(std::max_element(of_bin.begin(), of_bin.end()) - of_bin.begin());
    for (std::size_t k = 0; k < sides_.size(); ++k)
        if (std::size_t(turns[k][0] / (M_PI / 2) * 90) % 90 == bin && turns[k][1] > best) {
            best = turns[k][1];
            dominant_ = direction(at(sides_[k].from), at(sides_[k].to));
        }
}

/// Chains of reflex corners that turn little by little: along the chord of such a chain lies the box of a curved wall.
void CutChooser::find_arcs() {
    std::vector<std::uint32_t> corner_of(sides_.size(), no_index);  // the corner at the beginning of a side
    for (std::uint32_t c = 0; c < corners_.size(); ++c) corner_of[sight_.triangles().side[corners_[c].start]] = c;
    const auto turns_gently = [&](std::uint32_t c) {
        const Direction in = corners_[c].in, out = corners_[c].out;
        return dot(in, out) > 0 && std::abs(double(cross(in, out))) < double(dot(in, out)) * 1.2;
    };
    std::vector<bool> seen(corners_.size(), false);
    for (std::uint32_t c = 0; c < corners_.size(); ++c) {
        if (seen[c] || !turns_gently(c)) continue;
        const auto side_of = [&](std::uint32_t corner) { return sight_.triangles().side[corners_[corner].start]; };
        std::uint32_t first = c;
        for (;;) {
            const std::uint32_t before = corner_of[before_[side_of(first)]];
            if (before == no_index || before == c || !turns_gently(before)) break;
            first = before;
        }
        std::vector<std::uint32_t> chain = {first};
        for (;;) {
            const std::uint32_t after = corner_of[subdivision_.next(side_of(chain.back()))];
            if (after == no_index || after == first || !turns_gently(after)) break;
            chain.push_back(after);
        }
        for (const std::uint32_t k : chain) seen[k] = true;
        if (chain.size() < 2) continue;
        // From the beginning of the first side to the end of the last one.
        const GridPoint a = at(sides_[before_[side_of(chain.front())]].from), b = at(sides_[side_of(chain.back())].to);
        const Direction chord = direction(a, b);
        if (chord.x == 0 && chord.y == 0) continue;
        std::uint32_t farthest = chain.front();
        double most = -1;
        for (const std::uint32_t k : chain) {
            const double off = std::abs(double(cross(chord, direction(a, at(corners_[k].point)))));
            if (off > most) most = off, farthest = k;
            extra_[k].push_back(turned_left(chord));
            extra_[k].push_back(reversed(turned_left(chord)));
        }
        extra_[farthest].push_back(chord);
        extra_[farthest].push_back(reversed(chord));
    }
}

bool CutChooser::resolves(const Corner& corner, Direction d, std::uint32_t line) const {
    const bool fine_in = cross(corner.in, d) >= 0 || (line != no_index && line == corner.line_in);
    const bool fine_out = cross(corner.out, d) >= 0 || (line != no_index && line == corner.line_out);
    return fine_in && fine_out;
}

void CutChooser::add(std::uint32_t corner, Direction d, std::uint32_t line) {
    if ((d.x == 0 && d.y == 0) || !resolves(corners_[corner], d, line)) return;
    for (const std::uint32_t k : corners_[corner].candidates) {
        const Candidate& other = candidates_[k];
        if (other.wanted_line == line && cross(other.d, d) == 0 && dot(other.d, d) > 0) return;
    }
    const std::uint32_t id = std::uint32_t(candidates_.size());
    candidates_.push_back({corner, d, line, line, 0, false, 0, false, 0, {}, {}});
    corners_[corner].candidates.push_back(id);
    look(id);
}

bool CutChooser::is_on_track(const Hit& hit) const {
    const std::vector<std::uint32_t>& nodes = subdivision_.track(hit.id).nodes;
    return orientation(at(nodes.front()), at(nodes.back()), hit.point) == 0;
}

/// Whether a cut goes on so straight that it may count as part of the line that it prolongs.
bool CutChooser::prolongs(const Corner& corner, const Candidate& candidate) const {
    const Direction along = candidate.line == corner.line_in ? corner.in : reversed(corner.out);
    const Direction d = direction(at(corner.point), candidate.hit.point);
    const std::int64_t bend = cross(along, d);
    if (bend != 0) return false;
    // Where it meets another side of its line, both have to run alike.
    return candidate.hit.at != Hit::At::Point ||
           subdivision_.meets_line_straight(corner.point, candidate.hit.id, candidate.line);
}

/// A direction to another point of the track that a cut hits, a unit on, where rounding left the cut on the wrong side
/// of an edge of its corner.
Direction CutChooser::nudged(const Corner& corner, const Hit& hit, int units) const {
    const Direction d = direction(at(corner.point), hit.point);
    const Direction edge = cross(corner.in, d) < 0 ? corner.in : corner.out;
    Direction along =
        direction(at(subdivision_.track(hit.id).nodes.front()), at(subdivision_.track(hit.id).nodes.back()));
    if (cross(edge, along) < 0) along = reversed(along);
    const double scale = units / length(along);
    return {d.x + std::lround(double(along.x) * scale), d.y + std::lround(double(along.y) * scale)};
}

void CutChooser::look(std::uint32_t id) {
    Candidate& candidate = candidates_[id];
    const Corner& corner = corners_[candidate.corner];
    ++candidate.version;
    candidate.alive = false;
    candidate.looked_at = cut_count_;
    const bool sees_far = candidate.corner % (corners_.size() / many_corners + 1) == 0;
    const std::uint32_t limit = is_small() ? no_index : sees_far ? far_limit : near_limit;
    // Where it would pass or meet a point too closely it goes straight to that point.
    Direction d = candidate.d;
    Hit& hit = candidate.hit;
    for (int attempt = 0;; ++attempt) {
        if (attempt == 6) return;
        hit = sight_.look(corner.start, d, limit, candidate.passed);
        if (hit.at == Hit::At::Nothing) return;
        std::uint32_t aim = no_index;
        if (hit.at == Hit::At::Point) {
            if (!hit.moved) break;
            aim = hit.id;
        } else {
            const std::uint32_t node = subdivision_.node_near(hit.id, at(corner.point), hit.point);
            if (node == no_index) {
                if (resolves(corner, direction(at(corner.point), hit.point), no_index) || attempt > 3) break;
                d = nudged(corner, hit, attempt + 1);
                continue;
            }
            const Direction straight = direction(at(corner.point), at(node));
            if (cross(straight, d) == 0) {  // it is aimed at
                hit.point = at(node);
                break;
            }
            aim = node;
        }
        if (aim == corner.point) return;
        d = direction(at(corner.point), at(aim));
    }
    if (exact_ && hit.at != Hit::At::Point && !is_on_track(hit)) return;
    candidate.is_moved = cross(candidate.d, direction(at(corner.point), hit.point)) != 0 && cross(d, candidate.d) != 0;
    candidate.line = candidate.wanted_line;
    if (candidate.line != no_index && !prolongs(corner, candidate)) candidate.line = no_index;
    if (!resolves(corner, direction(at(corner.point), hit.point), candidate.line)) return;
    candidate.alive = true;
    candidate.cost = candidate.hit.length + price_.cut + (candidate.hit.at == Hit::At::Point ? 0 : price_.new_node);
    if (!is_small() && candidate.passed.size() > eager_limit) return;
    for (const std::uint32_t triangle : candidate.passed) seen_from_[triangle].push_back(id);
}

void CutChooser::add_candidates(std::uint32_t c) {
    const Direction in = corners_[c].in, out = corners_[c].out;
    add(c, in, corners_[c].line_in);
    add(c, reversed(out), corners_[c].line_out);
    add(c, turned_left(in));
    add(c, turned_left(out));
    Direction axis = dominant_;
    for (int quarter = 0; quarter < 4; ++quarter, axis = turned_left(axis)) add(c, axis);
    for (const Direction d : extra_[c]) add(c, d);
    add_fan(c);
}

/// To the corners of the triangles around, and to the nearest points of their far edges.
void CutChooser::add_fan(std::uint32_t c) {
    const Triangulation& triangles = sight_.triangles();
    const GridPoint v = at(corners_[c].point);
    for (std::uint32_t h = corners_[c].start; h != no_index; h = triangles.twin[previous_in_triangle(h)]) {
        const std::uint32_t far = next_in_triangle(h);
        const GridPoint a = at(triangles.from[far]), b = at(triangles.from[previous_in_triangle(h)]);
        const Direction across = direction(a, b);
        if (dot(across, direction(a, v)) > 0 && dot(across, direction(b, v)) < 0) add(c, reversed(turned_left(across)));
        add(c, direction(v, b));
    }
}

/// One cut for two reflex corners that see each other.
void CutChooser::add_pairs() {
    if (corners_.size() > pair_limit) return;
    for (std::uint32_t c = 0; c < corners_.size(); ++c)
        for (std::uint32_t o = 0; o < corners_.size(); ++o) {
            if (o == c) continue;
            const Direction d = direction(at(corners_[c].point), at(corners_[o].point));
            if (resolves(corners_[o], reversed(d), no_index)) add(c, d);
        }
}

void CutChooser::update_cheapest(Corner& corner) {
    corner.cheapest = unreachable;
    for (const std::uint32_t k : corner.candidates)
        if (candidates_[k].alive) corner.cheapest = std::min(corner.cheapest, candidates_[k].cost);
}

template <class Visit>
void CutChooser::for_each_passed_corner(std::span<const std::uint32_t> passed, Visit visit) {
    ++stamp_now_;
    for (const std::uint32_t triangle : passed)
        for (std::uint32_t h = 3 * triangle; h < 3 * triangle + 3; ++h)
            for (std::uint32_t c = first_corner_[sight_.triangles().from[h]]; c != no_index; c = next_corner_[c]) {
                if (!corners_[c].open || stamp_[c] == stamp_now_) continue;
                stamp_[c] = stamp_now_;
                visit(c);
            }
}

/// The point of the segment nearest to `p`, rounded.
static GridPoint foot(GridPoint p, GridPoint a, GridPoint b) {
    const Direction along = direction(a, b);
    const double t = std::clamp(
        double(dot(direction(a, p), along)) / double(std::max<std::int64_t>(dot(along, along), 1)), 0.0, 1.0);
    return {std::int32_t(std::lround(a.x + t * double(along.x))), std::int32_t(std::lround(a.y + t * double(along.y)))};
}

double CutChooser::score(const Candidate& candidate) {
    const Corner& own = corners_[candidate.corner];
    double score = candidate.cost - own.cheapest;
    const GridPoint a = at(own.point), b = candidate.hit.point;
    for_each_passed_corner(candidate.passed, [&](std::uint32_t c) {
        Corner& other = corners_[c];
        if (&other == &own || other.cheapest >= unreachable) return;
        if (candidate.hit.at == Hit::At::Point && other.point == candidate.hit.id) {
            if (resolves(other, direction(b, a), candidate.line)) score -= other.cheapest;
            return;
        }
        const Direction d = direction(at(other.point), foot(at(other.point), a, b));
        if ((d.x == 0 && d.y == 0) || !resolves(other, d, no_index)) return;
        score -= std::max(0.0, other.cheapest - (length(d) + price_.cut + price_.new_node));
    });
    return score;
}

void CutChooser::push(std::uint32_t id) {
    const Candidate& candidate = candidates_[id];
    if (candidate.alive) queue_.push({score(candidate), candidate.cost, id, candidate.version});
}

void CutChooser::run() {
    if (corners_.empty()) return;
    for (std::uint32_t c = 0; c < corners_.size(); ++c) add_candidates(c);
    add_pairs();
    for (Corner& corner : corners_) update_cheapest(corner);
    for (std::uint32_t k = 0; k < candidates_.size(); ++k) push(k);
    while (!queue_.empty()) {
        const Waiting best = queue_.top();
        queue_.pop();
        const Candidate& candidate = candidates_[best.candidate];
        if (!candidate.alive || candidate.version != best.version) continue;
        if (!is_small() && candidate.looked_at != cut_count_) {  // a cut may have come between
            const double before = candidate.cost;
            look(best.candidate);
            if (!candidate.alive) update_cheapest(corners_[candidate.corner]);
            else if (candidate.cost != before) push(best.candidate);
            if (!candidate.alive || candidate.cost != before) continue;
        }
        const double now = score(candidate);
        if (now > best.score + 1e-6) queue_.push({now, candidate.cost, best.candidate, candidate.version});
        else accept(best.candidate);
    }
}

void CutChooser::close(Corner& corner) {
    corner.open = false;
    for (const std::uint32_t k : corner.candidates) candidates_[k].alive = false;
}

void CutChooser::accept(std::uint32_t id) {
    const Candidate made = candidates_[id];
    Corner& corner = corners_[made.corner];
    candidates_[id].alive = false;
    std::uint32_t end = made.hit.id;
    if (made.hit.at != Hit::At::Point) {
        end = subdivision_.node_near(made.hit.id, at(corner.point), made.hit.point);
        if (end != no_index && at(end) != made.hit.point) {  // made since it was looked
            look(id);
            update_cheapest(corner);
            push(id);
            return;
        }
        if (end == no_index) end = subdivision_.add_node(made.hit.id, made.hit.point);
    }
    const Direction d = direction(at(corner.point), at(end));
    std::uint32_t track = no_index;
    if (resolves(corner, d, made.line)) {
        const std::uint32_t line = made.line != no_index ? made.line : first_cut_line + subdivision_.track_count();
        track = subdivision_.connect(corner.point, end, line);
    }
    if (track == no_index) {
        update_cheapest(corner);
        return;
    }
    moved_ += made.is_moved;
    const GridPoint a = at(corner.point), b = at(end);
    sight_.add_cut(track, a, b, made.passed);
    close(corner);
    meet_corners(end, reversed(d), subdivision_.track(track).line);
    ++cut_count_;
    cut_others(made, a, b);
    offer_feet(made, a, b);
}

/// A cut ends at a point: it closes a corner there, or leaves a smaller one.
void CutChooser::meet_corners(std::uint32_t point, Direction back, std::uint32_t line) {
    if (point >= first_corner_.size()) return;
    for (std::uint32_t c = first_corner_[point]; c != no_index; c = next_corner_[c]) {
        Corner& corner = corners_[c];
        if (!corner.open) continue;
        if (resolves(corner, back, line)) {
            close(corner);
            continue;
        }
        // Between the cut and one of the edges it is still reflex, if the cut lies in this wedge at all.
        const bool right_of_in = cross(corner.in, back) < 0, right_of_out = cross(corner.out, back) < 0;
        if (right_of_in && right_of_out) continue;
        if (right_of_in) corner.out = back, corner.line_out = line;
        else corner.in = reversed(back), corner.line_in = line;
        for (const std::uint32_t k : corner.candidates) {
            Candidate& candidate = candidates_[k];
            if (candidate.alive && !resolves(corner, direction(at(corner.point), candidate.hit.point), candidate.line))
                candidate.alive = false;
        }
        add(c, corner.in, corner.line_in);
        add(c, reversed(corner.out), corner.line_out);
        update_cheapest(corner);
        for (const std::uint32_t k : std::vector<std::uint32_t>(corner.candidates)) push(k);
    }
}

/// Looks that a new cut crosses end there now.
void CutChooser::cut_others(const Candidate& made, GridPoint a, GridPoint b) {
    std::vector<std::uint32_t> crossing;
    for (const std::uint32_t triangle : made.passed) {
        std::vector<std::uint32_t>& seen = seen_from_[triangle];
        std::size_t kept = 0;
        for (const std::uint32_t k : seen) {
            const Candidate& other = candidates_[k];
            if (!other.alive) continue;
            seen[kept++] = k;
            const GridPoint v = at(corners_[other.corner].point), w = other.hit.point;
            const bool apart = (orientation(a, b, v) > 0) == (orientation(a, b, w) > 0) && orientation(a, b, w) != 0;
            if (!apart) crossing.push_back(k);
        }
        seen.resize(kept);
    }
    std::sort(crossing.begin(), crossing.end());
    crossing.erase(std::unique(crossing.begin(), crossing.end()), crossing.end());
    for (const std::uint32_t k : crossing) look(k);
    for (const std::uint32_t k : crossing) update_cheapest(corners_[candidates_[k].corner]);
    for (const std::uint32_t k : crossing) push(k);
}

/// Corners that see a new cut may be cut square to it.
void CutChooser::offer_feet(const Candidate& made, GridPoint a, GridPoint b) {
    std::vector<std::uint32_t> open;
    for_each_passed_corner(made.passed, [&](std::uint32_t c) { open.push_back(c); });
    for (const std::uint32_t c : open) {
        const std::size_t count = candidates_.size();
        const Direction d = direction(at(corners_[c].point), foot(at(corners_[c].point), a, b));
        if (length(d) + price_.cut >= corners_[c].cheapest) continue;
        add(c, d);
        if (candidates_.size() == count) continue;
        update_cheapest(corners_[c]);
        push(std::uint32_t(count));
    }
}

}  // namespace enfilade::modeler
