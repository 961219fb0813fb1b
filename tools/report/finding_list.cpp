#include "tools/report/finding_list.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "plans/number_text.h"
#include "tools/report/code_meanings.h"
#include "tools/report/html_text.h"

namespace enfilade::tools {
namespace {

/// The storey that a finding names, else the one whose floor lies next under its point.
std::uint32_t storey_of(const Finding& finding, const modeler::Building& building) {
    for (std::uint32_t k = 0; k < building.storeys.size(); ++k)
        if (building.storeys[k].id == finding.storey) return k;
    if (!finding.point || building.storeys.empty()) return UINT32_MAX;
    std::uint32_t found = 0;
    for (std::uint32_t k = 1; k < building.storeys.size(); ++k)
        if (building.frame.world_z(building.storeys[k].z_floor) <= (*finding.point)[2] + 1e-6) found = k;
    return found;
}

std::string storey_name(const modeler::StoreyInfo& storey) { return storey.name.empty() ? storey.id : storey.name; }

std::string place_html(const PlacedFinding& placed, const PlanView* view) {
    const Finding& finding = *placed.finding;
    std::vector<std::string> parts;
    if (view && placed.storey != UINT32_MAX)
        parts.push_back("<bdi>" + escaped(storey_name(view->building().storeys[placed.storey])) + "</bdi>");
    else if (!finding.storey.empty()) parts.push_back("<bdi>" + escaped(finding.storey) + "</bdi>");
    if (finding.point) {
        const auto& [x, y, z] = *finding.point;
        parts.push_back("x " + decimal(x, 2) + ", y " + decimal(y, 2) + ", z " + decimal(z, 2) + " m");
    }
    if (finding.moved_mm > 0) {
        const bool far = finding.moved_mm >= 1000;
        parts.push_back("moved " + plans::rounded_text(far ? finding.moved_mm / 1000 : finding.moved_mm, far ? 2 : 1) +
                        (far ? " m" : " mm"));
    }
    if (parts.empty()) parts.push_back("no place");
    std::string text;
    for (const std::string& part : parts) text += (text.empty() ? "<span>" : " · <span>") + part + "</span>";
    return text;
}

std::string entry(const PlacedFinding& placed, const PlanView* view) {
    const Finding& finding = *placed.finding;
    const std::string severity = name_of(finding.severity), number = std::to_string(placed.number);
    std::string text = "<li class=\"finding " + severity + "\" id=\"finding-" + number + "\" data-n=\"" + number +
                       "\"><button type=\"button\" class=\"pick\" tabindex=\"-1\"><span class=\"num\">" + number +
                       "</span><span class=\"body\"><span class=\"sentence\" dir=\"auto\">" +
                       escaped(finding.sentence) + "</span><span class=\"place\">" + place_html(placed, view) +
                       "</span></span></button>";
    text += "<div class=\"more\"><a class=\"code\" href=\"#code-" + escaped(finding.code) + "\" title=\"" +
            escaped(meaning_of(finding.code)) + "\">" + escaped(finding.code) + "</a>";
    for (const ElementRef& element : finding.elements) {
        text += "<span class=\"element\">" + escaped(element.kind) + " <bdi>" +
                escaped(element.name.empty() ? element.id : element.name) + "</bdi>";
        if (!element.name.empty() && element.name != element.id)
            text += " <bdi class=\"id\">" + escaped(element.id) + "</bdi>";
        text += "</span>";
    }
    if (!finding.hint.empty()) text += "<p class=\"hint\" dir=\"auto\">" + escaped(finding.hint) + "</p>";
    return text + "</div></li>\n";
}

}  // namespace

std::vector<PlacedFinding> place_findings(const modeler::CheckReport& report, const PlanView* view) {
    std::vector<PlacedFinding> placed;
    for (const Finding& finding : report.findings) placed.push_back({&finding});
    std::stable_sort(placed.begin(), placed.end(), [](const PlacedFinding& a, const PlacedFinding& b) {
        return a.finding->severity > b.finding->severity;
    });
    std::size_t number = 0;
    for (PlacedFinding& at : placed) {
        at.number = ++number;
        if (!view) continue;
        at.storey = storey_of(*at.finding, view->building());
        const auto& point = at.finding->point;
        if (!point || at.storey == UINT32_MAX || !std::isfinite((*point)[0]) || !std::isfinite((*point)[1])) continue;
        at.has_pin = true;
        at.x = (*point)[0] - view->origin()[0];
        at.y = view->origin()[1] - (*point)[1];
    }
    return placed;
}

std::set<std::string> blamed_elements(const modeler::CheckReport& report) {
    std::set<std::string> ids;
    for (const Finding& finding : report.findings)
        for (const ElementRef& element : finding.elements)
            if (element.kind != "storey") ids.insert(element.id);
    return ids;
}

std::string finding_list(const std::vector<PlacedFinding>& findings, const PlanView* view) {
    std::string text;
    for (const PlacedFinding& finding : findings) text += entry(finding, view);
    return text;
}

std::string pins(const std::vector<PlacedFinding>& findings, std::uint32_t storey) {
    std::string text;
    // The gravest last: it is drawn on top.
    for (auto at = findings.rbegin(); at != findings.rend(); ++at) {
        if (!at->has_pin || at->storey != storey) continue;
        const std::string number = std::to_string(at->number);
        text += "<g class=\"pin " + std::string(name_of(at->finding->severity)) + "\" id=\"pin-" + number +
                "\" data-n=\"" + number + "\" transform=\"translate(" + decimal(at->x, 3) + " " + decimal(at->y, 3) +
                ")\"><g class=\"k\"><path class=\"drop\" d=\"M0 0C-3-7-11-11-11-19A11 11 0 1 1 11-19C11-11 3-7 0 0z\"/>"
                "<text y=\"-15\">" +
                number + "</text></g></g>\n";
    }
    return text;
}

nlohmann::ordered_json page_data(const std::vector<PlacedFinding>& findings, const PlanView* view) {
    nlohmann::ordered_json data;
    data["origin"] = view ? nlohmann::ordered_json(view->origin()) : nlohmann::ordered_json(nullptr);
    data["storeys"] = nlohmann::ordered_json::array();
    if (view)
        for (const modeler::StoreyInfo& storey : view->building().storeys)
            data["storeys"].push_back({{"id", storey.id}, {"name", storey_name(storey)}});
    data["findings"] = nlohmann::ordered_json::array();
    for (const PlacedFinding& at : findings) {
        nlohmann::ordered_json entry = {
            {"n", at.number}, {"code", at.finding->code}, {"severity", name_of(at.finding->severity)}};
        entry["storey"] = nullptr;
        if (at.storey != UINT32_MAX) entry["storey"] = at.storey;
        entry["at"] = nullptr;
        if (at.has_pin) entry["at"] = {std::round(at.x * 1000) / 1000, std::round(at.y * 1000) / 1000};
        entry["elements"] = nlohmann::ordered_json::array();
        for (const ElementRef& element : at.finding->elements)
            if (element.kind != "storey") entry["elements"].push_back(element.id);
        data["findings"].push_back(std::move(entry));
    }
    return data;
}

}  // namespace enfilade::tools
