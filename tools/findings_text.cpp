#include "tools/findings_text.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "tools/console.h"

namespace enfilade::tools {

namespace {

constexpr std::array severities = {Severity::Error, Severity::Warning, Severity::Note};

/// "wall w3 (north wall)"
std::string element_text(const ElementRef& element) {
    std::string text = element.kind;
    if (!element.id.empty()) text += ' ' + element.id;
    if (!element.name.empty() && element.name != element.id) text += " (" + element.name + ')';
    return text;
}

/// Where a finding lies, in one line; empty where it has no place.
std::string place_text(const Finding& finding) {
    std::string text;
    if (finding.point) {
        char place[96];
        const auto& [x, y, z] = *finding.point;
        std::snprintf(place, sizeof place, "at (%.2f, %.2f, %.2f)", x, y, z);
        text = place;
    }
    if (!finding.storey.empty()) text += (text.empty() ? "in storey " : " in storey ") + finding.storey;
    for (std::size_t i = 0; i < finding.elements.size(); ++i) {
        if (!text.empty()) text += i == 0 ? ": " : ", ";
        text += element_text(finding.elements[i]);
    }
    if (finding.moved_mm > 0) {
        const bool far = finding.moved_mm >= 1000;
        char moved[48];
        std::snprintf(moved, sizeof moved, "%smoved %.3g %s", text.empty() ? "" : ", ",
                      far ? finding.moved_mm / 1000 : finding.moved_mm, far ? "m" : "mm");
        text += moved;
    }
    return text;
}

void append(std::string& text, const Finding& finding) {
    const std::string indent(10, ' ');
    text += "  " + finding.code + std::string(finding.code.size() < 7 ? 8 - finding.code.size() : 1, ' ');
    text += finding.sentence + '\n';
    const std::string place = place_text(finding);
    if (!place.empty()) text += indent + place + '\n';
    if (!finding.hint.empty()) text += indent + finding.hint + '\n';
}

std::string severity_count(Severity severity, std::size_t count) { return counted(count, name_of(severity)); }

}  // namespace

SeverityCounts count(std::span<const Finding> findings) {
    SeverityCounts counts;
    for (const Finding& finding : findings) ++counts.of[std::size_t(finding.severity)];
    return counts;
}

std::string counts_text(std::span<const Finding> findings) {
    const SeverityCounts counts = count(findings);
    std::vector<std::string> parts;
    for (const Severity severity : severities)
        if (counts[severity] > 0) parts.push_back(severity_count(severity, counts[severity]));
    if (parts.empty()) return "no findings";
    std::string text = parts[0];
    for (std::size_t i = 1; i < parts.size(); ++i) text += (i + 1 == parts.size() ? " and " : ", ") + parts[i];
    return text;
}

std::string findings_text(std::span<const Finding> findings, std::size_t limit) {
    std::string text;
    for (const Severity severity : severities) {
        std::size_t shown = 0;
        std::size_t held_back = 0;
        for (const Finding& finding : findings) {
            if (finding.severity != severity) continue;
            if (shown == limit) {
                ++held_back;
                continue;
            }
            if (shown++ == 0) {
                std::string title = std::string(name_of(severity)) + "s:\n";
                title[0] = char(title[0] - 'a' + 'A');
                text += title;
            }
            append(text, finding);
        }
        if (held_back > 0) text += "  ... and " + severity_count(severity, held_back) + " more\n";
    }
    return text;
}

nlohmann::ordered_json findings_json(std::span<const Finding> findings) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Finding& finding : findings) {
        nlohmann::ordered_json entry;
        entry["code"] = finding.code;
        entry["severity"] = name_of(finding.severity);
        entry["sentence"] = finding.sentence;
        entry["hint"] = finding.hint;
        entry["point"] = nullptr;
        if (finding.point) entry["point"] = *finding.point;
        entry["storey"] = finding.storey;
        entry["elements"] = nlohmann::ordered_json::array();
        for (const ElementRef& element : finding.elements)
            entry["elements"].push_back({{"kind", element.kind}, {"id", element.id}, {"name", element.name}});
        entry["moved_mm"] = finding.moved_mm;
        list.push_back(std::move(entry));
    }
    return list;
}

}  // namespace enfilade::tools
