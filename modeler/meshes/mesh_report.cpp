#include "modeler/meshes/mesh_report.h"

#include <algorithm>
#include <cstdio>

namespace enfilade::modeler {
namespace {

constexpr std::size_t named_in_a_sentence = 6;

template <class Name>
std::string list_text(const std::vector<std::uint32_t>& list, const Name& name) {
    std::string text;
    for (std::size_t k = 0; k < std::min(list.size(), named_in_a_sentence); ++k) {
        if (k > 0) text += k + 1 == list.size() ? " and " : ", ";
        text += name(list[k]);
    }
    return text + (list.size() > named_in_a_sentence ? ", ..." : "");
}

}  // namespace

std::string short_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

MeshReport::MeshReport(const Mesh& mesh, const MeshOptions& options, CheckReport& report)
    : blame{std::vector<bool>(mesh.face_count()), std::vector<bool>(mesh.face_count()),
            std::vector<bool>(mesh.points.size()), std::vector<bool>(mesh.points.size())},
      mesh_(mesh),
      options_(options),
      report_(report) {}

void MeshReport::applied(std::initializer_list<const char*> codes) {
    for (const char* code : codes) report_.codes_checked.emplace_back(code);
}

void MeshReport::add(Finding finding, const char* kind) {
    Kind& known = kinds_[finding.code + " " + kind];
    known.code = finding.code;
    known.severity = std::max(known.severity, finding.severity);
    if (known.count++ < options_.listed) report_.findings.push_back(std::move(finding));
}

void MeshReport::finish() {
    for (const auto& [key, kind] : kinds_) {
        if (kind.count <= options_.listed) continue;
        Finding finding{.code = kind.code, .severity = kind.severity};
        finding.sentence = std::to_string(kind.count - options_.listed) + " more " + key.substr(kind.code.size() + 1) +
                           " were found, " + std::to_string(kind.count) + " in all.";
        report_.findings.push_back(std::move(finding));
    }
    const auto level = [](const Finding& finding) { return finding.code.starts_with('T') ? 0 : 1; };
    std::stable_sort(report_.findings.begin(), report_.findings.end(), [&](const Finding& a, const Finding& b) {
        return std::pair(level(a), a.code) < std::pair(level(b), b.code);
    });
}

const MeshSolid* MeshReport::solid_of(std::uint32_t face, std::uint32_t& shell) const {
    const auto after = std::upper_bound(mesh_.shells.begin(), mesh_.shells.end(), face,
                                        [](std::uint32_t f, const MeshShell& s) { return f < s.first_face; });
    if (after == mesh_.shells.begin()) return nullptr;
    const auto number = static_cast<std::uint32_t>(after - mesh_.shells.begin() - 1);
    const auto solid = std::upper_bound(mesh_.solids.begin(), mesh_.solids.end(), number,
                                        [](std::uint32_t s, const MeshSolid& m) { return s < m.first_shell; }) -
                       1;
    shell = number - solid->first_shell;
    return &*solid;
}

std::string MeshReport::vertex(std::uint32_t v) const {
    if (mesh_.format == MeshFormat::Obj) return std::to_string(v + std::uint64_t{1});
    const auto part = std::upper_bound(mesh_.solids.begin(), mesh_.solids.end(), v,
                                       [](std::uint32_t w, const MeshSolid& solid) { return w < solid.first_vertex; });
    return std::to_string(part == mesh_.solids.begin() ? v : v - (part - 1)->first_vertex);
}

std::string MeshReport::face(std::uint32_t f) const {
    if (mesh_.format == MeshFormat::Obj) return std::to_string(f + std::uint64_t{1});
    std::uint32_t shell = 0;
    const MeshSolid* solid = solid_of(f, shell);
    return std::to_string(solid == nullptr ? f : f - mesh_.shells[solid->first_shell + shell].first_face);
}

std::string MeshReport::vertices(const std::vector<std::uint32_t>& list) const {
    return list_text(list, [&](std::uint32_t v) { return vertex(v); });
}

std::string MeshReport::faces(const std::vector<std::uint32_t>& list) const {
    return list_text(list, [&](std::uint32_t f) { return face(f); });
}

std::string MeshReport::owner(std::uint32_t f) const {
    std::uint32_t shell = 0;
    if (const MeshSolid* solid = solid_of(f, shell))
        return solid->name + (shell == 0 ? std::string() : ", void " + std::to_string(shell - 1));
    const auto group = std::upper_bound(mesh_.groups.begin(), mesh_.groups.end(), f,
                                        [](std::uint32_t g, const MeshGroup& m) { return g < m.first_face; });
    if (group == mesh_.groups.begin() || (group - 1)->name.empty()) return {};
    return "\"" + (group - 1)->name + "\"";
}

void MeshReport::name_owner(Finding& finding, std::uint32_t f) const {
    std::uint32_t shell = 0;
    ElementRef element{"object", "", ""};
    if (const MeshSolid* solid = solid_of(f, shell)) {
        element = {"solid", solid->object, owner(f)};
    } else {
        element.name = owner(f);
        if (element.name.size() < 2) return;
        element.name = element.name.substr(1, element.name.size() - 2);
    }
    for (const ElementRef& known : finding.elements)
        if (known.kind == element.kind && known.name == element.name) return;
    finding.elements.push_back(std::move(element));
}

void MeshReport::name_face(Finding& finding, std::uint32_t f) const {
    name_owner(finding, f);
    finding.elements.push_back({"face", face(f), ""});
}

void MeshReport::name_vertex(Finding& finding, std::uint32_t v) const {
    finding.elements.push_back({"vertex", vertex(v), ""});
}

}  // namespace enfilade::modeler
