#include "tools/report/area_scale.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace enfilade::tools {
namespace {

/// Lightness of a colour as eyes judge it: L of OKLab.
double lightness(const std::string& hex) {
    const auto linear = [&](std::size_t at) {
        const double c = std::stoi(hex.substr(at, 2), nullptr, 16) / 255.0;
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    const double r = linear(1), g = linear(3), b = linear(5);
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return 0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s;
}

TEST(AreaScale, DoublesFromClassToClass) {
    EXPECT_EQ(area_class(0), 0u);
    EXPECT_EQ(area_class(0.49), 0u);
    for (std::size_t k = 1; k < area_classes.size(); ++k) {
        if (k > 1) {
            EXPECT_EQ(area_classes[k], 2 * area_classes[k - 1]);
        }
        EXPECT_EQ(area_class(area_classes[k]), k);
        EXPECT_EQ(area_class(std::nextafter(area_classes[k], 0)), k - 1);
    }
    EXPECT_EQ(area_class(1e12), area_classes.size() - 1);
}

TEST(AreaScale, TakesWhatIsNoNumberAsNothing) {
    EXPECT_EQ(area_class(std::numeric_limits<double>::quiet_NaN()), 0u);
    EXPECT_EQ(area_class(-1), 0u);
}

TEST(AreaScale, StepsLookAlike) {
    for (const Ground ground : {Ground::Light, Ground::Dark}) {
        const std::size_t last = area_classes.size() - 1;
        const double from = lightness(area_colour(0, ground)), to = lightness(area_colour(last, ground));
        const double step = (to - from) / double(last);
        EXPECT_EQ(step < 0, ground == Ground::Light) << "large areas stand out from the ground";
        EXPECT_GT(std::abs(step), 0.05);
        for (std::size_t k = 1; k <= last; ++k)
            EXPECT_NEAR(lightness(area_colour(k, ground)) - lightness(area_colour(k - 1, ground)), step, 0.006) << k;
    }
}

TEST(AreaScale, NamesEveryClass) {
    EXPECT_EQ(area_class_text(0), "up to 0.5");
    EXPECT_EQ(area_class_text(1), "0.5 to 1");
    EXPECT_EQ(area_class_text(area_classes.size() - 1), "over 32");
    std::set<std::string> names;
    for (std::size_t k = 0; k < area_classes.size(); ++k) names.insert(area_class_text(k));
    EXPECT_EQ(names.size(), area_classes.size());
}

TEST(AreaScale, GivesPagesEveryColourOfBothGrounds) {
    const std::string page = area_style(), picture = plain_area_style();
    for (std::size_t k = 0; k < area_classes.size(); ++k) {
        const std::string name = ".a" + std::to_string(k) + " { ";
        EXPECT_NE(page.find(name + "--area: " + area_colour(k, Ground::Light) + ";"), std::string::npos);
        EXPECT_NE(page.find(name + "--area: " + area_colour(k, Ground::Dark) + ";"), std::string::npos);
        EXPECT_NE(picture.find(name + "stroke: " + area_colour(k, Ground::Light) + ";"), std::string::npos);
    }
}

}  // namespace
}  // namespace enfilade::tools
