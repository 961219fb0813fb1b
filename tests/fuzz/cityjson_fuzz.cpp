// Any text is either refused or city models whose solids, shells and faces follow one another without a gap.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/error.h"
#include "modeler/meshes/mesh_readers.h"
#include "tests/fuzz/mesh_invariants.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        enfilade::modeler::require_consistent(
            enfilade::modeler::read_city_json({reinterpret_cast<const char*>(data), size}, "fuzz.city.json"));
    } catch (const enfilade::InputError&) {
    }
    return 0;
}
