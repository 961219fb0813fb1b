#include "tools/certify.h"

#include <algorithm>

#include "accel/certificate.h"
#include "modeler/export_scene.h"
#include "modeler/model_group.h"
#include "tools/console.h"

namespace enfilade::tools {

std::optional<std::string> first_difference(const accel::Scene& scene, const accel::Scene& again) {
    for (const accel::SceneArray& array : scene.arrays()) {
        if (array.group != accel::Group::Trace) continue;
        const std::string name(array.name);
        const accel::SceneArray* other = again.find(array.name);
        if (other == nullptr) return name;
        const auto elements = [](const accel::SceneArray& a) { return a.bytes.size() / std::max(a.element_bytes, 1u); };
        if (array.bytes.size() != other->bytes.size())
            return name + ": " + counted(elements(array), "element") + " instead of " +
                   std::to_string(elements(*other));
        const auto [here, there] = std::mismatch(array.bytes.begin(), array.bytes.end(), other->bytes.begin());
        if (here != array.bytes.end())
            return name + '[' +
                   std::to_string(std::size_t(here - array.bytes.begin()) / std::max(array.element_bytes, 1u)) + ']';
    }
    for (const accel::SceneArray& array : again.arrays())
        if (array.group == accel::Group::Trace && scene.find(array.name) == nullptr) return std::string(array.name);
    return std::nullopt;
}

Certification certify(const accel::Scene& scene) {
    Certification result;
    if (!scene.has_model()) {
        result.verdict = "uncertified: no model group";
        return result;
    }
    const modeler::Building building = modeler::read_model(scene);
    result.report = modeler::check(building);
    const std::optional<accel::Certificate> certificate = accel::certificate(scene);
    const accel::Scene again = modeler::export_scene(building, *result.report, certificate ? certificate->options : "");
    const std::optional<std::string> difference = first_difference(scene, again);
    result.verdict = difference ? "differs at " + *difference : "certified";
    return result;
}

}  // namespace enfilade::tools
