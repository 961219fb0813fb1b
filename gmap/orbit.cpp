#include "gmap/orbit.h"

#include <algorithm>

namespace enfilade::gmap {

namespace {

/// Up to here a search through the list is faster than hashing.
constexpr std::size_t list_limit = 24;

std::size_t slot_of(std::uint32_t id, std::size_t slot_count) {
    return static_cast<std::size_t>((id * std::uint64_t{0x9E3779B97F4A7C15}) >> 32) & (slot_count - 1);
}

}  // namespace

namespace detail {

bool IdSet::insert(std::uint32_t id) {
    if (2 * (size_ + 1) > slots_.size()) grow();
    std::size_t slot = slot_of(id, slots_.size());
    while (slots_[slot] != none_u32) {
        if (slots_[slot] == id) return false;
        slot = (slot + 1) & (slots_.size() - 1);
    }
    slots_[slot] = id;
    ++size_;
    return true;
}

bool IdSet::contains(std::uint32_t id) const {
    if (slots_.empty()) return false;
    for (std::size_t slot = slot_of(id, slots_.size()); slots_[slot] != none_u32;
         slot = (slot + 1) & (slots_.size() - 1))
        if (slots_[slot] == id) return true;
    return false;
}

void IdSet::grow() {
    std::vector<std::uint32_t> old(std::max<std::size_t>(32, 2 * slots_.size()), none_u32);
    old.swap(slots_);
    for (const std::uint32_t id : old) {
        if (id == none_u32) continue;
        std::size_t slot = slot_of(id, slots_.size());
        while (slots_[slot] != none_u32) slot = (slot + 1) & (slots_.size() - 1);
        slots_[slot] = id;
    }
}

}  // namespace detail

bool Orbit::add(DartId d) {
    if (found_.size() <= list_limit) {
        if (std::find(found_.begin(), found_.end(), d) != found_.end()) return false;
        found_.push_back(d);
        if (found_.size() > list_limit)
            for (const DartId known : found_) set_.insert(static_cast<std::uint32_t>(known));
        return true;
    }
    if (!set_.insert(static_cast<std::uint32_t>(d))) return false;
    found_.push_back(d);
    return true;
}

bool Orbit::reach(std::size_t position) {
    while (position >= found_.size() && expanded_ < found_.size()) {
        const DartId d = found_[expanded_++];
        for (int i = 0; i < 4; ++i)
            if ((generators_ >> i) & 1u) (void)add(map_->alpha(i, d));
    }
    return position < found_.size();
}

}  // namespace enfilade::gmap
