#include "plans/sweet_home/xml.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/error.h"
#include "plans/colour.h"
#include "plans/number_text.h"
#include "plans/utf8.h"

namespace enfilade::plans {
namespace {

constexpr int max_depth = 256;
constexpr std::size_t max_elements = 4'000'000;

struct Fault {
    const char* code;
    std::size_t at;  ///< byte
    std::string sentence;
};

[[noreturn]] void refuse(std::string_view text, const Fault& fault, const std::string& file_name) {
    int line = 1;
    int column = 1;
    for (const char c : text.substr(0, fault.at)) {
        if (c == '\n') {
            ++line;
            column = 1;
        } else if ((static_cast<unsigned char>(c) & 0xC0u) != 0x80u) {
            ++column;
        }
    }
    throw InputError(fault.code, file_name, line, column, "Home.xml in this file " + fault.sentence);
}

/// Goes once over the text for what pugixml does not mind: bare or unknown `&`, NUL, and nesting without end.
class Scanner {
public:
    explicit Scanner(std::string_view text) : text_(text) {}

    /// The first fault.
    std::optional<Fault> run() {
        while (at_ < text_.size() && !fault_) {
            if (text_[at_] == '&') reference();
            else if (text_[at_] == '<') markup();
            else if (text_[at_] == 0) fail("P154", at_, "holds a zero byte; it must be XML in UTF-8.");
            else ++at_;
        }
        return fault_;
    }

private:
    void fail(const char* code, std::size_t at, std::string sentence) {
        if (!fault_) fault_ = Fault{code, at, std::move(sentence)};
        at_ = text_.size();
    }

    /// Moves behind the closing words of a comment, a CDATA section or an instruction.
    void skip_past(std::string_view closing) {
        const std::size_t end = text_.find(closing, at_);
        at_ = end == std::string_view::npos ? text_.size() : end + closing.size();
    }

    void markup() {
        const std::string_view rest = text_.substr(at_);
        if (rest.starts_with("<!--")) return skip_past("-->");
        if (rest.starts_with("<![CDATA[")) return skip_past("]]>");
        if (rest.starts_with("<?")) return skip_past("?>");
        if (rest.starts_with("<!")) return skip_past(">");
        tag(rest.starts_with("</"));
    }

    void tag(bool closing) {
        const std::size_t start = at_++;
        char quote = 0;
        for (; at_ < text_.size(); ++at_) {
            const char c = text_[at_];
            if (c == '&') {
                reference();
                --at_;
            } else if (c == '<') {
                return fail("P154", at_,
                            quote != 0 ? "is not well-formed XML: a value may not hold \"<\"; write \"&lt;\"."
                                       : "is not well-formed XML: a tag is not closed before the next one begins.");
            } else if (quote != 0) {
                if (c == quote) quote = 0;
            } else if (c == '"' || c == '\'') {
                quote = c;
            } else if (c == '>') {
                break;
            }
        }
        if (at_ >= text_.size()) return;  // pugixml names an open end
        const bool empty = text_[at_ - 1] == '/';
        if (closing) --depth_;
        else if (!empty && ++depth_ > max_depth)
            return fail("P156", start, "nests its elements more than 256 deep, which no home does.");
        if (!closing && ++elements_ > max_elements)
            return fail("P156", start, "has more than 4 million elements, which no home has.");
        ++at_;
    }

    /// Ends behind the reference, or at the end of the text after a fault.
    void reference() {
        const std::size_t end =
            text_.find_first_not_of("#ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789", at_ + 1);
        const std::string_view name =
            end == std::string_view::npos || text_[end] != ';' ? "" : text_.substr(at_ + 1, end - at_ - 1);
        const bool known =
            name == "amp" || name == "lt" || name == "gt" || name == "quot" || name == "apos" || is_number(name);
        if (known) {
            at_ = end + 1;
            return;
        }
        fail("P154", at_,
             name.empty()
                 ? "is not well-formed XML: \"&\" must be written \"&amp;\"."
                 : "is not well-formed XML: the entity \"&" + std::string(name.substr(0, 40)) + ";\" is not known.");
    }

    static bool is_number(std::string_view name) {
        if (!name.starts_with('#')) return false;
        const bool hexadecimal = name.starts_with("#x");
        const std::string_view digits = name.substr(hexadecimal ? 2 : 1);
        std::uint32_t code = 0;
        const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), code, hexadecimal ? 16 : 10);
        return !digits.empty() && result.ec == std::errc() && result.ptr == digits.data() + digits.size() &&
               code != 0 && code <= 0x10FFFF;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t elements_ = 0;
    int depth_ = 0;
    std::optional<Fault> fault_;
};

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

std::optional<double> finite_number(std::string_view text) {
    text = trimmed(text);
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc() || result.ptr != text.data() + text.size() || !std::isfinite(value)) return {};
    return value;
}

std::optional<std::uint32_t> argb(std::string_view text) {
    text = trimmed(text);
    const auto parse = [&](std::string_view digits, int base) -> std::optional<std::uint32_t> {
        std::uint64_t value = 0;
        const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
        if (result.ec != std::errc() || result.ptr != digits.data() + digits.size()) return {};
        if (value > std::numeric_limits<std::uint32_t>::max()) return {};
        return static_cast<std::uint32_t>(value);
    };
    if (text.starts_with('#')) return parse(text.substr(1), 16);
    if (text.size() <= 8) return parse(text, 16);
    return parse(text, 10);  // more digits than ARGB has: 4291344794
}

}  // namespace

void parse_home_xml(pugi::xml_document& document, std::string_view text, const std::string& file_name) {
    const std::optional<Fault> fault = Scanner(text).run();
    if (fault && fault->code == std::string_view("P156")) refuse(text, *fault, file_name);
    const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size());
    // The earlier fault is the cause of the later one.
    const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0));
    if (fault && (result || fault->at <= offset)) refuse(text, *fault, file_name);
    if (!result) {
        std::string reason = result.description();
        if (!reason.empty() && reason.front() >= 'A' && reason.front() <= 'Z') reason.front() += 'a' - 'A';
        refuse(text, {"P154", offset, "is not well-formed XML: " + reason + "."}, file_name);
    }
    const std::string root = to_utf8(document.document_element().name());
    if (root != "home")
        throw InputError(
            "P155", file_name,
            "Home.xml in this file begins with <" + root + ">, not with <home>; it is no Sweet Home 3D home.");
}

std::string HomeElement::text(const char* key) const { return to_utf8(node_.attribute(key).value()); }

bool HomeElement::flag(const char* key, bool fallback) const {
    const pugi::xml_attribute attribute = node_.attribute(key);
    if (!attribute) return fallback;
    const std::string_view value = trimmed(attribute.value());
    if (value == "true" || value == "1") return true;
    if (value == "false" || value == "0") return false;
    report_unusable(key, fallback ? "true" : "false");
    return fallback;
}

std::optional<double> HomeElement::number(const char* key, const NumberRange& range) const {
    const std::optional<double> value = finite_number(node_.attribute(key).value());
    return value && range.holds(*value) ? value : std::nullopt;
}

double HomeElement::number(const char* key, const NumberRange& range, double fallback) const {
    if (!has(key)) return fallback;
    const std::optional<double> value = number(key, range);
    if (!value) report_unusable(key, rounded_text(fallback, 4));
    return value.value_or(fallback);
}

std::optional<double> HomeElement::metres(const char* key, const NumberRange& range) const {
    const std::optional<double> value = number(key, {});
    // Centimetres are written with a few digits: divided by 100 they are the nearest number to the length in metres.
    if (!value || !range.holds(*value / 100)) return {};
    return *value / 100;
}

double HomeElement::metres(const char* key, const NumberRange& range, double fallback) const {
    if (!has(key)) return fallback;
    const std::optional<double> value = metres(key, range);
    if (!value) report_unusable(key, rounded_text(fallback * 100, 2) + " cm");
    return value.value_or(fallback);
}

std::optional<SurfaceTexture> HomeElement::texture(const char* attribute) const {
    constexpr NumberRange sizes = {1e-3, 1e3};
    for (const pugi::xml_node node : node_.children("texture")) {
        const HomeElement element = child(node);
        if (element.text("attribute") != attribute) continue;
        SurfaceTexture texture;
        texture.picture = element.text("image");
        const auto width = element.metres("width", sizes), height = element.metres("height", sizes);
        if (texture.picture.empty() || !width || !height) return std::nullopt;  // a colour is what is left
        const double scale = element.number("scale", {1e-3, 1e3}, 1);
        texture.width = std::clamp(*width * scale, sizes.min, sizes.max);
        texture.height = std::clamp(*height * scale, sizes.min, sizes.max);
        // Sweet Home 3D turns the axes, not the picture.
        texture.angle = -std::remainder(element.number("angle", {-1e6, 1e6}, 0), 2 * std::numbers::pi);
        texture.offset_x = element.number("xOffset", {-1e6, 1e6}, 0);
        texture.offset_y = element.number("yOffset", {-1e6, 1e6}, 0);
        return texture;
    }
    return std::nullopt;
}

std::optional<Colour> HomeElement::colour(const char* key) const {
    if (!has(key)) return {};
    const std::optional<std::uint32_t> value = argb(node_.attribute(key).value());
    if (!value) {
        report_unusable(key, "no colour");
        return {};
    }
    return colour_from_rgb(*value);
}

std::string HomeElement::label() const {
    std::string label = std::string(node_.name()) == "doorOrWindow" ? "door or window" : to_utf8(node_.name());
    const std::string name = text("name");
    const std::string id = text("id");
    if (!name.empty()) label += " \"" + name + "\"";
    else if (!id.empty()) label += " \"" + id + "\"";
    return label;
}

void HomeElement::report_unusable(const char* key, const std::string& instead) const {
    Finding finding;
    finding.code = "P160";
    finding.sentence = "The " + label() + " has the unusable value \"" + text(key) + "\" for " + key + "; " + instead +
                       " is taken instead.";
    finding.hint = "Set the value in Sweet Home 3D and save the home again.";
    finding.elements.push_back({node_.name(), text("id"), text("name")});
    findings_->push_back(std::move(finding));
}

}  // namespace enfilade::plans
