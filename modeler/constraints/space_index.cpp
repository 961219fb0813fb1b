#include "modeler/constraints/space_index.h"

namespace enfilade::modeler {

SpaceIndex::SpaceIndex(const Building& building, const plans::Plan& plan) : first_(building.spaces.size() + 1, 0) {
    spaces_.reserve(building.spaces.size());
    for (std::uint32_t s = 0; s < building.spaces.size(); ++s)
        spaces_.try_emplace(Key{building.spaces[s].label, building.spaces[s].id}, s);
    for (const Volume& volume : building.volumes) ++first_[volume.space + 1];
    for (std::size_t s = 1; s < first_.size(); ++s) first_[s] += first_[s - 1];
    volumes_.resize(building.volumes.size());
    std::vector<std::uint32_t> fill(first_.begin(), first_.end() - 1);
    for (std::uint32_t v = 0; v < building.volumes.size(); ++v) volumes_[fill[building.volumes[v].space]++] = v;
    for (const StoreyInfo& info : building.storeys) {
        const plans::Storey* found = nullptr;
        for (const plans::Storey& storey : plan.storeys)
            if (storey.id == info.id) found = &storey;
        storeys_.push_back(found);
    }
}

std::optional<std::uint32_t> SpaceIndex::find(Label label, const std::string& id) const {
    const auto at = spaces_.find(Key{label, id});
    if (at == spaces_.end()) return std::nullopt;
    return at->second;
}

}  // namespace enfilade::modeler
