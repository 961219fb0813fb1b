#include "tools/report/code_meanings.h"

#include <map>
#include <vector>

#include "tools/report/embedded.h"

namespace enfilade::tools {
namespace {

/// The cells of a row of a table in Markdown, without the spaces around them.
std::vector<std::string_view> cells(std::string_view row) {
    std::vector<std::string_view> all;
    for (std::size_t at = 1; at < row.size();) {
        std::size_t end = row.find('|', at);
        if (end == std::string_view::npos) break;
        std::string_view cell = row.substr(at, end - at);
        while (!cell.empty() && cell.front() == ' ') cell.remove_prefix(1);
        while (!cell.empty() && cell.back() == ' ') cell.remove_suffix(1);
        all.push_back(cell);
        at = end + 1;
    }
    return all;
}

bool is_code(std::string_view text) {
    if (text.size() < 2 || text[0] < 'A' || text[0] > 'Z') return false;
    for (const char c : text.substr(1))
        if (c < '0' || c > '9') return false;
    return true;
}

/// Without the marks of code, and with links reduced to their text.
std::string plain(std::string_view text) {
    std::string out;
    for (std::size_t k = 0; k < text.size(); ++k) {
        if (text[k] == '`' || text[k] == '*') continue;
        if (text[k] == '[') continue;
        if (text[k] == ']') {
            const std::size_t close =
                k + 1 < text.size() && text[k + 1] == '(' ? text.find(')', k) : std::string_view::npos;
            if (close != std::string_view::npos) k = close;
            continue;
        }
        out += text[k];
    }
    if (!out.empty() && out[0] >= 'a' && out[0] <= 'z') out[0] = char(out[0] - 'a' + 'A');
    return out;
}

/// Rows `| code | ... | meaning | ... |` of one document: the meaning stands under `column`.
void read_tables(std::string_view text, std::map<std::string, std::string, std::less<>>& meanings) {
    std::size_t column = 1;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        const std::string_view line = text.substr(0, end);
        text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
        if (line.empty() || line[0] != '|') continue;
        const std::vector<std::string_view> row = cells(line);
        for (std::size_t k = 0; k < row.size(); ++k)
            if (row[k] == "meaning" || row[k] == "says that" || row[k] == "constraint") column = k;
        if (row.size() > column && is_code(row[0])) meanings.emplace(row[0], plain(row[column]));
    }
}

}  // namespace

std::string meaning_of(std::string_view code) {
    static const auto meanings = [] {
        std::map<std::string, std::string, std::less<>> all;
        read_tables(embedded::checks_page, all);
        read_tables(embedded::findings_page, all);
        return all;
    }();
    const auto found = meanings.find(code);
    return found == meanings.end() ? "" : found->second;
}

}  // namespace enfilade::tools
