#include "modeler/furnishing/entry_lists.h"

#include <algorithm>

namespace enfilade::modeler {

std::uint64_t hash_of(std::string_view text) {
    std::uint64_t hash = 0xCBF29CE484222325u;
    for (const char c : text) {
        hash ^= static_cast<unsigned char>(c);
        hash *= 0x100000001B3u;
    }
    return hash;
}

EntryLists::EntryLists(std::span<const CatalogueEntry> entries) {
    for (const CatalogueEntry& entry : entries) {
        ids_.emplace(entry.id, &entry);
        if (entry.kind.empty() || !(entry.width > 0) || !(entry.depth > 0) || !(entry.height > 0)) continue;
        Kind& kind = kinds_[entry.kind];
        (entry.id.starts_with("own/") ? kind.own : kind.others).push_back(&entry);
    }
}

bool EntryLists::knows(std::string_view word) const {
    return kinds_.find(word) != kinds_.end() || ids_.find(word) != ids_.end();
}

std::vector<const CatalogueEntry*> EntryLists::drawn(std::string_view word, plans::Random& random, bool hangs) const {
    std::vector<const CatalogueEntry*> tries;
    const auto add = [&](const CatalogueEntry* entry) {
        if (std::find(tries.begin(), tries.end(), entry) == tries.end()) tries.push_back(entry);
    };
    const auto kind = kinds_.find(word);
    if (kind != kinds_.end()) {
        for (const auto* list : {&kind->second.others, &kind->second.own}) {
            if (list->empty()) continue;
            if (tries.empty()) add((*list)[random.below(std::uint32_t(list->size()))]);
            add(*std::min_element(list->begin(), list->end(), [&](const CatalogueEntry* a, const CatalogueEntry* b) {
                return hangs ? a->height < b->height : a->width * a->depth < b->width * b->depth;
            }));
        }
    } else if (const auto id = ids_.find(word); id != ids_.end()) {
        add(id->second);
    }
    return tries;
}

}  // namespace enfilade::modeler
