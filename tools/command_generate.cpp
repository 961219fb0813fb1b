#include <nlohmann/json.hpp>

#include "base/error.h"
#include "plans/generate.h"
#include "plans/read.h"
#include "tools/commands.h"
#include "tools/exit_code.h"
#include "tools/output_file.h"
#include "tools/plan_summary.h"
#include "tools/progress.h"

namespace enfilade::tools {

int run_generate(const GenerateCommandOptions& options, const Console& console) {
    if (options.rooms < options.storeys)
        throw InputError("F101", "",
                         "A building of " + counted(options.storeys, "storey") + " cannot have only " +
                             counted(options.rooms, "room") + ": give each storey at least one.");
    plans::Plan plan;
    {
        Progress progress(console, {"Laying out the rooms", "Writing"});
        plan = plans::generate({options.rooms, options.storeys, options.curved, options.oblique, options.seed});
        progress.next();
        write_text(options.output, plans::write_json(plan));
    }
    if (console.json()) {
        nlohmann::ordered_json result = {{"command", "generate"}, {"output", options.output.string()}};
        result["plan"] = plan_counts_json(plan);
        console.print(result.dump(2) + '\n');
    } else {
        console.say(options.output.string() + ": " + plan_counts_text(plan) + '.');
    }
    return exit_ok;
}

}  // namespace enfilade::tools
