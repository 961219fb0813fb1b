#include <algorithm>
#include <bit>
#include <cctype>

#include "base/error.h"
#include "modeler/meshes/mesh_readers.h"
#include "modeler/meshes/mesh_text.h"
#include "modeler/meshes/point_index.h"

namespace enfilade::modeler {
namespace {

constexpr std::size_t header_bytes = 84;
constexpr std::size_t triangle_bytes = 50;

std::uint32_t little_u32(const char* at) {
    std::uint32_t value = 0;
    for (unsigned k = 0; k < 4; ++k) value |= static_cast<std::uint32_t>(static_cast<unsigned char>(at[k])) << (8 * k);
    return value;
}

class StlReader {
public:
    StlReader(std::string_view bytes, const std::string& file, bool tolerant) : text_(bytes, file) {
        text_.set_tolerant(tolerant);
    }

    Mesh read_binary() {
        const std::string_view bytes = text_.bytes();
        if (bytes.size() < header_bytes)
            throw InputError("P805", text_.file(), "The file ends within its header of 84 bytes: is it complete?");
        const std::uint64_t count = little_u32(bytes.data() + 80);
        if (count > (bytes.size() - header_bytes) / triangle_bytes)
            throw InputError("P805", text_.file(),
                             "The header promises " + std::to_string(count) + " triangles, but the file holds " +
                                 std::to_string((bytes.size() - header_bytes) / triangle_bytes) + ": is it complete?");
        if (3 * count > max_corners) text_.fail("P800", "The faces of this mesh have more than 2^30 corners.");
        mesh_.ring.reserve(3 * count);
        mesh_.ring_first.reserve(count + 1);
        for (std::uint64_t t = 0; t < count; ++t) {
            const char* corner = bytes.data() + header_bytes + t * triangle_bytes + 12;
            for (int k = 0; k < 3; ++k, corner += 12) {
                MeshPoint point;
                for (std::size_t i = 0; i < 3; ++i) point[i] = std::bit_cast<float>(little_u32(corner + 4 * i));
                if (!std::all_of(point.begin(), point.end(), is_coordinate) && !text_.is_tolerant())
                    throw InputError("P803", text_.file(),
                                     "Triangle " + std::to_string(t) + " (byte " +
                                         std::to_string(corner - bytes.data()) +
                                         ") has a coordinate that is not a finite number below 1e12; export the mesh "
                                         "again.");
                add_corner(point);
            }
            mesh_.end_face();
        }
        if (const std::size_t rest = bytes.size() - header_bytes - count * triangle_bytes; rest != 0) {
            Finding finding{.code = "P815", .severity = Severity::Warning};
            finding.sentence = "The file holds " + std::to_string(rest) + " bytes more than its " +
                               std::to_string(count) + " triangles.";
            finding.hint = "Triangles may be missing: export the mesh again.";
            mesh_.findings.push_back(std::move(finding));
        }
        return finished();
    }

    Mesh read_text() {
        bool is_open = true;
        while (text_.next()) {
            const std::string key = keyword();
            is_open = key != "endsolid";
            if (key == "solid") {
                mesh_.groups.push_back({static_cast<std::uint32_t>(mesh_.face_count()), text_.rest_of_line()});
                text_.skip_line();
            } else if (key == "facet") {
                read_facet();
            } else if (key == "endsolid") {
                text_.skip_line();
            } else {
                unexpected("\"facet\" or \"endsolid\" is expected here.");
            }
        }
        if (is_open) {
            Finding finding{.code = "P815", .severity = Severity::Warning};
            finding.sentence = "The file ends without \"endsolid\".";
            finding.hint = "Triangles may be missing: export the mesh again.";
            mesh_.findings.push_back(std::move(finding));
        }
        return finished();
    }

private:
    std::string keyword() {
        std::string word(text_.word());
        std::transform(word.begin(), word.end(), word.begin(),
                       [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        return word;
    }

    /// A word that does not belong; the last one of the file may be half of one that does.
    [[noreturn]] void unexpected(const std::string& sentence) {
        if (text_.ended()) text_.fail("P805", "The file ends within a solid: is it complete?");
        text_.fail("P802", sentence);
    }

    void expect(const char* wanted) {
        if (!text_.next()) text_.fail_at(text_.position(), "P805", "The file ends within a facet: is it complete?");
        if (keyword() != wanted) unexpected("\"" + std::string(wanted) + "\" is expected here.");
    }

    void read_facet() {
        expect("normal");
        for (int k = 0; k < 3; ++k) {  // many programs write "nan" here; nobody needs it
            if (!text_.next()) text_.fail_at(text_.position(), "P805", "The file ends within a facet: is it complete?");
            (void)text_.word();
        }
        expect("outer");
        expect("loop");
        for (;;) {
            if (!text_.next()) text_.fail_at(text_.position(), "P805", "The file ends within a facet: is it complete?");
            const std::string key = keyword();
            if (key == "endloop") break;
            if (key != "vertex") unexpected("\"vertex\" or \"endloop\" is expected here.");
            MeshPoint point;
            for (double& x : point) {
                text_.next_in_line();
                x = text_.coordinate();
            }
            add_corner(point);
        }
        expect("endfacet");
        mesh_.end_face();
        if (mesh_.ring.size() > max_corners) text_.fail("P800", "The faces of this mesh have more than 2^30 corners.");
    }

    void add_corner(const MeshPoint& point) {
        if (!std::all_of(point.begin(), point.end(), is_coordinate)) {  // in tolerant reading alone; equal to no other
            mesh_.ring.push_back(absent_vertex);
            return;
        }
        const std::uint32_t vertex = index_.find_or_add(point, mesh_.points);
        if (vertex == mesh_.points.size()) mesh_.points.push_back(point);
        mesh_.ring.push_back(vertex);
    }

    Mesh finished() {
        Finding finding{.code = "P810", .severity = Severity::Note};
        finding.sentence = "STL has no vertex numbers: " + std::to_string(mesh_.ring.size()) +
                           " corners with equal coordinates were welded to " + std::to_string(mesh_.points.size()) +
                           " vertices, numbered from 0 as they come.";
        finding.hint = "Points that differ in the last digit stay apart: --weld X welds those nearer than X.";
        mesh_.findings.push_back(std::move(finding));
        return std::move(mesh_);
    }

    MeshText text_;
    Mesh mesh_{.format = MeshFormat::Stl};
    PointIndex index_;
};

}  // namespace

bool is_binary_stl(std::string_view bytes) {
    return bytes.size() >= header_bytes &&
           bytes.size() == header_bytes + triangle_bytes * std::uint64_t{little_u32(bytes.data() + 80)};
}

Mesh read_stl(std::string_view bytes, const std::string& file, bool tolerant) {
    StlReader reader(bytes, file, tolerant);
    // The header of a binary file may begin with "solid" as well: its size tells, else the zeros that fill it up.
    std::string_view head = bytes.substr(0, 1000);
    head.remove_prefix(std::min(head.find_first_not_of(" \t\r\n"), head.size()));
    const bool says_solid = head.starts_with("solid") || head.starts_with("SOLID") || head.starts_with("Solid");
    const bool is_text = !is_binary_stl(bytes) && says_solid && head.find('\0') == std::string_view::npos;
    return is_text ? reader.read_text() : reader.read_binary();
}

}  // namespace enfilade::modeler
