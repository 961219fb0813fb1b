#pragma once
// The flat scene that a tracer consumes: its arrays, and the object that owns them (README.md, docs/scene-format.md).

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "accel/array_view.h"
#include "accel/label.h"
#include "base/id.h"

namespace enfilade::accel {

enum class CellId : std::uint32_t {};
enum class SectionId : std::uint32_t {};  ///< a vertical section: one side of one cell
enum class FaceId : std::uint32_t {};     ///< a side face: one storey of a section's stack
enum class PortalId : std::uint32_t {};
enum class SourceFaceId : std::uint32_t {};
enum class SpaceId : std::uint32_t {};
enum class MaterialId : std::uint32_t {};
enum class TextId : std::uint32_t {};
enum class MeshId : std::uint32_t {};    ///< a mesh that objects share (the paper's clone)
enum class ObjectId : std::uint32_t {};  ///< a mesh at its place
enum class LightId : std::uint32_t {};   ///< a lamp
enum class TextureId : std::uint32_t {};

enum class TargetKind : std::uint32_t { Solid, Clear, Virtual, Glass };

/// What lies behind a face of a cell: a solid source face, or the neighbour behind a portal.
/// 32 bits: kind in the upper two, source face or cell in the lower thirty.
struct Target {
    static constexpr std::uint32_t index_bits = 30;
    static constexpr std::uint32_t index_mask = (1u << index_bits) - 1;
    std::uint32_t bits = 0;

    ENFILADE_HD TargetKind kind() const { return static_cast<TargetKind>(bits >> index_bits); }
    ENFILADE_HD bool is_portal() const { return bits > index_mask; }
    ENFILADE_HD bool is_glass() const { return bits >= (3u << index_bits); }
    /// \pre !is_portal()
    ENFILADE_HD SourceFaceId source_face() const { return static_cast<SourceFaceId>(bits); }
    /// \pre is_portal()
    ENFILADE_HD CellId neighbour() const { return static_cast<CellId>(bits & index_mask); }
    static constexpr Target solid(std::uint32_t face) { return {face}; }
    static constexpr Target portal(PortalKind kind, std::uint32_t cell) {
        return {(static_cast<std::uint32_t>(kind) + 1) << index_bits | cell};
    }
    friend constexpr bool operator==(Target, Target) = default;
};

/// A convex vertical prism. Its sections are [first_section, first_section + section_count), counter-clockwise.
struct Cell {
    std::uint32_t first_section;
    std::uint16_t section_count;
    Label label;
    std::uint8_t reserved;
    float z_floor;
    float z_ceiling;
    Target floor;
    Target ceiling;
    SpaceId space;
    std::uint32_t volume;  ///< id of its volume in the map
};

/// What the walk needs of the one section it leaves by, apart from the lines that it tests in all of them.
struct SectionTail {
    std::uint32_t first_face;  ///< its side faces end where the next section's begin
};

/// One face of a section's stack, from the top of the face below (or the floor) up to `z_top`.
struct SideFace {
    float z_top;
    Target target;
};

/// The same portal as its two cells see it; front < back.
struct Portal {
    CellId front;
    CellId back;
    std::uint32_t kind_and_tint;  ///< PortalKind in the lower two bits, index into `tints` above
    [[nodiscard]] PortalKind kind() const { return static_cast<PortalKind>(kind_and_tint & 3u); }
    [[nodiscard]] std::uint32_t tint() const { return kind_and_tint >> 2; }
};

/// The portals behind a cell's floor and ceiling, `none<PortalId>` where they are solid.
struct CellPortals {
    PortalId floor;
    PortalId ceiling;
};

/// A flat solid face as it was before convexification. Its ring ends where the next face's begins.
struct SourceFace {
    std::uint32_t first_vertex;
    Surface surface;
    std::array<std::uint8_t, 3> reserved;
    SpaceId space;
    MaterialId material;
};

struct Vertex {
    float x, y, z;
};

struct Material {
    std::array<float, 3> colour;  ///< diffuse reflectance, linear RGB
    TextId name;
};

struct Space {
    Label label;
    std::array<std::uint8_t, 3> reserved;
    TextId id;
    TextId name;
    TextId storey;
    std::uint32_t storey_index;
    std::uint32_t reserved2;
    double area_m2;
};

/// A mesh in its own space: metres, z up, its front towards -y, the middle of its bottom at the origin. Any triangles:
/// open, crossing, without area.
struct ObjectMesh {
    std::uint32_t first_vertex;    ///< into `mesh_vertices`
    std::uint32_t first_triangle;  ///< into `mesh_triangles`
    std::uint32_t vertex_count;
    std::uint32_t triangle_count;
    std::array<float, 3> low;  ///< of its vertices; low > high where it has none
    std::array<float, 3> high;
    TextId name;
    std::uint32_t texcoords;  ///< 0: it has none; else 1 + the first of its 3 * triangle_count in `mesh_texcoords`
};

/// Corners count from the mesh's first vertex. Both sides are seen.
struct MeshTriangle {
    std::array<std::uint32_t, 3> corners;
    MaterialId material;
};

/// Rows of 3 x 4 numbers: p -> (row . (p, 1)) for the three rows. Not singular, of any handedness.
struct Placement {
    std::array<float, 12> rows;
};

/// A mesh that stands in a room. It is seen in the cells that list it, nowhere else: what pokes through a wall of its
/// room is cut off there.
struct PlacedObject {
    Placement scene_from_object;
    Placement object_from_scene;  ///< its inverse, rounded
    std::array<float, 3> low;     ///< its box along the axes of the scene, rounded outward
    std::array<float, 3> high;
    MeshId mesh;
    MaterialId material;  ///< of the whole object; none<MaterialId>: what its triangles say
    SpaceId space;        ///< the room that it stands in, or its own where it is a volume
    TextId id;            ///< its own: no other object has it
    TextId name;
    std::uint32_t reserved;
};

/// A lamp: a point, or for tracers of soft shadows a ball, that shines alike in all directions.
struct Light {
    std::array<float, 3> position;   ///< metres, scene frame; on no grid
    float radius;                    ///< metres; 0: a point
    std::array<float, 3> intensity;  ///< candela by linear RGB
    CellId cell;                     ///< that holds the position; none<CellId> where a solid does: it lights nothing
    ObjectId carrier;                ///< the lamp that one sees: it throws no shadow of this light; or none<ObjectId>
    TextId id;                       ///< its own: no other light has it
    TextId name;
    std::uint32_t reserved;
};

/// What light does at a material besides being scattered in its colour. `mirror` and the largest part of `through`
/// are 1 or less together; the rest shows the colour.
struct MaterialLook {
    float mirror;                  ///< share of the light that is reflected as by a mirror
    std::array<float, 3> through;  ///< what goes straight through, linear RGB; 0: none
    TextureId texture;             ///< its texels are the colour; none<TextureId>: the material's own
    /// Rows of 2 x 3 numbers: (u, v, 1) -> repeats of the texture to the right and downward from its upper left corner.
    /// On faces u and v are metres (FaceFrame), on triangles what `mesh_texcoords` say.
    std::array<float, 6> texture_from_face;
    std::uint32_t reserved;
};

/// A picture that repeats in both directions: levels from the largest on, each half as wide and high as the one before
/// (rounded down, 1 at least), row by row from the top, in `texels` one after the other.
struct Texture {
    std::uint32_t first_texel;
    std::uint16_t width;
    std::uint16_t height;
    std::uint32_t level_count;  ///< down to the level of one texel
    TextId name;                ///< of the picture
};

/// sRGB (IEC 61966-2-1); alpha is linear: what it lacks to 255 is seen through.
struct Texel {
    std::uint8_t r, g, b, a;
};

struct TexCoord {
    float u, v;
};

/// How textures lie on a source face, so that they go on from face to face. u = x_u x + y_u y + u_0 (metres, to the
/// right as one looks at a wall); v is z + v_0 on walls (up), -y_u x + x_u y + v_0 on floors and ceilings.
struct FaceFrame {
    float x_u, y_u;  ///< of length 1
    float u_0, v_0;
};

/// One box of the point locator, in depth-first order: a point outside it goes on at `skip`, inside it at the next
/// node. Leaves hold `locator_cells[first .. first + count)`.
struct LocatorNode {
    std::array<float, 3> low;
    std::array<float, 3> high;
    std::uint32_t skip;
    std::uint32_t first_and_count;  ///< count in the lower three bits, 0 in inner nodes
};

/// Everything a tracer reads, as plain pointers. Positions are metres in the scene's own frame: float32 holds them
/// exactly, because they are multiples of `unit` (a power of two) below 2^24 of them.
struct SceneView {
    double unit = 0;               ///< metres per grid unit
    double origin[3] = {0, 0, 0};  ///< world position of the frame's (0, 0, 0), metres
    ArrayView<Cell> cells;
    ArrayView<CellPortals> cell_portals;   ///< [cell_count]
    ArrayView<float> section_x;            ///< [section_count + 1]: where the section begins, the last one unused
    ArrayView<float> section_y;            ///< [section_count + 1]
    ArrayView<SectionTail> section_tails;  ///< [section_count + 1]
    ArrayView<SideFace> side_faces;
    ArrayView<PortalId> side_face_portals;  ///< [side_face_count]
    ArrayView<Portal> portals;
    ArrayView<Vertex> tints;             ///< linear RGB transmittance of the glass portals
    ArrayView<SourceFace> source_faces;  ///< [source_face_count + 1], the last one closes the rings
    ArrayView<Vertex> vertices;
    ArrayView<Material> materials;
    ArrayView<Space> spaces;
    ArrayView<std::uint32_t> text_offsets;  ///< [text_count + 1]
    ArrayView<char> text;                   ///< UTF-8
    ArrayView<LocatorNode> locator_nodes;
    ArrayView<CellId> locator_cells;
    // Furniture: all of these are empty in a scene without.
    ArrayView<ObjectMesh> meshes;
    ArrayView<Vertex> mesh_vertices;
    ArrayView<MeshTriangle> mesh_triangles;
    ArrayView<PlacedObject> objects;               ///< by ascending id
    ArrayView<std::uint32_t> cell_object_offsets;  ///< [cell_count + 1] into `cell_objects`
    ArrayView<ObjectId> cell_objects;              ///< of each cell, ascending: whose box shares a place with it

    // Empty in a scene without lamps.
    ArrayView<Light> lights;  ///< by ascending id

    // Empty in a scene whose materials are all plain colours.
    ArrayView<MaterialLook> material_looks;  ///< [material_count]
    ArrayView<Texture> textures;
    ArrayView<Texel> texels;
    ArrayView<TexCoord> mesh_texcoords;  ///< of the triangles of meshes that have them, corner by corner
    ArrayView<FaceFrame> face_frames;    ///< [source_face_count], or empty where no face has a texture

    ENFILADE_HD bool has_objects() const { return objects.count != 0; }
    ENFILADE_HD bool has_looks() const { return material_looks.count != 0; }
    ENFILADE_HD std::size_t section_count() const { return section_x.size() - 1; }
    ENFILADE_HD std::size_t source_face_count() const { return source_faces.size() - 1; }
    [[nodiscard]] std::string_view string(TextId id) const {
        const std::uint32_t begin = text_offsets[index(id)];
        return {text.data() + begin, text_offsets[index(id) + 1] - begin};
    }
};

static_assert(sizeof(Cell) == 32 && sizeof(SectionTail) == 4 && sizeof(SideFace) == 8 && sizeof(Portal) == 12);
static_assert(sizeof(SourceFace) == 16 && sizeof(Material) == 16 && sizeof(Space) == 32 && sizeof(LocatorNode) == 32);
static_assert(sizeof(ObjectMesh) == 48 && sizeof(MeshTriangle) == 16 && sizeof(PlacedObject) == 144);
static_assert(sizeof(Light) == 48);
static_assert(sizeof(MaterialLook) == 48 && sizeof(Texture) == 16 && sizeof(Texel) == 4 && sizeof(TexCoord) == 8);
static_assert(sizeof(FaceFrame) == 16);
static_assert(std::is_trivially_copyable_v<SceneView>);

/// Which part of the file an array belongs to (1-architecture, decision 7 of the design).
enum class Group : std::uint32_t { Trace, Model, Certificate };

/// One array of a scene's file image.
struct SceneArray {
    std::string_view name;
    std::uint32_t id = 0;  ///< `SectionKind` in scene_file.h, or a number this version does not know
    Group group = Group::Trace;
    std::uint32_t element_bytes = 1;
    std::span<const std::byte> bytes;
    std::array<std::uint8_t, 32> sha256 = {};  ///< as the file states it
};

/// Owns the memory (allocated or mapped) that holds one scene file image, validated. Move-only; views stay valid
/// while it lives, also after a move.
class Scene {
public:
    /// Memory that somebody keeps alive for the scene.
    struct Storage {
        std::shared_ptr<const std::byte> bytes;
        std::size_t size = 0;
    };

    Scene() = default;
    Scene(Storage storage, const SceneView& view, std::vector<SceneArray> arrays);
    Scene(Scene&&) noexcept = default;
    Scene& operator=(Scene&&) noexcept = default;
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    [[nodiscard]] const SceneView& view() const { return view_; }
    /// All arrays of the file, in file order, the ones this version does not know included.
    [[nodiscard]] std::span<const SceneArray> arrays() const { return arrays_; }
    /// The array of that name, or nullptr.
    [[nodiscard]] const SceneArray* find(std::string_view name) const;
    [[nodiscard]] bool has_model() const;
    /// The file image itself: what `write` writes.
    [[nodiscard]] std::span<const std::byte> bytes() const { return {storage_.bytes.get(), storage_.size}; }

private:
    Storage storage_;
    SceneView view_;
    std::vector<SceneArray> arrays_;
};

}  // namespace enfilade::accel
