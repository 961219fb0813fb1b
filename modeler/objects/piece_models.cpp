#include "modeler/objects/piece_models.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "modeler/catalogue/kind_words.h"
#include "modeler/catalogue/own_pieces.h"

namespace enfilade::modeler {
namespace {

constexpr const char* box_id = "box";

/// How much a mesh would have to be stretched.
double stretch(const CatalogueEntry& entry, const plans::Furniture& piece) {
    return std::abs(std::log(piece.width / entry.width)) + std::abs(std::log(piece.depth / entry.depth)) +
           std::abs(std::log(piece.height / entry.height));
}

}  // namespace

PieceModel PieceModels::of(const plans::Furniture& piece) {
    Overrides overrides;
    for (const plans::FurnitureMaterial& material : piece.materials)
        overrides.emplace_back(material.name, material.colour);
    PieceModel model;
    const auto take = [&](const CatalogueEntry* entry, const Overrides& colours) {
        if (entry == nullptr) return false;
        if (const auto failed = unreadable_.find(entry->id); failed != unreadable_.end()) {
            model.unread = failed->second;
            return false;
        }
        try {
            model.mesh = loaded(*entry, colours);
        } catch (const InputError& error) {
            model.unread = unreadable_.emplace(entry->id, error.what()).first->second;
            return false;
        }
        model.id = entry->id;
        return true;
    };
    if (take(piece.model.empty() ? nullptr : catalogue_.find(piece.model), overrides)) return model;
    if (take(piece.catalogue.empty() ? nullptr : catalogue_.find(piece.catalogue), overrides)) {
        model.is_turned = true;
        return model;
    }
    model.is_turned = true;
    model.source = ModelSource::Own;
    if (take(own_piece(piece), {})) return model;
    model.source = ModelSource::Box;
    model.id = box_id;
    model.mesh = box_mesh();
    return model;
}

const CatalogueEntry* PieceModels::own_piece(const plans::Furniture& piece) const {
    const std::string kind = kind_of_piece({.name = piece.name,
                                            .id = piece.catalogue.empty() ? piece.model : piece.catalogue,
                                            .category = {},
                                            .width = piece.width,
                                            .depth = piece.depth,
                                            .height = piece.height,
                                            .elevation = piece.elevation});
    if (kind.empty()) return nullptr;
    const OwnPiece* best = nullptr;
    for (const OwnPiece& own : own_pieces())
        if (own.entry.kind == kind && (best == nullptr || stretch(own.entry, piece) < stretch(best->entry, piece)))
            best = &own;
    return best != nullptr ? catalogue_.find(best->entry.id) : nullptr;
}

std::uint32_t PieceModels::loaded(const CatalogueEntry& entry, const Overrides& overrides) {
    const auto known = known_.find({entry.id, overrides});
    if (known != known_.end()) return known->second;
    ObjectMesh mesh = catalogue_.load(entry).mesh;
    for (ObjectMaterial& material : mesh.materials)
        for (const auto& [name, colour] : overrides)
            if (material.name == name) {
                material.colour = colour;
                material.look.texture = UINT32_MAX;
                material.name += " (" + std::to_string(int(std::lround(255 * colour[0]))) + ", " +
                                 std::to_string(int(std::lround(255 * colour[1]))) + ", " +
                                 std::to_string(int(std::lround(255 * colour[2]))) + ")";
                break;
            }
    const auto number = std::uint32_t(meshes_.size());
    meshes_.push_back(std::make_shared<const ObjectMesh>(std::move(mesh)));
    known_.emplace(std::pair(entry.id, overrides), number);
    return number;
}

std::uint32_t PieceModels::box_mesh() {
    const auto [at, is_new] = known_.try_emplace({box_id, {}}, std::uint32_t(meshes_.size()));
    if (!is_new) return at->second;
    ObjectMesh mesh;
    mesh.name = box_id;
    for (int k = 0; k < 8; ++k)
        mesh.vertices.push_back({(k & 1) ? 0.5f : -0.5f, (k & 2) ? 0.5f : -0.5f, (k & 4) ? 1.0f : 0.0f});
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    mesh.triangle_materials.assign(mesh.triangles.size(), 0);
    mesh.materials = {{"unknown piece", {0.6f, 0.6f, 0.6f}}};
    meshes_.push_back(std::make_shared<const ObjectMesh>(std::move(mesh)));
    return at->second;
}

}  // namespace enfilade::modeler
