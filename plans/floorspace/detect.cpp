#include "plans/floorspace/detect.h"

namespace enfilade::plans {
namespace {

/// Walks over the members of the outermost object. Asks for nothing but balanced brackets and closed texts.
class TopLevelKeys {
public:
    explicit TopLevelKeys(std::string_view text) : text_(text) {
        if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
        skip_space();
        if (peek() == '{') ++at_;
        else at_ = text_.size();
    }

    /// The next key; empty at the end, or where the text makes no sense.
    std::string_view next() {
        skip_space();
        if (peek() == ',') {
            ++at_;
            skip_space();
        }
        if (peek() != '"') return {};
        const std::string_view key = text_token();
        skip_space();
        if (peek() != ':') return key;
        ++at_;
        skip_value();
        return key;
    }

private:
    [[nodiscard]] char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }

    void skip_to(std::string_view what) {
        const std::size_t found = text_.find(what, at_);
        at_ = found == std::string_view::npos ? text_.size() : found + what.size();
    }
    void skip_space() {
        while (at_ < text_.size()) {
            const std::string_view rest = text_.substr(at_, 2);
            if (rest == "//") skip_to("\n");
            else if (rest == "/*") skip_to("*/");
            else if (std::string_view(" \t\r\n").find(text_[at_]) != std::string_view::npos) ++at_;
            else return;
        }
    }

    /// What stands between two double quotes, escapes as written.
    std::string_view text_token() {
        const std::size_t begin = ++at_;
        while (at_ < text_.size() && text_[at_] != '"') at_ += text_[at_] == '\\' ? 2 : 1;
        const std::string_view token = text_.substr(begin, at_ < text_.size() ? at_ - begin : std::string_view::npos);
        ++at_;
        return token;
    }

    /// Up to the comma or bracket behind the value.
    void skip_value() {
        std::size_t depth = 0;
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == '"') {
                (void)text_token();
                continue;
            }
            if (c == '/') {
                const std::size_t before = at_;
                skip_space();
                at_ = at_ == before ? before + 1 : at_;
                continue;
            }
            if (c == '{' || c == '[') ++depth;
            if ((c == ',' || c == '}' || c == ']') && depth == 0) return;
            if (c == '}' || c == ']') --depth;
            ++at_;
        }
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

}  // namespace

bool is_floorspace(std::string_view text) {
    TopLevelKeys keys(text);
    bool found = false;
    for (std::string_view key = keys.next(); !key.empty(); key = keys.next()) {
        if (key == "storeys" || key == "format_version") return false;
        found = found || key == "stories" || key == "application" || key == "project";
    }
    return found;
}

}  // namespace enfilade::plans
