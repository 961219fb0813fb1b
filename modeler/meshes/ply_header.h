#pragma once
// What a PLY file says that it holds.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "modeler/meshes/mesh_text.h"

namespace enfilade::modeler {

enum class PlyType : std::uint8_t { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };
enum class PlyEncoding : std::uint8_t { Text, LittleEndian, BigEndian };

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::Float32;
    std::optional<PlyType> count;  ///< of a list: the type of its length
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;

    /// Position of a property, or nothing.
    [[nodiscard]] std::optional<std::size_t> find(std::string_view property) const;
};

struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::Text;
    std::vector<PlyElement> elements;
};

[[nodiscard]] std::size_t size_of(PlyType type);
[[nodiscard]] bool is_whole(PlyType type);

/// Reads up to the line behind `end_header`. Throws P806 for what this format does not have, P805 where it promises
/// more than the file holds.
[[nodiscard]] PlyHeader read_ply_header(MeshText& text);

}  // namespace enfilade::modeler
