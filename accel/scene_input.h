#pragma once
// The plain description from which `assemble` lays out a Scene: what a modeler has to provide, in grid units.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "accel/label.h"

namespace enfilade::accel {

/// Where a face of a cell leads: a portal (index into `portals`) or a solid source face (index into `source_faces`).
struct InputTarget {
    bool is_portal = false;
    std::uint32_t index = 0;
};

/// One face of a vertical section, from the top of the face below it (or the cell's floor) up to `z_top`.
struct InputSideFace {
    std::int32_t z_top = 0;
    InputTarget target;
};

/// The side of a cell over the floor edge from (x, y) to the next section's (x, y).
struct InputSection {
    std::int32_t x = 0;
    std::int32_t y = 0;
    std::uint32_t first_face = 0;  ///< into `side_faces`; the section's faces end where the next section's begin
};

/// A convex vertical prism. Sections run counter-clockwise seen from above.
struct InputCell {
    Label label = Label::Room;
    std::uint32_t space = 0;   ///< into `spaces`
    std::uint32_t volume = 0;  ///< id of its volume in the map
    std::int32_t z_floor = 0;
    std::int32_t z_ceiling = 0;
    std::uint32_t first_section = 0;  ///< into `sections`; ends where the next cell's begin
    InputTarget floor;
    InputTarget ceiling;
};

/// A portal between cells `front` < `back`.
struct InputPortal {
    std::uint32_t front = 0;
    std::uint32_t back = 0;
    PortalKind kind = PortalKind::Clear;
    std::array<float, 3> tint = {1, 1, 1};
};

/// A flat solid face as it was before convexification: the ring runs counter-clockwise seen from the light side.
struct InputSourceFace {
    Surface surface = Surface::WallPaper;
    std::uint32_t space = 0;         ///< the space that sees it
    std::uint32_t material = 0;      ///< into `materials`
    std::uint32_t first_vertex = 0;  ///< into `vertices`; ends where the next face's begin
    /// How textures lie on it: x_u, y_u, u_0, v_0 (accel/scene.h, FaceFrame); metres of the scene's frame.
    std::array<float, 4> frame = {1, 0, 0, 0};
};

/// A picture with all its levels (accel/texture_chain.h makes them).
struct InputTexture {
    std::string name;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t level_count = 0;
    std::vector<std::array<std::uint8_t, 4>> texels;  ///< of all levels, the largest first: sRGB and alpha
    friend bool operator==(const InputTexture&, const InputTexture&) = default;
};

/// What a material is besides its colour (accel/scene.h, MaterialLook).
struct InputLook {
    float mirror = 0;
    std::array<float, 3> through = {0, 0, 0};
    std::uint32_t texture = UINT32_MAX;  ///< into `textures`; UINT32_MAX: none
    std::array<float, 6> texture_from_face = {1, 0, 0, 0, -1, 0};
    friend bool operator==(const InputLook&, const InputLook&) = default;
    friend auto operator<=>(const InputLook&, const InputLook&) = default;
};

struct InputMaterial {
    std::string name;
    std::array<float, 3> colour = {0.8f, 0.8f, 0.8f};  ///< diffuse reflectance, linear RGB; under a texture its mean
    InputLook look = {};
};

/// A room, door, ... as people know it: its cells are pieces of it.
struct InputSpace {
    Label label = Label::Room;
    std::string id;
    std::string name;
    std::string storey;  ///< id of the storey, empty for the exterior
    std::uint32_t storey_index = UINT32_MAX;
    double area_m2 = 0;
};

/// A triangle soup in its own space (accel/scene.h, ObjectMesh): metres.
struct InputMesh {
    std::string name;
    std::vector<std::array<float, 3>> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::uint32_t> triangle_materials;  ///< [triangle count] into SceneInput::materials
    std::vector<std::array<float, 2>> texcoords;    ///< [3 * triangle count], or empty: u to the right, v up, repeats
};

/// A mesh at its place.
struct InputObject {
    std::string id;
    std::string name;
    std::uint32_t mesh = 0;                      ///< into `meshes`
    std::uint32_t material = UINT32_MAX;         ///< of the whole object; UINT32_MAX: what its triangles say
    std::uint32_t space = 0;                     ///< into `spaces`
    std::array<double, 12> scene_from_object{};  ///< rows of 3 x 4 numbers
};

/// A lamp. Its cell is looked for when the scene is assembled.
struct InputLight {
    std::string id;
    std::string name;
    std::array<double, 3> position = {0, 0, 0};  ///< metres, scene frame
    double radius = 0;                           ///< metres
    std::array<float, 3> intensity = {1, 1, 1};  ///< candela by linear RGB, not negative
    std::uint32_t carrier = UINT32_MAX;          ///< into `objects`: throws no shadow of it; UINT32_MAX: none
};

/// An array that travels in the file for `modeler` and is opaque to `accel`.
struct InputModelArray {
    std::string name;  ///< at most 15 characters
    std::uint32_t element_bytes = 1;
    std::vector<std::byte> bytes;
};

/// What `check` said of the model that is exported (1-architecture, decision 7).
struct InputCertificate {
    std::string program_version;
    std::string options;                                             ///< the options of the build, as JSON
    std::vector<std::pair<std::string, std::uint64_t>> code_counts;  ///< checked codes and how many findings each had
};

struct SceneInput {
    double unit = 1.0 / 8192;                  ///< metres per grid unit
    std::array<double, 3> origin = {0, 0, 0};  ///< world position of grid point (0, 0, 0), metres
    std::vector<InputCell> cells;              ///< in ascending volume id
    std::vector<InputSection> sections;
    std::vector<InputSideFace> side_faces;
    std::vector<InputPortal> portals;
    std::vector<InputSourceFace> source_faces;
    std::vector<std::array<std::int32_t, 3>> vertices;  ///< of source faces, grid units
    std::vector<InputMaterial> materials;
    std::vector<std::shared_ptr<const InputTexture>> textures;
    std::vector<InputSpace> spaces;
    std::vector<std::shared_ptr<const InputMesh>> meshes;
    std::vector<InputObject> objects;                      ///< by ascending id
    std::vector<std::vector<std::uint32_t>> cell_objects;  ///< [cell count], each ascending; empty without objects
    std::vector<InputLight> lights;                        ///< by ascending id
    std::vector<InputModelArray> model;                    ///< empty: a stripped scene
    InputCertificate certificate;
};

}  // namespace enfilade::accel
