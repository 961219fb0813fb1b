// Any bytes as the properties or the materials of a library, or as the library itself: texts come out as UTF-8, colours
// as numbers in [0, 1], and every entry of an archive is read or refused. The first byte says which.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "base/error.h"
#include "modeler/catalogue/file_tree.h"
#include "modeler/catalogue/mtl.h"
#include "modeler/catalogue/properties.h"
#include "plans/utf8.h"

namespace {

using namespace enfilade;

void require(bool holds) {
    if (!holds) std::abort();
}

void read_text(std::string_view bytes) {
    for (const auto& [key, value] : modeler::read_properties(bytes))
        require(plans::to_utf8(key) == key && plans::to_utf8(value) == value);
}

void read_materials(std::string_view bytes) {
    for (const auto& [name, material] : modeler::read_mtl(bytes)) {
        require(material.opacity >= 0 && material.opacity <= 1);
        if (material.diffuse)
            for (const double c : *material.diffuse) require(c >= 0 && c <= 1);
        (void)modeler::colour_of_name(name);
        require(!modeler::name_beside("a/b.obj", material.image).starts_with('/'));
    }
}

void walk(std::string_view bytes) {
    const auto archive = modeler::open_archive(std::string(bytes), "fuzz.sh3f");
    for (const std::string& name : archive->names()) {
        try {
            require(archive->read(name).has_value());
        } catch (const InputError&) {
        }
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string_view bytes(reinterpret_cast<const char*>(data + 1), size - 1);
    try {
        if (data[0] % 3 == 0) read_text(bytes);
        else if (data[0] % 3 == 1) read_materials(bytes);
        else walk(bytes);
    } catch (const InputError&) {
    }
    return 0;
}
