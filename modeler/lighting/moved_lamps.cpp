#include "modeler/lighting/moved_lamps.h"

#include <cmath>
#include <map>
#include <string_view>

namespace enfilade::modeler {
namespace {

using Place = std::array<double, 3>;

/// Objects by their ids, in whatever order they are.
class ById {
public:
    explicit ById(const Furnishing& furnishing) {
        for (const FurnishedObject& object : furnishing.objects) objects_.emplace(object.id, &object);
    }
    /// nullptr where there is no such object.
    [[nodiscard]] const FurnishedObject* find(std::string_view id) const {
        const auto at = objects_.find(id);
        return at == objects_.end() ? nullptr : at->second;
    }

private:
    std::map<std::string_view, const FurnishedObject*> objects_;
};

bool stands_alike(const FurnishedObject& a, const FurnishedObject& b) {
    return a.position == b.position && a.angle == b.angle && a.size == b.size && a.mirrored == b.mirrored;
}

/// Shares of the object's box.
Place in_box(const FurnishedObject& object, const Place& place) {
    const double c = std::cos(object.angle), s = std::sin(object.angle);
    const double x = place[0] - object.position[0], y = place[1] - object.position[1];
    const double along = c * x + s * y;
    return {(object.mirrored ? -along : along) / object.size[0], (c * y - s * x) / object.size[1],
            (place[2] - object.position[2]) / object.size[2]};
}

Place out_of_box(const FurnishedObject& object, const Place& share) {
    const double c = std::cos(object.angle), s = std::sin(object.angle);
    const double x = (object.mirrored ? -share[0] : share[0]) * object.size[0], y = share[1] * object.size[1];
    return {object.position[0] + c * x - s * y, object.position[1] + s * x + c * y,
            object.position[2] + share[2] * object.size[2]};
}

}  // namespace

std::vector<Lamp> moved_lamps(std::vector<Lamp> lamps, const Furnishing& before, const Furnishing& after) {
    const ById old_pieces(before), new_pieces(after);
    std::vector<Lamp> moved;
    moved.reserve(lamps.size());
    for (Lamp& lamp : lamps) {
        if (const FurnishedObject* from = lamp.carrier.empty() ? nullptr : old_pieces.find(lamp.carrier)) {
            const FurnishedObject* to = new_pieces.find(lamp.carrier);
            if (to == nullptr) continue;
            if (!stands_alike(*from, *to)) lamp.position = out_of_box(*to, in_box(*from, lamp.position));
        }
        moved.push_back(std::move(lamp));
    }
    return moved;
}

}  // namespace enfilade::modeler
