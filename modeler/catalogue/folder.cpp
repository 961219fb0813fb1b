#include <algorithm>
#include <fstream>
#include <system_error>

#include "base/error.h"
#include "modeler/catalogue/file_tree.h"
#include "modeler/catalogue/name_index.h"

namespace enfilade::modeler {
namespace {

constexpr std::size_t max_files = 100'000;

std::optional<std::string> bytes_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return std::nullopt;
    std::string bytes;
    char block[1 << 16];
    while (stream.read(block, sizeof block) || stream.gcount() > 0) {
        bytes.append(block, static_cast<std::size_t>(stream.gcount()));
        if (bytes.size() > max_model_bytes)
            throw InputError("K103", file.string(),
                             "The file is larger than 512 MiB, which no mesh of furniture needs.");
    }
    return bytes;
}

class Folder final : public FileTree {
public:
    explicit Folder(const std::filesystem::path& folder) : folder_(folder), title_(folder.string()) {
        std::error_code error;
        auto at = std::filesystem::recursive_directory_iterator(
            folder, std::filesystem::directory_options::skip_permission_denied, error);
        if (error) throw InputError("K101", title_, "The folder cannot be read: " + error.message() + ".");
        const std::filesystem::recursive_directory_iterator end;
        while (at != end && names_.size() < max_files) {
            if (at->path().filename().string().starts_with('.')) {
                at.disable_recursion_pending();
            } else if (at->is_regular_file(error) && !error) {
                names_.push_back(at->path().lexically_relative(folder).generic_string());
            }
            at.increment(error);
            if (error) break;  // what could be listed so far is what there is
        }
        std::sort(names_.begin(), names_.end());
        index_ = NameIndex(names_);
    }

    [[nodiscard]] std::optional<std::string> read(const std::string& name) const override {
        const auto found = index_.find(name);
        if (!found) return std::nullopt;
        return bytes_of(folder_ / names_[*found]);
    }
    [[nodiscard]] const std::vector<std::string>& names() const override { return names_; }
    [[nodiscard]] const std::string& title() const override { return title_; }

private:
    std::filesystem::path folder_;
    std::string title_;
    std::vector<std::string> names_;
    NameIndex index_;
};

class SingleFile final : public FileTree {
public:
    explicit SingleFile(const std::filesystem::path& file)
        : folder_(file.parent_path()), title_(file.string()), names_{file.filename().string()} {}

    [[nodiscard]] std::optional<std::string> read(const std::string& name) const override {
        const std::filesystem::path relative = std::filesystem::path(name).lexically_normal();
        const bool leads_out = relative.is_absolute() || relative.empty() || *relative.begin() == "..";
        std::error_code error;
        if (leads_out || !std::filesystem::is_regular_file(folder_ / relative, error)) return std::nullopt;
        return bytes_of(folder_ / relative);
    }
    [[nodiscard]] std::string why_absent(const std::string& name) const override {
        std::error_code error;
        const std::filesystem::file_status status = std::filesystem::status(folder_ / name, error);
        if (std::filesystem::is_directory(status)) return "it is a folder; name a file in it.";
        if (std::filesystem::is_regular_file(status)) return "it cannot be opened; check that it may be read.";
        if (std::filesystem::exists(status)) return "it is no regular file; copy what it holds into one.";
        return FileTree::why_absent(name);
    }
    [[nodiscard]] const std::vector<std::string>& names() const override { return names_; }
    [[nodiscard]] const std::string& title() const override { return title_; }

private:
    std::filesystem::path folder_;
    std::string title_;
    std::vector<std::string> names_;
};

}  // namespace

std::unique_ptr<FileTree> open_file(const std::filesystem::path& file) { return std::make_unique<SingleFile>(file); }

std::unique_ptr<FileTree> open_folder(const std::filesystem::path& folder) { return std::make_unique<Folder>(folder); }

}  // namespace enfilade::modeler
