// The tours that are saved beside the example plans.

#include <gtest/gtest.h>

#include <set>

#include "accel/locate.h"
#include "modeler/build.h"
#include "modeler/check.h"
#include "modeler/convexify.h"
#include "modeler/export_scene.h"
#include "plans/read.h"
#include "tools/view_file.h"

namespace enfilade::test {
namespace {

class ExampleTours : public testing::TestWithParam<const char*> {};

TEST_P(ExampleTours, StandInFreeCellsOfTheBuilding) {
    const std::string name = std::string(ENFILADE_SOURCE_DIR "/plans/examples/") + GetParam();
    const modeler::Building building = modeler::convexify(modeler::build(plans::read(name + ".json")));
    const accel::Scene scene = modeler::export_scene(building, modeler::check(building), "{}");
    const tools::ViewFile file = tools::read_views(name + ".views.json", scene.view());  // throws for an eye in a wall
    EXPECT_GE(file.views.size(), 16u);
    EXPECT_LE(file.views.size(), 24u);
    EXPECT_TRUE(file.relocated.empty()) << "the plan or the way it is cut has changed; make the tour again:\n"
                                        << "  enfilade build plans/examples/" << GetParam() << ".json -o scene.enf\n"
                                        << "  enfilade tour scene.enf -o plans/examples/" << GetParam()
                                        << ".views.json";
    std::set<accel::CellId> cells;
    for (const tools::SavedView& view : file.views) {
        const render::Vec3f eye = render::vec_cast<float>(view.camera.eye);
        EXPECT_TRUE(accel::contains(scene.view(), view.cell, {eye.x, eye.y, eye.z})) << view.name;
        cells.insert(view.cell);
    }
    EXPECT_GE(cells.size(), 3u) << "a tour gets around";
}

INSTANTIATE_TEST_SUITE_P(All, ExampleTours, testing::Values("townhouse", "office-46", "office-135", "curved-room"));

}  // namespace
}  // namespace enfilade::test
