#include <nlohmann/json.hpp>

#include "plans/read.h"
#include "tools/commands.h"
#include "tools/exit_code.h"
#include "tools/findings_text.h"
#include "tools/output_file.h"
#include "tools/plan_summary.h"
#include "tools/progress.h"

namespace enfilade::tools {

int run_import(const ImportOptions& options, const Console& console) {
    if (options.read.list_layers) return list_layers(options.plan, console);
    need_output(options.output, "import");
    plans::Plan plan;
    nlohmann::ordered_json as_read;
    {
        Progress progress(console, {"Reading the plan", "Repairing", "Writing"});
        plan = plans::read(options.plan, options.read.options);
        as_read = plan_counts_json(plan);
        progress.next();
        plan = plans::clean(std::move(plan));
        progress.next();
        write_text(options.output, plans::write_json(plan));
    }
    const bool refused = has_errors(plan.findings) || (options.strict && count(plan.findings)[Severity::Warning] > 0);
    if (console.json()) {
        nlohmann::ordered_json result = {{"command", "import"}, {"input", options.plan.string()}};
        result["output"] = options.output.string();
        result["as_read"] = std::move(as_read);
        result["plan"] = plan_counts_json(plan);
        result["findings"] = findings_json(plan.findings);
        console.print(result.dump(2) + '\n');
    } else {
        console.say(findings_text(plan.findings) + options.output.string() + ": " + plan_counts_text(plan) + "; " +
                    counts_text(plan.findings) + '.');
    }
    return refused ? exit_defects : exit_ok;
}

}  // namespace enfilade::tools
