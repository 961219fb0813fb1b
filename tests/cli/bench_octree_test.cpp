// What the benchmark of octrees is made of: its meshes, its rays, its judge, and the counter of instructions.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/executor.h"
#include "tools/bench_octree.h"
#include "tools/counted_instructions.h"
#include "tools/examples.h"

namespace enfilade::tools {
namespace {

/// Two squares across the x axis, at -0.5 (triangles 0 and 1) and at 0.5 (2 and 3).
BenchMesh two_squares() {
    return {"squares",
            MeshKind::Flat,
            {{-0.5, -1, -1},
             {-0.5, 1, -1},
             {-0.5, 1, 1},
             {-0.5, -1, 1},
             {0.5, -1, -1},
             {0.5, 1, -1},
             {0.5, 1, 1},
             {0.5, -1, 1}},
            {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}}};
}

BenchMesh made(const char* name, MeshKind kind, std::uint32_t triangles) {
    const Console console(true, false);
    Bench bench(console, true, "no/folder");
    return std::move(*mesh_of({.name = name, .kind = kind, .triangles = triangles}, bench));
}

TEST(MeshJudge, AllowsTheNearestTriangleAlone) {
    const MeshJudge judge(two_squares());
    const BenchRay ray = {{-2, 0.25f, 0}, {1, 0, 0}};
    EXPECT_TRUE(judge.allows(ray, {1.5f, 0}));
    EXPECT_FALSE(judge.allows(ray, {2.5f, 2}));                     // the first square is nearer
    EXPECT_FALSE(judge.allows(ray, {1.5f, 1}));                     // beside it
    EXPECT_FALSE(judge.allows(ray, {1.4f, 0}));                     // not there
    EXPECT_FALSE(judge.allows(ray, {1e30f, render::no_triangle}));  // not missed
    EXPECT_TRUE(judge.allows({{-2, 3, 0}, {1, 0, 0}}, {1e30f, render::no_triangle}));
}

TEST(MeshJudge, AllowsBothSidesOfAnEdge) {
    const MeshJudge judge(two_squares());
    const BenchRay ray = {{-2, 0.25f, 0.25f}, {1, 0, 0}};  // through the diagonal
    EXPECT_TRUE(judge.allows(ray, {1.5f, 0}));
    EXPECT_TRUE(judge.allows(ray, {1.5f, 1}));
    EXPECT_FALSE(judge.allows(ray, {2.5f, 2}) && judge.allows(ray, {2.5f, 0}));
}

TEST(BenchMesh, FitsItsBoxAndHasAboutAsManyTriangles) {
    for (const MeshSource& source : mesh_sources()) {
        if (!source.file.empty() || source.triangles > 50'000) continue;
        const BenchMesh mesh = made(source.name.c_str(), source.kind, source.triangles);
        EXPECT_NEAR(double(mesh.triangle_count()), source.triangles, 0.2 * source.triangles) << source.name;
        float largest = 0;
        for (const auto& v : mesh.view().mesh_vertices)
            largest = std::max({largest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
        EXPECT_NEAR(largest, 1, 1e-5) << source.name;
    }
}

TEST(BenchMesh, RemarksThatAFileIsNotThere) {
    const Console console(true, false);
    Bench bench(console, true, "no/folder");
    EXPECT_FALSE(mesh_of({.name = "bunny", .kind = MeshKind::Compact, .file = "none.obj"}, bench).has_value());
}

TEST(OctreeRays, SixteenOfAViewAreNeighbours) {
    const std::vector<BenchRay> rays = view_rays(16);
    ASSERT_EQ(rays.size(), 8u * 16 * 16);
    for (std::size_t i = 0; i < rays.size(); i += 16)
        for (std::size_t k = 1; k < 16; ++k) {
            EXPECT_EQ(rays[i].origin, rays[i + k].origin);
            for (std::size_t axis = 0; axis < 3; ++axis)
                EXPECT_NEAR(rays[i].direction[axis], rays[i + k].direction[axis], 3.5 * 0.72 / 16 * std::sqrt(2));
        }
}

TEST(OctreeRays, AnswersOfOctreesAreRightInEveryWay) {
    for (const auto& [name, kind] :
         {std::pair{"plant", MeshKind::Thin}, std::pair{"many balls", MeshKind::Clustered}}) {
        const BenchMesh mesh = made(name, kind, 4'000);
        const accel::SerialExecutor one;
        const auto octree = render::build_object_accel(mesh.view(), render::ObjectAccelKind::Octree, one);
        const EmbreeMesh embree(mesh.view(), EmbreeMesh::Quality::High);
        const RayStream coherent(view_rays(16));
        const RayStream apart(apart_rays(coherent.rays, embree.tracer(), coherent.size()));
        ASSERT_EQ(apart.size(), coherent.size());
        const Verdict verdict = judged(mesh, octree->tracer(), embree.tracer(), coherent, apart, 2'000'000);
        EXPECT_EQ(verdict.rays, coherent.size() + apart.size());
        EXPECT_GE(verdict.judged, 100u);
        EXPECT_EQ(verdict.wrong, 0u) << name;
        EXPECT_EQ(verdict.disagree, 0u) << name;
        EXPECT_LT(verdict.unlike * 100, verdict.rays) << name;
    }
}

TEST(OctreeRays, AJudgeSeesWrongAnswers) {
    // A tracer that finds nothing is wrong wherever Embree finds something.
    const BenchMesh mesh = two_squares();
    const EmbreeMesh embree(mesh.view(), EmbreeMesh::Quality::Medium);
    render::ObjectTracer blind = embree.tracer();
    blind.nearest = [](const void*, accel::MeshId, render::ObjectRay&) {};
    const RayStream coherent(view_rays(8));
    const RayStream apart(apart_rays(coherent.rays, embree.tracer(), coherent.size()));
    const Verdict verdict = judged(mesh, blind, embree.tracer(), coherent, apart, 100'000);
    EXPECT_GT(verdict.unlike, 100u);
    EXPECT_GT(verdict.wrong, 100u);
    EXPECT_GT(verdict.disagree, 100u);
}

TEST(CountedInstructions, GrowWithTheWork) {
    const auto loop = [](int count) {
        return counted_instructions([count] {
            volatile int sink = 0;
            for (int i = 0; i < count; ++i) sink = sink + 1;
        });
    };
    const auto few = loop(100), many = loop(400);
    if (!few || !many) GTEST_SKIP() << "processes may not be traced here";
    EXPECT_GE(*many - *few, 300u);  // an instruction a turn at least
    EXPECT_LE(*many - *few, 300u * 20);
    EXPECT_EQ(*loop(100), *few);
    EXPECT_FALSE(counted_instructions(
                     [] {
                         volatile int sink = 0;
                         for (int i = 0; i < 1'000'000; ++i) sink = sink + 1;
                     },
                     1'000)
                     .has_value());
}

TEST(Examples, WhatStandsForOneThatIsNotThereHasItsOwnName) {
    const Console console(true, false);
    Bench bench(console, true, "no/folder");
    const ExamplePlan made_up = example_plan(bench, "no such example", 12);
    EXPECT_EQ(made_up.name, "12 rooms");
    EXPECT_FALSE(example_file("no such example.json").has_value());
}

}  // namespace
}  // namespace enfilade::tools
