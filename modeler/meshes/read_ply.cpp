#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>

#include "base/error.h"
#include "modeler/meshes/mesh_readers.h"
#include "modeler/meshes/mesh_text.h"
#include "modeler/meshes/ply_header.h"

namespace enfilade::modeler {
namespace {

/// Values one after the other, whichever way they are written.
class PlyValues {
public:
    PlyValues(MeshText& text, PlyEncoding encoding) : text_(text), encoding_(encoding) {}

    /// Where a complaint about the value read last points to.
    [[noreturn]] void fail(const char* code, const std::string& sentence) const {
        if (encoding_ == PlyEncoding::Text) text_.fail(code, sentence);
        throw InputError(code, text_.file(), sentence + " (Byte " + std::to_string(last_) + " of the file.)");
    }

    double number(PlyType type) {
        if (encoding_ == PlyEncoding::Text) {
            need_token();
            return text_.coordinate();
        }
        switch (type) {
            case PlyType::Float32: return checked(binary<float>());
            case PlyType::Float64: return checked(binary<double>());
            default: return static_cast<double>(whole(type));
        }
    }

    std::int64_t whole(PlyType type) {
        if (encoding_ == PlyEncoding::Text) {
            need_token();
            return text_.integer();
        }
        switch (type) {
            case PlyType::Int8: return binary<std::int8_t>();
            case PlyType::UInt8: return binary<std::uint8_t>();
            case PlyType::Int16: return binary<std::int16_t>();
            case PlyType::UInt16: return binary<std::uint16_t>();
            case PlyType::Int32: return binary<std::int32_t>();
            case PlyType::UInt32: return binary<std::uint32_t>();
            case PlyType::Float32:
            case PlyType::Float64: break;
        }
        fail("P806", "Vertex numbers are whole numbers.");
    }

    /// The length of a list, which the file can hold.
    std::uint64_t length(const PlyProperty& property) {
        const std::int64_t count = whole(*property.count);
        const std::size_t each = encoding_ == PlyEncoding::Text ? 2 : size_of(property.type);
        if (count < 0 || static_cast<std::uint64_t>(count) > text_.remaining() / each + 1)
            fail("P805", "A list promises " + std::to_string(count) +
                             " items, which the rest of the file cannot hold: is it complete?");
        return static_cast<std::uint64_t>(count);
    }

    void skip(const PlyProperty& property) {
        const std::uint64_t count = property.count ? length(property) : 1;
        if (encoding_ == PlyEncoding::Text) {
            for (std::uint64_t k = 0; k < count; ++k) {
                need_token();
                (void)text_.word();
            }
        } else {
            need_bytes(count * size_of(property.type));
            text_.seek(text_.position() + count * size_of(property.type));
        }
    }

private:
    void need_token() {
        if (!text_.next())
            text_.fail_at(text_.position(), "P805", "The file ends before its last value: is it complete?");
    }
    void need_bytes(std::uint64_t bytes) {
        last_ = text_.position();
        if (text_.remaining() < bytes) fail("P805", "The file ends within a value: is it complete?");
    }
    double checked(double value) const {
        if (!is_coordinate(value) && text_.is_tolerant()) return std::numeric_limits<double>::quiet_NaN();
        if (!is_coordinate(value))
            fail("P803", "A coordinate is not a finite number below 1e12; export the mesh again.");
        return value;
    }
    template <class T>
    T binary() {
        need_bytes(sizeof(T));
        std::array<char, sizeof(T)> raw;
        std::memcpy(raw.data(), text_.bytes().data() + text_.position(), sizeof(T));
        if ((encoding_ == PlyEncoding::BigEndian) != (std::endian::native == std::endian::big))
            std::reverse(raw.begin(), raw.end());
        text_.seek(text_.position() + sizeof(T));
        return std::bit_cast<T>(raw);
    }

    MeshText& text_;
    PlyEncoding encoding_;
    std::size_t last_ = 0;
};

class PlyReader {
public:
    PlyReader(std::string_view bytes, const std::string& file, bool tolerant) : text_(bytes, file) {
        text_.set_tolerant(tolerant);
    }

    Mesh read() {
        const PlyHeader header = read_ply_header(text_);
        PlyValues values(text_, header.encoding);
        for (const PlyElement& element : header.elements)
            if (element.name == "vertex") vertices_ = element.count;
        bool has_vertices = false, has_faces = false;
        for (const PlyElement& element : header.elements) {
            const auto ring = ring_property(element);
            if (element.name == "vertex" && !has_vertices) {
                read_vertices(element, values);
                has_vertices = true;
            } else if (element.name == "face" && ring && !has_faces) {
                read_faces(element, *ring, values);
                has_faces = true;
            } else {
                skip_element(element, values);
            }
        }
        if (!has_vertices) text_.fail_at(0, "P806", "The file has no element named vertex.");
        if (!has_faces && header_has(header, "tristrips"))
            text_.fail_at(0, "P806", "Triangle strips are not read: export the mesh with faces.");
        return std::move(mesh_);
    }

private:
    static bool header_has(const PlyHeader& header, std::string_view name) {
        return std::any_of(header.elements.begin(), header.elements.end(),
                           [&](const PlyElement& element) { return element.name == name; });
    }

    [[nodiscard]] static std::optional<std::size_t> ring_property(const PlyElement& element) {
        for (const char* name : {"vertex_indices", "vertex_index"})
            if (const auto k = element.find(name); k && element.properties[*k].count) return k;
        return std::nullopt;
    }

    void read_vertices(const PlyElement& element, PlyValues& values) {
        std::vector<int> axis(element.properties.size(), -1);
        int found = 0;
        for (const char* name : {"x", "y", "z"}) {
            const auto k = element.find(name);
            if (!k || element.properties[*k].count)
                text_.fail_at(0, "P806", std::string("The vertices have no property ") + name + ".");
            axis[*k] = found++;
        }
        mesh_.points.reserve(element.count);
        for (std::uint64_t v = 0; v < element.count; ++v) {
            std::array<double, 3> point{};
            for (std::size_t k = 0; k < axis.size(); ++k) {
                if (axis[k] < 0) values.skip(element.properties[k]);
                else point[static_cast<std::size_t>(axis[k])] = values.number(element.properties[k].type);
            }
            mesh_.points.push_back(point);
        }
    }

    void read_faces(const PlyElement& element, std::size_t ring, PlyValues& values) {
        if (!is_whole(element.properties[ring].type)) values.fail("P806", "Vertex numbers are whole numbers.");
        mesh_.ring_first.reserve(element.count + 1);
        for (std::uint64_t f = 0; f < element.count; ++f) {
            for (std::size_t k = 0; k < element.properties.size(); ++k) {
                if (k == ring) read_ring(element.properties[k], f, values);
                else values.skip(element.properties[k]);
            }
            mesh_.end_face();
        }
    }

    void read_ring(const PlyProperty& property, std::uint64_t face, PlyValues& values) {
        const std::uint64_t corners = values.length(property);
        for (std::uint64_t c = 0; c < corners; ++c) {
            const std::int64_t vertex = values.whole(property.type);
            const bool exists = vertex >= 0 && static_cast<std::uint64_t>(vertex) < vertices_;
            if (!exists && !text_.is_tolerant())
                values.fail("P804", "Face " + std::to_string(face) + " names vertex " + std::to_string(vertex) +
                                        ", but the file has " + std::to_string(vertices_) + ", counted from 0.");
            mesh_.ring.push_back(exists ? static_cast<std::uint32_t>(vertex) : absent_vertex);
        }
        if (mesh_.ring.size() > max_corners) values.fail("P800", "The faces of this mesh have more than 2^30 corners.");
    }

    void skip_element(const PlyElement& element, PlyValues& values) {
        if (element.properties.empty() || element.count == 0) return;
        for (std::uint64_t k = 0; k < element.count; ++k)
            for (const PlyProperty& property : element.properties) values.skip(property);
        Finding finding{.code = "P812", .severity = Severity::Note};
        finding.sentence = "The file holds " + std::to_string(element.count) + " of " + in_quotes(element.name) +
                           ", which are no faces.";
        finding.hint = "Only faces are checked.";
        mesh_.findings.push_back(std::move(finding));
    }

    MeshText text_;
    Mesh mesh_{.format = MeshFormat::Ply};
    std::uint64_t vertices_ = 0;
};

}  // namespace

Mesh read_ply(std::string_view bytes, const std::string& file, bool tolerant) {
    return PlyReader(bytes, file, tolerant).read();
}

}  // namespace enfilade::modeler
