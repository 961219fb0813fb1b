#pragma once
// Catalogue entries by the words of rules.

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "modeler/catalogue/catalogue.h"
#include "plans/random.h"

namespace enfilade::modeler {

class EntryLists {
public:
    /// \pre the entries outlive this
    explicit EntryLists(std::span<const CatalogueEntry> entries);

    [[nodiscard]] bool knows(std::string_view word) const;
    /// What to try for a kind or an id: one drawn, then the smallest, or the flattest of what `hangs` from a ceiling.
    /// Our own pieces only where there are no others, and last of all.
    [[nodiscard]] std::vector<const CatalogueEntry*> drawn(std::string_view word, plans::Random& random,
                                                           bool hangs = false) const;

private:
    struct Kind {
        std::vector<const CatalogueEntry*> others;
        std::vector<const CatalogueEntry*> own;
    };
    std::map<std::string, Kind, std::less<>> kinds_;
    std::map<std::string, const CatalogueEntry*, std::less<>> ids_;
};

/// FNV-1a (Fowler, Noll, Vo): the same on every machine.
[[nodiscard]] std::uint64_t hash_of(std::string_view text);

}  // namespace enfilade::modeler
