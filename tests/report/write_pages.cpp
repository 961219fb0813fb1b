// Writes the pages that browser_test.py opens: report_pages FOLDER

#include <fstream>
#include <iostream>

#include "modeler/check.h"
#include "plans/read.h"
#include "tests/report/faulty_building.h"
#include "tools/report_page.h"

namespace {

using namespace enfilade;

/// A finding at every 7th wall of the building, the severities in turn.
modeler::CheckReport many_findings(const modeler::Building& building) {
    modeler::CheckReport report = modeler::check(building);
    int k = 0;
    for (const modeler::Volume& volume : building.volumes) {
        const modeler::Space& space = building.spaces[volume.space];
        if (volume.label != modeler::Label::Wall || ++k % 7 != 0) continue;
        const plans::GridPoint at =
            building.points[building.corners[building.pieces[volume.piece].first_corner].vertex];
        Finding finding =
            testing::finding(k % 2 ? "G5" : "T7", Severity(k % 3), "Wall \"" + space.id + "\" is at fault.");
        finding.hint = "Draw it again.";
        finding.point = {building.frame.world_x(at.x), building.frame.world_y(at.y),
                         building.frame.world_z(volume.z_low)};
        finding.storey = building.storeys[space.storey].id;
        finding.elements.push_back({"wall", space.id, space.name});
        report.findings.push_back(finding);
    }
    report.findings.push_back(testing::finding("T1", Severity::Error, "The whole is at fault."));
    return report;
}

void write(const std::string& folder, const std::string& name, const modeler::CheckReport& report,
           const modeler::Building* building) {
    std::ofstream file(folder + "/" + name + ".html", std::ios::binary);
    file << tools::report_page({name + ".json", ""}, report, building);
    if (!file.flush()) throw std::runtime_error("cannot write " + name);
}

plans::Plan odd_names() {
    plans::Plan plan = testing::two_rooms();
    plan.name = "</title><script>document.title = 'taken'</script>";
    plan.storeys[0].name = "مطبخ <b>\"&'";
    plan.storeys[0].rooms.push_back(
        {"r\"1", "</script><script>throw 1</script>", "room", {{0.2, 0.2}, {1.8, 0.2}, {1.8, 2.8}, {0.2, 2.8}}});
    plan.storeys[0].rooms.push_back({"🛋", "🛋 客厅", "room", {{2.2, 0.2}, {3.8, 0.2}, {3.8, 2.8}, {2.2, 2.8}}});
    return plan;
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 2) return 2;
    const std::string folder = argv[1];
    const modeler::Building house =
        testing::cells_of(plans::read(ENFILADE_SOURCE_DIR "/plans/examples/townhouse.json"));
    write(folder, "house", many_findings(house), &house);
    write(folder, "sound", modeler::check(house), &house);
    const modeler::Building office =
        testing::cells_of(plans::read(ENFILADE_SOURCE_DIR "/plans/examples/office-135.json"));
    write(folder, "office", many_findings(office), &office);
    const modeler::Building odd = testing::cells_of(odd_names());
    write(folder, "odd", many_findings(odd), &odd);
    write(folder, "stripped", testing::mixed_report(), nullptr);
    return 0;
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
