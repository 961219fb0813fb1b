#include <assimp/GltfMaterial.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstring>
#include <map>

#include "base/error.h"
#include "modeler/catalogue/image_mean.h"
#include "modeler/catalogue/picture.h"
#include "modeler/catalogue/read_model.h"

namespace enfilade::modeler {
namespace {

constexpr std::size_t max_triangles = std::size_t{1} << 26;  ///< with every instance of a mesh

class Stream final : public Assimp::IOStream {
public:
    explicit Stream(std::string bytes) : bytes_(std::move(bytes)) {}
    size_t Read(void* into, size_t size, size_t count) override {
        if (size == 0) return 0;
        const std::size_t whole = std::min(count, (bytes_.size() - at_) / size);
        std::memcpy(into, bytes_.data() + at_, whole * size);
        at_ += whole * size;
        return whole;
    }
    size_t Write(const void*, size_t, size_t) override { return 0; }
    aiReturn Seek(size_t offset, aiOrigin origin) override {
        const std::size_t from = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? at_ : bytes_.size();
        if (offset > bytes_.size() - from) return aiReturn_FAILURE;
        at_ = from + offset;
        return aiReturn_SUCCESS;
    }
    [[nodiscard]] size_t Tell() const override { return at_; }
    [[nodiscard]] size_t FileSize() const override { return bytes_.size(); }
    void Flush() override {}

private:
    std::string bytes_;
    std::size_t at_ = 0;
};

/// The model's own bytes, and what it names beside itself; nothing else of this machine.
class Files final : public Assimp::IOSystem {
public:
    Files(const FileTree& tree, std::string root, std::string_view bytes)
        : tree_(tree), root_(std::move(root)), bytes_(bytes) {}
    bool Exists(const char* file) const override { return bytes_of(file).has_value(); }
    [[nodiscard]] char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* file, const char* mode) override {
        if (std::strpbrk(mode, "wa+") != nullptr) return nullptr;
        auto bytes = bytes_of(file);
        return bytes ? new Stream(std::move(*bytes)) : nullptr;  // assimp hands it to Close
    }
    void Close(Assimp::IOStream* stream) override { delete stream; }

private:
    [[nodiscard]] std::optional<std::string> bytes_of(const char* file) const {
        if (root_ == file) return std::string(bytes_);
        return tree_.read(name_beside("", file));
    }

    const FileTree& tree_;
    std::string root_;
    std::string_view bytes_;
};

using Matrix = std::array<std::array<double, 4>, 3>;

Matrix times(const Matrix& a, const aiMatrix4x4& b) {
    Matrix product{};
    for (unsigned i = 0; i < 3; ++i)
        for (unsigned j = 0; j < 4; ++j) {
            product[i][j] = j == 3 ? a[i][3] : 0;
            for (unsigned k = 0; k < 3; ++k) product[i][j] += a[i][k] * double(b[k][j]);
        }
    return product;
}

std::array<double, 3> moved_by(const Matrix& m, const aiVector3D& p) {
    std::array<double, 3> out;
    for (std::size_t i = 0; i < 3; ++i) out[i] = m[i][0] * p.x + m[i][1] * p.y + m[i][2] * p.z + m[i][3];
    return out;
}

class Conversion {
public:
    Conversion(const aiScene& scene, const FileTree& files, const std::string& name, ReadImages images,
               std::uint32_t texture_side)
        : scene_(scene), files_(files), name_(name), images_(images), texture_side_(texture_side) {}

    RawMesh run() {
        raw_.up = UpAxis::Y;
        raw_.in_metres = true;
        for (unsigned m = 0; m < scene_.mNumMaterials; ++m) raw_.materials.push_back(material(*scene_.mMaterials[m]));
        if (raw_.materials.empty()) raw_.materials.emplace_back();
        struct Visit {
            const aiNode* node;
            Matrix matrix;
        };
        const Matrix identity = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
        std::vector<Visit> open;
        if (scene_.mRootNode != nullptr) open.push_back({scene_.mRootNode, identity});
        while (!open.empty()) {
            const Visit visit = open.back();
            open.pop_back();
            const Matrix matrix = times(visit.matrix, visit.node->mTransformation);
            for (unsigned k = 0; k < visit.node->mNumMeshes; ++k) add(*scene_.mMeshes[visit.node->mMeshes[k]], matrix);
            for (unsigned k = visit.node->mNumChildren; k > 0; --k)
                open.push_back({visit.node->mChildren[k - 1], matrix});
        }
        drop_unused_texcoords(raw_);
        return std::move(raw_);
    }

private:
    RawMaterial material(const aiMaterial& from) {
        RawMaterial to;
        aiString text;
        if (from.Get(AI_MATKEY_NAME, text) == aiReturn_SUCCESS) to.name = text.C_Str();
        aiColor4D base;
        const bool has_base = from.Get(AI_MATKEY_BASE_COLOR, base) == aiReturn_SUCCESS ||
                              from.Get(AI_MATKEY_COLOR_DIFFUSE, base) == aiReturn_SUCCESS;
        if (has_base) to.colour = {clamped(base.r), clamped(base.g), clamped(base.b)};  // linear already
        if (has_base && from.Get(AI_MATKEY_GLTF_ALPHAMODE, text) == aiReturn_SUCCESS &&
            std::string_view(text.C_Str()) == "BLEND")
            to.opacity = clamped(base.a);
        make_glass(to);
        if (images_ == ReadImages::No) return to;
        if (from.GetTexture(aiTextureType_BASE_COLOR, 0, &text) != aiReturn_SUCCESS &&
            from.GetTexture(aiTextureType_DIFFUSE, 0, &text) != aiReturn_SUCCESS)
            return to;
        const auto bytes = texture_bytes(text.C_Str());
        const auto mean = bytes ? mean_colour(*bytes) : std::nullopt;
        if (!mean) {
            ++raw_.unread_images;
            return to;
        }
        const bool is_white = to.colour == std::array<float, 3>{1, 1, 1};
        for (std::size_t k = 0; k < 3; ++k) to.colour[k] *= (*mean)[k];
        // One whose texels are multiplied by another colour shows their mean.
        if (texture_side_ > 0 && (is_white || !has_base)) to.look.texture = texture_number(text.C_Str(), *bytes);
        return to;
    }

    /// Each picture once.
    std::uint32_t texture_number(const std::string& name, std::string_view bytes) {
        const auto [at, is_new] = textures_.try_emplace(name, UINT32_MAX);
        if (!is_new) return at->second;
        if (auto texture = read_texture(name, bytes, texture_side_)) {
            at->second = static_cast<std::uint32_t>(raw_.textures.size());
            raw_.textures.push_back(std::move(texture));
        }
        return at->second;
    }

    static float clamped(float value) { return value >= 0 ? std::min(value, 1.0f) : 0; }

    [[nodiscard]] std::optional<std::string> texture_bytes(const char* texture) const {
        if (const aiTexture* inside = scene_.GetEmbeddedTexture(texture)) {
            if (inside->mHeight != 0) return std::nullopt;  // raw pixels: no importer of glTF gives them
            return std::string(reinterpret_cast<const char*>(inside->pcData), inside->mWidth);
        }
        return files_.read(name_beside(name_, texture));
    }

    void add(const aiMesh& mesh, const Matrix& matrix) {
        if (raw_.triangles.size() + mesh.mNumFaces > max_triangles)
            throw InputError("K107", files_.title(),
                             "The model " + name_ +
                                 " cannot be used: with all instances of its "
                                 "meshes it has more than 67 million triangles.");
        const auto first = static_cast<std::uint32_t>(raw_.points.size());
        for (unsigned v = 0; v < mesh.mNumVertices; ++v) raw_.points.push_back(moved_by(matrix, mesh.mVertices[v]));
        const std::uint32_t material =
            std::min<std::uint32_t>(mesh.mMaterialIndex, static_cast<std::uint32_t>(raw_.materials.size() - 1));
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const aiFace& face = mesh.mFaces[f];
            if (face.mNumIndices != 3) {
                ++raw_.lines;
                continue;
            }
            std::array<std::uint32_t, 3> corners;
            bool sound = true;
            for (unsigned k = 0; k < 3; ++k) {
                sound = sound && face.mIndices[k] < mesh.mNumVertices;
                corners[k] = first + face.mIndices[k];
            }
            for (std::size_t k = 0; sound && k < 3; ++k) sound = is_finite(raw_.points[corners[k]]);
            if (!sound) {
                ++raw_.dropped;
                continue;
            }
            raw_.triangles.push_back(corners);
            raw_.triangle_materials.push_back(material);
            for (std::size_t k = 0; k < 3; ++k) raw_.texcoords.push_back(texcoord(mesh, face.mIndices[k]));
        }
    }

    /// The reader has v grow upward, as OBJ does.
    static std::array<float, 2> texcoord(const aiMesh& mesh, unsigned v) {
        constexpr float most_repeats = 1e5f;
        if (!mesh.HasTextureCoords(0)) return {0, 0};
        const aiVector3D& at = mesh.mTextureCoords[0][v];
        const bool is_sound = std::abs(at.x) <= most_repeats && std::abs(at.y) <= most_repeats;
        return is_sound ? std::array<float, 2>{at.x, at.y} : std::array<float, 2>{0, 0};
    }

    static bool is_finite(const std::array<double, 3>& p) {
        return std::all_of(p.begin(), p.end(), [](double x) { return std::abs(x) <= 1e12; });
    }

    const aiScene& scene_;
    const FileTree& files_;
    const std::string& name_;
    ReadImages images_;
    std::uint32_t texture_side_;
    std::map<std::string, std::uint32_t> textures_;
    RawMesh raw_;
};

/// The reason as its reader has it, but in words of the file that was given.
std::string why_unread(std::string reason, const std::string& root) {
    // What the reader says where a file does not even begin as glTF does.
    if (reason.empty() || reason.find("No suitable reader") != std::string::npos)
        return "it is damaged, or no glTF; export it again.";
    for (const std::string& given : {'"' + root + '"', root})
        for (std::size_t at = reason.find(given); at != std::string::npos; at = reason.find(given, at))
            reason.replace(at, given.size(), "it");
    constexpr std::string_view before = "GLTF: ";
    if (reason.starts_with(before)) reason.erase(0, before.size());
    return reason + (reason.ends_with('.') ? "" : ".");
}

}  // namespace

RawMesh read_gltf_model(const FileTree& files, const std::string& name, std::string_view bytes, ReadImages images,
                        std::uint32_t texture_side) {
    // assimp goes by the extension; archives may have given another.
    const std::string root = name_beside(name, bytes.starts_with("glTF") ? "model.glb" : "model.gltf");
    Assimp::Importer importer;
    importer.SetIOHandler(new Files(files, root, bytes));  // which the importer deletes
    // No step of post-processing: each of them may weld, drop or reorder.
    const aiScene* scene = importer.ReadFile(root, 0);
    if (scene == nullptr)
        throw InputError("K107", files.title(),
                         "The model " + name + " cannot be used: " + why_unread(importer.GetErrorString(), root));
    return Conversion(*scene, files, name, images, texture_side).run();
}

}  // namespace enfilade::modeler
