#include "tools/gpu/markdown.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace enfilade::tools::gpu {

namespace {

std::string escaped(const std::string& cell) {
    std::string text;
    for (const char c : cell) {
        if (c == '|') text += '\\';
        text += c == '\n' ? ' ' : c;
    }
    return text;
}

std::string line(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths) {
    std::string text;
    for (std::size_t i = 0; i < cells.size(); ++i)
        text += (i == 0 ? "| " : " | ") + cells[i] + std::string(widths[i] - cells[i].size(), ' ');
    return text + " |\n";
}

}  // namespace

std::string MarkdownTable::text() const {
    std::vector<std::vector<std::string>> all = {head_};
    all.insert(all.end(), rows_.begin(), rows_.end());
    std::vector<std::size_t> widths(head_.size(), 3);
    for (auto& row : all) {
        row.resize(head_.size());
        for (std::size_t i = 0; i < row.size(); ++i) {
            row[i] = escaped(row[i]);
            widths[i] = std::max(widths[i], row[i].size());
        }
    }
    std::string text = line(all[0], widths);
    for (const std::size_t width : widths) text += "|" + std::string(width + 2, '-');
    text += "|\n";
    for (std::size_t i = 1; i < all.size(); ++i) text += line(all[i], widths);
    return text;
}

std::string grouped(std::uint64_t number) {
    std::string text = std::to_string(number);
    for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, ",");
    return text;
}

std::string fixed(double number, int digits) {
    std::array<char, 64> text;
    std::snprintf(text.data(), text.size(), "%.*f", digits, number);
    return text.data();
}

std::string three_digits(double number) {
    if (!std::isfinite(number)) return "-";
    if (number >= 999.5) {
        const double step = std::pow(10.0, std::floor(std::log10(number)) - 2);
        return grouped(static_cast<std::uint64_t>(std::llround(number / step) * std::llround(step)));
    }
    const int digits = number == 0 ? 0 : 2 - static_cast<int>(std::floor(std::log10(number)));
    return fixed(number, std::max(0, digits));
}

std::string bytes_text(std::size_t bytes) {
    const double value = static_cast<double>(bytes);
    return bytes >= 1'000'000 ? three_digits(value / 1e6) + " MB" : three_digits(value / 1e3) + " kB";
}

std::string share_text(std::uint64_t part, std::uint64_t whole) {
    if (part == whole) return "100 %";
    return fixed(std::floor(1e6 * static_cast<double>(part) / static_cast<double>(whole)) / 1e4, 4) + " %";
}

}  // namespace enfilade::tools::gpu
