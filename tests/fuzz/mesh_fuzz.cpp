// Any bytes are either refused or a mesh whose numbers lead nowhere else, welded or not. The first byte says how the
// file is called and how it is welded.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/error.h"
#include "tests/fuzz/mesh_invariants.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    static constexpr const char* names[] = {"fuzz.obj", "fuzz.off", "fuzz.ply", "fuzz.stl"};
    static constexpr double welds[] = {-1, 0, 0.01, 10};
    const std::string_view bytes(reinterpret_cast<const char*>(data + 1), size - 1);
    if (!bytes.empty() && bytes.front() == '{') return 0;  // cityjson_fuzz
    try {
        const double weld = welds[data[0] / 4 % 4];
        enfilade::modeler::require_consistent(enfilade::modeler::read_mesh(bytes, names[data[0] % 4], {.weld = weld}));
    } catch (const enfilade::InputError&) {
    }
    return 0;
}
