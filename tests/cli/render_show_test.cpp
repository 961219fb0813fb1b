// What rays cost, in false colours.

#include <cmath>
#include <limits>

#include "accel/scene_file.h"
#include "render/colour_scale.h"
#include "render/image_file.h"
#include "render/ray_counts.h"
#include "render/trace.h"
#include "tests/cli/program.h"
#include "tools/false_colour.h"
#include "tools/floor_views.h"
#include "tools/pixel_font.h"

namespace enfilade::test {
namespace {

using nlohmann::json;
using render::PixelNumbers;
using render::RayCount;
using tools::ScaleRange;

class RenderShow : public OfficeTest {
protected:
    static Outcome show(const std::string& what, const std::string& picture, std::vector<std::string> more) {
        std::vector<std::string> words = {"render", "office.enf", "-o", picture, "--show", what, "--size", "96x72"};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    }
};

TEST_F(RenderShow, CountsAreThoseOfTheWalk) {
    const accel::Scene scene = accel::open(folder() / "office.enf");
    for (render::Camera camera : tools::floor_views(scene.view(), 3, 64)) {
        const PixelNumbers cells = render::count_by_pixel(scene.view(), camera, RayCount::Cells);
        const PixelNumbers sides = render::count_by_pixel(scene.view(), camera, RayCount::SideTests);
        render::RayStats stats;
        render::TraceOptions options;
        options.tracer = render::Tracer::Scalar;
        options.shading = render::Shading::Lambert;
        options.stats = &stats;
        (void)render::trace(scene.view(), camera, options);
        double cell_sum = 0, side_sum = 0;
        for (const float value : cells.of_pixel) cell_sum += double(value);
        for (const float value : sides.of_pixel) side_sum += double(value);
        EXPECT_EQ(cell_sum, double(stats.cells));
        EXPECT_EQ(side_sum, double(stats.side_tests));
    }
}

TEST_F(RenderShow, SaysTheNumbersAndColoursThePixels) {
    for (const char* camera : {"dollhouse", "aerial", "exterior"}) {
        const Outcome outcome = show("cells", "cells.exr", {"--camera", camera, "--json"});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        const json counts = json::parse(outcome.out)["counts"];
        EXPECT_EQ(counts["shown"], "cells");
        EXPECT_GE(counts["least"], 1);
        EXPECT_GT(counts["most"], counts["least"]);
        EXPECT_GT(counts["mean"], counts["least"]);
        EXPECT_LT(counts["mean"], counts["most"]);
        // Above the bar every pixel has the colour of a whole number, or is grey.
        const render::Image image = render::read_image(folder() / "cells.exr");
        const double low = counts["scale"][0], high = counts["scale"][1];
        for (int y = 0; y < 40; ++y) {
            for (int x = 0; x < 96; ++x) {
                const render::Vec3f pixel = image.pixel(x, y);
                double nearest = 1;
                for (double n = low; n <= high; ++n)
                    nearest = std::min(nearest,
                                       double(render::length(pixel - render::scale_colour((n - low) / (high - low)))));
                nearest = std::min(nearest, double(render::length(pixel - render::scale_colour(std::nan("")))));
                EXPECT_LT(nearest, 2e-3) << x << ' ' << y;
            }
        }
    }
}

TEST_F(RenderShow, SidesAreAtLeastThreeACell) {
    const Outcome text = show("sides", "sides.png", {"--camera", "exterior"});
    ASSERT_EQ(text.exit_code, 0) << text.err;
    EXPECT_NE(text.out.find("sides a ray: "), std::string::npos) << text.out;
    const json sides = json::parse(show("sides", "sides.png", {"--camera", "exterior", "--json"}).out)["counts"];
    const json cells = json::parse(show("cells", "sides.png", {"--camera", "exterior", "--json"}).out)["counts"];
    EXPECT_GE(sides["mean"].get<double>(), 3 * cells["mean"].get<double>());
    EXPECT_EQ(sides["rays"], 96 * (72 - tools::bar_rows(96, 72)));
}

TEST_F(RenderShow, OtherTracersAreRefused) {
    for (const std::vector<std::string>& more : std::vector<std::vector<std::string>>{{"--tracer", "packet"},
                                                                                      {"--tracer", "oracle"},
                                                                                      {"--real", "double"},
                                                                                      {"--mirror-floor"},
                                                                                      {"--packets", "64:8"},
                                                                                      {"--stats"}}) {
        const Outcome outcome = show("cells", "no.png", more);
        EXPECT_EQ(outcome.exit_code, 2) << more[0];
        EXPECT_EQ(line_count(outcome.err), 1u) << outcome.err;
    }
    EXPECT_EQ(show("warmth", "no.png", {}).exit_code, 2);
    EXPECT_EQ(show("cells", "yes.png", {"--tracer", "scalar"}).exit_code, 0);
    EXPECT_FALSE(std::filesystem::exists(folder() / "no.png"));
}

PixelNumbers numbers(int width, int height, float value) {
    return {width, height, std::vector<float>(std::size_t(width) * std::size_t(height), value)};
}

TEST(FalseColour, RangeSpansThePicturesAndNothingElse) {
    PixelNumbers some = numbers(4, 4, 3);
    some.of_pixel[1] = 9;
    some.of_pixel[2] = std::numeric_limits<float>::quiet_NaN();
    const ScaleRange range = tools::range_of(std::vector{some, numbers(2, 2, 5)});
    EXPECT_EQ(range.least, 3);
    EXPECT_EQ(range.most, 9);
    EXPECT_EQ(tools::range_of(std::vector{numbers(2, 2, 7)}).most, 8);
    EXPECT_EQ(tools::range_of({}).most, 1);
    EXPECT_EQ(tools::range_of(std::vector{numbers(2, 2, 0)}).most, 1);
    PixelNumbers many = numbers(10, 10, 2);
    many.of_pixel[40] = 50;
    many.of_pixel[41] = 7;
    EXPECT_EQ(tools::range_of(std::vector{many}, 0.99).most, 7);
    EXPECT_EQ(tools::range_of(std::vector{many}, 0.98).most, 3) << "one more than the least";
    EXPECT_EQ(tools::range_of(std::vector{many}).most, 50);
}

TEST(FalseColour, EmptySurroundingsDoNotEndTheScale) {
    PixelNumbers small_object = numbers(100, 100, 0);
    for (std::size_t k = 0; k < 10; ++k) small_object.of_pixel[k] = float(k);
    const ScaleRange range = tools::range_of(std::vector{small_object}, 0.995);
    EXPECT_EQ(range.least, 0);
    EXPECT_EQ(range.most, 9);
}

TEST(FalseColour, MarksAreWholeAndFew) {
    EXPECT_EQ(tools::scale_marks({1, 6}, 8), (std::vector{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(tools::scale_marks({1, 60}, 8), (std::vector{10, 20, 30, 40, 50, 60}));
    EXPECT_EQ(tools::scale_marks({0, 1000}, 4), (std::vector{0, 500, 1000}));
    for (int most = 1; most < 3000; most += 7) {
        const std::vector<int> marks = tools::scale_marks({1, double(most)}, 6);
        EXPECT_GE(marks.size(), 1u) << most;
        EXPECT_LE(marks.size(), 6u) << most;
        EXPECT_GE(marks.front(), 1);
        EXPECT_LE(marks.back(), most);
    }
}

TEST(FalseColour, SmallPicturesHaveNoBar) {
    EXPECT_EQ(tools::bar_rows(79, 60), 0);
    EXPECT_EQ(tools::bar_rows(80, 59), 0);
    for (const int side : {80, 240, 1024, 5000}) {
        EXPECT_GT(tools::bar_rows(side, side), 0) << side;
        EXPECT_LT(2 * tools::bar_rows(side, side), side) << side;
    }
}

TEST(FalseColour, TheBarHidesNothing) {
    const int rows = tools::bar_rows(300, 100);
    const render::Image image = tools::false_colour(numbers(300, 100 - rows, 3), {1, 5}, "cells a ray", rows);
    ASSERT_EQ(image.height, 100);
    for (int y = 0; y < 100; ++y) EXPECT_EQ(image.pixel(0, y) == render::scale_colour(0.5), y < 100 - rows) << y;
}

TEST(FalseColour, LettersStayInThePicture) {
    render::Image image(20, 10);
    tools::draw_text(image, -3, -2, 2, "0123456789+ cells ?", {1, 1, 1});
    tools::draw_text(image, 18, 8, 3, "8", {1, 1, 1});
    tools::fill_rectangle(image, 15, -5, 100, 6, {0, 1, 0});
    EXPECT_EQ(image.pixel(19, 0), (render::Vec3f{0, 1, 0}));
    EXPECT_EQ(tools::text_width("12", 2), 2 * 11);
    render::Image one(5, 7);
    tools::draw_text(one, 0, 0, 1, "1", {1, 1, 1});
    EXPECT_EQ(one.pixel(2, 0).x, 1);
    EXPECT_EQ(one.pixel(0, 0).x, 0);
}

}  // namespace
}  // namespace enfilade::test
