#include <charconv>

#include "modeler/meshes/mesh_readers.h"
#include "modeler/meshes/mesh_text.h"

namespace enfilade::modeler {
namespace {

class ObjReader {
public:
    ObjReader(std::string_view bytes, const std::string& file, bool tolerant) : text_(bytes, file) {
        text_.set_tolerant(tolerant);
        text_.set_comments(true);
        text_.set_continuation(true);
    }

    Mesh read() {
        if (text_.bytes().starts_with("\xEF\xBB\xBF")) text_.seek(3);
        while (text_.next()) {
            const std::string_view key = text_.word();
            if (key == "v") read_vertex();
            else if (key == "vt" && text_.is_tolerant()) read_texcoord();
            else if (key == "f" || key == "fo") read_face();
            else if (key == "o" || key == "g") read_name(key == "o");
            else if (key == "usemtl") add_group(mesh_.materials, rest());
            else if (key == "mtllib") mesh_.material_files.push_back(rest());
            else if (key == "l" || key == "p" || key == "curv" || key == "surf") ++passed_over_;
            skip_logical_line();
        }
        finish();
        return std::move(mesh_);
    }

private:
    void read_vertex() {
        std::array<double, 3> point;
        for (double& x : point) {
            text_.next_in_line();
            x = text_.coordinate();
        }
        mesh_.points.push_back(point);
    }

    void read_texcoord() {
        std::array<float, 2> at = {0, 0};
        for (float& x : at)
            if (text_.next_in_line()) x = static_cast<float>(text_.coordinate());
        mesh_.texcoords.push_back(at);
    }

    /// behind: of a corner `v/vt/vn`, what follows the first slash.
    void add_texcoord(std::string_view behind) {
        std::int64_t written = 0;
        std::from_chars(behind.data(), behind.data() + behind.size(), written);
        if (written == 0 && mesh_.ring_texcoord.empty()) return;
        const std::int64_t named =
            written > 0 ? written - 1 : static_cast<std::int64_t>(mesh_.texcoords.size()) + written;
        const bool can_exist = written != 0 && named >= 0 && named < absent_vertex;
        mesh_.ring_texcoord.resize(mesh_.ring.size() - 1, UINT32_MAX);
        mesh_.ring_texcoord.push_back(can_exist ? static_cast<std::uint32_t>(named) : UINT32_MAX);
    }

    void read_face() {
        while (text_.next_in_line()) {
            const std::size_t at = text_.position();
            std::string_view behind;
            const std::int64_t written = text_.integer_before('/', &behind);
            const auto count = static_cast<std::int64_t>(mesh_.points.size());
            if (written == 0 && !text_.is_tolerant())
                text_.fail("P804", "Vertices of an OBJ file are counted from 1; vertex 0 does not exist.");
            if (written < -count && !text_.is_tolerant())
                text_.fail("P804", "Vertex " + std::to_string(written) + " is counted back from here, but only " +
                                       std::to_string(count) + " vertices come before.");
            const std::int64_t named = written > 0 ? written - 1 : count + written;
            if (named >= std::int64_t{1} << 32 && !text_.is_tolerant()) fail_range(at, written);
            const bool can_exist = written != 0 && named >= 0 && named < std::int64_t{1} << 32;
            const std::int64_t vertex = can_exist ? named : absent_vertex;
            if (vertex > highest_) highest_ = vertex, highest_at_ = at;
            mesh_.ring.push_back(static_cast<std::uint32_t>(vertex));
            if (!mesh_.texcoords.empty()) add_texcoord(behind);
        }
        if (mesh_.ring.size() > max_corners) text_.fail("P800", "The faces of this mesh have more than 2^30 corners.");
        mesh_.end_face();
    }

    void read_name(bool is_object) {
        std::string name = rest();
        if (is_object) object_ = name;
        // A group inside an object is a part of it: the object's name is the one that people know.
        else if (!object_.empty()) name = object_ + (name.empty() ? "" : ", " + name);
        add_group(mesh_.groups, std::move(name));
    }

    std::string rest() { return text_.next_in_line() ? text_.rest_of_line() : std::string(); }

    /// What is named before the next face came goes: it has no faces.
    void add_group(std::vector<MeshGroup>& groups, std::string name) {
        const auto face = static_cast<std::uint32_t>(mesh_.face_count());
        if (!groups.empty() && groups.back().first_face == face) groups.pop_back();
        groups.push_back({face, std::move(name)});
    }

    void skip_logical_line() {
        while (text_.next_in_line()) (void)text_.word();
        text_.skip_line();
    }

    [[noreturn]] void fail_range(std::size_t at, std::int64_t written) {
        text_.fail_at(at, "P804",
                      "Vertex " + std::to_string(written) + " does not exist: the file has " +
                          std::to_string(mesh_.points.size()) + " vertices.");
    }

    void finish() {
        if (!mesh_.ring_texcoord.empty()) mesh_.ring_texcoord.resize(mesh_.ring.size(), UINT32_MAX);
        if (highest_ >= static_cast<std::int64_t>(mesh_.points.size()) && !text_.is_tolerant())
            fail_range(highest_at_, highest_ + 1);
        if (passed_over_ == 0) return;
        Finding finding{.code = "P812", .severity = Severity::Note};
        finding.sentence = std::to_string(passed_over_) + " lines, points or curves of the file are no faces.";
        finding.hint = "Only faces are checked.";
        mesh_.findings.push_back(std::move(finding));
    }

    MeshText text_;
    Mesh mesh_{.format = MeshFormat::Obj};
    std::string object_;
    std::uint64_t passed_over_ = 0;
    std::int64_t highest_ = -1;
    std::size_t highest_at_ = 0;
};

}  // namespace

Mesh read_obj(std::string_view bytes, const std::string& file, bool tolerant) {
    return ObjReader(bytes, file, tolerant).read();
}

}  // namespace enfilade::modeler
