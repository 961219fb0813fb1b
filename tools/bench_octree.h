#pragma once
// What the benchmarks of octrees share (bench_octree*.cpp): single meshes, rays through them, Embree's answers and the
// judge's.

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "accel/octree/octree.h"
#include "accel/scene.h"
#include "render/object_tracer.h"
#include "tools/bench.h"

namespace enfilade::tools {

/// How triangles lie in their box: what makes octrees and trees of boxes differ.
enum class MeshKind { Compact, Thin, Clustered, Flat };
[[nodiscard]] const char* name_of(MeshKind kind);

/// One mesh, in a box about the origin whose longest side is 2. Move-only: its view points into it.
class BenchMesh {
public:
    /// Corners name places. Moves and scales them into the box.
    BenchMesh(std::string name, MeshKind kind, const std::vector<std::array<double, 3>>& places,
              const std::vector<std::array<std::uint32_t, 3>>& triangles);
    BenchMesh(BenchMesh&&) = default;
    BenchMesh& operator=(BenchMesh&&) = default;

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] MeshKind kind() const { return kind_; }
    [[nodiscard]] std::size_t triangle_count() const { return view_.mesh_triangles.size(); }
    /// Its name with its size: "bunny, 69k".
    [[nodiscard]] std::string title() const;
    /// A scene of one mesh and one object, of which nothing else is there: enough for build_object_accel.
    [[nodiscard]] const accel::SceneView& view() const { return view_; }
    /// What builders of octrees read: triangles with area.
    [[nodiscard]] accel::MeshPart part() const { return {places_.data(), triangles_.data(), used_}; }
    [[nodiscard]] const accel::ObjectMesh& mesh() const { return meshes_.front(); }

private:
    std::string name_;
    MeshKind kind_;
    std::vector<accel::Vertex> places_;
    std::vector<accel::MeshTriangle> triangles_;
    std::vector<std::uint32_t> used_;
    std::vector<accel::ObjectMesh> meshes_;
    std::vector<accel::PlacedObject> objects_;
    std::vector<accel::ObjectId> listed_;
    accel::SceneView view_;
};

/// A mesh that the benchmarks trace, made or read when it is its turn.
struct MeshSource {
    std::string name;
    MeshKind kind;
    std::filesystem::path file = {};  ///< empty: made here
    std::uint32_t triangles = 0;      ///< about as many are made
    bool is_quick = false;            ///< also part of short runs
    bool is_studied = false;          ///< under several depths and sizes of leaves
    bool is_papers = false;           ///< in its tables
    bool has_limit = false;           ///< what it would cost without waiting for memory
};
/// Meshes of other people that lie in `data`/mesh, then ours, which are always there.
[[nodiscard]] std::vector<MeshSource> mesh_sources();
/// Nothing where its file is not there, with a remark. \throws InputError (K...) if it cannot be read
[[nodiscard]] std::optional<BenchMesh> mesh_of(const MeshSource& source, Bench& bench);

struct BenchRay {
    std::array<float, 3> origin, direction;
};

/// The questions that are timed.
enum class RayCase { OneCoherent, OneApart, AnyApart, SixteenCoherent, SixteenApart };
inline constexpr std::array ray_cases = {RayCase::OneCoherent, RayCase::OneApart, RayCase::AnyApart,
                                         RayCase::SixteenCoherent, RayCase::SixteenApart};
[[nodiscard]] const char* name_of(RayCase what);
[[nodiscard]] constexpr bool is_coherent(RayCase what) {
    return what == RayCase::OneCoherent || what == RayCase::SixteenCoherent;
}

/// Rays in the forms that tracers take, so that no time goes into packing. Counts are multiples of 16.
struct RayStream {
    std::vector<BenchRay> rays;
    std::vector<render::ObjectRays> packs;

    explicit RayStream(std::vector<BenchRay> rays_);
    [[nodiscard]] std::size_t size() const { return rays.size(); }
};
[[nodiscard]] render::ObjectRay object_ray(const BenchRay& ray);

/// Primary rays from eight views around the box, side x side pixels each, in tiles of 4 x 4: 16 in a row are
/// neighbours. side: a multiple of 4
[[nodiscard]] std::vector<BenchRay> view_rays(int side);
/// `count` rays in no order: half of them leave what the views see as light does from a white surface, the others are
/// chords of the sphere around the box. \pre views: view_rays; tracer finds what they see
[[nodiscard]] std::vector<BenchRay> apart_rays(const std::vector<BenchRay>& views, const render::ObjectTracer& tracer,
                                               std::size_t count);

/// Asks all rays of the stream; how many of them hit.
std::size_t ask(const render::ObjectTracer& tracer, RayCase what, const RayStream& stream);

/// What was found: `any` says nothing of the triangle and nothing of where.
struct MeshAnswer {
    float distance;
    std::uint32_t triangle;  ///< no_triangle: none
};
[[nodiscard]] std::vector<MeshAnswer> answers_of(const render::ObjectTracer& tracer, RayCase what,
                                                 const RayStream& stream);

/// Embree's tree over a mesh, asked as our own.
class EmbreeMesh {
public:
    enum class Quality { Medium, High };  ///< High: triangles may be in several leaves
    /// On all of Embree's threads. \throws IoError if Embree fails
    EmbreeMesh(const accel::SceneView& scene, Quality quality);
    ~EmbreeMesh();
    EmbreeMesh(const EmbreeMesh&) = delete;
    EmbreeMesh& operator=(const EmbreeMesh&) = delete;
    [[nodiscard]] render::ObjectTracer tracer() const;
    [[nodiscard]] std::size_t bytes() const;
    [[nodiscard]] double build_seconds() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Every triangle of a mesh in double: which answers rounding explains. Slow, and shares nothing with the tracers.
class MeshJudge {
public:
    explicit MeshJudge(const BenchMesh& mesh);
    /// Whether the ray may rightly be answered so.
    [[nodiscard]] bool allows(const BenchRay& ray, const MeshAnswer& answer) const;

private:
    struct Corner {
        double x, y, z;
    };
    std::vector<std::array<Corner, 3>> triangles_;
};

/// How octrees answered a stream.
struct Verdict {
    std::size_t rays = 0;      ///< answered
    std::size_t judged = 0;    ///< by the judge: some at random, and those that Embree answers otherwise
    std::size_t unlike = 0;    ///< answered otherwise by Embree
    std::size_t wrong = 0;     ///< of those judged
    std::size_t disagree = 0;  ///< answered otherwise than one ray at a time, exactly compared
};
/// Of all ways to ask, on both streams. tests: the judge looks at no more triangles than that
[[nodiscard]] Verdict judged(const BenchMesh& mesh, const render::ObjectTracer& octree,
                             const render::ObjectTracer& embree, const RayStream& coherent, const RayStream& apart,
                             std::size_t tests);

/// Depth and leaf size against time, memory and answers: silent rows, and a remark.
void bench_octree_study(Bench& bench, const BenchMesh& mesh);
/// Tables 1 and 3 of the paper: silent rows, and a remark.
void bench_octree_paper(Bench& bench, const BenchMesh& mesh);
/// Wrong exits by depth and offset, and what walks make of them (exit_study.h): silent rows, and remarks.
void bench_octree_exits(Bench& bench);
/// What rays do, and what they would cost if memory answered at once: silent rows, and remarks.
void bench_octree_limit(Bench& bench, const BenchMesh& mesh);

}  // namespace enfilade::tools
