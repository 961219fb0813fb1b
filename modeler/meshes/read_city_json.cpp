#include <algorithm>
#include <map>
#include <optional>

#include "base/error.h"
#include "modeler/meshes/json_cursor.h"
#include "modeler/meshes/mesh_readers.h"
#include "modeler/meshes/mesh_text.h"

namespace enfilade::modeler {
namespace {

constexpr std::size_t listed_geometries = 20;

struct Transform {
    std::array<double, 3> scale{1, 1, 1};
    std::array<double, 3> translate{0, 0, 0};
};

/// Where the parts of a document stand: their order in the text is free.
struct Document {
    std::string type;
    std::string version;
    std::optional<std::size_t> transform, vertices, objects, templates;
};

/// The same for a geometry.
struct GeometryText {
    std::string type;
    std::string lod;
    std::optional<std::size_t> boundaries, template_index, matrix;
};

/// The vertices that the numbers of a geometry mean.
struct VertexRange {
    std::size_t first = 0;
    std::size_t count = 0;
};

struct TemplateUse {
    std::uint64_t count = 0;
    std::string first_object;
};

class CityReader {
public:
    CityReader(std::string_view bytes, const std::string& file) : json_(bytes, file) {
        if (bytes.starts_with("\xEF\xBB\xBF")) json_.seek(3);
    }

    Mesh read() {
        const Document city = read_document();
        if (city.type == "CityJSONFeature")
            json_.fail("P809", "The first object of the file must be of type CityJSON: its transform is needed.");
        if (city.type != "CityJSON") json_.fail("P809", "The file is JSON, but not of type CityJSON.");
        if (!city.version.starts_with("1.") && !city.version.starts_with("2."))
            json_.fail("P806",
                       "CityJSON " + in_quotes(city.version) + " is not read: upgrade the file to 1.0-2.0 (cjio).");
        if (city.transform) read_transform(*city.transform);
        read_part(city);
        if (city.templates) read_templates(*city.templates);
        // One feature after the other, each with vertices of its own: a sequence.
        std::size_t after = 0;
        for (json_.seek(end_of_first_); json_.peek() != '\0'; json_.seek(after)) {
            const Document feature = read_document();
            after = json_.position();
            if (feature.type != "CityJSONFeature")
                json_.fail("P809", "Only objects of type CityJSONFeature may follow the first one.");
            read_part(feature);
        }
        finish();
        return std::move(mesh_);
    }

private:
    Document read_document() {
        Document found;
        json_.members("The document", [&](const std::string& key) {
            const std::size_t at = json_.position();
            if (key == "type") found.type = json_.string("The type of the document");
            else if (key == "version") found.version = json_.string("The version of CityJSON");
            else {
                if (key == "transform") found.transform = at;
                else if (key == "vertices") found.vertices = at;
                else if (key == "CityObjects") found.objects = at;
                else if (key == "geometry-templates") found.templates = at;
                json_.skip();
            }
        });
        if (end_of_first_ == 0) end_of_first_ = json_.position();
        return found;
    }

    void read_transform(std::size_t at) {
        json_.seek(at);
        json_.members("The transform", [&](const std::string& key) {
            if (key == "scale") transform_.scale = read_point("The scale of the transform");
            else if (key == "translate") transform_.translate = read_point("The translation of the transform");
            else json_.skip();
        });
    }

    std::array<double, 3> read_point(const char* what) {
        std::array<double, 3> point{};
        std::uint64_t count = 0;
        json_.items(what, [&](std::uint64_t k) {
            if (k >= 3) json_.fail("P809", std::string(what) + " has three numbers.");
            point[k] = json_.number(what);
            count = k + 1;
        });
        if (count != 3) json_.fail("P809", std::string(what) + " has three numbers.");
        return point;
    }

    VertexRange read_vertices(std::size_t at, const Transform& transform) {
        json_.seek(at);
        VertexRange range{mesh_.points.size(), 0};
        json_.items("The list of vertices", [&](std::uint64_t) {
            std::array<double, 3> point = read_point("A vertex");
            for (std::size_t i = 0; i < 3; ++i) {
                point[i] = point[i] * transform.scale[i] + transform.translate[i];
                if (!is_coordinate(point[i])) json_.fail("P803", "A vertex lies farther than 1e12 from the origin.");
            }
            mesh_.points.push_back(point);
        });
        range.count = mesh_.points.size() - range.first;
        return range;
    }

    void read_part(const Document& part) {
        if (!part.vertices) json_.fail("P809", "The document has no list of vertices.");
        if (!part.objects) json_.fail("P809", "The document has no CityObjects.");
        range_ = read_vertices(*part.vertices, transform_);
        json_.seek(*part.objects);
        json_.members("CityObjects", [&](const std::string& id) { read_object(id); });
    }

    void read_object(const std::string& id) {
        std::string type = "CityObject";
        std::optional<std::size_t> geometries;
        json_.members("A CityObject", [&](const std::string& key) {
            const std::size_t at = json_.position();
            if (key == "type") {
                type = json_.string("The type of a CityObject");
            } else {
                if (key == "geometry") geometries = at;
                json_.skip();
            }
        });
        if (!geometries) return;
        const std::size_t after = json_.position();
        json_.seek(*geometries);
        object_ = id;
        title_ = type + " " + in_quotes(id);
        json_.items("The geometry of a CityObject", [&](std::uint64_t) { read_geometry(); });
        json_.seek(after);
    }

    GeometryText read_geometry_text() {
        GeometryText found;
        json_.members("A geometry", [&](const std::string& key) {
            (void)json_.peek();
            const std::size_t at = json_.position();
            if (key == "type") {
                found.type = json_.string("The type of a geometry");
            } else if (key == "lod" && json_.peek() == '"') {
                found.lod = json_.string("The LoD");
            } else {
                if (key == "boundaries") found.boundaries = at;
                else if (key == "template") found.template_index = at;
                else if (key == "transformationMatrix") found.matrix = at;
                json_.skip();
                if (key == "lod") found.lod = json_.between(at, json_.position());
            }
        });
        return found;
    }

    void read_geometry() {
        const GeometryText text = read_geometry_text();
        const std::size_t after = json_.position();
        if (text.type == "GeometryInstance") read_instance(text);
        else read_shape(text);
        json_.seek(after);
    }

    void read_shape(const GeometryText& text) {
        const std::string title = title_ + (text.lod.empty() ? "" : ", LoD " + text.lod.substr(0, 10));
        const bool many = text.type == "MultiSolid" || text.type == "CompositeSolid";
        if (!many && text.type != "Solid") {
            note_no_solid(title, text.type);
            return;
        }
        if (!text.boundaries) json_.fail("P809", "A geometry has no boundaries.");
        json_.seek(*text.boundaries);
        ++composites_;
        if (!many) return read_solid(title);
        json_.items("The boundaries of a geometry", [&](std::uint64_t k) {
            if (text.type == "MultiSolid") ++composites_;
            read_solid(title + ", solid " + std::to_string(k));
        });
    }

    void read_solid(const std::string& name) {
        MeshSolid solid{object_, name,        static_cast<std::uint32_t>(mesh_.shells.size()),
                        0,       composites_, static_cast<std::uint32_t>(range_.first)};
        json_.items("A solid", [&](std::uint64_t) {
            MeshShell shell{static_cast<std::uint32_t>(mesh_.face_count()), 0};
            json_.items("A shell", [&](std::uint64_t) { read_surface(); });
            shell.face_count = static_cast<std::uint32_t>(mesh_.face_count()) - shell.first_face;
            mesh_.shells.push_back(shell);
            ++solid.shell_count;
        });
        mesh_.solids.push_back(std::move(solid));
    }

    void read_surface() {
        const auto face = static_cast<std::uint32_t>(mesh_.face_count());
        json_.items("A surface", [&](std::uint64_t k) {
            if (k == 0) return read_ring(mesh_.ring);
            MeshHole hole{face, static_cast<std::uint32_t>(mesh_.hole_ring.size()), 0};
            read_ring(mesh_.hole_ring);
            hole.count = static_cast<std::uint32_t>(mesh_.hole_ring.size()) - hole.first;
            mesh_.holes.push_back(hole);
        });
        mesh_.end_face();
        if (mesh_.ring.size() + mesh_.hole_ring.size() + 2 * mesh_.holes.size() > max_corners)
            json_.fail("P800", "The faces of this mesh have more than 2^30 corners.");
    }

    void read_ring(std::vector<std::uint32_t>& ring) {
        json_.items("A ring", [&](std::uint64_t) {
            (void)json_.peek();
            const std::size_t at = json_.position();
            const std::int64_t vertex = json_.integer("A vertex number");
            if (vertex < 0 || static_cast<std::uint64_t>(vertex) >= range_.count) {
                json_.seek(at);
                json_.fail("P804", "Vertex " + std::to_string(vertex) + " of " + title_ +
                                       " does not exist: there are " + std::to_string(range_.count) +
                                       ", counted from 0.");
            }
            ring.push_back(static_cast<std::uint32_t>(range_.first + static_cast<std::size_t>(vertex)));
        });
    }

    void note_no_solid(const std::string& title, const std::string& type) {
        if (++no_solids_ > listed_geometries) return;
        Finding finding{.code = "P813", .severity = Severity::Note};
        finding.sentence = title + " is a " + type.substr(0, 40) + ", not a solid.";
        finding.hint = "Only solids are checked.";
        finding.elements.push_back({"CityObject", object_, ""});
        mesh_.findings.push_back(std::move(finding));
    }

    void read_instance(const GeometryText& text) {
        if (!text.template_index || !text.matrix)
            json_.fail("P809", "A GeometryInstance needs a template and a transformationMatrix.");
        json_.seek(*text.template_index);
        const std::int64_t index = json_.integer("The number of a template");
        TemplateUse& use = uses_[index];
        if (use.count++ == 0) use.first_object = title_;
        json_.seek(*text.matrix);
        std::array<double, 16> m{};
        std::uint64_t count = 0;
        json_.items("A transformationMatrix", [&](std::uint64_t k) {
            if (k >= 16) json_.fail("P809", "A transformationMatrix has 16 numbers.");
            m[k] = json_.number("A number of the transformationMatrix");
            count = k + 1;
        });
        if (count != 16) json_.fail("P809", "A transformationMatrix has 16 numbers.");
        const double determinant = m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) +
                                   m[2] * (m[4] * m[9] - m[5] * m[8]);
        if (determinant == 0) note_flat_instance(index);
    }

    void note_flat_instance(std::int64_t index) {
        if (++flat_instances_ > listed_geometries) return;
        Finding finding{.code = "P814", .severity = Severity::Warning};
        finding.sentence = title_ + " places template " + std::to_string(index) + " by a matrix that flattens it.";
        finding.hint = "Correct the transformationMatrix.";
        finding.elements.push_back({"CityObject", object_, ""});
        mesh_.findings.push_back(std::move(finding));
    }

    void read_templates(std::size_t at) {
        std::optional<std::size_t> shapes, vertices;
        json_.seek(at);
        json_.members("geometry-templates", [&](const std::string& key) {
            if (key == "templates") shapes = json_.position();
            if (key == "vertices-templates") vertices = json_.position();
            json_.skip();
        });
        if (!shapes || !vertices) json_.fail("P809", "geometry-templates needs templates and vertices-templates.");
        range_ = read_vertices(*vertices, {});
        json_.seek(*shapes);
        json_.items("The templates", [&](std::uint64_t k) {
            title_ = "Template " + std::to_string(k);
            if (const auto use = uses_.find(static_cast<std::int64_t>(k)); use != uses_.end())
                title_ +=
                    " (" + std::to_string(use->second.count) + " times, first in " + use->second.first_object + ")";
            object_ = "template " + std::to_string(k);
            templates_ = k + 1;
            const GeometryText text = read_geometry_text();
            const std::size_t after = json_.position();
            read_shape(text);
            json_.seek(after);
        });
    }

    void finish() {
        for (const auto& [index, use] : uses_)
            if (index < 0 || static_cast<std::uint64_t>(index) >= templates_)
                json_.fail("P804", use.first_object + " places template " + std::to_string(index) +
                                       ", but the file has " + std::to_string(templates_) + ", counted from 0.");
        summarise(no_solids_, "P813", Severity::Note, " geometries more are no solids.", "Only solids are checked.");
        summarise(flat_instances_, "P814", Severity::Warning, " instances more are flattened by their matrix.",
                  "Correct the transformationMatrix.");
    }

    void summarise(std::uint64_t count, const char* code, Severity severity, const char* text, const char* hint) {
        if (count <= listed_geometries) return;
        Finding finding{.code = code, .severity = severity};
        finding.sentence = std::to_string(count - listed_geometries) + text;
        finding.hint = hint;
        mesh_.findings.push_back(std::move(finding));
    }

    JsonCursor json_;
    Mesh mesh_{.format = MeshFormat::CityJson};
    Transform transform_;
    VertexRange range_;
    std::string object_, title_;
    std::map<std::int64_t, TemplateUse> uses_;
    std::uint64_t templates_ = 0;
    std::uint64_t no_solids_ = 0, flat_instances_ = 0;
    std::uint32_t composites_ = 0;
    std::size_t end_of_first_ = 0;
};

}  // namespace

Mesh read_city_json(std::string_view bytes, const std::string& file) { return CityReader(bytes, file).read(); }

}  // namespace enfilade::modeler
