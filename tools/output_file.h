#pragma once
// Files that are there whole or not at all.

#include <filesystem>
#include <string_view>

namespace enfilade::tools {

/// A name beside `path` to write to; `commit` renames it to `path`, and what is not committed is removed.
/// The extension stays, as writers choose the format by it.
class OutputFile {
public:
    /// Throws IoError where the folder does not exist or `path` is one.
    explicit OutputFile(std::filesystem::path path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    [[nodiscard]] const std::filesystem::path& temporary() const { return temporary_; }
    void commit();

private:
    std::filesystem::path path_;
    std::filesystem::path temporary_;
};

/// Writes `text` to `path`, whole or not at all. Throws IoError.
void write_text(const std::filesystem::path& path, std::string_view text);

}  // namespace enfilade::tools
