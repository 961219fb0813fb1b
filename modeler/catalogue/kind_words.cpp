#include "modeler/catalogue/kind_words.h"

#include <algorithm>

#include "modeler/catalogue/kind_table.h"
#include "modeler/furnishing/plain_words.h"

namespace enfilade::modeler {
namespace {

template <class Visit>
void for_each_phrase(std::string_view phrases, const Visit& visit) {
    for (std::size_t at = 0; at <= phrases.size();) {
        const std::size_t end = std::min(phrases.find('|', at), phrases.size());
        visit(phrases.substr(at, end - at));
        at = end + 1;
    }
}

/// "kitchenUpperCabinet2" -> "kitchen Upper Cabinet2".
std::string split_at_capitals(std::string_view text) {
    std::string out;
    for (std::size_t k = 0; k < text.size(); ++k) {
        const bool is_capital = text[k] >= 'A' && text[k] <= 'Z';
        const bool follows_small = k > 0 && text[k - 1] >= 'a' && text[k - 1] <= 'z';
        if (is_capital && follows_small) out.push_back(' ');
        out.push_back(text[k]);
    }
    return out;
}

/// Where the phrase begins in the words for the last time, or npos; only whole words count.
std::size_t last_place(std::string_view words, std::string_view phrase) {
    for (std::size_t at = words.rfind(phrase); at != std::string_view::npos; at = words.rfind(phrase, at - 1)) {
        const std::size_t end = at + phrase.size();
        const bool begins = at == 0 || words[at - 1] == ' ';
        const bool ends = end == words.size() || words[end] == ' ';
        if (begins && ends) return at;
        if (at == 0) break;
    }
    return std::string_view::npos;
}

bool holds_any(std::string_view words, std::string_view phrases) {
    bool found = false;
    for_each_phrase(phrases, [&](std::string_view phrase) {
        found = found || last_place(words, phrase) != std::string_view::npos;
    });
    return found;
}

/// What stands before "with", "for" ...: a chair with cushion is no cushion.
std::string_view head_of(std::string_view words) {
    for (const std::string_view stop :
         {" with ", " for ", " mit ", " fur ", " avec ", " pour ", " con ", " per ", " para "})
        if (const std::size_t at = words.find(stop); at != std::string_view::npos && at > 0)
            words = words.substr(0, at);
    return words;
}

bool is_within(double value, const std::array<double, 2>& range) {
    constexpr double slack = 1e-6;
    return value >= range[0] - slack && value <= range[1] + slack;
}

bool has_size_of(const PieceWords& piece, const KindWords& row) {
    if (!(piece.width > 0) || !(piece.depth > 0) || !(piece.height > 0)) return true;
    return is_within(piece.width, row.width) && is_within(piece.depth, row.depth) &&
           is_within(piece.height, row.height) && is_within(piece.elevation, row.elevation);
}

struct Match {
    std::string_view kind;
    std::ptrdiff_t word_count = 0;  ///< of the phrase that was found
    std::size_t end = 0;
};

Match match_in(std::string_view words, const PieceWords& piece) {
    Match best;
    for (const KindWords& row : kind_table()) {
        if (!has_size_of(piece, row)) continue;
        for_each_phrase(row.phrases, [&](std::string_view phrase) {
            const std::size_t at = last_place(words, phrase);
            if (at == std::string_view::npos) return;
            const auto word_count = 1 + std::count(phrase.begin(), phrase.end(), ' ');
            const std::size_t end = at + phrase.size();
            if (word_count > best.word_count || (word_count == best.word_count && end > best.end))
                best = {row.kind, word_count, end};
        });
    }
    return best;
}

/// In the head of the words, or else in all of them.
Match match_of(std::string_view words, const PieceWords& piece) {
    const Match in_head = match_in(head_of(words), piece);
    return in_head.word_count > 0 ? in_head : match_in(words, piece);
}

}  // namespace

std::string kind_of_piece(const PieceWords& piece) {
    const std::string name = plain_words(piece.name);
    if (holds_any(plain_words(piece.category), categories_of_no_kind())) {
        // Bicycles are vehicles that people keep indoors.
        const Match match = match_of(name, piece);
        return match.kind == "bicycle" ? "bicycle" : "";
    }
    if (holds_any(name, phrases_of_no_kind())) return {};
    Match best = match_of(name, piece);
    if (best.word_count == 0) best = match_of(plain_words(split_at_capitals(piece.name)), piece);
    const std::string id = plain_words(split_at_capitals(piece.id.substr(piece.id.find_last_of("#/") + 1)));
    if (holds_any(id, phrases_of_no_kind())) return best.word_count > 1 ? std::string(best.kind) : std::string();
    // A "Chair" whose id is office_chair is one: the id may say more, not less.
    const Match by_id = match_of(id, piece);
    return std::string(by_id.word_count > best.word_count ? by_id.kind : best.kind);
}

}  // namespace enfilade::modeler
