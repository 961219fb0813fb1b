#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>

#include "accel/scene_file.h"
#include "base/error.h"
#include "plans/read.h"
#include "tools/certify.h"
#include "tools/check_report.h"
#include "tools/commands.h"
#include "tools/exit_code.h"
#include "tools/model.h"

namespace enfilade::tools {

namespace {

/// By its first bytes: a scene with another name is one all the same.
bool is_scene(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::array<char, 8> magic = {};
    stream.read(magic.data(), magic.size());
    return file.extension() == ".enf" || std::string_view(magic.data(), magic.size()) == "ENFILADE";
}

modeler::CheckReport check_plan(const CheckOptions& options, const Console& console) {
    std::vector<std::string> steps = {"Reading the plan"};
    steps.insert(steps.end(), model_steps.begin(), model_steps.end());
    Progress progress(console, std::move(steps));
    const plans::Plan plan = plans::read(options.input, options.read.options);
    progress.next();
    return model(plan, options.model, progress).report;
}

}  // namespace

int run_check(const CheckOptions& options, const Console& console) {
    need_report_name(options.report);
    ReportSubject subject{options.input.string(), ""};
    modeler::CheckReport report;
    if (is_scene(options.input)) {
        Progress progress(console, {"Reading the scene", "Checking"});
        const accel::Scene scene = accel::open(options.input, {.verify_hashes = true});
        progress.next();
        Certification certification = certify(scene);
        subject.certificate = certification.verdict;
        // A stripped scene has no map: what reading it validated is all there is.
        if (certification.report) report = std::move(*certification.report);
    } else {
        report = check_plan(options, console);
    }
    if (!options.report.empty()) write_report(options.report, subject, report, nullptr);
    if (console.json()) console.print(dump(report_json(subject, report)));
    else console.say(report_text(subject, report));
    const bool differs = subject.certificate.starts_with("differs");
    return has_defects(report, options.strict) || differs ? exit_defects : exit_ok;
}

}  // namespace enfilade::tools
