#include <algorithm>

#include "modeler/catalogue/file_tree.h"
#include "modeler/catalogue/name_index.h"

namespace enfilade::modeler {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    const char l = lower(c);
    return l >= 'a' && l <= 'f' ? l - 'a' + 10 : -1;
}

std::string without_url_escapes(std::string_view name) {
    std::string out;
    for (std::size_t at = 0; at < name.size(); ++at) {
        const int high = name[at] == '%' && at + 2 < name.size() ? hex_digit(name[at + 1]) : -1;
        const int low = high >= 0 ? hex_digit(name[at + 2]) : -1;
        if (low < 0) {
            out.push_back(name[at]);
        } else {
            out.push_back(static_cast<char>(high * 16 + low));
            at += 2;
        }
    }
    return out;
}

/// Both in an archive and in what refers to it, "/a" is "a".
std::string_view without_root(std::string_view name) {
    name.remove_prefix(std::min(name.find_first_not_of('/'), name.size()));
    return name;
}

}  // namespace

std::string in_lower_case(std::string_view text) {
    std::string out(text);
    std::transform(out.begin(), out.end(), out.begin(), lower);
    return out;
}

std::string name_beside(std::string_view from, std::string_view name) {
    const std::size_t slash = from.find_last_of("/\\");
    std::string whole(slash == std::string_view::npos ? std::string_view() : from.substr(0, slash + 1));
    whole.append(name);
    std::replace(whole.begin(), whole.end(), '\\', '/');
    std::vector<std::string_view> parts;
    const std::string_view view = whole;
    for (std::size_t at = 0; at <= view.size();) {
        const std::size_t end = std::min(view.find('/', at), view.size());
        const std::string_view part = view.substr(at, end - at);
        at = end + 1;
        if (part.empty() || part == ".") continue;
        if (part == ".." && !parts.empty() && parts.back() != "..") parts.pop_back();
        else parts.push_back(part);
    }
    std::string out;
    for (const std::string_view part : parts) (out.empty() ? out : out += '/').append(part);
    return out;
}

std::string extension_of_name(std::string_view name) {
    const std::size_t slash = name.find_last_of("/\\");
    const std::size_t dot = name.rfind('.');
    if (dot == std::string_view::npos || (slash != std::string_view::npos && dot < slash)) return {};
    return in_lower_case(name.substr(dot + 1));
}

std::string stem_of_name(std::string_view name) {
    const std::size_t slash = name.find_last_of("/\\");
    if (slash != std::string_view::npos) name.remove_prefix(slash + 1);
    const std::size_t dot = name.rfind('.');
    return std::string(dot == std::string_view::npos || dot == 0 ? name : name.substr(0, dot));
}

NameIndex::NameIndex(const std::vector<std::string>& names) {
    for (std::size_t k = 0; k < names.size(); ++k) {
        const std::string_view name = without_root(names[k]);
        exact_.emplace(name, k);
        lower_.emplace(in_lower_case(name), k);
    }
}

std::optional<std::size_t> NameIndex::find(std::string_view name) const {
    name = without_root(name);
    for (const std::string& candidate : {std::string(name), without_url_escapes(name)})
        if (const auto at = exact_.find(candidate); at != exact_.end()) return at->second;
    for (const std::string& candidate : {in_lower_case(name), in_lower_case(without_url_escapes(name))})
        if (const auto at = lower_.find(candidate); at != lower_.end()) return at->second;
    return std::nullopt;
}

}  // namespace enfilade::modeler
