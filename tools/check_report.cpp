#include "tools/check_report.h"

#include <map>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "tools/console.h"
#include "tools/findings_text.h"
#include "tools/output_file.h"
#include "tools/report_page.h"
#include "tools/version.h"

namespace enfilade::tools {

namespace {
/// How many findings each code has, the checked codes without any included.
std::map<std::string, std::size_t> code_counts(const modeler::CheckReport& report) {
    std::map<std::string, std::size_t> counts;
    for (const std::string& code : report.codes_checked) counts[code] = 0;
    for (const Finding& finding : report.findings) ++counts[finding.code];
    return counts;
}

/// Not for a stripped scene: there is no model in it to check.
bool is_checked(const modeler::CheckReport& report) { return !report.codes_checked.empty(); }

bool is_certified(const ReportSubject& subject) {
    return subject.certificate.empty() || subject.certificate == "certified";
}
}  // namespace

bool has_defects(const modeler::CheckReport& report, bool strict) {
    return has_errors(report.findings) || (strict && count(report.findings)[Severity::Warning] > 0);
}

std::string report_text(const ReportSubject& subject, const modeler::CheckReport& report, std::size_t limit) {
    std::string text = findings_text(report.findings, limit);
    if (is_checked(report)) {
        text += "Checked:";
        for (const std::string& code : report.codes_checked) text += ' ' + code;
        text += '\n';
    }
    if (report.suppressed > 0)
        text += counted(report.suppressed, "further finding") + " at cells that are already blamed left out.\n";
    text += subject.input + ": ";
    text += !is_checked(report) ? "not checked" : has_errors(report.findings) ? "not sound" : "sound";
    text += ", " + counts_text(report.findings);
    if (!subject.certificate.empty()) text += "; " + subject.certificate;
    return text + ".\n";
}

nlohmann::ordered_json report_json(const ReportSubject& subject, const modeler::CheckReport& report) {
    const SeverityCounts counts = count(report.findings);
    nlohmann::ordered_json json = {{"program", "enfilade"}, {"version", version}, {"input", subject.input}};
    json["sound"] = nullptr;
    if (is_checked(report)) json["sound"] = !has_errors(report.findings) && is_certified(subject);
    json["certificate"] = nullptr;
    if (!subject.certificate.empty()) json["certificate"] = subject.certificate;
    json["counts"] = {
        {"error", counts[Severity::Error]}, {"warning", counts[Severity::Warning]}, {"note", counts[Severity::Note]}};
    json["codes_checked"] = report.codes_checked;
    json["code_counts"] = nlohmann::ordered_json::object();
    for (const auto& [code, number] : code_counts(report)) json["code_counts"][code] = number;
    json["suppressed"] = report.suppressed;
    json["findings"] = findings_json(report.findings);
    return json;
}

std::string dump(const nlohmann::ordered_json& json) {
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

void need_report_name(const std::filesystem::path& file) {
    const std::string extension = file.extension().string();
    if (!file.empty() && extension != ".html" && extension != ".json" && extension != ".txt")
        throw InputError("F104", file.string(), "A report is written as .html, .json or .txt: end its name so.");
}

void write_report(const std::filesystem::path& file, const ReportSubject& subject, const modeler::CheckReport& report,
                  const modeler::Building* building) {
    need_report_name(file);
    const std::string extension = file.extension().string();
    if (extension == ".html") write_text(file, report_page(subject, report, building));
    else if (extension == ".json") write_text(file, dump(report_json(subject, report)));
    else write_text(file, report_text(subject, report));
}

}  // namespace enfilade::tools
