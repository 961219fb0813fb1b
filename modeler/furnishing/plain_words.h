#pragma once
// Names of rooms without what makes no difference between them.

#include <string>
#include <string_view>

namespace enfilade::modeler {

/// Lower case, accents of Latin letters taken off ("Büro" is "buro", "Wohnzimmer 2" is "wohnzimmer"), everything that
/// is no letter one space. Letters beyond Latin stay as they are.
[[nodiscard]] std::string plain_words(std::string_view utf8);

/// Whether `word`, which may be several words, stands in `text` between its spaces; a word of letters without spaces
/// between words (Chinese, Japanese) anywhere. Both as `plain_words` gives them; no empty word.
[[nodiscard]] bool holds_words(std::string_view text, std::string_view word);

}  // namespace enfilade::modeler
