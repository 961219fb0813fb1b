#pragma once
// From the plan's elements to the spaces and volumes of the model that stand for them.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "modeler/building.h"
#include "plans/plan.h"

namespace enfilade::modeler {

class SpaceIndex {
public:
    SpaceIndex(const Building& building, const plans::Plan& plan);

    /// The space with this label and id; the plan's ids are unique, others ("w1/above", "t1/slab") derive from them.
    [[nodiscard]] std::optional<std::uint32_t> find(Label label, const std::string& id) const;
    /// Volumes that name the space, ascending.
    [[nodiscard]] std::span<const std::uint32_t> volumes(std::uint32_t space) const {
        return std::span(volumes_).subspan(first_[space], first_[space + 1] - first_[space]);
    }
    /// The plan's storey of a storey of the building, nullptr where the plan has none of that id.
    [[nodiscard]] const plans::Storey* storey(std::uint32_t k) const { return storeys_[k]; }

private:
    struct Key {
        Label label;
        std::string_view id;
        friend bool operator==(const Key&, const Key&) = default;
    };
    struct Hash {
        std::size_t operator()(const Key& key) const {
            return std::hash<std::string_view>()(key.id) * 31 + std::size_t(key.label);
        }
    };

    std::unordered_map<Key, std::uint32_t, Hash> spaces_;  ///< ids are the building's
    std::vector<std::uint32_t> first_;                     ///< [space + 1] into volumes_
    std::vector<std::uint32_t> volumes_;
    std::vector<const plans::Storey*> storeys_;  ///< [storey of the building]
};

}  // namespace enfilade::modeler
