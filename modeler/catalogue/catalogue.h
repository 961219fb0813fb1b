#pragma once
// Where furniture comes from: our own pieces, libraries of Sweet Home 3D, folders of meshes, in one list.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "accel/parallel_for.h"
#include "base/finding.h"
#include "modeler/catalogue/object_mesh.h"

namespace enfilade::modeler {

struct CatalogueEntry {
    std::string id;        ///< its own in the whole catalogue: "own/chair", "eTeks#bed", "meshes/bunny.ply"
    std::string name;      ///< for people: "Office chair"
    std::string kind;      ///< what rules ask for: "chair", "bed" ... (docs/furnishing.md); empty: no rule takes it
    std::string category;  ///< of its library; may be empty
    double width = 1;      ///< metres: of its box, as `load` gives it
    double depth = 1;
    double height = 1;
    double elevation = 0;         ///< of its bottom above the floor, where it is made to hang or to stand on something
    std::optional<double> top;    ///< where other things may stand on it, above its bottom
    std::uint32_t triangles = 0;  ///< before it is decimated; 0 (of homes alone): there is nothing to see
    MeshDefects defects;
    std::string source;   ///< the library or folder
    std::string creator;  ///< may be empty
    std::string licence;  ///< may be empty
};

struct CatalogueOptions {
    std::uint32_t detail = 1;            ///< of our own pieces: 1 plain, 2, 3 ... rounder and finer
    std::uint32_t object_triangles = 0;  ///< meshes of more are decimated to this where they can be; 0: never
    std::uint32_t texture_side = 1024;   ///< pictures have at most that many texels a side; 0: their mean colours alone
    std::filesystem::path cache;         ///< folder of the index; empty: `default_cache()`
    bool use_cache = true;
};

/// $XDG_CACHE_HOME/enfilade, or ~/.cache/enfilade; empty where there is no home.
[[nodiscard]] std::filesystem::path default_cache();

/// What a library or a mesh was found to be.
struct LoadedMesh {
    ObjectMesh mesh;
    std::uint32_t triangles_before = 0;  ///< as the file has it
    double error = 0;                    ///< metres: how far decimation moved the surface, 0 where nothing was done
    std::string refused;                 ///< why it has more triangles than asked for; else empty
};

class Catalogue {
public:
    /// Our own pieces alone (kind by kind, docs/furnishing.md).
    explicit Catalogue(const CatalogueOptions& options = {});
    ~Catalogue();
    Catalogue(Catalogue&&) noexcept;
    Catalogue& operator=(Catalogue&&) noexcept;

    /// Adds a `.sh3f` library, a `.sh3d` home (the models of its pieces, by their name in the file), a mesh (OBJ, glTF,
    /// GLB, PLY, OFF, STL) or a folder of meshes. The index is built once and kept in the cache, by path, size and
    /// time. What could not be used is told in `findings()`. Entries found before move. The executor reads models side
    /// by side where the index is not kept; what is found does not depend on it. \throws InputError (codes K1...) where
    /// nothing can be used; homes without furniture are fine
    void add(const std::filesystem::path& path, const accel::Executor& executor = accel::SerialExecutor());

    /// By ascending id, within each source; our own pieces last: what was added is preferred.
    [[nodiscard]] std::span<const CatalogueEntry> entries() const;
    /// The entry of that id; or, for homes, that a plan names as `model`. nullptr where there is none.
    [[nodiscard]] const CatalogueEntry* find(std::string_view id) const;
    /// The model of that name in the home that was added as `source` (CatalogueEntry::source): several homes call their
    /// models by the same names.
    [[nodiscard]] const CatalogueEntry* find_in(std::string_view source, std::string_view model) const;
    /// Entries of a kind, in the order of `entries()`.
    [[nodiscard]] std::vector<const CatalogueEntry*> of_kind(std::string_view kind) const;
    /// The mesh, read now, or from the cache. The same for the same entry and options; may be called from several
    /// threads at once. Our own pieces are never decimated: `detail` says how fine they are. \throws InputError (K...)
    /// if it cannot be read
    [[nodiscard]] LoadedMesh load(const CatalogueEntry& entry) const;
    [[nodiscard]] std::span<const Finding> findings() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace enfilade::modeler
