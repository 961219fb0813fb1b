#include "modeler/furnishing/furnish_room.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "modeler/furnishing/candidates.h"
#include "modeler/furnishing/group.h"
#include "modeler/furnishing/score.h"
#include "modeler/furnishing/walkways.h"

namespace enfilade::modeler {

using plans::Point;
using plans::Random;

namespace {

constexpr std::size_t most_tries = 10;    ///< places of a group whose first piece stands there, until the best is taken
constexpr std::size_t most_refused = 48;  ///< places of a group that would block a way
constexpr std::size_t most_candidates = 600;  ///< candidates that are scored
constexpr std::uint32_t give_up = 3;    ///< objects of one rule in a row that found no place: the rest will not, too
constexpr double eye_level = 1.55;      ///< metres: middle of pictures
constexpr double under_ceiling = 0.01;  ///< metres
constexpr double head_room = 2;         ///< metres below lamps where nothing stands beneath
constexpr double window_reach = 1.2;    ///< metres: what is near a window
constexpr double access_reach = 0.5;    ///< metres from the floor that it keeps clear

class RoomFurnisher {
public:
    RoomFurnisher(const RoomShape& room, const RoomRules& rules, double temperature, const EntryLists& entries,
                  std::span<const StandingPiece> standing, std::uint64_t seed)
        : room_(room),
          rules_(rules),
          temperature_(temperature),
          entries_(entries),
          seed_(seed),
          unit_(room.frame.unit),
          rings_(wall_rings(room)),
          occupancy_(room),
          standing_(standing) {
        std::vector<Ring> obstacles;
        for (const StandingPiece& piece : standing) {
            Body body;
            body.ring = piece.footprint;
            body.box = box_around(body.ring);
            body.z_low = piece.z_low;
            body.z_high = piece.z_high;
            body.kind = piece.kind;
            body.pose.at = {0.5 * (double(body.box.x_low) + body.box.x_high),
                            0.5 * (double(body.box.y_low) + body.box.y_high)};
            body.width = double(body.box.x_high) - body.box.x_low;
            body.depth = double(body.box.y_high) - body.box.y_low;
            if (is_obstacle(room, piece.z_low, piece.z_high)) obstacles.push_back(piece.footprint);
            occupancy_.add(std::move(body));
        }
        walkways_ = std::make_unique<Walkways>(room, obstacles);
        (void)walkways_->all_open();
    }

    RoomLayout run() {
        for (std::uint32_t k = 0; k < rules_.objects.size(); ++k) request(rules_.objects[k], k);
        write_pieces();
        return std::move(layout_);
    }

private:
    void request(const ObjectRule& rule, std::uint32_t number) {
        const std::uint64_t style = Random{seed_, hash_of(room_.id), hash_of(rules_.kind)}.next();
        Random random{seed_, hash_of(room_.id), number, hash_of(rule.object.front())};
        if (room_.area_m2 < rule.least_area || room_.area_m2 > rule.most_area) return;
        if (rule.place == Relation::Ceiling && room_.open_to_sky) return;
        const auto is_there = [&](const Body& body) { return body.kind == rule.unless; };
        if (!rule.unless.empty() && std::any_of(occupancy_.bodies().begin(), occupancy_.bodies().end(), is_there))
            return;
        const bool comes = random.chance(rule.probability);
        std::uint32_t count = rule.least + random.below(rule.most - rule.least + 1);
        if (rule.per_area > 0)
            count = std::clamp(std::uint32_t(std::lround(std::min(room_.area_m2 / rule.per_area, 1000.0))), rule.least,
                               rule.most);
        count -= std::min(count, standing_of(rule));
        if (!comes || count == 0) return;
        lamp_places_ = rule.place == Relation::Ceiling ? spread_over(room_, rings_, count) : std::vector<Point>{};
        std::uint32_t refused = 0, placed = 0;
        for (std::uint32_t k = 0; k < count; ++k) {
            const std::uint64_t key = random.next();
            const Draft group = draft(rule, 1, entries_, random, style);
            if (!group.known) return note(layout_.unknown, rule.object.front());
            layout_.requested += group.pieces_each();
            note_unknown(group);
            if (refused >= give_up) continue;
            const bool found = place(group, k, key);
            if (found)
                for (const ObjectRule* with : missing_) note(layout_.no_place, with->object.front());
            refused = found ? 0 : refused + 1;
            placed += found;
        }
        if (placed < count) note(layout_.no_place, rule.object.front());
    }

    /// How many of these stand there already.
    [[nodiscard]] std::uint32_t standing_of(const ObjectRule& rule) const {
        return std::uint32_t(std::count_if(standing_.begin(), standing_.end(), [&](const StandingPiece& piece) {
            return std::find(rule.object.begin(), rule.object.end(), piece.kind) != rule.object.end();
        }));
    }

    static void note(std::vector<std::string>& list, const std::string& kind) {
        if (std::find(list.begin(), list.end(), kind) == list.end()) list.push_back(kind);
    }
    void note_unknown(const Draft& group) {
        for (const Draft& with : group.with) {
            if (!with.known) note(layout_.unknown, with.rule->object.front());
            note_unknown(with);
        }
    }

    struct Scored {
        double key;
        Candidate candidate;
    };

    /// A place where some of the group fits.
    struct Found {
        std::size_t entry = 0;  ///< into Draft::tries
        Pose pose;
        std::uint64_t key = 0;
        std::uint32_t placed = 0;
    };

    /// Of the best or luckiest places the first at which all of the group fits, or else the one with most of it.
    /// Entries that come later in the rule have to fit better by more than one piece.
    bool place(const Draft& group, std::uint32_t number, std::uint64_t key) {
        const std::uint32_t wanted = group.pieces_each();
        Found best;
        for (std::size_t t = 0; t < group.tries.size(); ++t) {
            const CatalogueEntry& entry = *group.tries[t];
            const std::vector<Scored> places =
                drawn_places(*group.rule, entry, number, key + t, t + 1 == group.tries.size());
            std::size_t tried = 0, refused = 0;
            for (std::size_t k = 0; k < places.size() && tried < most_tries && refused < most_refused; ++k) {
                const Found here{t, places[k].candidate.pose, key + k,
                                 try_at(group, t, places[k].candidate.pose, key + k)};
                const std::uint32_t handicap = best.placed > 0 && best.entry != t ? 1 : 0;
                if (here.placed == wanted && (best.placed == 0 || wanted > best.placed + handicap)) return true;
                refused += here.placed == refused_way;
                if (here.placed == 0 || here.placed == refused_way) continue;
                ++tried;
                if (here.placed > best.placed + handicap) best = here;
                take_back();
            }
        }
        return best.placed > 0 && try_at(group, best.entry, best.pose, best.key) != 0;
    }

    static constexpr std::uint32_t refused_way = UINT32_MAX;

    /// Pieces placed; 0 where the first finds no place; `refused_way` where a way would be closed.
    std::uint32_t try_at(const Draft& group, std::size_t entry_number, const Pose& pose, std::uint64_t key) {
        const CatalogueEntry& entry = *group.tries[entry_number];
        const double elevation = elevation_of(*group.rule, entry);
        const bool hangs = group.rule->place == Relation::OnWall || group.rule->place == Relation::Ceiling;
        before_ = occupancy_.mark();
        const std::uint32_t number = groups_ + 1;
        GroupPlacer placer(occupancy_, number, key);
        const std::uint32_t placed = placer.place(group, entry, pose, elevation, hangs);
        missing_ = placer.missing();
        if (placed == 0) return 0;
        ++groups_;
        obstacles_.clear();
        bool changed = false;
        const std::vector<Body>& bodies = occupancy_.bodies();
        for (std::size_t k = before_.bodies; k < bodies.size(); ++k) {
            if (!is_obstacle(room_, bodies[k].z_low, bodies[k].z_high) || stands_on_obstacle(bodies[k])) continue;
            obstacles_.push_back(bodies[k].ring);
            changed = walkways_->put(bodies[k].ring, 1) || changed;
        }
        accesses_.push_back(access_of(group, before_));
        if (obstacles_.empty()) return placed;
        // Where nothing that was free is blocked now, what was reached before still is.
        const bool open = (!changed && !stale_) || walkways_->all_open();
        stale_ = false;
        if (open && all_accessible(changed)) return placed;
        take_back();
        return refused_way;
    }

    void take_back() {
        for (const Ring& ring : obstacles_) (void)walkways_->put(ring, -1);
        stale_ = stale_ || !obstacles_.empty();
        obstacles_.clear();
        occupancy_.undo(before_);
        accesses_.pop_back();
        --groups_;
    }

    [[nodiscard]] bool stands_on_obstacle(const Body& body) const {
        if (body.carrier == UINT32_MAX) return false;
        const Body& carrier = occupancy_.bodies()[body.carrier];
        return is_obstacle(room_, carrier.z_low, carrier.z_high);
    }

    /// Nodes of which one has to be reached, so that people come to the group.
    struct Access {
        bool needed = false;
        std::vector<std::uint32_t> nodes;
    };

    /// By the floor that the group keeps clear.
    [[nodiscard]] Access access_of(const Draft& group, Occupancy::Mark before) const {
        const Body& first = occupancy_.bodies()[before.bodies];
        if (first.hangs || !walkways_->has_gates()) return {};
        const Clearance& clear = group.rule->clearance;
        if (!(clear.front > 0) && !(clear.one_side > 0) && !(clear.sides > 0)) return {};
        const double metre = 1 / unit_;
        const double side = std::max(clear.one_side, clear.sides) * metre;
        return {true, walkways_->nodes_near(occupancy_.around(first, clear.front * metre, 0, side, side),
                                            access_reach * metre)};
    }

    /// Where no free node was blocked, only the newest group is in question.
    [[nodiscard]] bool all_accessible(bool changed) const {
        if (!walkways_->has_gates()) return true;
        if (!changed) return is_accessible(accesses_.back());
        return std::all_of(accesses_.begin(), accesses_.end(),
                           [&](const Access& access) { return is_accessible(access); });
    }
    [[nodiscard]] bool is_accessible(const Access& access) const {
        return !access.needed || walkways_->some_reached(access.nodes);
    }

    [[nodiscard]] double elevation_of(const ObjectRule& rule, const CatalogueEntry& entry) const {
        const double ceiling = (room_.z_ceiling - room_.z_floor) * unit_;
        if (rule.place == Relation::Ceiling) return std::floor((ceiling - under_ceiling - entry.height) / unit_) - 1;
        if (rule.elevation >= 0) return rule.elevation / unit_;
        const bool hangs = rule.place == Relation::OnWall;
        // Basins and radiators are made to hang on the wall that others stand against.
        if (!hangs && rule.place != Relation::AgainstWall && rule.place != Relation::NearWindow) return 0;
        const double hung = !hangs || entry.elevation > 0 ? entry.elevation : eye_level - entry.height / 2;
        return std::max(0.0, std::min(hung, ceiling - entry.height - 0.05)) / unit_;
    }

    [[nodiscard]] std::vector<Candidate> candidates(const ObjectRule& rule, const CatalogueEntry& entry,
                                                    std::uint32_t number) const {
        const PieceSize size{entry.width / unit_, entry.depth / unit_};
        switch (rule.place) {
            case Relation::Ceiling: return lamp_candidates(number);
            case Relation::Middle: return middle_candidates(occupancy_, rings_, size);
            case Relation::Rows: return row_candidates(occupancy_, rings_, size, rule.gap / unit_);
            default: break;
        }
        WallSearch search;
        search.size = size;
        search.gap = rule.gap / unit_;
        search.turned = rule.turned;
        search.hangs = rule.place == Relation::OnWall;
        const double bottom = elevation_of(rule, entry);
        search.z_low = room_.z_floor + std::int32_t(bottom);
        search.z_high = std::int32_t(std::ceil(search.z_low + entry.height / unit_));
        std::vector<Candidate> found = wall_candidates(occupancy_, rings_, search);
        if (rule.place != Relation::NearWindow || room_.windows.empty()) return found;
        std::vector<Candidate> near;
        for (const Candidate& candidate : found)
            for (const RoomOpening& window : room_.windows)
                if (plans::distance(candidate.pose.at, window.a, window.b) <
                    window_reach / unit_ + (size.width + size.depth) / 2) {
                    near.push_back(candidate);
                    break;
                }
        return near.empty() ? found : near;
    }

    [[nodiscard]] std::vector<Candidate> lamp_candidates(std::uint32_t number) const {
        std::vector<Candidate> result;
        if (number >= lamp_places_.size()) return result;
        const Point along = main_way(rings_);
        const double angle = std::atan2(along.y, along.x);
        for (const double away : {0.0, 0.3, 0.7})
            for (int k = 0; k < (away == 0 ? 1 : 8); ++k) {
                const double turn = angle + k * 0.78539816339744831;
                const Point off = Point{std::cos(turn), std::sin(turn)} * (away / unit_);
                result.push_back({{lamp_places_[number] + off, angle}, -1});
            }
        return result;
    }

    /// Whether a lamp leaves no head room over floor where people walk. A long one may hang over a table in the middle,
    /// but is not moved aside until it hangs over something.
    [[nodiscard]] bool hangs_in_the_way(const ObjectRule& rule, const Body& lamp, std::size_t candidate) const {
        if (rule.place != Relation::Ceiling || (lamp.z_low - room_.z_floor) * unit_ >= head_room) return false;
        return candidate > 0 ||
               std::none_of(occupancy_.bodies().begin(), occupancy_.bodies().end(), [&](const Body& body) {
                   return body.carrier == UINT32_MAX && is_obstacle(room_, body.z_low, body.z_high) &&
                          body.z_high <= lamp.z_low && body.box.meets(lamp.box) && overlap(body.ring, lamp.ring);
               });
    }

    /// Places by descending score plus Gumbel noise: the order of draws with probabilities exp(score / temperature).
    /// Of a ceiling's lamps only the flattest may hang where people would run into it.
    [[nodiscard]] std::vector<Scored> drawn_places(const ObjectRule& rule, const CatalogueEntry& entry,
                                                   std::uint32_t number, std::uint64_t key, bool flattest) const {
        Random random{key, 1};
        std::vector<Candidate> found = candidates(rule, entry, number);
        const PieceSize size{entry.width / unit_, entry.depth / unit_};
        const bool in_order = rule.place == Relation::Rows || rule.place == Relation::Ceiling;
        if (found.size() > most_candidates && !in_order) {
            std::vector<Candidate> kept;
            for (std::size_t k = 0; k < most_candidates; ++k) kept.push_back(found[k * found.size() / most_candidates]);
            found = std::move(kept);
        }
        const double elevation = elevation_of(rule, entry);
        std::vector<Scored> places;
        for (std::size_t k = 0; k < found.size(); ++k) {
            Body body = occupancy_.body(entry, found[k].pose, elevation);
            body.hangs = rule.place == Relation::OnWall || rule.place == Relation::Ceiling;
            body.group = UINT32_MAX;
            if (!occupancy_.is_possible(body) || (!flattest && hangs_in_the_way(rule, body, k))) continue;
            const double noise = -std::log(-std::log(std::max(random.uniform(), 1e-300)));
            const double good = in_order ? -double(k) : score(occupancy_, found[k], size, rule) + temperature_ * noise;
            places.push_back({good, found[k]});
        }
        std::stable_sort(places.begin(), places.end(), [](const Scored& a, const Scored& b) { return a.key > b.key; });
        return places;
    }

    void write_pieces() {
        const std::vector<Body>& bodies = occupancy_.bodies();
        const auto first = std::uint32_t(standing_.size());
        for (std::size_t k = first; k < bodies.size(); ++k) {
            const Body& body = bodies[k];
            RoomPiece piece;
            piece.entry = body.entry;
            piece.pose = body.pose;
            piece.z_low = body.z_low;
            piece.size = {body.metres_wide, body.metres_deep, body.metres_high};
            if (body.carrier != UINT32_MAX) piece.carrier = body.carrier - first;
            layout_.pieces.push_back(piece);
        }
    }

    const RoomShape& room_;
    const RoomRules& rules_;
    double temperature_;
    const EntryLists& entries_;
    std::uint64_t seed_;
    double unit_;
    std::vector<WallRing> rings_;
    Occupancy occupancy_;
    std::span<const StandingPiece> standing_;
    std::unique_ptr<Walkways> walkways_;
    std::vector<Access> accesses_;  ///< [group]
    std::vector<Point> lamp_places_;
    std::vector<Ring> obstacles_;  ///< of the group that is tried
    Occupancy::Mark before_ = {0, 0};
    std::vector<const ObjectRule*> missing_;  ///< of the group that was tried last
    std::uint32_t groups_ = 0;
    bool stale_ = false;  ///< what the walkways reached was told of obstacles that are gone
    RoomLayout layout_;
};

}  // namespace

RoomLayout furnish_room(const RoomShape& room, const RoomRules& rules, double temperature, const EntryLists& entries,
                        std::span<const StandingPiece> standing, std::uint64_t seed) {
    if (room.floor.sides().empty()) return {};
    return RoomFurnisher(room, rules, temperature, entries, standing, seed).run();
}

}  // namespace enfilade::modeler
