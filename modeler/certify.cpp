#include "modeler/certify.h"

#include <algorithm>
#include <map>

#include "accel/certificate.h"
#include "accel/scene_file.h"
#include "modeler/export_scene.h"
#include "modeler/model_group.h"
#include "modeler/place.h"

namespace enfilade::modeler {
namespace {

constexpr const char* hint =
    "Build the scene again from its plan: neither this file's pictures nor its certificate are those of a checked "
    "model.";

std::size_t elements(const accel::SceneArray& array) { return array.bytes.size() / std::max(array.element_bytes, 1u); }

/// The cell of the re-exported scene to which an element of an array belongs; nothing for tables of names.
std::optional<std::uint32_t> cell_at(const accel::SceneView& view, const SceneDifference& difference) {
    if (!difference.index) return std::nullopt;
    const std::size_t i = *difference.index;
    const auto cell_of_section = [&](std::size_t section) -> std::optional<std::uint32_t> {
        for (std::uint32_t c = 0; c < view.cells.size(); ++c)
            if (section >= view.cells[c].first_section &&
                section < std::size_t(view.cells[c].first_section) + view.cells[c].section_count)
                return c;
        return std::nullopt;
    };
    const auto cell_of_face = [&](std::size_t face) -> std::optional<std::uint32_t> {
        for (std::size_t s = 0; s < view.section_count(); ++s)
            if (face >= view.section_tails[s].first_face && face < view.section_tails[s + 1].first_face)
                return cell_of_section(s);
        return std::nullopt;
    };
    const auto cell_of_space = [&](accel::SpaceId space) -> std::optional<std::uint32_t> {
        for (std::uint32_t c = 0; c < view.cells.size(); ++c)
            if (view.cells[c].space == space) return c;
        return std::nullopt;
    };
    const auto cell_of_source = [&](std::size_t source) -> std::optional<std::uint32_t> {
        if (source >= view.source_face_count()) return std::nullopt;
        for (std::uint32_t c = 0; c < view.cells.size(); ++c)
            for (const accel::Target target : {view.cells[c].floor, view.cells[c].ceiling})
                if (!target.is_portal() && index(target.source_face()) == source) return c;
        for (std::size_t f = 0; f < view.side_faces.size(); ++f)
            if (const accel::Target target = view.side_faces[f].target;
                !target.is_portal() && index(target.source_face()) == source)
                return cell_of_face(f);
        return std::nullopt;
    };
    switch (accel::SectionKind(difference.array_id)) {
        case accel::SectionKind::Cells:
        case accel::SectionKind::CellPortals:
            return i < view.cells.size() ? std::optional(std::uint32_t(i)) : std::nullopt;
        case accel::SectionKind::SectionX:
        case accel::SectionKind::SectionY:
        case accel::SectionKind::SectionTails: return cell_of_section(i);
        case accel::SectionKind::SideFaces:
        case accel::SectionKind::SideFacePortals: return cell_of_face(i);
        case accel::SectionKind::Portals:
            if (i < view.portals.size()) return std::uint32_t(index(view.portals[i].front));
            return std::nullopt;
        case accel::SectionKind::SourceFaces: return cell_of_source(i);
        case accel::SectionKind::Vertices:
            for (std::size_t s = 0; s < view.source_face_count(); ++s)
                if (i >= view.source_faces[s].first_vertex && i < view.source_faces[s + 1].first_vertex)
                    return cell_of_source(s);
            return std::nullopt;
        case accel::SectionKind::Spaces: return cell_of_space(accel::SpaceId(std::uint32_t(i)));
        case accel::SectionKind::LocatorCells:
            if (i < view.locator_cells.size()) return std::uint32_t(index(view.locator_cells[i]));
            return std::nullopt;
        case accel::SectionKind::Objects:
            if (i < view.objects.size()) return cell_of_space(view.objects[i].space);
            return std::nullopt;
        case accel::SectionKind::CellObjectOffsets:
            return i < view.cells.size() ? std::optional(std::uint32_t(i)) : std::nullopt;
        case accel::SectionKind::CellObjects:
            for (std::uint32_t c = 0; c < view.cells.size() && view.has_objects(); ++c)
                if (i < view.cell_object_offsets[c + 1]) return c;
            return std::nullopt;
        default: return std::nullopt;
    }
}

Finding finding_of(const Building& building, const accel::Scene& again, const SceneDifference& difference) {
    Finding finding{.code = "D3", .severity = Severity::Error, .hint = hint};
    finding.sentence = "The scene is not its checked model: they differ at " + difference.text;
    if (const auto cell = cell_at(again.view(), difference)) {
        const std::uint32_t volume = again.view().cells[*cell].volume;
        place_at_volume(building, volume, finding);
        finding.sentence += ", of " + title(building.spaces[building.volumes[volume].space]);
    }
    const bool is_object = accel::SectionKind(difference.array_id) == accel::SectionKind::Objects;
    if (is_object && difference.index && *difference.index < again.view().objects.size()) {
        const accel::PlacedObject& object = again.view().objects[*difference.index];
        finding.elements.push_back(
            {"object", std::string(again.view().string(object.id)), std::string(again.view().string(object.name))});
    }
    finding.sentence += '.';
    return finding;
}

/// What the certificate states of another model or another check.
std::optional<std::string> certificate_fault(const accel::Scene& scene, const accel::Certificate& certificate,
                                             const CheckReport& report) {
    const std::string model = accel::hex(accel::model_hash(scene.arrays()));
    if (certificate.model_sha256 != model) return "its certificate is of another model group";
    for (const auto& [name, hash] : certificate.trace_sha256) {
        const accel::SceneArray* array = scene.find(name);
        if (array == nullptr || accel::hex(array->sha256) != hash)
            return "its certificate is of another array \"" + name + "\"";
    }
    // Another version may apply other constraints: those that both know have to agree.
    std::map<std::string, std::uint64_t> stated(certificate.code_counts.begin(), certificate.code_counts.end());
    const bool same_version = certificate.program_version == ENFILADE_VERSION;
    for (const std::string& code : report.codes_checked) {
        const auto at = stated.find(code);
        if (at == stated.end()) {
            if (same_version) return "its certificate does not speak of " + code;
            continue;
        }
        if (at->second != report.count(code))
            return "its certificate counts " + std::to_string(at->second) +
                   (at->second == 1 ? " finding of " : " findings of ") + code + ", checking it " +
                   std::to_string(report.count(code));
    }
    return std::nullopt;
}

/// By level: before what the plan's stages had to say.
void insert(Finding finding, CheckReport& report) {
    const auto at = std::find_if(report.findings.begin(), report.findings.end(),
                                 [](const Finding& f) { return f.code.starts_with('P'); });
    report.findings.insert(at, std::move(finding));
}

}  // namespace

std::optional<SceneDifference> first_difference(const accel::Scene& scene, const accel::Scene& again) {
    for (const accel::SceneArray& array : scene.arrays()) {
        if (array.group != accel::Group::Trace) continue;
        const std::string name(array.name);
        const accel::SceneArray* other = again.find(array.name);
        if (other == nullptr) return SceneDifference{name, array.id, std::nullopt};
        const auto [here, there] =
            std::mismatch(array.bytes.begin(), array.bytes.end(), other->bytes.begin(), other->bytes.end());
        const std::size_t index = std::size_t(here - array.bytes.begin()) / std::max(array.element_bytes, 1u);
        if (array.bytes.size() != other->bytes.size())
            return SceneDifference{name + ": " + std::to_string(elements(array)) + " elements instead of " +
                                       std::to_string(elements(*other)),
                                   array.id, index};
        if (here != array.bytes.end())
            return SceneDifference{name + '[' + std::to_string(index) + ']', array.id, index};
    }
    for (const accel::SceneArray& array : again.arrays())
        if (array.group == accel::Group::Trace && scene.find(array.name) == nullptr)
            return SceneDifference{std::string(array.name), array.id, std::nullopt};
    return std::nullopt;
}

Certification certify(const accel::Scene& scene) {
    Certification result;
    if (!scene.has_model()) {
        result.verdict = "uncertified: no model group";
        return result;
    }
    result.building = read_model(scene);
    const Building& building = *result.building;
    result.report = check(building);
    CheckReport& report = *result.report;
    const std::optional<accel::Certificate> certificate = accel::certificate(scene);
    const accel::Scene again = export_scene(building, report, certificate ? certificate->options : "");
    const auto difference = first_difference(scene, again);
    const auto fault = certificate ? certificate_fault(scene, *certificate, report)
                                   : std::optional<std::string>("it has no certificate");
    result.verdict = "certified";
    if (difference) {
        insert(finding_of(building, again, *difference), report);
        result.verdict = "differs at " + difference->text;
    } else if (fault) {
        insert({.code = "D3",
                .severity = Severity::Error,
                .sentence = "The scene is not what was certified: " + *fault + ".",
                .hint = hint},
               report);
        result.verdict = "differs at certificate";
    }
    report.codes_checked.emplace_back("D3");
    return result;
}

}  // namespace enfilade::modeler
