#include "tools/report/page_header.h"

#include <map>
#include <set>

#include "tools/console.h"
#include "tools/findings_text.h"
#include "tools/report/cell_layers.h"
#include "tools/report/code_meanings.h"
#include "tools/report/html_text.h"

namespace enfilade::tools {
namespace {

using modeler::Label;

struct CodeCount {
    std::size_t count = 0;
    Severity worst = Severity::Note;
};

/// In the order in which they were checked, then by name.
std::vector<std::pair<std::string, CodeCount>> code_counts(const modeler::CheckReport& report) {
    std::map<std::string, CodeCount> found;
    for (const Finding& finding : report.findings) {
        CodeCount& at = found[finding.code];
        ++at.count;
        at.worst = std::max(at.worst, finding.severity);
    }
    std::vector<std::pair<std::string, CodeCount>> all;
    for (const std::string& code : report.codes_checked) {
        all.push_back({code, found[code]});
        found.erase(code);
    }
    all.insert(all.end(), found.begin(), found.end());
    return all;
}

void add_count(std::string& text, std::size_t value, const char* one, const char* many = "") {
    const std::string words = counted(value, one, many);
    const std::size_t space = words.find(' ');
    text += "<div><dd>" + words.substr(0, space) + "</dd><dt>" + words.substr(space + 1) + "</dt></div>";
}

std::string building_counts(const modeler::Building& building, const PlanView* view) {
    std::map<Label, std::set<std::uint32_t>> spaces;
    for (const modeler::Volume& volume : building.volumes)
        if (building.spaces[volume.space].storey < building.storeys.size()) spaces[volume.label].insert(volume.space);
    double area = 0;
    if (view)
        for (std::uint32_t k = 0; k < view->storey_count(); ++k)
            for (const modeler::SpacePart& part : view->parts(k))
                if (view->space(part.space).label == Label::Room) area += modeler::area_m2(building, part);
    const CellCounts cells = count_cells(building);
    std::string text = "<dl class=\"counts\">";
    add_count(text, building.storeys.size(), "storey");
    add_count(text, spaces[Label::Room].size(), "room");
    if (view) text += "<div><dd>" + area_text(area) + "</dd><dt>of rooms</dt></div>";
    add_count(text, spaces[Label::Door].size(), "door");
    add_count(text, spaces[Label::Window].size(), "window");
    add_count(text, building.volumes.size(), "volume");
    add_count(text, building.map.dart_count(), "dart");
    add_count(text, cells.cells, "cell");
    add_count(text, cells.portals, "portal");
    return text + "</dl>\n";
}

std::string finding_counts(const modeler::CheckReport& report) {
    const SeverityCounts counts = count(report.findings);
    std::string text = "<p class=\"tally\">";
    for (const Severity severity : {Severity::Error, Severity::Warning, Severity::Note}) {
        if (counts[severity] == 0) continue;
        const std::string name = name_of(severity);
        text += "<span class=\"sev " + name + "\">" + counted(counts[severity], name) + "</span> ";
    }
    for (const auto& [code, at] : code_counts(report))
        if (at.count > 0)
            text += "<a class=\"chip " + std::string(name_of(at.worst)) + "\" href=\"#code-" + escaped(code) +
                    "\" title=\"" + escaped(meaning_of(code)) + "\">" + escaped(code) + " <b>" + grouped(at.count) +
                    "</b></a> ";
    if (report.findings.empty() && !report.codes_checked.empty()) text += "<span class=\"quiet\">Nothing found.</span>";
    if (report.suppressed > 0)
        text += "<span class=\"quiet\">" + counted(report.suppressed, "further finding") +
                " at what is already blamed left out.</span>";
    return text + "</p>\n";
}

std::string certificate_html(const std::string& certificate) {
    if (certificate.empty()) return "";
    const char* meaning = "The model behind the file is another one than what rays are traced in.";
    const char* classes = "bad";
    if (certificate == "certified") meaning = "What was checked is what is traced, array by array.", classes = "good";
    else if (certificate.starts_with("uncertified"))
        meaning = "The file holds no model, so nothing in it can be checked.", classes = "unknown";
    return std::string("<p class=\"certificate ") + classes + "\"><strong>" + escaped(certificate) + "</strong> " +
           meaning + "</p>\n";
}

}  // namespace

std::string verdict_text(const ReportSubject& subject, const modeler::CheckReport& report) {
    if (report.codes_checked.empty()) return "not checked";
    const bool certified = subject.certificate.empty() || subject.certificate == "certified";
    return has_errors(report.findings) || !certified ? "not sound" : "sound";
}

std::string page_header(const ReportSubject& subject, const modeler::CheckReport& report,
                        const modeler::Building* building, const PlanView* view) {
    const std::string verdict = verdict_text(subject, report);
    const char* classes = verdict == "sound" ? "good" : verdict == "not sound" ? "bad" : "unknown";
    const char* icon = verdict == "sound"       ? "m5 12.5 4.5 4.5L19 7.5"
                       : verdict == "not sound" ? "m7 7 10 10M17 7 7 17"
                                                : "M6 12h12";
    std::string label = verdict;
    label[0] = char(label[0] - 'a' + 'A');
    std::string text = "<header class=\"top\">\n<div class=\"head\"><p class=\"verdict " + std::string(classes) +
                       "\"><svg viewBox=\"0 0 24 24\" aria-hidden=\"true\"><circle cx=\"12\" cy=\"12\" r=\"12\"/><path "
                       "d=\"" +
                       icon + "\"/></svg>" + label + "</p>\n<div><h1><bdi>" +
                       escaped(building && !building->name.empty() ? building->name : subject.input) +
                       "</bdi></h1>\n<p class=\"input\"><bdi>" + escaped(subject.input) + "</bdi></p></div></div>\n";
    text += certificate_html(subject.certificate);
    if (building) text += building_counts(*building, view);
    return text + finding_counts(report) + "</header>\n";
}

std::string code_table(const modeler::CheckReport& report) {
    std::string text;
    for (const auto& [code, at] : code_counts(report)) {
        const std::string meaning = meaning_of(code);
        text += "<tr id=\"code-" + escaped(code) + "\"><th scope=\"row\">" + escaped(code) + "</th><td>" +
                escaped(meaning) + "</td><td class=\"number\">";
        if (at.count == 0) text += "<span class=\"ok\" title=\"checked, nothing found\">&#10003;</span>";
        else
            text += "<button type=\"button\" class=\"chip " + std::string(name_of(at.worst)) + "\" data-code=\"" +
                    escaped(code) + "\">" + grouped(at.count) + "</button>";
        text += "</td></tr>\n";
    }
    return text;
}

}  // namespace enfilade::tools
