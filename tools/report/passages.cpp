#include "tools/report/passages.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>

namespace enfilade::tools {
namespace {

using modeler::Direction;
using modeler::Face;
using modeler::Label;
using modeler::Volume;

/// Where two spaces meet, all faces together.
struct Contact {
    double length = 0;
    double x = 0, y = 0;  ///< middles times lengths
    void add(Mm a, Mm b) {
        const double part = std::hypot(double(b.x - a.x), double(b.y - a.y)) + 1e-6;
        length += part;
        x += part * double(a.x + b.x) / 2, y += part * double(a.y + b.y) / 2;
    }
    [[nodiscard]] Mm middle() const { return {std::llround(x / length), std::llround(y / length)}; }
};

class PassageFinder {
public:
    explicit PassageFinder(const PlanView& view) : view_(view), building_(view.building()) {}

    Passages run() {
        for (const Face& face : building_.faces) face.direction == Direction::Side ? add_side(face) : add_level(face);
        for (const auto& [opening, sides] : openings_) add_opening(opening, sides);
        for (const auto& [spaces, contact] : borders_) {
            const Mm at = contact.middle();
            const std::uint32_t storey = std::min(view_.space(spaces.first).storey, view_.space(spaces.second).storey);
            result_.list.push_back({PassageKind::Border, storey, UINT32_MAX, spaces.first, spaces.second, at, at});
        }
        measure_depths();
        return std::move(result_);
    }

private:
    static bool is_hole(Label label) {
        return label == Label::Door || label == Label::Window || label == Label::Opening;
    }
    /// A stair or shaft inside the slab above its storey.
    [[nodiscard]] bool is_well(const Volume& volume) const {
        if (volume.label != Label::Stair && volume.label != Label::Shaft) return false;
        const std::uint32_t storey = view_.space(volume.space).storey;
        return storey < building_.storeys.size() && volume.z_low >= building_.storeys[storey].z_ceiling;
    }

    void add_side(const Face& face) {
        const Volume &front = building_.volumes[face.front], &back = building_.volumes[face.back];
        if (front.space == back.space || !carries_light(front.label) || !carries_light(back.label)) return;
        const modeler::PlanEdge& edge = building_.edges[face.edge];
        const Mm a = view_.mm(building_.points[edge.a]), b = view_.mm(building_.points[edge.b]);
        if (is_hole(front.label)) openings_[front.space][back.space].add(a, b);
        if (is_hole(back.label)) openings_[back.space][front.space].add(a, b);
        if (is_hole(front.label) || is_hole(back.label) || is_well(front) || is_well(back)) return;
        borders_[std::minmax(front.space, back.space)].add(a, b);
    }

    void add_level(const Face& face) {
        const Volume &above = building_.volumes[face.front], &below = building_.volumes[face.back];
        if (!carries_light(above.label) || !carries_light(below.label) || above.space == below.space) return;
        if (is_well(above)) add_well(above.space, below);
        if (is_well(below)) add_well(below.space, above);
    }
    void add_well(std::uint32_t well, const Volume& beside) {
        const Mm at = view_.middle(building_.pieces[beside.piece]);
        openings_[well][beside.space].add(at, at);
    }

    /// The two spaces that an opening shares most border with.
    void add_opening(std::uint32_t opening, const std::map<std::uint32_t, Contact>& sides) {
        const modeler::Space& space = view_.space(opening);
        if (sides.size() < 2 || space.storey >= building_.storeys.size()) return;
        std::vector<std::pair<std::uint32_t, const Contact*>> order;
        for (const auto& [side, contact] : sides) order.push_back({side, &contact});
        std::stable_sort(order.begin(), order.end(),
                         [](const auto& a, const auto& b) { return a.second->length > b.second->length; });
        order.resize(2);
        const PassageKind kind = space.label == Label::Door     ? PassageKind::Door
                                 : space.label == Label::Window ? PassageKind::Window
                                 : is_hole(space.label)         ? PassageKind::Opening
                                                                : PassageKind::Stair;
        const auto storey_of = [&](const auto& side) { return view_.space(side.first).storey; };
        if (kind == PassageKind::Stair ? storey_of(order[0]) > storey_of(order[1]) : order[0].first > order[1].first)
            std::swap(order[0], order[1]);
        result_.list.push_back({kind, space.storey, opening, order[0].first, order[1].first, order[0].second->middle(),
                                order[1].second->middle()});
    }

    void measure_depths() {
        std::vector<std::vector<std::uint32_t>> beside(building_.spaces.size());
        for (const Passage& passage : result_.list) {
            if (passage.kind == PassageKind::Window) continue;
            if (passage.space != UINT32_MAX && view_.space(passage.space).id.ends_with("/above")) continue;
            beside[passage.from].push_back(passage.to);
            beside[passage.to].push_back(passage.from);
        }
        result_.depth.assign(building_.spaces.size(), unreachable);
        std::deque<std::uint32_t> open = {modeler::exterior_space};
        result_.depth[modeler::exterior_space] = 0;
        while (!open.empty()) {
            const std::uint32_t at = open.front();
            open.pop_front();
            for (const std::uint32_t next : beside[at]) {
                if (result_.depth[next] != unreachable) continue;
                result_.depth[next] = result_.depth[at] + 1;
                open.push_back(next);
            }
        }
    }

    const PlanView& view_;
    const modeler::Building& building_;
    std::map<std::uint32_t, std::map<std::uint32_t, Contact>> openings_;  ///< by hole or well, by what it meets
    std::map<std::pair<std::uint32_t, std::uint32_t>, Contact> borders_;
    Passages result_;
};

}  // namespace

Passages find_passages(const PlanView& view) { return PassageFinder(view).run(); }

}  // namespace enfilade::tools
