#pragma once
// Scene files that somebody changed after they were checked.

#include <cstring>
#include <string_view>
#include <vector>

#include "accel/scene_file.h"
#include "accel/sha256.h"

namespace enfilade::testing {

/// The scene with bytes of one array changed, and all hashes of the file made to fit: a fault that no hash shows.
template <class Change>
accel::Scene changed(const accel::Scene& scene, std::string_view name, Change change) {
    std::vector<std::byte> bytes(scene.bytes().begin(), scene.bytes().end());
    accel::FileHeader header;
    std::memcpy(&header, bytes.data(), sizeof header);
    for (std::uint32_t s = 0; s < header.section_count; ++s) {
        std::byte* const row = bytes.data() + sizeof header + s * sizeof(accel::SectionEntry);
        accel::SectionEntry entry;
        std::memcpy(&entry, row, sizeof entry);
        if (name != entry.name.data()) continue;
        change(bytes.data() + entry.offset, entry.bytes);
        entry.sha256 = accel::sha256({bytes.data() + entry.offset, entry.bytes});
        std::memcpy(row, &entry, sizeof entry);
    }
    header.header_sha256 = {};
    std::memcpy(bytes.data(), &header, sizeof header);
    const std::size_t table = sizeof header + header.section_count * sizeof(accel::SectionEntry);
    header.header_sha256 = accel::sha256({bytes.data(), table});
    std::memcpy(bytes.data(), &header, sizeof header);
    return accel::read(bytes, {.verify_hashes = true});
}

}  // namespace enfilade::testing
