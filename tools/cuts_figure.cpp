// cuts_figure PLAN FILE.svg: the first storey of a plan, cut in every way that there is, side by side (figures.sh).

#include <algorithm>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "accel/scene.h"
#include "modeler/build.h"
#include "modeler/check.h"
#include "modeler/convexify.h"
#include "modeler/export_scene.h"
#include "plans/read.h"
#include "tools/console.h"
#include "tools/convexifiers.h"
#include "tools/cut_summary.h"
#include "tools/output_file.h"
#include "tools/report/cut_sheet.h"
#include "tools/report/html_text.h"

namespace {

using namespace enfilade;

struct Way {
    const char* name;
    const char* title;
};
constexpr Way ways[] = {
    {"diagonals", "(a) Diagonals"}, {"hertel-mehlhorn", "(b) Hertel and Mehlhorn"}, {"sah", "(c) SAH"}};

/// What the rooms of a scene come to, in a line.
std::string rooms_text(const accel::SceneView& scene) {
    std::size_t cells = 0, rooms = 0;
    double area = 0, sah = 0;
    const std::vector<tools::SpaceCuts> spaces = tools::cuts_per_space(scene);
    for (std::size_t s = 0; s < spaces.size(); ++s) {
        if (scene.spaces[s].label != accel::Label::Room) continue;
        ++rooms, cells += spaces[s].cells, area += spaces[s].cut_area_m2, sah += spaces[s].sah_sum;
    }
    return tools::counted(cells, "cell") + ", " + tools::area_text(area) + " of cuts, SAH sum " +
           tools::decimal(sah / double(std::max<std::size_t>(rooms, 1)), 2);
}

void write_figure(const std::string& plan_file, const std::string& svg_file) {
    const modeler::Building building = modeler::build(plans::read(plan_file));
    std::vector<accel::Scene> scenes;
    for (const Way& way : ways) {
        const modeler::Building cells = modeler::convexify(building, {tools::convexifier_of(way.name)});
        const modeler::CheckReport report = modeler::check(cells);
        if (!report.sound()) throw std::runtime_error(plan_file + " is not sound when cut by " + way.name);
        scenes.push_back(modeler::export_scene(cells, report, "{}"));
    }
    std::vector<tools::CutPanel> panels;
    for (std::size_t k = 0; k < scenes.size(); ++k) {
        const accel::SceneView& scene = scenes[k].view();
        panels.push_back({&scene, tools::scene_storeys(scene).at(0), ways[k].title, {rooms_text(scene)}});
    }
    tools::write_text(svg_file, tools::cut_sheet("One room, cut in three ways", panels));
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 3) {
        std::fputs("cuts_figure PLAN FILE.svg\n", stderr);
        return 2;
    }
    write_figure(argv[1], argv[2]);
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "cuts_figure: %s\n", error.what());
    return 1;
}
