#pragma once
// Files that are there whole or not at all.

#include <filesystem>
#include <string_view>

namespace enfilade::tools {

/// Where a file of that name is to be written: links followed. Throws IoError where its folder does not exist, or where
/// it names something that is no file (a folder, a device: renaming a file over /dev/null would end it for everybody).
[[nodiscard]] std::filesystem::path output_path(const std::filesystem::path& path);

/// A name beside `path` to write to; `commit` renames it to `path`, and what is not committed is removed.
/// The extension stays, as writers choose the format by it.
class OutputFile {
public:
    /// Throws IoError as `output_path`.
    explicit OutputFile(const std::filesystem::path& path);
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
