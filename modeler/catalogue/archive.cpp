#include <zip.h>

#include <algorithm>
#include <cstdint>

#include "base/error.h"
#include "modeler/catalogue/file_tree.h"
#include "modeler/catalogue/name_index.h"

namespace enfilade::modeler {
namespace {

/// Entries of an archive: the largest library known has some two thousand.
constexpr zip_int64_t max_entries = 1'000'000;

struct DiscardZip {
    void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct CloseEntry {
    void operator()(zip_file_t* entry) const { zip_fclose(entry); }
};
using Zip = std::unique_ptr<zip_t, DiscardZip>;
using Entry = std::unique_ptr<zip_file_t, CloseEntry>;

[[noreturn]] void refuse(const std::string& title, const std::string& reason) {
    throw InputError("K103", title, "The archive cannot be read (" + reason + "): copy or save it again.");
}

class Archive final : public FileTree {
public:
    /// `bytes` are kept while the archive is open: libzip reads from them.
    Archive(zip_source_t* (*make)(const Archive&, zip_error_t*), std::string bytes, std::string path, std::string title)
        : bytes_(std::move(bytes)), path_(std::move(path)), title_(std::move(title)) {
        zip_error_t error;
        zip_error_init(&error);
        zip_source_t* source = make(*this, &error);
        zip_t* opened = source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY, &error);
        const std::string reason = opened == nullptr ? zip_error_strerror(&error) : "";
        zip_error_fini(&error);
        if (opened == nullptr && source != nullptr) zip_source_free(source);
        if (opened == nullptr) refuse(title_, reason);
        zip_.reset(opened);
        list_names();
    }

    [[nodiscard]] std::optional<std::string> read(const std::string& name) const override {
        const auto found = index_.find(name);
        if (!found) return std::nullopt;
        return read_entry(entries_[*found], names_[*found]);
    }
    [[nodiscard]] const std::vector<std::string>& names() const override { return names_; }
    [[nodiscard]] const std::string& title() const override { return title_; }

    [[nodiscard]] const std::string& bytes() const { return bytes_; }
    [[nodiscard]] const std::string& path() const { return path_; }

private:
    void list_names() {
        const zip_int64_t count = zip_get_num_entries(zip_.get(), 0);
        if (count > max_entries) refuse(title_, "it has more than a million entries");
        std::vector<std::pair<std::string, zip_uint64_t>> found;
        for (zip_int64_t k = 0; k < count; ++k) {
            const char* name = zip_get_name(zip_.get(), static_cast<zip_uint64_t>(k), ZIP_FL_ENC_GUESS);
            if (name == nullptr || *name == '\0' || std::string_view(name).ends_with('/')) continue;
            found.emplace_back(name, static_cast<zip_uint64_t>(k));
        }
        std::sort(found.begin(), found.end());
        for (auto& [name, entry] : found) {
            names_.push_back(std::move(name));
            entries_.push_back(entry);
        }
        index_ = NameIndex(names_);
    }

    [[nodiscard]] std::string read_entry(zip_uint64_t at, const std::string& name) const {
        const auto fail = [&](const std::string& reason) { refuse(title_, "its entry " + name + ": " + reason); };
        zip_stat_t stat;
        zip_stat_init(&stat);
        if (zip_stat_index(zip_.get(), at, 0, &stat) != 0) fail(zip_strerror(zip_.get()));
        if ((stat.valid & ZIP_STAT_SIZE) != 0 && stat.size > max_model_bytes) fail("it unpacks to more than 512 MiB");
        if ((stat.valid & ZIP_STAT_ENCRYPTION_METHOD) != 0 && stat.encryption_method != ZIP_EM_NONE)
            fail("it is encrypted");
        const Entry entry(zip_fopen_index(zip_.get(), at, 0));
        if (!entry) fail(zip_strerror(zip_.get()));
        // The size in the archive's directory may lie: what comes out is counted.
        std::string bytes;
        char block[1 << 16];
        for (;;) {
            const zip_int64_t count = zip_fread(entry.get(), block, sizeof block);
            if (count < 0) fail(zip_file_strerror(entry.get()));
            if (count <= 0) return bytes;
            if (bytes.size() + static_cast<std::size_t>(count) > max_model_bytes)
                fail("it unpacks to more than 512 MiB");
            bytes.append(block, static_cast<std::size_t>(count));
        }
    }

    std::string bytes_;
    std::string path_;
    std::string title_;
    Zip zip_;
    std::vector<std::string> names_;
    std::vector<zip_uint64_t> entries_;
    NameIndex index_;
};

}  // namespace

std::unique_ptr<FileTree> open_archive(const std::filesystem::path& file) {
    const auto make = [](const Archive& archive, zip_error_t* error) {
        return zip_source_file_create(archive.path().c_str(), 0, -1, error);
    };
    return std::make_unique<Archive>(make, std::string(), file.string(), file.string());
}

std::unique_ptr<FileTree> open_archive(std::string bytes, std::string title) {
    // libzip takes no bytes at all for an archive without entries.
    if (bytes.empty()) refuse(title, "it is empty");
    const auto make = [](const Archive& archive, zip_error_t* error) {
        return zip_source_buffer_create(archive.bytes().data(), archive.bytes().size(), 0, error);
    };
    return std::make_unique<Archive>(make, std::move(bytes), std::string(), std::move(title));
}

}  // namespace enfilade::modeler
