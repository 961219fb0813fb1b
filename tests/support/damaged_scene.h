#pragma once
// What `validate` says of a scene in which one element of an array is wrong.

#include <cstddef>
#include <string>
#include <vector>

#include "accel/scene_file.h"
#include "accel/validate.h"

namespace enfilade::test {

/// A scene's bytes, in which elements are damaged one at a time.
class DamagedScene {
public:
    explicit DamagedScene(const accel::Scene& sound) : bytes_(sound.bytes().begin(), sound.bytes().end()) {}

    /// The code of the first defect where `change` wrote to element i of the array of that name; "" if there is none.
    template <class T, class Change>
    [[nodiscard]] std::string first_defect(const char* name, std::size_t i, Change change) const {
        const accel::Scene scene = accel::read(bytes_);
        change(reinterpret_cast<T*>(const_cast<std::byte*>(scene.find(name)->bytes.data()))[i]);
        const std::vector<accel::Defect> defects = accel::validate(scene.view());
        return defects.empty() ? "" : defects.front().code;
    }

private:
    std::vector<std::byte> bytes_;
};

}  // namespace enfilade::test
