// Any text is either refused with a place or a plan that our own format holds: written and read again it is the same.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "base/error.h"
#include "plans/read.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    std::string once;
    try {
        once = enfilade::plans::write_json(enfilade::plans::read_json(text, "fuzz"));
    } catch (const enfilade::InputError& error) {
        if (error.line <= 0) std::abort();
        return 0;
    }
    if (enfilade::plans::write_json(enfilade::plans::read_json(once, "again")) != once) std::abort();
    return 0;
}
