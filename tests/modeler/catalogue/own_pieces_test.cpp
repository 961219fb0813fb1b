#include "modeler/catalogue/own_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "base/disjoint_sets.h"

namespace enfilade::modeler {
namespace {

using Point = std::array<double, 3>;

Point corner(const ObjectMesh& mesh, std::uint32_t vertex) {
    const auto& p = mesh.vertices[vertex];
    return {p[0], p[1], p[2]};
}
Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// One number for each place: vertices at one place count as one.
std::vector<std::uint32_t> places_of(const ObjectMesh& mesh) {
    std::map<std::array<float, 3>, std::uint32_t> seen;
    std::vector<std::uint32_t> places;
    for (const auto& p : mesh.vertices) {
        places.push_back(seen.try_emplace(p, static_cast<std::uint32_t>(seen.size())).first->second);
    }
    return places;
}

/// What every test below goes through: each piece, at details 1 to 3.
template <class Look>
void for_each_mesh(const Look& look) {
    for (const OwnPiece& piece : own_pieces()) {
        for (std::uint32_t detail = 1; detail <= 3; ++detail) {
            SCOPED_TRACE(piece.entry.id + " at detail " + std::to_string(detail));
            look(piece, piece.make(detail), detail);
        }
    }
}

TEST(OwnPieces, HaveAscendingIdsOfTheirOwn) {
    ASSERT_FALSE(own_pieces().empty());
    for (std::size_t k = 1; k < own_pieces().size(); ++k) {
        EXPECT_LT(own_pieces()[k - 1].entry.id, own_pieces()[k].entry.id);
    }
    for (const OwnPiece& piece : own_pieces()) {
        EXPECT_TRUE(piece.entry.id.starts_with("own/")) << piece.entry.id;
        EXPECT_FALSE(piece.entry.name.empty()) << piece.entry.id;
        EXPECT_FALSE(piece.entry.category.empty()) << piece.entry.id;
    }
}

TEST(OwnPieces, FillTheBoxOfTheirEntryAndStandOnIt) {
    for_each_mesh([](const OwnPiece& piece, const ObjectMesh& mesh, std::uint32_t) {
        Point low, high;
        low.fill(1e9), high.fill(-1e9);
        for (const auto& p : mesh.vertices) {
            for (int axis = 0; axis < 3; ++axis) {
                low[axis] = std::min<double>(low[axis], p[axis]), high[axis] = std::max<double>(high[axis], p[axis]);
            }
        }
        EXPECT_EQ(low[2], 0);
        EXPECT_NEAR(high[2], piece.entry.height, 1e-6);
        EXPECT_NEAR(low[0], -piece.entry.width / 2, 1e-6);
        EXPECT_NEAR(high[0], piece.entry.width / 2, 1e-6);
        EXPECT_NEAR(low[1], -piece.entry.depth / 2, 1e-6);
        EXPECT_NEAR(high[1], piece.entry.depth / 2, 1e-6);
    });
}

TEST(OwnPieces, AreWellFormed) {
    for_each_mesh([](const OwnPiece& piece, const ObjectMesh& mesh, std::uint32_t) {
        EXPECT_EQ(mesh.name, piece.entry.id);
        ASSERT_EQ(mesh.triangle_materials.size(), mesh.triangles.size());
        std::set<std::uint32_t> used_materials;
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            for (const std::uint32_t k : mesh.triangles[t]) ASSERT_LT(k, mesh.vertices.size());
            ASSERT_LT(mesh.triangle_materials[t], mesh.materials.size());
            used_materials.insert(mesh.triangle_materials[t]);
        }
        EXPECT_EQ(used_materials.size(), mesh.materials.size());
        for (const ObjectMaterial& material : mesh.materials) {
            for (const float part : material.colour) EXPECT_TRUE(part > 0 && part < 0.95f) << material.name;
        }
    });
}

TEST(OwnPieces, HaveNoTriangleWithoutArea) {
    for_each_mesh([](const OwnPiece&, const ObjectMesh& mesh, std::uint32_t) {
        std::size_t thin = 0;
        for (const auto& [a, b, c] : mesh.triangles) {
            const Point u = minus(corner(mesh, b), corner(mesh, a)), v = minus(corner(mesh, c), corner(mesh, a));
            const Point normal = cross(u, v);
            // Area over the square of the longest side: of a needle a million times as long as wide, 1e-6.
            const double longest = std::max({dot(u, u), dot(v, v), dot(minus(u, v), minus(u, v))});
            thin += !(std::sqrt(dot(normal, normal)) > 1e-6 * longest);
        }
        EXPECT_EQ(thin, 0u);
    });
}

TEST(OwnPieces, AreClosedAndTurnedOutward) {
    for_each_mesh([](const OwnPiece&, const ObjectMesh& mesh, std::uint32_t) {
        const std::vector<std::uint32_t> places = places_of(mesh);
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;  // there less back
        DisjointSets shells(mesh.vertices.size());
        for (const auto& corners : mesh.triangles) {
            for (int k = 0; k < 3; ++k) {
                const std::uint32_t a = places[corners[k]], b = places[corners[(k + 1) % 3]];
                balance[std::minmax(a, b)] += a < b ? 1 : -1;
                shells.join(corners[k], corners[(k + 1) % 3]);
            }
        }
        EXPECT_EQ(std::ranges::count_if(balance, [](const auto& edge) { return edge.second != 0; }), 0);
        std::map<std::size_t, double> volumes;
        for (const auto& [a, b, c] : mesh.triangles) {
            const Point origin = corner(mesh, static_cast<std::uint32_t>(shells.find(a)));
            volumes[shells.find(a)] += dot(minus(corner(mesh, a), origin),
                                           cross(minus(corner(mesh, b), origin), minus(corner(mesh, c), origin)));
        }
        EXPECT_EQ(std::ranges::count_if(volumes, [](const auto& shell) { return !(shell.second > 0); }), 0);
    });
}

TEST(OwnPieces, HaveNoneOfTheDefectsOfFiles) {
    for_each_mesh([](const OwnPiece&, const ObjectMesh& mesh, std::uint32_t) {
        const MeshDefects defects = defects_of(mesh);
        EXPECT_EQ(defects.degenerate, 0u);
        EXPECT_EQ(defects.duplicate, 0u);
        EXPECT_EQ(defects.open_edges, 0u);
        EXPECT_EQ(defects.dropped, 0u);
    });
}

TEST(OwnPieces, GetFinerWithDetailWithinWhatIsPromised) {
    std::array<std::size_t, 3> all{};
    for (const OwnPiece& piece : own_pieces()) {
        std::array<std::size_t, 3> counts{};
        for (std::uint32_t detail = 1; detail <= 3; ++detail) {
            counts[detail - 1] = piece.make(detail).triangles.size();
            all[detail - 1] += counts[detail - 1];
        }
        EXPECT_LT(counts[0], counts[1]) << piece.entry.id;
        EXPECT_LT(counts[1], counts[2]) << piece.entry.id;
        EXPECT_TRUE(counts[0] >= 100 && counts[0] <= 9000) << piece.entry.id << ": " << counts[0];
        EXPECT_LE(counts[2], 90000u) << piece.entry.id;
    }
    EXPECT_LE(all[0], 250000u);
    EXPECT_GE(all[2], 500000u);  // what benchmarks of unique triangles need
}

TEST(OwnPieces, TakeDetailsBeyondTheirRangeAsTheNearest) {
    const OwnPiece& piece = own_pieces().front();
    EXPECT_EQ(piece.make(0), piece.make(1));
    EXPECT_EQ(piece.make(1000), piece.make(8));
}

TEST(OwnPieces, CarryThingsWithinTheirBoxAndHangBelowCeilings) {
    for (const OwnPiece& piece : own_pieces()) {
        const CatalogueEntry& e = piece.entry;
        EXPECT_TRUE(!e.top || (*e.top > 0 && *e.top <= e.height + 1e-9)) << e.id;
        EXPECT_GE(e.elevation, 0) << e.id;
        EXPECT_LE(e.elevation + e.height, 2.35) << e.id;
    }
}

/// A surface to stand on is where the entry says: over most of the box (of a round one: pi / 4).
TEST(OwnPieces, HaveASurfaceAtTheirTop) {
    for_each_mesh([](const OwnPiece& piece, const ObjectMesh& mesh, std::uint32_t) {
        if (!piece.entry.top) return;
        double area = 0;
        for (const auto& [a, b, c] : mesh.triangles) {
            const Point pa = corner(mesh, a), pb = corner(mesh, b), pc = corner(mesh, c);
            const bool is_there = std::max({std::abs(pa[2] - *piece.entry.top), std::abs(pb[2] - *piece.entry.top),
                                            std::abs(pc[2] - *piece.entry.top)}) < 0.004;
            if (is_there) area += std::max(0.0, cross(minus(pb, pa), minus(pc, pa))[2] / 2);
        }
        EXPECT_GT(area, 0.74 * piece.entry.width * piece.entry.depth);
    });
}

TEST(OwnPieces, AreOfKindsWhoseFrontIsDocumented) {
    std::ifstream file(ENFILADE_SOURCE_DIR "/docs/furniture.md");
    ASSERT_TRUE(file);
    std::string line;
    std::set<std::string> kinds, ids;
    while (std::getline(file, line)) {
        std::istringstream words(line);
        for (std::string word; words >> word;) {
            if (word.starts_with("own/")) ids.insert(word);
            while (!word.empty() && (word.back() == ',' || word.back() == '*')) word.pop_back();
            if (line.starts_with("|") && line.find("own/") == std::string::npos) kinds.insert(word);
        }
    }
    for (const OwnPiece& piece : own_pieces()) {
        EXPECT_TRUE(kinds.contains(piece.entry.kind)) << piece.entry.id << " is a " << piece.entry.kind;
        EXPECT_TRUE(ids.contains(piece.entry.id)) << piece.entry.id << " is not in the table: tools/pieces.sh";
    }
}

/// Every kind that rules may ask for has a piece: the default needs no files.
TEST(OwnPieces, CoverEveryKind) {
    const char* const kinds[] = {"bed",
                                 "double_bed",
                                 "bunk_bed",
                                 "cot",
                                 "bedside_table",
                                 "wardrobe",
                                 "chest_of_drawers",
                                 "dressing_table",
                                 "sofa",
                                 "armchair",
                                 "coffee_table",
                                 "tv_stand",
                                 "tv",
                                 "bookshelf",
                                 "shelf",
                                 "dining_table",
                                 "round_table",
                                 "chair",
                                 "stool",
                                 "bench",
                                 "sideboard",
                                 "desk",
                                 "office_chair",
                                 "computer",
                                 "desk_lamp",
                                 "floor_lamp",
                                 "table_lamp",
                                 "ceiling_lamp",
                                 "office_lamp",
                                 "wall_lamp",
                                 "filing_cabinet",
                                 "meeting_table",
                                 "whiteboard",
                                 "printer",
                                 "kitchen_unit",
                                 "kitchen_sink",
                                 "stove",
                                 "fridge",
                                 "dishwasher",
                                 "wall_cabinet",
                                 "toilet",
                                 "wash_basin",
                                 "bathtub",
                                 "shower",
                                 "washing_machine",
                                 "mirror",
                                 "towel_rail",
                                 "plant",
                                 "small_plant",
                                 "rug",
                                 "picture",
                                 "curtain",
                                 "radiator",
                                 "coat_rack",
                                 "umbrella_stand",
                                 "shoe_cabinet",
                                 "bin",
                                 "box",
                                 "bicycle",
                                 "piano",
                                 "fireplace",
                                 "vase",
                                 "book_pile",
                                 "cup",
                                 "server_rack",
                                 "reception_desk",
                                 "vending_machine",
                                 "locker",
                                 "bar_stool",
                                 "wall_shelf"};
    std::set<std::string> made;
    for (const OwnPiece& piece : own_pieces()) made.insert(piece.entry.kind);
    for (const char* const kind : kinds) EXPECT_TRUE(made.contains(kind)) << kind;
    EXPECT_EQ(made.size(), std::size(kinds));
}

TEST(OwnPieces, AreTheSameEveryTime) {
    for_each_mesh([](const OwnPiece& piece, const ObjectMesh& mesh, std::uint32_t detail) {
        EXPECT_EQ(mesh, piece.make(detail));
    });
}

}  // namespace
}  // namespace enfilade::modeler
