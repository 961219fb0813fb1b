#include "accel/defect_report.h"

namespace enfilade::accel::detail {
namespace {

constexpr float place_limit = 1e12f;
constexpr float brightest = 1e18f;  ///< candela: a micrometre away still no infinity (render/lamp_light.h)

bool is_place(const std::array<float, 3>& p) {
    return std::abs(p[0]) <= place_limit && std::abs(p[1]) <= place_limit && std::abs(p[2]) <= place_limit;
}

bool is_intensity(const std::array<float, 3>& c) {
    for (const float v : c)
        if (!(v >= 0 && v <= brightest)) return false;
    return true;
}

}  // namespace

void validate_lights(const SceneView& view, const Executor& executor, DefectReport& report) {
    const SceneView& v = view;
    if (v.lights.size() >= UINT32_MAX) return report.add(0, "F3", "the array lights is too long");
    const auto is_text = [&](TextId id) { return index(id) + 1 < v.text_offsets.size(); };
    check_each(
        executor, v.lights.size(),
        [&](std::size_t i) {
            const Light& l = v.lights[i];
            return (l.cell == none<CellId> || index(l.cell) < v.cells.size()) &&
                   (l.carrier == none<ObjectId> || index(l.carrier) < v.objects.size()) && is_text(l.id) &&
                   is_text(l.name);
        },
        [&](std::size_t i) { report.add(i, "F4", element("lights", i) + " has an index out of range"); });
    check_each(
        executor, v.lights.size(),
        [&](std::size_t i) {
            const Light& l = v.lights[i];
            return is_place(l.position) && is_intensity(l.intensity) && l.radius >= 0 && l.radius <= place_limit;
        },
        [&](std::size_t i) {
            report.add(i, "F5", element("lights", i) + " has a place, a size or an intensity that is none");
        });
    if (!report.empty()) return;
    check_each(
        executor, v.lights.size(),
        [&](std::size_t i) { return i == 0 || v.string(v.lights[i - 1].id) < v.string(v.lights[i].id); },
        [&](std::size_t i) { report.add(i, "F4", element("lights", i) + " has no id above the one before"); });
}

}  // namespace enfilade::accel::detail
