#include <nlohmann/json.hpp>

#include "accel/scene_file.h"
#include "base/error.h"
#include "tools/bench.h"
#include "tools/check_report.h"
#include "tools/commands.h"
#include "tools/exit_code.h"
#include "tools/output_file.h"
#include "tools/progress.h"
#include "tools/tour.h"

namespace enfilade::tools {

int run_tour(const TourCommandOptions& options, const Console& console) {
    (void)output_path(options.output);  // said before the work
    std::vector<SavedView> views;
    double seconds = 0;
    {
        Progress progress(console, {"Reading the scene", "Walking through it"});
        const accel::Scene scene = accel::open(options.scene);
        progress.next();
        seconds = seconds_of([&] { views = make_tour(scene.view(), {options.views, options.rooms}); });
        write_text(options.output, view_file_text(views, scene.view()));
    }
    if (console.json()) {
        nlohmann::ordered_json json = {{"command", "tour"},
                                       {"input", options.scene.string()},
                                       {"output", options.output.string()},
                                       {"seconds", seconds}};
        json["views"] = nlohmann::ordered_json::array();
        for (const SavedView& view : views) json["views"].push_back(view.name);
        console.print(dump(json));
    } else {
        console.say(options.output.string() + ": " + counted(views.size(), "view") + ", from \"" + views.front().name +
                    "\" to \"" + views.back().name + "\".");
    }
    return exit_ok;
}

}  // namespace enfilade::tools
