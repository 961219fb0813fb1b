#pragma once
// Meshes for the plan's own pieces.

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "modeler/catalogue/catalogue.h"
#include "modeler/objects/furnishing.h"
#include "plans/plan.h"

namespace enfilade::modeler {

/// Where a piece's mesh came from.
enum class ModelSource {
    Named,  ///< the entry that the plan names
    Own,    ///< our own piece of the kind that its name tells
    Box     ///< a plain box
};

struct PieceModel {
    std::uint32_t mesh = 0;  ///< into `PieceModels::meshes`
    std::string id;          ///< of its catalogue entry
    ModelSource source = ModelSource::Named;
    bool is_turned = false;  ///< by its library already: the plan's rotation is that of another file's mesh
    std::string unread;      ///< why the entry that the plan names could not be read; else empty
};

/// Loads each mesh once, and once more for each set of other colours.
class PieceModels {
public:
    explicit PieceModels(const Catalogue& catalogue) : catalogue_(catalogue) {}
    [[nodiscard]] PieceModel of(const plans::Furniture& piece);
    [[nodiscard]] std::vector<std::shared_ptr<const ObjectMesh>>& meshes() { return meshes_; }

private:
    using Overrides = std::vector<std::pair<std::string, std::array<float, 3>>>;

    std::uint32_t loaded(const CatalogueEntry& entry, const Overrides& overrides);
    std::uint32_t box_mesh();
    [[nodiscard]] const CatalogueEntry* own_piece(const plans::Furniture& piece) const;

    const Catalogue& catalogue_;
    std::vector<std::shared_ptr<const ObjectMesh>> meshes_;
    std::map<std::pair<std::string, Overrides>, std::uint32_t> known_;
    std::map<std::string, std::string> unreadable_;  ///< entry -> why
};

}  // namespace enfilade::modeler
