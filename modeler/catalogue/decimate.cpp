#include "modeler/catalogue/decimate.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <algorithm>
#include <cmath>
#include <string>

#include "modeler/catalogue/fit_mesh.h"
#include "modeler/catalogue/manifold.h"
#include "modeler/catalogue/nearest_surface.h"

namespace enfilade::modeler {
namespace {

struct Traits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;  // quadrics of a table top lose their zeros in floats
    using Normal = OpenMesh::Vec3d;
    VertexAttributes(OpenMesh::Attributes::Status);
    HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge | OpenMesh::Attributes::Status);
    EdgeAttributes(OpenMesh::Attributes::Status);
    FaceAttributes(OpenMesh::Attributes::Normal | OpenMesh::Attributes::Status);
};
/// Of the box's diagonal: how far a rim may move in one step.
constexpr double rim_share = 0.0005;

using TriMesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

/// Keeps the rims of open sheets: quadrics see no difference between a table top and half of it.
template <class MeshType>
class KeepRim : public OpenMesh::Decimater::ModBaseT<MeshType> {
public:
    DECIMATING_MODULE(KeepRim, MeshType, KeepRim);
    explicit KeepRim(MeshType& mesh) : Base(mesh, true) {}
    void set_limit(double limit) { limit_squared_ = limit * limit; }

    float collapse_priority(const CollapseInfo& info) override {
        MeshType& mesh = Base::mesh();
        if (!mesh.is_boundary(info.v0)) return Base::LEGAL_COLLAPSE;
        // v0 goes to v1 along the rim: how far is it from the side that takes its place?
        const auto out = mesh.halfedge_handle(info.v0);  // on the rim, where there is one
        const auto ahead = mesh.to_vertex_handle(out);
        const auto behind = mesh.from_vertex_handle(mesh.prev_halfedge_handle(out));
        const auto other = ahead == info.v1 ? behind : ahead;
        const auto a = mesh.point(other);
        const auto side = mesh.point(info.v1) - a;
        const auto from = mesh.point(info.v0) - a;
        const double length = side.sqrnorm();
        const double t = length > 0 ? std::clamp((from | side) / length, 0.0, 1.0) : 0.0;
        return (from - side * t).sqrnorm() <= limit_squared_ ? Base::LEGAL_COLLAPSE : Base::ILLEGAL_COLLAPSE;
    }

private:
    double limit_squared_ = 0;
};

using Decimater = OpenMesh::Decimater::DecimaterT<TriMesh>;

/// Triangles with two corners at one vertex are seen from nowhere; without them the rest may be a manifold.
ObjectMesh without_collapsed(ObjectMesh mesh) {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto [a, b, c] = mesh.triangles[t];
        if (a == b || b == c || c == a) continue;
        mesh.triangle_materials[kept] = mesh.triangle_materials[t];
        mesh.triangles[kept++] = {a, b, c};
    }
    mesh.triangles.resize(kept);
    mesh.triangle_materials.resize(kept);
    return mesh;
}

/// OpenMesh complains on the terminal about what is no manifold: it is asked only for what it can take.
std::string fill(const ObjectMesh& from, TriMesh& to, OpenMesh::FPropHandleT<std::uint32_t> material) {
    if (const std::string why = why_no_manifold(from); !why.empty()) return why;
    std::vector<TriMesh::VertexHandle> handles;
    handles.reserve(from.vertices.size());
    for (const auto& v : from.vertices) handles.push_back(to.add_vertex({v[0], v[1], v[2]}));
    for (std::size_t t = 0; t < from.triangles.size(); ++t) {
        const auto& [a, b, c] = from.triangles[t];
        const auto face = to.add_face(handles[a], handles[b], handles[c]);
        if (!face.is_valid()) return "OpenMesh does not take triangle " + std::to_string(t);
        to.property(material, face) = from.triangle_materials[t];
    }
    return {};
}

void lock_material_borders(TriMesh& mesh, OpenMesh::FPropHandleT<std::uint32_t> material) {
    for (const auto edge : mesh.edges()) {
        if (mesh.is_boundary(edge)) continue;
        const auto half = mesh.halfedge_handle(edge, 0);
        const auto left = mesh.face_handle(half);
        const auto right = mesh.face_handle(mesh.opposite_halfedge_handle(half));
        if (mesh.property(material, left) == mesh.property(material, right)) continue;
        mesh.status(mesh.to_vertex_handle(half)).set_locked(true);
        mesh.status(mesh.from_vertex_handle(half)).set_locked(true);
    }
}

/// What is left, in the order in which it was.
ObjectMesh taken_back(const TriMesh& from, OpenMesh::FPropHandleT<std::uint32_t> material, ObjectMesh whole) {
    std::vector<std::uint32_t> number(from.n_vertices(), UINT32_MAX);
    ObjectMesh mesh;
    mesh.name = std::move(whole.name);
    mesh.materials = std::move(whole.materials);
    // Collapsed edges take no care of where textures lie: their means show.
    for (ObjectMaterial& kept : mesh.materials) kept.look.texture = UINT32_MAX;
    for (const auto face : from.all_faces()) {
        if (from.status(face).deleted()) continue;
        std::array<std::uint32_t, 3> corners{};
        std::size_t k = 0;
        for (auto at = from.cfv_iter(face); at.is_valid() && k < 3; ++at, ++k) {
            const auto v = static_cast<std::size_t>(at->idx());
            if (number[v] == UINT32_MAX) {
                number[v] = static_cast<std::uint32_t>(mesh.vertices.size());
                mesh.vertices.push_back(whole.vertices[v]);
            }
            corners[k] = number[v];
        }
        mesh.triangles.push_back(corners);
        mesh.triangle_materials.push_back(from.property(material, face));
    }
    return mesh;
}

}  // namespace

LoadedMesh decimated(ObjectMesh mesh, std::uint32_t triangles) {
    LoadedMesh loaded;
    loaded.triangles_before = static_cast<std::uint32_t>(mesh.triangles.size());
    if (triangles == 0 || mesh.triangles.size() <= triangles) {
        loaded.mesh = std::move(mesh);
        return loaded;
    }
    TriMesh work;
    OpenMesh::FPropHandleT<std::uint32_t> material;
    work.add_property(material);
    loaded.refused = fill(without_collapsed(mesh), work, material);
    if (!loaded.refused.empty()) {
        loaded.mesh = std::move(mesh);
        return loaded;
    }
    lock_material_borders(work, material);
    work.update_face_normals();
    Decimater decimater(work);
    OpenMesh::Decimater::ModQuadricT<TriMesh>::Handle quadric;
    OpenMesh::Decimater::ModNormalFlippingT<TriMesh>::Handle flipping;
    KeepRim<TriMesh>::Handle rim;
    decimater.add(quadric);
    decimater.add(flipping);
    decimater.add(rim);
    decimater.module(quadric).unset_max_err();
    decimater.module(flipping).set_max_normal_deviation(80);
    const MeshBox box = box_of(mesh);
    decimater.module(rim).set_limit(rim_share * std::hypot(box.side(0), box.side(1), box.side(2)));
    decimater.initialize();
    decimater.decimate_to_faces(0, triangles);
    ObjectMesh reduced = taken_back(work, material, mesh);
    if (reduced.triangles.size() > triangles)
        loaded.refused = "its rims, its borders between materials or its folds leave " +
                         std::to_string(reduced.triangles.size()) + " triangles";
    loaded.error = surface_distance(mesh, reduced);
    loaded.mesh = std::move(reduced);
    return loaded;
}

}  // namespace enfilade::modeler
