#pragma once
// Named bytes: the entries of an archive, or the files of a folder. What a model and its materials are read from.

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace enfilade::modeler {

/// What one file or entry may have at most, unpacked: a model of five million triangles as text.
inline constexpr std::size_t max_model_bytes = std::size_t{1} << 29;

class FileTree {
public:
    virtual ~FileTree() = default;
    /// The bytes of that name ('/' between folders). Nothing where there is none. \throws InputError K103 where it is
    /// damaged, encrypted or larger than `max_model_bytes`
    [[nodiscard]] virtual std::optional<std::string> read(const std::string& name) const = 0;
    /// Why `read` finds nothing of that name, to end a sentence.
    [[nodiscard]] virtual std::string why_absent(const std::string& /*name*/) const { return "there is no such file."; }
    /// Ascending; folders not included.
    [[nodiscard]] virtual const std::vector<std::string>& names() const = 0;
    /// For messages.
    [[nodiscard]] virtual const std::string& title() const = 0;
};

/// A zip archive. Names that differ in case only, or are written as in URLs (%20), are found as well; nothing is ever
/// written to disk, so names like ../x are but names. \throws InputError K103 where the archive cannot be opened
[[nodiscard]] std::unique_ptr<FileTree> open_archive(const std::filesystem::path& file);

/// The same from bytes, which it keeps; `title` stands in messages.
[[nodiscard]] std::unique_ptr<FileTree> open_archive(std::string bytes, std::string title);

/// A folder and its folders. Links to folders are not followed; names that begin with a dot are passed over. Names that
/// lead out of it are not found. Ends after 100 000 files.
[[nodiscard]] std::unique_ptr<FileTree> open_folder(const std::filesystem::path& folder);

/// One file, and what lies beside it or below: `names` is the file's alone, the others are found when asked for.
[[nodiscard]] std::unique_ptr<FileTree> open_file(const std::filesystem::path& file);

/// `name` seen from the file `from`: "a/b.obj", "c.mtl" -> "a/c.mtl"; backslashes count as slashes, "." and ".." go.
[[nodiscard]] std::string name_beside(std::string_view from, std::string_view name);

/// In lower case (ASCII), without the dot: "obj". Empty where there is none.
[[nodiscard]] std::string extension_of_name(std::string_view name);

/// Behind the last slash, without extension.
[[nodiscard]] std::string stem_of_name(std::string_view name);

}  // namespace enfilade::modeler
