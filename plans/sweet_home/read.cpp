// A Sweet Home 3D home: Home.xml out of the archive, element by element into the plan (docs/sweet-home.md).
#include <filesystem>

#include "plans/read.h"
#include "plans/sweet_home/archive.h"
#include "plans/sweet_home/parts.h"

namespace enfilade::plans {
namespace {

/// The home's name is often the path where it was once saved.
std::string plan_name(const std::string& attribute, const std::string& file_name) {
    std::string name = attribute.empty() ? file_name : attribute;
    if (const std::size_t slash = name.find_last_of("/\\"); slash != std::string::npos) name.erase(0, slash + 1);
    for (const char* ending : {".sh3d", ".sh3x"})
        if (name.size() > 5 && name.ends_with(ending)) name.resize(name.size() - 5);
    return name;
}

std::string pieces(std::size_t count) {
    return count == 1 ? "One piece of furniture is" : std::to_string(count) + " pieces of furniture are";
}

void report_left_out(Home& home) {
    for (std::size_t k = 0; k < home.plan.storeys.size(); ++k) {
        const Storey& storey = home.plan.storeys[k];
        const std::string level = storey.name.empty() ? "" : " of level \"" + storey.name + "\"";
        const ElementRef ref{"storey", storey.id, storey.name};
        if (home.hidden[k] > 0)
            home.report(finding_at(storey, "P176", Severity::Note,
                                   pieces(home.hidden[k]) + " set invisible and left out" + level + ".",
                                   "Set them visible in Sweet Home 3D to have them.", ref, {}));
        if (std::vector<ElementRef>& lost = home.without_size[k]; !lost.empty()) {
            Finding finding =
                finding_at(storey, "P179", Severity::Warning,
                           pieces(lost.size()) + " left out" + level + ": the file gives no usable place and size (\"" +
                               (lost.front().name.empty() ? lost.front().id : lost.front().name) + "\"" +
                               (lost.size() > 1 ? " and others)." : ")."),
                           "Open the home in Sweet Home 3D, place them again and save it.", ref, {});
            finding.elements = std::move(lost);
            home.report(std::move(finding));
        }
    }
}

}  // namespace

Plan read_sweet_home(std::span<const std::byte> bytes, const std::string& file_name) {
    pugi::xml_document document;
    parse_home_xml(document, home_xml(bytes, file_name), file_name);
    Home home(document.document_element());
    const HomeElement root(document.document_element(), home.plan.findings);
    home.plan.name = plan_name(root.text("name"), file_name);
    read_levels(root, home);
    for (const pugi::xml_node node : root.node().children()) {
        const std::string_view kind = node.name();
        const HomeElement element = root.child(node);
        if (kind == "wall") read_wall(element, home);
        else if (kind == "room") read_room(element, home);
        else read_piece(element, home, "");
    }
    for (std::size_t k = 0; k < home.plan.storeys.size(); ++k)
        bind_openings(home.plan.storeys[k], std::move(home.openings[k]), home);
    report_left_out(home);
    return std::move(home.plan);
}

}  // namespace enfilade::plans
