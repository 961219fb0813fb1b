// Any bytes are either refused or the header of a .npy file, written the way numpy reads it.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "base/error.h"
#include "tools/npy.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace enfilade;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    try {
        const tools::NpyHeader header = tools::parse_npy_header(bytes, "rays.npy");
        if (header.data_offset > size || header.data_offset < 10) std::abort();
        for (const std::uint64_t side : header.shape)
            if (side > INT64_MAX) std::abort();
    } catch (const InputError& error) {
        if (error.code != "F140") std::abort();
    }
    return 0;
}
