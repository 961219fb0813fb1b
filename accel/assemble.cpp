#include "accel/assemble.h"

#include <cmath>
#include <map>
#include <unordered_map>

#include "accel/certificate.h"
#include "accel/locate.h"
#include "accel/locator.h"
#include "accel/look_arrays.h"
#include "accel/placement.h"
#include "accel/scene_file.h"
#include "accel/scene_image.h"
#include "accel/sha256.h"
#include "base/error.h"

namespace enfilade::accel {
namespace {

constexpr std::int32_t coordinate_limit = 1 << 24;

[[noreturn]] void refuse(const char* code, const std::string& sentence) { throw InputError(code, "", sentence); }

std::string at(const char* what, std::size_t i) { return std::string(what) + " " + std::to_string(i); }

/// Strings by id, each once.
class TextPool {
public:
    TextId add(const std::string& text) {
        const auto [found, is_new] = ids_.try_emplace(text, static_cast<TextId>(offsets.size() - 1));
        if (is_new) {
            bytes += text;
            if (bytes.size() > UINT32_MAX) refuse("F10", "the scene's names take more than 4 GB");
            offsets.push_back(static_cast<std::uint32_t>(bytes.size()));
        }
        return found->second;
    }
    std::vector<std::uint32_t> offsets = {0};
    std::string bytes;

private:
    std::unordered_map<std::string, TextId> ids_;
};

class Assembler {
public:
    explicit Assembler(const SceneInput& input) : input_(input) {}

    Scene assemble(const Executor& executor) {
        check_sizes();
        lay_out_portals();
        lay_out_cells();
        lay_out_source_faces();
        lay_out_names();
        lay_out_objects();
        looks_ = detail::lay_out_looks(input_, [&](const std::string& text) { return text_.add(text); });
        SceneView view;
        view.cells = {cells_.data(), cells_.size()};
        view.section_x = {x_.data(), x_.size()};
        view.section_y = {y_.data(), y_.size()};
        locator_ = detail::build_locator(view);
        lay_out_lights(view);
        return detail::parse_and_validate(make_image(executor), "", {.executor = &executor});
    }

private:
    void check_sizes() const {
        int exponent = 0;
        if (!(input_.unit > 0) || std::frexp(input_.unit, &exponent) != 0.5 || exponent < -60 || exponent > 60)
            refuse("F13", "the scene's grid unit is no power of two");
        if (input_.cells.size() > Target::index_mask || input_.source_faces.size() > Target::index_mask ||
            input_.portals.size() >= UINT32_MAX || input_.sections.size() >= UINT32_MAX - 1 ||
            input_.side_faces.size() >= UINT32_MAX || input_.vertices.size() >= UINT32_MAX ||
            input_.cells.size() >= UINT32_MAX >> 3)
            refuse("F10", "the scene has more elements than 32-bit indices can name; build fewer storeys at once");
    }

    /// Metres of a grid coordinate; exact.
    float metres(std::int32_t grid, const char* what, std::size_t i) const {
        if (grid > coordinate_limit || grid < -coordinate_limit)
            refuse("F11", at(what, i) + " lies beyond 2^24 grid units of the origin; take a coarser grid");
        return static_cast<float>(static_cast<double>(grid) * input_.unit);
    }

    void lay_out_portals() {
        for (std::size_t i = 0; i < input_.portals.size(); ++i) {
            const InputPortal& portal = input_.portals[i];
            if (portal.front >= portal.back || portal.back >= input_.cells.size())
                refuse("F12", at("portal", i) + " does not name two cells in ascending order");
            std::uint32_t tint = 0;
            for (const float part : portal.tint)
                if (!(part >= 0) || !std::isfinite(part))
                    refuse("F13", at("portal", i) + " has a tint that is no colour");
            if (portal.kind == PortalKind::Glass) tint = tint_of(portal.tint);
            portals_.push_back({static_cast<CellId>(portal.front), static_cast<CellId>(portal.back),
                                tint << 2 | static_cast<std::uint32_t>(portal.kind)});
        }
    }

    std::uint32_t tint_of(const std::array<float, 3>& tint) {
        const auto [found, is_new] = tint_ids_.try_emplace(tint, static_cast<std::uint32_t>(tints_.size()));
        if (is_new) tints_.push_back({tint[0], tint[1], tint[2]});
        return found->second;
    }

    /// The target and portal id behind a face of `cell`.
    std::pair<Target, PortalId> target_of(const InputTarget& target, std::uint32_t cell) const {
        if (!target.is_portal) {
            if (target.index >= input_.source_faces.size())
                refuse("F10", at("cell", cell) + " names source face " + std::to_string(target.index) +
                                  ", which does not exist");
            return {Target::solid(target.index), none<PortalId>};
        }
        if (target.index >= input_.portals.size())
            refuse("F10",
                   at("cell", cell) + " names portal " + std::to_string(target.index) + ", which does not exist");
        const InputPortal& portal = input_.portals[target.index];
        if (portal.front != cell && portal.back != cell)
            refuse("F12", at("cell", cell) + " names portal " + std::to_string(target.index) +
                              ", which joins two other cells");
        const std::uint32_t neighbour = portal.front == cell ? portal.back : portal.front;
        return {Target::portal(portal.kind, neighbour), static_cast<PortalId>(target.index)};
    }

    void lay_out_cells() {
        if (input_.sections.empty() || input_.cells.empty()) refuse("F10", "the scene has no cell that carries light");
        for (const InputSection& section : input_.sections) {
            x_.push_back(metres(section.x, "section", x_.size()));
            y_.push_back(metres(section.y, "section", y_.size()));
        }
        x_.push_back(0);
        y_.push_back(0);
        tails_.resize(x_.size());
        for (std::uint32_t c = 0; c < input_.cells.size(); ++c) lay_out_cell(c);
        tails_.back() = {static_cast<std::uint32_t>(faces_.size())};
    }

    void lay_out_cell(std::uint32_t c) {
        const InputCell& from = input_.cells[c];
        const std::size_t end =
            c + 1 < input_.cells.size() ? input_.cells[c + 1].first_section : input_.sections.size();
        if (from.first_section != next_section_ || end > input_.sections.size() || end < from.first_section + 3u ||
            end - from.first_section > UINT16_MAX)
            refuse("F10", at("cell", c) + " does not have between 3 and 65535 sections in a row");
        if (from.z_floor >= from.z_ceiling) refuse("F13", at("cell", c) + " has no height");
        const auto [floor, floor_portal] = target_of(from.floor, c);
        const auto [ceiling, ceiling_portal] = target_of(from.ceiling, c);
        cells_.push_back({from.first_section, static_cast<std::uint16_t>(end - from.first_section), from.label, 0,
                          metres(from.z_floor, "cell", c), metres(from.z_ceiling, "cell", c), floor, ceiling,
                          static_cast<SpaceId>(from.space), from.volume});
        cell_portals_.push_back({floor_portal, ceiling_portal});
        for (std::size_t s = from.first_section; s < end; ++s) lay_out_section(c, s);
        next_section_ = end;
    }

    void lay_out_section(std::uint32_t c, std::size_t s) {
        const InputSection& a = input_.sections[s];
        tails_[s] = {static_cast<std::uint32_t>(faces_.size())};
        const std::size_t end =
            s + 1 < input_.sections.size() ? input_.sections[s + 1].first_face : input_.side_faces.size();
        if (a.first_face != faces_.size() || end <= a.first_face || end > input_.side_faces.size())
            refuse("F10", at("section", s) + " does not have its side faces in a row");
        std::int32_t below = input_.cells[c].z_floor;
        for (std::size_t f = a.first_face; f < end; ++f) {
            const InputSideFace& face = input_.side_faces[f];
            if (face.z_top <= below) refuse("F13", at("side face", f) + " does not lie above the one below it");
            below = face.z_top;
            const auto [target, portal] = target_of(face.target, c);
            faces_.push_back({metres(face.z_top, "side face", f), target});
            face_portals_.push_back(portal);
        }
        if (below != input_.cells[c].z_ceiling)
            refuse("F13", at("section", s) + " has a stack that does not end at the ceiling of its cell");
    }

    void lay_out_source_faces() {
        std::size_t next = 0;
        for (std::size_t i = 0; i < input_.source_faces.size(); ++i) {
            const InputSourceFace& face = input_.source_faces[i];
            const std::size_t end =
                i + 1 < input_.source_faces.size() ? input_.source_faces[i + 1].first_vertex : input_.vertices.size();
            if (face.first_vertex != next || end < next + 3 || end > input_.vertices.size())
                refuse("F10", at("source face", i) + " does not have at least 3 vertices in a row");
            next = end;
            source_faces_.push_back({face.first_vertex,
                                     face.surface,
                                     {},
                                     static_cast<SpaceId>(face.space),
                                     static_cast<MaterialId>(face.material)});
        }
        source_faces_.push_back(
            {static_cast<std::uint32_t>(next), Surface::WallPaper, {}, none<SpaceId>, none<MaterialId>});
        if (next != input_.vertices.size()) refuse("F10", "the scene has vertices that belong to no source face");
        for (std::size_t i = 0; i < input_.vertices.size(); ++i) {
            const auto& v = input_.vertices[i];
            vertices_.push_back({metres(v[0], "vertex", i), metres(v[1], "vertex", i), metres(v[2], "vertex", i)});
        }
    }

    void lay_out_names() {
        for (const InputMaterial& material : input_.materials)
            materials_.push_back({material.colour, text_.add(material.name)});
        for (const InputSpace& space : input_.spaces)
            spaces_.push_back({space.label,
                               {},
                               text_.add(space.id),
                               text_.add(space.name),
                               text_.add(space.storey),
                               space.storey_index,
                               0,
                               space.area_m2});
    }

    void lay_out_objects() {
        for (std::size_t i = 0; i < input_.meshes.size(); ++i) lay_out_mesh(i);
        for (std::size_t i = 0; i < input_.objects.size(); ++i) lay_out_object(i);
        if (input_.objects.empty()) return;
        if (input_.cell_objects.size() != cells_.size()) refuse("F10", "the scene's cells do not list their objects");
        for (std::size_t c = 0; c < cells_.size(); ++c) {
            cell_object_offsets_.push_back(static_cast<std::uint32_t>(cell_objects_.size()));
            for (const std::uint32_t object : input_.cell_objects[c])
                cell_objects_.push_back(static_cast<ObjectId>(object));
        }
        cell_object_offsets_.push_back(static_cast<std::uint32_t>(cell_objects_.size()));
    }

    void lay_out_mesh(std::size_t i) {
        const InputMesh& from = *input_.meshes[i];
        if (from.triangle_materials.size() != from.triangles.size() ||
            mesh_vertices_.size() + from.vertices.size() >= UINT32_MAX ||
            mesh_triangles_.size() + from.triangles.size() >= UINT32_MAX)
            refuse("F10", at("mesh", i) + " has triangles without materials, or too many of them");
        ObjectMesh mesh = {static_cast<std::uint32_t>(mesh_vertices_.size()),
                           static_cast<std::uint32_t>(mesh_triangles_.size()),
                           static_cast<std::uint32_t>(from.vertices.size()),
                           static_cast<std::uint32_t>(from.triangles.size()),
                           {INFINITY, INFINITY, INFINITY},
                           {-INFINITY, -INFINITY, -INFINITY},
                           text_.add(from.name),
                           lay_out_texcoords(from, i)};
        for (const std::array<float, 3>& v : from.vertices) {
            for (std::size_t k = 0; k < 3; ++k) {
                mesh.low[k] = std::min(mesh.low[k], v[k]);
                mesh.high[k] = std::max(mesh.high[k], v[k]);
            }
            mesh_vertices_.push_back({v[0], v[1], v[2]});
        }
        for (std::size_t t = 0; t < from.triangles.size(); ++t)
            mesh_triangles_.push_back({from.triangles[t], static_cast<MaterialId>(from.triangle_materials[t])});
        meshes_.push_back(mesh);
    }

    /// ObjectMesh::texcoords of a mesh.
    std::uint32_t lay_out_texcoords(const InputMesh& from, std::size_t i) {
        if (from.texcoords.empty()) return 0;
        if (from.texcoords.size() != 3 * from.triangles.size() ||
            mesh_texcoords_.size() + from.texcoords.size() >= UINT32_MAX)
            refuse("F10", at("mesh", i) + " has triangles without texture coordinates, or too many of them");
        const auto first = static_cast<std::uint32_t>(mesh_texcoords_.size());
        for (const std::array<float, 2>& at_corner : from.texcoords)
            mesh_texcoords_.push_back({at_corner[0], at_corner[1]});
        return first + 1;
    }

    void lay_out_object(std::size_t i) {
        const InputObject& from = input_.objects[i];
        if (from.mesh >= meshes_.size()) refuse("F10", at("object", i) + " names a mesh that does not exist");
        PlacedObject object = {};
        object.mesh = static_cast<MeshId>(from.mesh);
        object.material = from.material == UINT32_MAX ? none<MaterialId> : static_cast<MaterialId>(from.material);
        object.space = static_cast<SpaceId>(from.space);
        object.id = text_.add(from.id);
        object.name = text_.add(from.name);
        const std::optional<std::array<double, 12>> inverse = inverse_of(from.scene_from_object);
        if (!inverse) refuse("F13", at("object", i) + " has a placement that flattens it");
        for (std::size_t k = 0; k < 12; ++k) {
            object.scene_from_object.rows[k] = static_cast<float>(from.scene_from_object[k]);
            object.object_from_scene.rows[k] = static_cast<float>((*inverse)[k]);
        }
        bound(meshes_[from.mesh], object);
        objects_.push_back(object);
    }

    /// Of a lamp the number that the file holds decides in which cell it hangs.
    void lay_out_lights(SceneView view) {
        view.section_tails = {tails_.data(), tails_.size()};
        view.locator_nodes = {locator_.nodes.data(), locator_.nodes.size()};
        view.locator_cells = {locator_.cells.data(), locator_.cells.size()};
        for (const InputLight& from : input_.lights) {
            Light light = {};
            std::array<double, 3> place = {};
            for (std::size_t k = 0; k < 3; ++k) {
                light.position[k] = static_cast<float>(from.position[k]);
                place[k] = double{light.position[k]};
            }
            light.radius = static_cast<float>(from.radius);
            light.intensity = from.intensity;
            light.cell = locate(view, place).value_or(none<CellId>);
            light.carrier = from.carrier == UINT32_MAX ? none<ObjectId> : static_cast<ObjectId>(from.carrier);
            light.id = text_.add(from.id);
            light.name = text_.add(from.name);
            lights_.push_back(light);
        }
    }

    template <class T>
    void add(SectionKind kind, const char* name, const std::vector<T>& elements) {
        arrays_.push_back(
            {name, static_cast<std::uint32_t>(kind), Group::Trace, sizeof(T), std::as_bytes(std::span(elements)), {}});
    }

    Scene::Storage make_image(const Executor& executor) {
        using enum SectionKind;
        add(Cells, "cells", cells_);
        add(CellPortals, "cell_portals", cell_portals_);
        add(SectionX, "section_x", x_);
        add(SectionY, "section_y", y_);
        add(SectionTails, "section_tails", tails_);
        add(SideFaces, "side_faces", faces_);
        add(SideFacePortals, "side_face_ports", face_portals_);
        add(Portals, "portals", portals_);
        add(Tints, "tints", tints_);
        add(SourceFaces, "source_faces", source_faces_);
        add(Vertices, "vertices", vertices_);
        add(Materials, "materials", materials_);
        add(Spaces, "spaces", spaces_);
        add(TextOffsets, "text_offsets", text_.offsets);
        arrays_.push_back(
            {"text", static_cast<std::uint32_t>(Text), Group::Trace, 1, std::as_bytes(std::span(text_.bytes)), {}});
        add(LocatorNodes, "locator_nodes", locator_.nodes);
        add(LocatorCells, "locator_cells", locator_.cells);
        if (!meshes_.empty()) {
            add(Meshes, "meshes", meshes_);
            add(MeshVertices, "mesh_vertices", mesh_vertices_);
            add(MeshTriangles, "mesh_triangles", mesh_triangles_);
        }
        if (!objects_.empty()) {
            add(Objects, "objects", objects_);
            add(CellObjectOffsets, "cell_object_off", cell_object_offsets_);
            add(CellObjects, "cell_objects", cell_objects_);
        }
        if (!lights_.empty()) add(SectionKind::Lights, "lights", lights_);
        if (!looks_.material_looks.empty()) add(MaterialLooks, "material_looks", looks_.material_looks);
        if (!looks_.textures.empty()) {
            add(Textures, "textures", looks_.textures);
            add(Texels, "texels", looks_.texels);
        }
        if (!mesh_texcoords_.empty()) add(MeshTexCoords, "mesh_texcoords", mesh_texcoords_);
        if (!looks_.face_frames.empty()) add(FaceFrames, "face_frames", looks_.face_frames);
        std::uint32_t id = static_cast<std::uint32_t>(FirstModel);
        for (const InputModelArray& array : input_.model) {
            if (array.name.empty() || array.name.size() > 15 || array.element_bytes == 0 ||
                array.bytes.size() % array.element_bytes != 0)
                refuse("F10", "the model array '" + array.name + "' has no usable name or size");
            arrays_.push_back({array.name, id++, Group::Model, array.element_bytes, array.bytes, {}});
        }
        executor.run(arrays_.size(), [&](std::size_t i) { arrays_[i].sha256 = sha256(arrays_[i].bytes); });
        const std::string text = to_text(make_certificate());
        arrays_.push_back({"certificate",
                           static_cast<std::uint32_t>(SectionKind::Certificate),
                           Group::Certificate,
                           1,
                           std::as_bytes(std::span(text)),
                           {}});
        arrays_.back().sha256 = sha256(arrays_.back().bytes);
        return detail::lay_out(input_.unit, input_.origin, arrays_);
    }

    [[nodiscard]] accel::Certificate make_certificate() const {
        accel::Certificate certificate;
        certificate.program_version = input_.certificate.program_version;
        certificate.options = input_.certificate.options;
        certificate.code_counts = input_.certificate.code_counts;
        if (!input_.model.empty()) certificate.model_sha256 = hex(model_hash(arrays_));
        for (const SceneArray& array : arrays_)
            if (array.group == Group::Trace) certificate.trace_sha256.emplace_back(array.name, hex(array.sha256));
        return certificate;
    }

    const SceneInput& input_;
    std::size_t next_section_ = 0;
    std::vector<Cell> cells_;
    std::vector<CellPortals> cell_portals_;
    std::vector<float> x_, y_;
    std::vector<SectionTail> tails_;
    std::vector<SideFace> faces_;
    std::vector<PortalId> face_portals_;
    std::vector<Portal> portals_;
    std::vector<Vertex> tints_;
    std::map<std::array<float, 3>, std::uint32_t> tint_ids_;
    std::vector<SourceFace> source_faces_;
    std::vector<Vertex> vertices_;
    std::vector<Material> materials_;
    std::vector<Space> spaces_;
    TextPool text_;
    std::vector<ObjectMesh> meshes_;
    std::vector<Vertex> mesh_vertices_;
    std::vector<MeshTriangle> mesh_triangles_;
    std::vector<PlacedObject> objects_;
    std::vector<std::uint32_t> cell_object_offsets_;
    std::vector<ObjectId> cell_objects_;
    std::vector<Light> lights_;
    std::vector<TexCoord> mesh_texcoords_;
    detail::LookArrays looks_;
    detail::Locator locator_;
    std::vector<SceneArray> arrays_;
};

}  // namespace

Scene assemble(const SceneInput& input, const Executor* executor) {
    const ThreadExecutor all_cores;
    return Assembler(input).assemble(executor != nullptr ? *executor : all_cores);
}

}  // namespace enfilade::accel
