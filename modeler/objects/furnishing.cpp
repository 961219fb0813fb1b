#include "modeler/objects/furnishing.h"

#include <algorithm>
#include <cmath>

#include "modeler/objects/object_box.h"

namespace enfilade::modeler {
namespace {

/// Metres: what is thinner has no extent that a size could be asked of.
constexpr double flat = 1e-6;

}  // namespace

TurnedBox turned_box(const std::array<double, 9>& turned, const ObjectMesh& mesh) {
    TurnedBox box;
    if (mesh.vertices.empty()) return box;
    box.low = {INFINITY, INFINITY, INFINITY};
    box.high = {-INFINITY, -INFINITY, -INFINITY};
    for (const std::array<float, 3>& v : mesh.vertices)
        for (std::size_t k = 0; k < 3; ++k) {
            const double at = turned[3 * k] * v[0] + turned[3 * k + 1] * v[1] + turned[3 * k + 2] * v[2];
            box.low[k] = std::min(box.low[k], at);
            box.high[k] = std::max(box.high[k], at);
        }
    return box;
}

std::array<double, 12> plan_from_mesh(const FurnishedObject& object, const TurnedBox& box) {
    // Where the middle of the bottom of the turned mesh's box is, and by how much the box is stretched.
    const std::array<double, 3> foot = {(box.low[0] + box.high[0]) / 2, (box.low[1] + box.high[1]) / 2, box.low[2]};
    std::array<double, 3> scale = {1, 1, 1};
    for (std::size_t k = 0; k < 3; ++k)
        if (const double extent = box.high[k] - box.low[k]; extent > flat) scale[k] = object.size[k] / extent;
    if (object.mirrored) scale[0] = -scale[0];
    const double c = std::cos(object.angle), s = std::sin(object.angle);
    const std::array<std::array<double, 3>, 3> stand = {
        {{c * scale[0], -s * scale[1], 0}, {s * scale[0], c * scale[1], 0}, {0, 0, scale[2]}}};
    std::array<double, 12> rows{};
    for (std::size_t r = 0; r < 3; ++r) {
        rows[4 * r + 3] = object.position[r];
        for (std::size_t k = 0; k < 3; ++k) {
            rows[4 * r + 3] -= stand[r][k] * foot[k];
            for (std::size_t column = 0; column < 3; ++column)
                rows[4 * r + column] += stand[r][k] * object.turned[3 * k + column];
        }
    }
    return rows;
}

std::array<double, 12> plan_from_mesh(const FurnishedObject& object, const ObjectMesh& mesh) {
    return plan_from_mesh(object, turned_box(object.turned, mesh));
}

ObjectBox box_of(const FurnishedObject& object) {
    const double c = std::cos(object.angle), s = std::sin(object.angle);
    const double w = object.size[0] / 2, d = object.size[1] / 2;
    ObjectBox box;
    const std::array<std::array<double, 2>, 4> corners = {{{-w, -d}, {w, -d}, {w, d}, {-w, d}}};
    for (std::size_t k = 0; k < 4; ++k)
        box.footprint[k] = {object.position[0] + c * corners[k][0] - s * corners[k][1],
                            object.position[1] + s * corners[k][0] + c * corners[k][1]};
    box.z_low = object.position[2];
    box.z_high = object.position[2] + object.size[2];
    return box;
}

}  // namespace enfilade::modeler
