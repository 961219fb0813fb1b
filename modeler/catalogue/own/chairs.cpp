// Chairs, stools, benches: whoever sits there faces -y, the back stands at +y.

#include "modeler/catalogue/own/families.h"
#include "modeler/catalogue/own/shapes.h"

namespace enfilade::modeler::own {
namespace {

constexpr std::array<double, 2> sides = {-1, 1};

/// A dining chair: splayed front legs, back legs that run on as posts, a bowed back, a cushion.
void dining_chair(Shaper& s, const Paint& wood, const Paint& cloth, int slats) {
    for (const double side : sides) {
        rod(s, {side * 0.205, -0.235, 0}, {side * 0.185, -0.195, 0.42}, 0.012, 0.019, wood);
        const Vec points[] = {{side * 0.185, 0.255, 0},
                              {side * 0.18, 0.2, 0.4},
                              {side * 0.178, 0.205, 0.55},
                              {side * 0.175, 0.262, 0.84}};
        const int steps = s.fine(4);
        std::vector<double> radii;
        for (int k = 0; k <= 3 * steps; ++k) radii.push_back(0.019 - 0.007 * std::abs(k / (1.5 * steps) - 0.8));
        tube(s, curve(points, steps), radii, wood, 10);
        block(s, {side * 0.18 - 0.009, -0.19, 0.385}, {side * 0.18 + 0.009, 0.2, 0.425}, wood, 0.004);
    }
    for (const double y : {-0.195, 0.195}) block(s, {-0.18, y - 0.009, 0.385}, {0.18, y + 0.009, 0.425}, wood, 0.004);
    cushion(s, {0, -0.015, 0.447}, {0.222, 0.215, 0.028}, 0.06, 0.42, cloth);
    for (int k = 0; k < slats; ++k) {
        const double z = 0.80 - k * 0.085, y = 0.205 + 0.057 * (z - 0.55) / 0.29;
        slat(s, {-0.176, y, z}, {0.176, y, z}, 0.035, k == 0 ? 0.034 : 0.022, 0.008, wood);
    }
    if (s.detail() < 2) return;
    const Ring welt = rounded_rectangle({0, -0.015, 0.447}, 0.2225, 0.2155, 0.06, s.fine(4), s.fine(3));
    tube(s, welt, 0.0028, cloth, 5, Ends::Looped);
}

/// One moulded shell on a frame of wire.
void shell_chair(Shaper& s, const Paint& shell, const Paint& metal) {
    const int parts = s.fine(3), across = s.fine(12);
    const Vec line[] = {{0, -0.235, 0.421}, {0, -0.222, 0.436}, {0, -0.18, 0.446}, {0, -0.06, 0.442},
                        {0, 0.07, 0.435},   {0, 0.155, 0.449},  {0, 0.203, 0.51},  {0, 0.225, 0.6},
                        {0, 0.25, 0.74},    {0, 0.259, 0.80},   {0, 0.262, 0.82}};
    // Half widths at those places: it narrows where the seat turns into the back.
    const Vec width[] = {{0.15, 0, 0},  {0.19, 0, 0},  {0.21, 0, 0}, {0.225, 0, 0}, {0.225, 0, 0}, {0.215, 0, 0},
                         {0.205, 0, 0}, {0.205, 0, 0}, {0.19, 0, 0}, {0.14, 0, 0},  {0.06, 0, 0}};
    const std::vector<Vec> spine = curve(line, parts), halves = curve(width, parts);
    std::vector<Ring> rings;
    for (std::size_t k = 0; k < spine.size(); ++k) {
        const double half = halves[k].x;
        const Vec before = spine[k > 0 ? k - 1 : 0], after = spine[std::min(k + 1, spine.size() - 1)];
        const Vec along_spine = unit(after - before), normal = {0, -along_spine.z, along_spine.y};
        Ring& ring = rings.emplace_back();
        for (int side = 0; side < 2; ++side) {
            for (int i = 0; i < across; ++i) {
                const double u = (side == 0 ? 1 : -1) * (2.0 * i / across - 1);
                const double lift = 0.045 * std::pow(std::abs(u), 2.6) * half / 0.225;
                const double thick = (side == 0 ? -0.5 : 0.5) * 0.011;
                ring.push_back(spine[k] + Vec{half * u, 0, 0} + (lift + thick * (1 - 0.4 * u * u)) * normal);
            }
        }
    }
    s.skin(rings, shell);
    for (const double side : sides) {
        for (const double y : {-1.0, 1.0}) {
            rod(s, {side * 0.2, y * 0.22 + 0.01, 0}, {side * 0.12, y * 0.12, 0.427}, 0.009, 0.011, metal, 10);
        }
        rod(s, {side * 0.12, -0.13, 0.422}, {side * 0.12, 0.13, 0.422}, 0.008, 0.008, metal, 8);
    }
    for (const double y : {-0.12, 0.12}) rod(s, {-0.12, y, 0.42}, {0.12, y, 0.42}, 0.008, 0.008, metal, 8);
}

void bar_stool(Shaper& s, const Paint& wood, const Paint& metal) {
    {
        const auto scope = s.inside(move(0, 0, 0.62));
        const Vec profile[] = {{0, 0, 0},        {0.13, 0, 0},      {0.165, 0, 0.006}, {0.175, 0, 0.018},
                               {0.172, 0, 0.03}, {0.155, 0, 0.034}, {0.08, 0, 0.028},  {0, 0, 0.025}};
        lathe(s, profile, wood, 28);
    }
    for (int k = 0; k < 4; ++k) {
        const auto scope = s.inside(turn_z(45 + 90 * k));
        rod(s, {0.215, 0, 0}, {0.11, 0, 0.625}, 0.011, 0.015, wood, 12);
        const double z = k % 2 == 0 ? 0.22 : 0.26, r = mix(0.215, 0.11, z / 0.625);
        rod(s, {r, 0, z}, {0, r, z}, 0.007, 0.007, metal, 8);
    }
}

/// Three legs, bent at their tops, under a round seat.
void low_stool(Shaper& s, const Paint& wood) {
    drum(s, {0, 0, 0.42}, 0.175, 0.03, wood, 0.01, 36);
    for (int k = 0; k < 4; ++k) {
        const auto scope = s.inside(turn_z(45 + 90 * k));
        const Vec bend[] = {{0.19, 0, 0}, {0.183, 0, 0.2}, {0.176, 0, 0.36}, {0.15, 0, 0.412}, {0.09, 0, 0.414}};
        const std::vector<Vec> path = curve(bend, s.fine(3));
        std::vector<Ring> rings;
        for (std::size_t i = 0; i < path.size(); ++i) {
            const Vec along = unit(path[std::min(i + 1, path.size() - 1)] - path[i > 0 ? i - 1 : 0]);
            const Vec across = {along.z, 0, -along.x};
            Ring& ring = rings.emplace_back();
            for (const Vec& p : rounded_rectangle({}, 0.009, 0.024, 0.005, std::min(s.detail(), 4))) {
                ring.push_back(path[i] + p.x * across + Vec{0, p.y, 0});
            }
        }
        s.skin(rings, wood);
    }
}

void bench(Shaper& s, const Size& size, const Paint& wood) {
    const double x = size.width / 2, y = size.depth / 2;
    for (int k = 0; k < 3; ++k) {
        const double from = -y + k * (2 * y + 0.008) / 3;
        block(s, {-x, from, 0.415}, {x, from + (2 * y - 0.016) / 3, 0.45}, wood, 0.006);
    }
    for (const double side : sides) {
        for (const double front : sides) {
            post(s, {side * (x - 0.08), front * (y - 0.03), 0}, {side * (x - 0.14), front * (y - 0.05), 0.415},
                 {0.02, 0.02, 0}, {0.026, 0.026, 0}, wood, 0.005);
        }
        block(s, {side * (x - 0.14) - 0.02, -y + 0.04, 0.36}, {side * (x - 0.14) + 0.02, y - 0.04, 0.414}, wood, 0.004);
    }
    block(s, {-x + 0.13, -0.015, 0.30}, {x - 0.13, 0.015, 0.35}, wood, 0.004);
    for (const double side : sides) {
        block(s, {side * (x - 0.13) - 0.015, -y + 0.07, 0.31}, {side * (x - 0.13) + 0.015, y - 0.07, 0.34}, wood,
              0.004);
    }
}

}  // namespace

void add_chairs(Pieces& pieces) {
    pieces.push_back(piece<"own/chair", Size{0.445, 0.545, 0.845}>(
        "Dining chair, oak", "chair", "Seats", [](Shaper& s, const Size&) { dining_chair(s, oak, linen, 3); }));
    pieces.push_back(piece<"own/chair-walnut", Size{0.445, 0.545, 0.845}>(
        "Dining chair, walnut", "chair", "Seats", [](Shaper& s, const Size&) { dining_chair(s, walnut, petrol, 2); }));
    pieces.push_back(piece<"own/chair-shell", Size{0.45, 0.53, 0.83}>(
        "Shell chair", "chair", "Seats", [](Shaper& s, const Size&) { shell_chair(s, sage_lacquer, beech); }));
    pieces.push_back(piece<"own/stool", Size{0.35, 0.35, 0.45}>("Stool", "stool", "Seats",
                                                                [](Shaper& s, const Size&) { low_stool(s, birch); }));
    pieces.push_back(piece<"own/stool-bar", Size{0.35, 0.35, 0.655}>(
        "Bar stool", "bar_stool", "Seats", [](Shaper& s, const Size&) { bar_stool(s, oak, iron); }));
    pieces.push_back(piece<"own/bench", Size{1.4, 0.36, 0.45}>(
        "Bench", "bench", "Seats", [](Shaper& s, const Size& size) { bench(s, size, oak); }));
}

}  // namespace enfilade::modeler::own
