// Any bytes are either refused or a home whose plan our own format can hold. What is no archive is taken for Home.xml
// itself, else hardly a mutation would come past the archive's checksums.
#include <zip.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>

#include "base/error.h"
#include "plans/read.h"

namespace {

std::string archived(const std::uint8_t* data, std::size_t size) {
    zip_source_t* target = zip_source_buffer_create(nullptr, 0, 0, nullptr);
    zip_source_keep(target);
    zip_t* zip = zip_open_from_source(target, ZIP_CREATE | ZIP_TRUNCATE, nullptr);
    zip_source_t* source = zip_source_buffer(zip, data, size, 0);
    const zip_int64_t index = zip_file_add(zip, "Home.xml", source, 0);
    if (index < 0 || zip_set_file_compression(zip, zip_uint64_t(index), ZIP_CM_STORE, 0) != 0 || zip_close(zip) != 0)
        std::abort();
    zip_stat_t stat;
    zip_stat_init(&stat);
    zip_source_open(target);
    zip_source_stat(target, &stat);
    std::string bytes(stat.size, '\0');
    zip_source_read(target, bytes.data(), bytes.size());
    zip_source_close(target);
    zip_source_free(target);
    return bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const bool archive = size >= 2 && data[0] == 'P' && data[1] == 'K';
    const std::string bytes = archive ? std::string(data, data + size) : archived(data, size);
    enfilade::plans::Plan plan;
    try {
        plan = enfilade::plans::read_sweet_home(std::as_bytes(std::span(bytes)), "fuzz.sh3d");
    } catch (const enfilade::InputError&) {
        return 0;
    }
    const std::string json = enfilade::plans::write_json(plan);
    if (enfilade::plans::write_json(enfilade::plans::read_json(json, "fuzz.json")) != json) std::abort();
    return 0;
}
