#pragma once
// Words by which the layers and blocks of drawings are called, in several languages.

#include <span>
#include <string_view>

#include "plans/dxf/role.h"

namespace enfilade::plans::dxf {

/// Words that say the same. A Latin or Cyrillic entry stands for all words that begin with it, one of up to three Latin
/// letters for itself only; "=head" stands for itself only, "*wand" for every word that has it anywhere, as Chinese and
/// Japanese entries do. All are folded: small letters without accents.
struct RoleWords {
    Role role;
    std::span<const std::string_view> words;
};

/// Rows in the order in which they win: what is drawn about a wall or a door (its dimension, its hatch, its tag) is not
/// taken for the thing.
[[nodiscard]] std::span<const RoleWords> role_words();

/// Words for what is written, as "iden" in A-ROOM-IDEN, and for where: together they are the names of rooms.
[[nodiscard]] std::span<const std::string_view> writing_words();
[[nodiscard]] std::span<const std::string_view> place_words();

/// Words that make a wall a low one.
[[nodiscard]] std::span<const std::string_view> low_words();

/// Whether the word is one for which the entry stands.
[[nodiscard]] bool stands_for(std::string_view entry, std::string_view word);

}  // namespace enfilade::plans::dxf
