#include "modeler/meshes/ply_header.h"

#include <array>
#include <utility>

namespace enfilade::modeler {
namespace {

PlyType read_type(MeshText& text) {
    static constexpr std::array<std::pair<std::string_view, PlyType>, 16> names{{{"char", PlyType::Int8},
                                                                                 {"int8", PlyType::Int8},
                                                                                 {"uchar", PlyType::UInt8},
                                                                                 {"uint8", PlyType::UInt8},
                                                                                 {"short", PlyType::Int16},
                                                                                 {"int16", PlyType::Int16},
                                                                                 {"ushort", PlyType::UInt16},
                                                                                 {"uint16", PlyType::UInt16},
                                                                                 {"int", PlyType::Int32},
                                                                                 {"int32", PlyType::Int32},
                                                                                 {"uint", PlyType::UInt32},
                                                                                 {"uint32", PlyType::UInt32},
                                                                                 {"float", PlyType::Float32},
                                                                                 {"float32", PlyType::Float32},
                                                                                 {"double", PlyType::Float64},
                                                                                 {"float64", PlyType::Float64}}};
    text.next_in_line();
    const std::string_view word = text.word();
    for (const auto& [name, type] : names)
        if (name == word) return type;
    text.fail("P806", in_quotes(word) + " is no type of a PLY property.");
}

PlyEncoding read_encoding(MeshText& text) {
    text.next_in_line();
    const std::string_view word = text.word();
    if (word == "ascii") return PlyEncoding::Text;
    if (word == "binary_little_endian") return PlyEncoding::LittleEndian;
    if (word == "binary_big_endian") return PlyEncoding::BigEndian;
    text.fail("P806", in_quotes(word) + " is no format of PLY: ascii, binary_little_endian and binary_big_endian are.");
}

void read_property(MeshText& text, PlyHeader& header) {
    if (header.elements.empty()) text.fail("P806", "A property stands before the first element.");
    PlyProperty property;
    text.next_in_line();
    const std::size_t at = text.position();
    if (text.word() == "list") {
        property.count = read_type(text);
        if (!is_whole(*property.count)) text.fail("P806", "The length of a list is a whole number.");
    } else {
        text.seek(at);
    }
    property.type = read_type(text);
    property.name = text.rest_of_line();
    header.elements.back().properties.push_back(std::move(property));
    if (header.elements.back().properties.size() > 1000) text.fail("P806", "An element has more than 1000 properties.");
}

void read_element(MeshText& text, PlyHeader& header) {
    PlyElement element;
    text.next_in_line();
    element.name = std::string(text.word());
    text.next_in_line();
    const std::int64_t count = text.integer();
    if (count < 0) text.fail("P802", "The number of elements is negative.");
    element.count = static_cast<std::uint64_t>(count);
    header.elements.push_back(std::move(element));
    if (header.elements.size() > 1000) text.fail("P806", "The header has more than 1000 elements.");
}

/// The bytes that one of these takes at least.
std::size_t least_bytes(const PlyElement& element, PlyEncoding encoding) {
    std::size_t bytes = 0;
    for (const PlyProperty& property : element.properties)
        bytes += encoding == PlyEncoding::Text ? 2 : size_of(property.count.value_or(property.type));
    return bytes;
}

void check_promises(const MeshText& text, const PlyHeader& header) {
    std::uint64_t left = text.remaining() + 1;  // text may lack its last line end
    for (const PlyElement& element : header.elements) {
        const std::size_t bytes = least_bytes(element, header.encoding);
        if (bytes != 0 && element.count > left / bytes)
            text.fail("P805", "The header promises " + std::to_string(element.count) + " of " +
                                  in_quotes(element.name) +
                                  ", more than the rest of the file can hold: is it complete?");
        left -= bytes * element.count;
    }
}

}  // namespace

std::optional<std::size_t> PlyElement::find(std::string_view property) const {
    for (std::size_t k = 0; k < properties.size(); ++k)
        if (properties[k].name == property) return k;
    return std::nullopt;
}

std::size_t size_of(PlyType type) {
    switch (type) {
        case PlyType::Int8:
        case PlyType::UInt8: return 1;
        case PlyType::Int16:
        case PlyType::UInt16: return 2;
        case PlyType::Int32:
        case PlyType::UInt32:
        case PlyType::Float32: return 4;
        case PlyType::Float64: return 8;
    }
    return 1;
}

bool is_whole(PlyType type) { return type != PlyType::Float32 && type != PlyType::Float64; }

PlyHeader read_ply_header(MeshText& text) {
    PlyHeader header;
    bool has_format = false;
    text.skip_line();  // "ply"
    while (text.next()) {
        const std::string_view key = text.word();
        if (key == "format") {
            header.encoding = read_encoding(text);
            has_format = true;
        } else if (key == "element") {
            read_element(text, header);
        } else if (key == "property") {
            read_property(text, header);
        } else if (key == "end_header") {
            if (!has_format) text.fail("P806", "The header does not say its format.");
            text.skip_line();
            check_promises(text, header);
            return header;
        } else if (key != "comment" && key != "obj_info") {
            text.fail("P806", in_quotes(key) + " belongs to no PLY header.");
        }
        text.skip_line();
    }
    text.fail("P805", "The file ends before its header does (end_header).");
}

}  // namespace enfilade::modeler
