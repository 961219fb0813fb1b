#include "modeler/cutting/cut_chooser.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace enfilade::modeler {

using plans::GridPoint;

namespace {

constexpr double unreachable = 1e18;
/// Looks end after so many triangles where a polygon has very many corners: the time stays n log n.
constexpr std::uint32_t near_limit = 64, far_limit = 4096, far_corners = 256;
/// Corners beyond this number find partners only among their neighbours.
constexpr std::size_t pair_limit = 64;

Direction turned_left(Direction d) { return {-d.y, d.x}; }
Direction reversed(Direction d) { return {-d.x, -d.y}; }
double length(Direction d) { return std::hypot(double(d.x), double(d.y)); }

}  // namespace

CutChooser::CutChooser(std::span<const GridPoint> points, std::span<const PolygonSide> sides, CutPrice price)
    : sides_(sides),
      price_(price),
      sight_(points, sides),
      before_(sight_.corners_before()),
      subdivision_(points, sides, before_) {
    seen_from_.resize(sight_.triangles().triangle_count());
    first_corner_.assign(points.size(), no_index);
    find_corners(before_);
    find_dominant_direction();
    find_arcs();
}

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
        const GridPoint start = at(sides_[run_first[in]].from), v = at(sides_[k].from), end = at(sides_[run_last[k]].to);
        if (orientation(start, v, end) >= 0 || orientation(at(sides_[in].from), v, at(sides_[k].to)) >= 0) continue;
        const std::uint32_t id = std::uint32_t(corners_.size());
        corners_.push_back({sides_[k].from, sight_.along(k), direction(start, v), direction(v, end), sides_[in].line,
                            sides_[k].line, true, unreachable, {}});
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
    for (std::uint32_t c = 0; c < corners_.size(); ++c)
        corner_of[sight_.triangles().side[corners_[c].start]] = c;
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
        if (other.line == line && cross(other.d, d) == 0 && dot(other.d, d) > 0) return;
    }
    const std::uint32_t id = std::uint32_t(candidates_.size());
    candidates_.push_back({corner, d, line, 0, false, 0, {}, {}});
    corners_[corner].candidates.push_back(id);
    look(id);
}

void CutChooser::look(std::uint32_t id) {
    Candidate& candidate = candidates_[id];
    const Corner& corner = corners_[candidate.corner];
    ++candidate.version;
    candidate.alive = false;
    const bool is_large = corners_.size() > 2 * far_corners;
    const bool sees_far = !is_large || candidate.corner % (corners_.size() / far_corners) == 0;
    Direction d = candidate.d;
    for (int attempt = 0; attempt < 3; ++attempt) {
        candidate.hit =
            sight_.look(corner.start, d, !is_large ? no_index : sees_far ? far_limit : near_limit, candidate.passed);
        if (candidate.hit.at != Hit::At::Point || !candidate.hit.moved) break;
        d = direction(at(corner.point), candidate.hit.point);  // straight to the point that it would pass
    }
    if (candidate.hit.at == Hit::At::Nothing || candidate.hit.moved) return;
    if (!resolves(corner, direction(at(corner.point), candidate.hit.point), candidate.line)) return;
    candidate.alive = true;
    candidate.cost = candidate.hit.length + price_.cut + (candidate.hit.at == Hit::At::Point ? 0 : price_.new_node);
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
    const double t =
        std::clamp(double(dot(direction(a, p), along)) / double(std::max<std::int64_t>(dot(along, along), 1)), 0.0, 1.0);
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
        const double now = score(candidate);
        if (now > best.score + 1e-6) queue_.push({now, candidate.cost, best.candidate, best.version});
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
    if (made.hit.at == Hit::At::Side || made.hit.at == Hit::At::Cut)
        end = subdivision_.node_near(made.hit.id, made.hit.point);
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
    moved_ += cross(made.d, d) != 0 && made.hit.at == Hit::At::Point;
    const GridPoint a = at(corner.point), b = at(end);
    sight_.add_cut(track, a, b, made.passed);
    close(corner);
    meet_corners(end, reversed(d), subdivision_.track(track).line);
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
        add(c, direction(at(corners_[c].point), foot(at(corners_[c].point), a, b)));
        if (candidates_.size() == count) continue;
        update_cheapest(corners_[c]);
        push(std::uint32_t(count));
    }
}

}  // namespace enfilade::modeler
