#include "modeler/exports/obj.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "modeler/exports/scene_mesh.h"
#include "plans/colour.h"

namespace enfilade::modeler {

namespace {

void append(std::string& text, float value) {
    char digits[32];
    // + 0: no "-0".
    const auto end = std::to_chars(digits, digits + sizeof digits, value + 0.0f).ptr;
    text += ' ';
    text.append(digits, end);
}

void append_line(std::string& text, const char* key, const std::array<float, 3>& p) {
    text += key;
    for (const float value : p) append(text, value);
    text += '\n';
}

/// The format does not say what Kd means; most readers, ours too, take it for sRGB. Six digits, so that the last bits
/// of pow() of some library do not enter the file.
float srgb_digits(float linear) { return std::round(plans::srgb_from_linear(linear) * 1e6f) / 1e6f; }

/// OBJ names end at the first blank.
std::string word(std::string name) {
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return c <= ' '; }, '_');
    return name;
}

void append_part(std::string& text, const MeshPart& part, std::size_t first) {
    for (const auto& [x, y, z] : part.positions) append_line(text, "v", {x, z, -y});
    for (const auto& [x, y, z] : part.normals) append_line(text, "vn", {x, z, -y});
    for (std::size_t i = 0; i < part.indices.size(); i += 3) {
        text += 'f';
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::string number = std::to_string(first + part.indices[i + corner]);
            text += ' ' + number + "//" + number;
        }
        text += '\n';
    }
}

}  // namespace

ObjText to_obj(const accel::SceneView& scene, std::string_view mtl_name) {
    const SceneMesh mesh = scene_mesh(scene);
    ObjText out;
    for (const MeshMaterial& material : mesh.materials) {
        out.mtl += "newmtl " + word(material.name) + '\n';
        const auto& [red, green, blue] = material.colour;
        append_line(out.mtl, "Kd", {srgb_digits(red), srgb_digits(green), srgb_digits(blue)});
        if (material.opacity < 1) {
            out.mtl += "d";
            append(out.mtl, material.opacity);
            out.mtl += '\n';
        }
    }
    out.obj = "mtllib " + std::string(mtl_name) + '\n';
    std::size_t first = 1;  // OBJ counts from one
    for (const MeshSpace& space : mesh.spaces) {
        out.obj += "o " + word(space.name) + '\n';
        for (const MeshPart& part : space.parts) {
            out.obj += "usemtl " + word(mesh.materials[part.material].name) + '\n';
            append_part(out.obj, part, first);
            first += part.positions.size();
        }
    }
    return out;
}

}  // namespace enfilade::modeler
