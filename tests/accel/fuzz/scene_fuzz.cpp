// Any bytes are either refused or a scene on which queries end. The header's hash is mended first, else no mutation
// would come past it.
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "accel/locate.h"
#include "accel/scene_file.h"
#include "accel/sha256.h"
#include "accel/stats.h"
#include "base/error.h"

namespace {

void mend_header(std::vector<std::byte>& bytes) {
    enfilade::accel::FileHeader header;
    if (bytes.size() < sizeof header) return;
    std::memcpy(&header, bytes.data(), sizeof header);
    header.file_bytes = bytes.size();
    const std::size_t table = std::size_t{header.section_count} * sizeof(enfilade::accel::SectionEntry);
    if (header.section_count > 4096 || sizeof header + table > bytes.size()) return;
    header.header_sha256 = {};
    std::memcpy(bytes.data(), &header, sizeof header);
    header.header_sha256 = enfilade::accel::sha256(std::span(bytes).first(sizeof header + table));
    std::memcpy(bytes.data(), &header, sizeof header);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto* begin = reinterpret_cast<const std::byte*>(data);
    std::vector<std::byte> bytes(begin, begin + size);
    mend_header(bytes);
    const enfilade::accel::SerialExecutor serial;
    try {
        const enfilade::accel::Scene scene = enfilade::accel::read(bytes, {.executor = &serial});
        (void)enfilade::accel::stats(scene);
        (void)enfilade::accel::locate(scene.view(), {0, 0, 1});
    } catch (const enfilade::InputError&) {
    }
    return 0;
}
