#include <map>

#include "modeler/catalogue/face_triangles.h"
#include "modeler/catalogue/image_mean.h"
#include "modeler/catalogue/mtl.h"
#include "modeler/catalogue/picture.h"
#include "modeler/catalogue/read_model.h"
#include "modeler/meshes/mesh_readers.h"

namespace enfilade::modeler {
namespace {

using Library = std::map<std::string, MtlMaterial, std::less<>>;

/// The material libraries that the model names; several may stand in one line, or one with blanks in its name.
Library read_libraries(const FileTree& files, const std::string& model, const std::vector<std::string>& named,
                       bool& lacks_some) {
    Library all;
    const auto add = [&](const std::string& name) {
        const auto bytes = files.read(name_beside(model, name));
        if (!bytes) return false;
        all.merge(read_mtl(*bytes));  // of two materials with one name, the first file's is taken
        return true;
    };
    for (const std::string& line : named) {
        if (add(line)) continue;
        bool found = false;
        for (std::size_t at = 0; at < line.size();) {
            const std::size_t end = std::min(line.find(' ', at), line.size());
            if (end > at) found = add(line.substr(at, end - at)) || found;
            at = end + 1;
        }
        lacks_some = lacks_some || !found;
    }
    return all;
}

class Colours {
public:
    Colours(const FileTree& files, const std::string& model, ReadImages images, std::uint32_t texture_side,
            RawMesh& raw)
        : files_(files), model_(model), images_(images), texture_side_(texture_side), raw_(raw) {}

    /// The colour of a texture, or of the diffuse part where that cannot be had; what is mirrored and let through.
    void paint(RawMaterial& material, const MtlMaterial& found) {
        material.opacity = static_cast<float>(found.opacity);
        if (found.diffuse) material.colour = linear_colour(*found.diffuse);
        material.look.mirror = static_cast<float>(found.mirror * found.opacity);
        make_glass(material);
        if (found.image.empty() || images_ == ReadImages::No) return;
        const auto [at, is_new] = pictures_.try_emplace(found.image);
        if (is_new)
            if (const auto bytes = files_.read(name_beside(model_, found.image)))
                at->second = picture(found.image, *bytes);
        if (at->second.mean) material.colour = *at->second.mean;
        else ++raw_.unread_images;
        material.look.texture = at->second.texture;
    }

private:
    struct Known {
        std::optional<std::array<float, 3>> mean;
        std::uint32_t texture = UINT32_MAX;
    };

    Known picture(const std::string& name, std::string_view bytes) {
        Known known{mean_colour(bytes), UINT32_MAX};
        if (!known.mean || texture_side_ == 0) return known;
        if (auto texture = read_texture(name, bytes, texture_side_)) {
            known.texture = static_cast<std::uint32_t>(raw_.textures.size());
            raw_.textures.push_back(std::move(texture));
        }
        return known;
    }

    const FileTree& files_;
    const std::string& model_;
    ReadImages images_;
    std::uint32_t texture_side_;
    RawMesh& raw_;
    std::map<std::string, Known> pictures_;
};

}  // namespace

RawMesh read_obj_model(const FileTree& files, const std::string& name, std::string_view bytes, ReadImages images,
                       std::uint32_t texture_side) {
    const Mesh mesh = read_obj(bytes, name, true);
    RawMesh raw = triangulated(mesh);
    const Library library = read_libraries(files, name, mesh.material_files, raw.lacks_materials);
    Colours colours(files, name, images, texture_side, raw);
    for (RawMaterial& material : raw.materials) {
        if (const auto found = library.find(material.name); found != library.end()) {
            colours.paint(material, found->second);
        } else if (!material.name.empty()) {
            raw.lacks_materials = true;
            if (const auto colour = colour_of_name(material.name)) material.colour = linear_colour(*colour);
        }
    }
    drop_unused_texcoords(raw);
    return raw;
}

}  // namespace enfilade::modeler
