#include "accel/scene.h"

#include <algorithm>

namespace enfilade::accel {

Scene::Scene(Storage storage, const SceneView& view, std::vector<SceneArray> arrays)
    : storage_(std::move(storage)), view_(view), arrays_(std::move(arrays)) {}

const SceneArray* Scene::find(std::string_view name) const {
    const auto found = std::ranges::find(arrays_, name, &SceneArray::name);
    return found == arrays_.end() ? nullptr : &*found;
}

bool Scene::has_model() const { return std::ranges::find(arrays_, Group::Model, &SceneArray::group) != arrays_.end(); }

}  // namespace enfilade::accel
