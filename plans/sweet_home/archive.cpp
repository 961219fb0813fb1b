#include "plans/sweet_home/archive.h"

#include <zip.h>

#include <memory>

#include "base/error.h"

namespace enfilade::plans {
namespace {

/// A home of ten thousand rooms takes some 20 MB; what unpacks to more than this is no plan but a bomb.
constexpr std::size_t max_xml_bytes = std::size_t{64} << 20;

struct DiscardZip {
    void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct CloseEntry {
    void operator()(zip_file_t* entry) const { zip_fclose(entry); }
};
using Archive = std::unique_ptr<zip_t, DiscardZip>;
using Entry = std::unique_ptr<zip_file_t, CloseEntry>;

Archive open_archive(std::span<const std::byte> bytes, const std::string& file_name) {
    // libzip takes no bytes at all for an archive without entries.
    if (bytes.empty()) throw InputError("P150", file_name, "The file is empty; copy or save it again.");
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
    zip_t* archive = source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY, &error);
    const std::string reason = archive == nullptr ? zip_error_strerror(&error) : "";
    zip_error_fini(&error);
    if (archive != nullptr) return Archive(archive);
    if (source != nullptr) zip_source_free(source);
    throw InputError("P150", file_name,
                     "The file cannot be opened as the zip archive that a Sweet Home 3D home is (" + reason +
                         "); it may be cut off: copy or save it again.");
}

[[noreturn]] void refuse_without_xml(zip_t* archive, const std::string& file_name) {
    if (zip_name_locate(archive, "Home", 0) >= 0)
        throw InputError("P151", file_name,
                         "The home is stored only in Java's serialised form, as Sweet Home 3D did before version 5.3; "
                         "open it with Sweet Home 3D 5.3 or later and save it again, which adds the entry Home.xml "
                         "that is read here.");
    throw InputError("P152", file_name,
                     "The archive holds no Home.xml, so it is no Sweet Home 3D home; furniture libraries (.sh3f) and "
                     "texture libraries (.sh3t) are no plans.");
}

[[noreturn]] void refuse_size(const std::string& file_name) {
    throw InputError("P153", file_name,
                     "The entry Home.xml unpacks to more than 64 MiB, which no home needs; the archive is damaged or "
                     "made to exhaust memory.");
}

std::string read_entry(zip_t* archive, zip_uint64_t index, const std::string& file_name) {
    const auto fail = [&](const std::string& reason) {
        throw InputError("P153", file_name,
                         "The entry Home.xml cannot be unpacked (" + reason + "); save the home again.");
    };
    zip_stat_t stat;
    zip_stat_init(&stat);
    if (zip_stat_index(archive, index, 0, &stat) != 0) fail(zip_strerror(archive));
    if ((stat.valid & ZIP_STAT_SIZE) != 0 && stat.size > max_xml_bytes) refuse_size(file_name);
    if ((stat.valid & ZIP_STAT_ENCRYPTION_METHOD) != 0 && stat.encryption_method != ZIP_EM_NONE)
        fail("it is encrypted");
    const Entry entry(zip_fopen_index(archive, index, 0));
    if (!entry) fail(zip_strerror(archive));
    // The size in the archive's directory may lie: what comes out is counted.
    std::string xml;
    char block[1 << 15];
    for (;;) {
        const zip_int64_t count = zip_fread(entry.get(), block, sizeof block);
        if (count < 0) fail(zip_file_strerror(entry.get()));
        if (count <= 0) return xml;
        if (xml.size() + std::size_t(count) > max_xml_bytes) refuse_size(file_name);
        xml.append(block, std::size_t(count));
    }
}

}  // namespace

std::string home_xml(std::span<const std::byte> bytes, const std::string& file_name) {
    const Archive archive = open_archive(bytes, file_name);
    zip_int64_t index = zip_name_locate(archive.get(), "Home.xml", 0);
    if (index < 0) index = zip_name_locate(archive.get(), "Home.xml", ZIP_FL_NOCASE);
    if (index < 0) refuse_without_xml(archive.get(), file_name);
    return read_entry(archive.get(), zip_uint64_t(index), file_name);
}

}  // namespace enfilade::plans
