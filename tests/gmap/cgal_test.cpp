// CGAL's linear cell complex as the oracle: it counts, validates and operates by code that shares nothing with ours.
#include "gmap/cgal.h"

#include <CGAL/Linear_cell_complex_for_generalized_map.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "gmap/close.h"
#include "gmap/isomorphism.h"
#include "gmap/sew.h"
#include "maps.h"
#include "random_ops.h"

namespace enfilade::gmap {
namespace {

using Complex = CGAL::Linear_cell_complex_for_generalized_map<3, 3>;
using Handle = Complex::Dart_handle;
using Points = std::vector<std::array<double, 3>>;

Points some_points(const Map& map) {
    Points points(map.cell_bound<0>());
    for (std::size_t v = 0; v < points.size(); ++v)
        points[v] = {static_cast<double>(v), 0.5 * static_cast<double>(v * v), -1.0};
    return points;
}

std::vector<std::size_t> cell_counts_of(const Complex& complex) {
    const std::vector<unsigned int> counts = complex.count_all_cells();  // vertices ... volumes, then connected pieces
    return {counts.begin(), counts.begin() + 4};
}

TEST(ToCgal, GivesAValidComplexWithTheSameCells) {
    for (const Map& map : {cube(), grid(3, 2, 2), built(prism_tuples(7)), built(wrapped_grid_tuples(3, 3, 4))}) {
        Complex complex;
        (void)to_cgal(map, some_points(map), complex);
        EXPECT_TRUE(complex.is_valid());
        EXPECT_EQ(complex.number_of_darts(), map.dart_count());
        EXPECT_EQ(cell_counts_of(complex), cell_counts(map));
        EXPECT_TRUE(complex.is_orientable());
        EXPECT_TRUE(complex.is_without_boundary());
    }
}

TEST(ToCgal, AgreesOnWhatIsNotOrientable) {
    const Map map = built(wrapped_grid_tuples(3, 3, 3, true));
    Complex complex;
    (void)to_cgal(map, some_points(map), complex);
    EXPECT_TRUE(complex.is_valid());
    EXPECT_FALSE(complex.is_orientable());
    EXPECT_EQ(codes_of(validate(map)), std::vector<std::string>{"T3"});
}

TEST(ToCgal, CarriesOpenMapsWithGaps) {
    Map map = grid(2, 2, 1);
    ASSERT_TRUE(remove_volume(map, map.representatives<3>()[4]));
    Complex complex;
    const std::vector<Handle> handles = to_cgal(map, some_points(map), complex);
    EXPECT_EQ(handles.size(), map.dart_bound());
    EXPECT_TRUE(complex.is_valid());
    EXPECT_FALSE(complex.is_without_boundary());
    EXPECT_EQ(cell_counts_of(complex), cell_counts(map));
}

TEST(ToCgal, RefusesTooFewPoints) {
    const Map map = cube();
    Complex complex;
    EXPECT_THROW((void)to_cgal(map, Points(7), complex), std::invalid_argument);
}

TEST(FromCgal, BringsBackTheMapAndItsPoints) {
    const Map map = grid(2, 3, 1);
    const Points points = some_points(map);
    Complex complex;
    (void)to_cgal(map, points, complex);
    Points read;
    const Map again = from_cgal(complex, &read);
    const auto found = find_isomorphism(map, again);
    ASSERT_TRUE(found);
    EXPECT_EQ(cell_counts(again), cell_counts(map));
    EXPECT_TRUE(all_ids_are_orbits(again));
    EXPECT_TRUE(validate(again).is_sound()) << text_of(validate(again));
    // Another isomorphism may send a point elsewhere; the labels tie each dart to its point.
    const auto by_point = [](const Map& of, const Points& at) {
        return [&of, &at](DartId d) { return static_cast<std::uint64_t>(at[index(of.vertex(d))][0]); };
    };
    EXPECT_TRUE(is_isomorphic(map, again, by_point(map, points), by_point(again, read)));
}

TEST(FromCgal, ReadsWhatCgalBuilt) {
    // Two hexahedra by CGAL, glued by CGAL and closed by CGAL, are our grid of two.
    Complex complex;
    const auto box = [&](double x) {
        using P = Complex::Point;
        return complex.make_hexahedron(P(x, 0, 0), P(x + 1, 0, 0), P(x + 1, 1, 0), P(x, 1, 0), P(x, 1, 1), P(x, 0, 1),
                                       P(x + 1, 0, 1), P(x + 1, 1, 1));
    };
    box(0);
    box(1);
    EXPECT_EQ(complex.sew3_same_facets(), 1u);
    Map open = from_cgal(complex);
    EXPECT_EQ(open.volume_count(), 2u);
    EXPECT_TRUE(is_isomorphic(closed_copy(open).first, grid(2, 1, 1)));
    complex.close<3>();
    EXPECT_TRUE(is_isomorphic(from_cgal(complex), grid(2, 1, 1)));
}

TEST(Close, MakesWhatCgalMakes) {
    EXPECT_TRUE(rc::check("close", [](std::vector<std::uint32_t> picks) {
        Map map = random_start();
        for (const std::uint32_t pick : picks)
            if (map.volume_count() > 1) (void)remove_volume(map, picked(map, pick));
        Complex complex;
        (void)to_cgal(map, some_points(map), complex);
        complex.close<3>();
        close(map);
        RC_ASSERT(complex.is_valid());
        RC_ASSERT(is_isomorphic(map, from_cgal(complex)));
        RC_ASSERT(cell_counts(map) == cell_counts_of(complex));
    }));
}

/// What `apply` did to `before`, done by CGAL. `at`: the handle of each dart of `before`.
void apply_by_cgal(Complex& complex, const Map& before, const Map& after, const Step& step, const Changes& done,
                   const std::vector<Handle>& at) {
    const DartId d = picked(before, step.where);
    switch (step.kind % kind_count) {
        case 0:
            complex.insert_cell_0_in_cell_1(at[index(d)], complex.create_vertex_attribute(Complex::Point(0, 0, 0)));
            break;
        case 1: complex.insert_cell_1_in_cell_2(at[index(d)], at[index(after.alpha<0, 1>(done.dart))]); break;
        case 2: {
            std::vector<Handle> path;
            for (const DartId x : around_patch(before, d, 3 + step.how % 3)) path.push_back(at[index(x)]);
            complex.insert_cell_2_in_cell_3(path.begin(), path.end());
            break;
        }
        case 3: complex.remove_cell<0>(at[index(d)]); break;
        case 4: complex.remove_cell<1>(at[index(d)]); break;
        default: complex.remove_cell<2>(at[index(d)]); break;
    }
}

TEST(RandomOperations, GiveTheMapThatCgalGives) {
    EXPECT_TRUE(rc::check("the same operations by both", [] {
        Map map = random_start();
        Complex complex;
        std::vector<Handle> at = to_cgal(map, some_points(map), complex);
        for (const Step& step : *rc::gen::container<std::vector<Step>>(rc::gen::arbitrary<Step>())) {
            const Map before = map;
            const auto done = apply(map, step);
            if (!done) continue;
            apply_by_cgal(complex, before, map, step, *done, at);
            RC_ASSERT(complex.is_valid());
            RC_ASSERT(cell_counts(map) == cell_counts_of(complex));

            const Map theirs = from_cgal(complex);
            const auto found = find_isomorphism(map, theirs);
            RC_ASSERT(found.has_value());
            std::vector<Handle> handles;
            for (auto it = complex.darts().begin(); it != complex.darts().end(); ++it) handles.push_back(it);
            at.assign(map.dart_bound(), Handle());
            for (const DartId d : map.darts()) at[index(d)] = handles[index((*found)[index(d)])];
            RC_ASSERT(complex.is_orientable());
        }
    }));
}

TEST(Sew, IsPossibleWhereCgalSaysSo) {
    EXPECT_TRUE(rc::check("is_sewable", [](std::uint32_t a, std::uint32_t b, std::uint8_t dimension) {
        // Pieces with open and closed faces of several sizes.
        Map map = grid(1, 1, 1);
        map.append(built(prism_tuples(3)));
        for (const std::uint32_t v : {1u, 3u}) RC_ASSERT(remove_volume(map, map.representatives<3>()[v]).has_value());
        const int i = dimension % 4;
        const DartId d = picked(map, a);
        const DartId e = picked(map, b);
        RC_PRE(d != e);
        (void)detail::unsew(map, i, d);
        (void)detail::unsew(map, i, e);
        Complex complex;
        const std::vector<Handle> at = to_cgal(map, some_points(map), complex);
        const auto theirs = [&] {
            switch (i) {
                case 0: return complex.is_sewable<0>(at[index(d)], at[index(e)]);
                case 1: return complex.is_sewable<1>(at[index(d)], at[index(e)]);
                case 2: return complex.is_sewable<2>(at[index(d)], at[index(e)]);
                default: return complex.is_sewable<3>(at[index(d)], at[index(e)]);
            }
        }();
        RC_ASSERT(detail::is_sewable(map, i, d, e) == theirs);
    }));
}

}  // namespace
}  // namespace enfilade::gmap
