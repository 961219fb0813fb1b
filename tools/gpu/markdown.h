#pragma once
// Tables of a report.

#include <cstdint>
#include <string>
#include <vector>

namespace enfilade::tools::gpu {

/// A Markdown table. Bars in cells are escaped.
class MarkdownTable {
public:
    explicit MarkdownTable(std::vector<std::string> head) : head_(std::move(head)) {}
    /// \pre as many cells as the head has
    void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
    [[nodiscard]] bool is_empty() const { return rows_.empty(); }
    /// Ends with a line break; columns are as wide as their widest cell.
    [[nodiscard]] std::string text() const;

private:
    std::vector<std::string> head_;
    std::vector<std::vector<std::string>> rows_;
};

/// 1234567 as "1,234,567".
[[nodiscard]] std::string grouped(std::uint64_t number);
/// With so many digits behind the point.
[[nodiscard]] std::string fixed(double number, int digits);
/// Three digits that count: 0.0123, 4.56, 78.9, 1,230.
[[nodiscard]] std::string three_digits(double number);
/// "1.23 MB", decimal.
[[nodiscard]] std::string bytes_text(std::size_t bytes);
/// part / whole as "99.9993 %", rounded downward so that 100 % is said of all alone.
[[nodiscard]] std::string share_text(std::uint64_t part, std::uint64_t whole);

}  // namespace enfilade::tools::gpu
