#include "modeler/meshes/mesh_readers.h"
#include "modeler/meshes/mesh_text.h"

namespace enfilade::modeler {
namespace {

class OffReader {
public:
    OffReader(std::string_view bytes, const std::string& file, bool tolerant) : text_(bytes, file) {
        text_.set_comments(true);
        text_.set_tolerant(tolerant);
    }

    Mesh read() {
        if (text_.bytes().starts_with("\xEF\xBB\xBF")) text_.seek(3);
        if (!text_.next()) text_.fail("P805", "The file holds nothing.");
        read_header();
        const std::uint64_t vertices = read_count("vertices", 6), faces = read_count("faces", 2);
        while (text_.next_in_line()) (void)text_.word();  // the number of edges: rarely true, never needed
        mesh_.points.reserve(vertices);
        for (std::uint64_t v = 0; v < vertices; ++v) read_vertex(v, vertices);
        mesh_.ring_first.reserve(faces + 1);
        for (std::uint64_t f = 0; f < faces; ++f) read_face(f, faces);
        return std::move(mesh_);
    }

private:
    /// [ST][C][N][4][n]OFF, or the counts at once.
    void read_header() {
        const std::size_t start = text_.position();
        const std::string_view word = text_.word();
        if (!word.ends_with("OFF")) {
            text_.seek(start);
            return;
        }
        std::string_view flags = word.substr(0, word.size() - 3);
        for (const std::string_view flag : {"ST", "C", "N"})
            if (flags.starts_with(flag)) flags.remove_prefix(flag.size());
        if (!flags.empty())
            text_.fail("P806", in_quotes(word) + " files have points of another dimension than three: export as OFF.");
        const std::size_t after = text_.position();
        if (text_.next_in_line() && text_.word() == "BINARY")
            text_.fail("P806", "Binary OFF is not read: export the mesh as text, or as PLY.");
        text_.seek(after);
    }

    /// `bytes_each`: what one of them takes in the file at least, so that no promise is believed blindly.
    std::uint64_t read_count(const char* what, std::uint64_t bytes_each) {
        if (!text_.next())
            text_.fail_at(text_.position(), "P805", std::string("The number of ") + what + " is missing.");
        const std::int64_t count = text_.integer();
        if (count < 0) text_.fail("P802", std::string("The number of ") + what + " is negative.");
        if (static_cast<std::uint64_t>(count) > text_.remaining() / bytes_each + 1)
            text_.fail("P805", "The header promises " + std::to_string(count) + " " + what +
                                   ", more than the rest of the file can hold: is it complete?");
        return static_cast<std::uint64_t>(count);
    }

    void read_vertex(std::uint64_t v, std::uint64_t count) {
        if (!text_.next()) fail_end("vertex", v, count);
        std::array<double, 3> point;
        for (double& x : point) {
            text_.next_in_line();
            x = text_.coordinate();
        }
        mesh_.points.push_back(point);
        text_.skip_line();  // normal, colour, texture coordinate, comment
    }

    void read_face(std::uint64_t f, std::uint64_t count) {
        if (!text_.next()) fail_end("face", f, count);
        const std::int64_t corners = text_.integer();
        if (corners < 0) text_.fail("P802", "A face begins with its number of corners, which is not negative.");
        if (static_cast<std::uint64_t>(corners) > text_.remaining() / 2 + 1)
            text_.fail("P805", "This face promises " + std::to_string(corners) +
                                   " corners, more than the rest of the file can hold: is it complete?");
        for (std::int64_t k = 0; k < corners; ++k) {
            if (!text_.next()) fail_end("face", f, count);
            const std::int64_t vertex = text_.integer();
            const bool exists = vertex >= 0 && vertex < static_cast<std::int64_t>(mesh_.points.size());
            if (!exists && !text_.is_tolerant())
                text_.fail("P804", "Vertex " + std::to_string(vertex) + " does not exist: the file has " +
                                       std::to_string(mesh_.points.size()) + ", counted from 0.");
            mesh_.ring.push_back(exists ? static_cast<std::uint32_t>(vertex) : absent_vertex);
        }
        if (mesh_.ring.size() > max_corners) text_.fail("P800", "The faces of this mesh have more than 2^30 corners.");
        mesh_.end_face();
        text_.skip_line();  // colour, comment
    }

    [[noreturn]] void fail_end(const char* what, std::uint64_t at, std::uint64_t count) {
        text_.fail_at(text_.position(), "P805",
                      std::string("The file ends before ") + what + " " + std::to_string(at) + " of " +
                          std::to_string(count) + ": is it complete?");
    }

    MeshText text_;
    Mesh mesh_{.format = MeshFormat::Off};
};

}  // namespace

Mesh read_off(std::string_view bytes, const std::string& file, bool tolerant) {
    return OffReader(bytes, file, tolerant).read();
}

}  // namespace enfilade::modeler
