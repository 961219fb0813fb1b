#include "modeler/lighting/rule_lamps.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>
#include <set>

#include "modeler/face_label.h"
#include "modeler/furnishing/rules.h"
#include "modeler/lighting/ceiling_lamps.h"
#include "modeler/lighting/outdoor_lamps.h"
#include "modeler/lighting/piece_lamps.h"

namespace enfilade::modeler {
namespace {

/// A room on its way to its lamps.
struct RoomLamps {
    std::uint32_t space = UINT32_MAX;
    const RoomLight* light = nullptr;
    std::optional<RoomShape> shape;
    std::size_t count = 0;
    std::vector<const FurnishedObject*> objects;
    std::vector<std::size_t> pieces;  ///< that light the room: into the piece lamps
    std::vector<Lamp> lamps;
};

class RuleLamps {
public:
    RuleLamps(const Building& building, const LampRules& rules, const Catalogue* catalogue,
              const accel::Executor& executor)
        : building_(building), rules_(rules), executor_(executor), shapes_(building), volumes_(building) {
        if (building.furnishing.empty() || rules.count > 0) return;
        const std::optional<Catalogue> own =
            catalogue == nullptr ? std::optional<Catalogue>(std::in_place) : std::nullopt;
        pieces_ = piece_lamps(building, rules, catalogue == nullptr ? *own : *catalogue);
    }

    std::vector<Lamp> run() {
        find_rooms();
        if (rules_.count > 0) share_out();
        each_room([&](RoomLamps& room) { hang(room); });
        std::vector<Lamp> lamps;
        for (RoomLamps& room : rooms_) {
            give_to_pieces(room);
            lamps.insert(lamps.end(), room.lamps.begin(), room.lamps.end());
        }
        for (PieceLamp& piece : pieces_) lamps.push_back(std::move(piece.lamp));
        for (const auto& more :
             {entrance_lamps(building_, rules_.outdoor, volumes_), site_lamps(building_, rules_.outdoor, volumes_)})
            lamps.insert(lamps.end(), more.begin(), more.end());
        std::ranges::stable_sort(lamps, {}, &Lamp::id);
        return lamps;
    }

private:
    template <class Work>
    void each_room(const Work& work) {
        accel::parallel_for(executor_, rooms_.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) work(rooms_[k]);
        });
    }

    /// Rooms that lamps are asked for, with their shapes.
    void find_rooms() {
        std::vector<std::uint32_t> room_of(building_.spaces.size(), UINT32_MAX);
        for (const std::uint32_t s : shapes_.spaces()) {
            const Space& space = building_.spaces[s];
            if (space.label != Label::Room) continue;
            const RoomLight* light = rules_.room(room_kind(own_rules(), space.kind, space.name));
            if (light == nullptr) continue;
            room_of[s] = std::uint32_t(rooms_.size());
            rooms_.emplace_back();
            rooms_.back().space = s;
            rooms_.back().light = light;
        }
        for (const FurnishedObject& object : building_.furnishing.objects)
            if (room_of[object.space] != UINT32_MAX) rooms_[room_of[object.space]].objects.push_back(&object);
        for (std::size_t k = 0; k < pieces_.size(); ++k)
            if (pieces_[k].lights_room && room_of[pieces_[k].space] != UINT32_MAX)
                rooms_[room_of[pieces_[k].space]].pieces.push_back(k);
        const std::set<std::uint32_t> lit = lit_spaces();
        each_room([&](RoomLamps& room) {
            room.shape = shapes_.shape(room.space);
            if (!room.shape || lit.contains(room.space) || !room.pieces.empty()) return;
            room.count = std::size_t(std::max(1.0, std::round(room.shape->area_m2 / room.light->area)));
        });
    }

    /// Where the plan has lamps of its own that shine.
    [[nodiscard]] std::set<std::uint32_t> lit_spaces() const {
        std::set<std::uint32_t> lit;
        if (rules_.replace || rules_.count > 0) return lit;
        for (const Lamp& lamp : building_.lamps) {
            const std::uint32_t v = volumes_.at(lamp.position);
            if (v != UINT32_MAX && candela(lamp) != std::array<float, 3>{0, 0, 0})
                lit.insert(place_of(building_, building_.volumes[v].space));
        }
        return lit;
    }

    /// One for each room as far as they go, the largest first; then always one more where most floor shares a lamp.
    void share_out() {
        using Share = std::pair<double, std::size_t>;  // floor of a lamp, room; of equal ones the first room
        const auto later = [](const Share& a, const Share& b) {
            return a.first < b.first || (a.first == b.first && a.second > b.second);
        };
        std::vector<std::size_t> order;
        for (std::size_t k = 0; k < rooms_.size(); ++k) {
            rooms_[k].count = 0;
            if (rooms_[k].shape) order.push_back(k);
        }
        const auto area = [&](std::size_t k) { return rooms_[k].shape->area_m2; };
        std::ranges::stable_sort(order, std::greater<>(), area);
        std::size_t left = rules_.count;
        std::priority_queue<Share, std::vector<Share>, decltype(later)> shares(later);
        for (const std::size_t k : order)
            if (left > 0) rooms_[k].count = 1, --left, shares.push({area(k), k});
        for (; left > 0 && !shares.empty(); --left) {
            const std::size_t k = shares.top().second;
            shares.pop();
            shares.push({area(k) / double(++rooms_[k].count), k});
        }
    }

    void hang(RoomLamps& room) const {
        if (room.count == 0) return;
        room.lamps = ceiling_lamps(*room.shape, *room.light, rules_.utilisation, room.count, rules_.count > 0, volumes_,
                                   room.objects);
        for (Lamp& lamp : room.lamps) lamp.storey = building_.spaces[room.space].storey;
    }

    /// Ceiling lamps that furniture rules or the plan put there share what their room asks for.
    void give_to_pieces(const RoomLamps& room) {
        for (const std::size_t k : room.pieces) {
            Lamp& lamp = pieces_[k].lamp;
            if (room.shape)
                lamp.lumen =
                    std::max(lamp.lumen, std::round(room_lumen(room.shape->area_m2, *room.light, rules_.utilisation) /
                                                    double(room.pieces.size())));
            lamp.storey = building_.spaces[room.space].storey;
        }
    }

    const Building& building_;
    const LampRules& rules_;
    const accel::Executor& executor_;
    RoomShapes shapes_;
    VolumeFinder volumes_;
    std::vector<RoomLamps> rooms_;
    std::vector<PieceLamp> pieces_;
};

/// The id, or the first of "id-2", "id-3" ... that is free.
std::string free_id(const std::string& id, const std::set<std::string, std::less<>>& taken) {
    std::string free = id;
    for (std::size_t k = 2; taken.contains(free); ++k) free = id + "-" + std::to_string(k);
    return free;
}

}  // namespace

std::vector<Lamp> rule_lamps(const Building& building, const LampRules& rules, const Catalogue* catalogue,
                             const accel::Executor& executor) {
    return RuleLamps(building, rules, catalogue, executor).run();
}

void light_building(Building& building, const LampRules& rules, const Catalogue* catalogue,
                    const accel::Executor& executor) {
    if (rules.replace) building.lamps.clear();
    std::vector<Lamp> more = rule_lamps(building, rules, catalogue, executor);
    std::set<std::string, std::less<>> taken;
    for (const Lamp& lamp : building.lamps) taken.insert(lamp.id);
    for (Lamp& lamp : more) {
        lamp.id = free_id(lamp.id, taken);
        taken.insert(lamp.id);
        building.lamps.push_back(std::move(lamp));
    }
    std::ranges::sort(building.lamps, {}, &Lamp::id);
}

}  // namespace enfilade::modeler
