#pragma once
// A binary glTF 2.0 file while it grows: its JSON and its one buffer.

#include <array>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

namespace enfilade::modeler {

class GltfFile {
public:
    using Json = nlohmann::ordered_json;
    using Point3 = std::array<float, 3>;

    GltfFile();

    Json& operator[](const char* list) { return json_[list]; }
    /// Adds `element` to a list of the file; returns its index there.
    std::size_t add(const char* list, Json element);
    /// Names an extension as used (not as required: readers without it see the rest).
    void use_extension(std::string_view name);

    /// Accessors of glTF: vectors of three floats (with bounds where they are positions), and triangle indices.
    std::size_t add_positions(std::span<const Point3> points);
    std::size_t add_normals(std::span<const Point3> normals);
    std::size_t add_indices(std::span<const std::uint32_t> indices);

    /// The whole file: header and two chunks, each filled up to a multiple of four bytes. Bytes of names that are not
    /// UTF-8 become U+FFFD. Throws InputError where it would be larger than 4 GiB.
    [[nodiscard]] std::string bytes();

private:
    std::size_t accessor(std::span<const std::byte> bytes, int target, int component, const char* type,
                         std::size_t count);

    Json json_;
    std::string binary_;
};

}  // namespace enfilade::modeler
