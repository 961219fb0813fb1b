#include <array>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "tools/bench.h"
#include "tools/commands.h"
#include "tools/exit_code.h"
#include "tools/output_file.h"

namespace enfilade::tools {

namespace {

struct Entry {
    const char* name;
    const char* sentence;
    void (*run)(Bench&);
};

constexpr std::array entries = {
    Entry{"build", "from a plan to a scene: time, memory and how both grow", bench_build},
    Entry{"check", "proving a model sound: every constraint, and how its time grows", bench_check},
    Entry{"gmap", "the topological kernel: bytes a dart, validation", bench_gmap},
    Entry{"scene", "loading and validating a scene file", bench_scene},
    Entry{"cells", "tracing through cells, against Embree on the same rays", bench_cells},
    Entry{"queries", "files of rays: where the time goes, and what lies behind walls", bench_queries},
    Entry{"convexify", "the ways to cut rooms into cells: how few, how fast, and what rays make of them",
          bench_convexify},
    Entry{"edit", "boxes put into rooms, against building all again", bench_edit},
    Entry{"furniture", "objects placed by rule: time, guarantees, and how much finds a place", bench_furniture},
    Entry{"octree", "octrees over single meshes, against Embree's trees on the same rays", bench_octree},
    Entry{"furnished", "tracing furnished floors, against Embree's instances on the same rays", bench_furnished},
    Entry{"lights", "pictures lit by many lamps: walks, lists and light trees, against Embree with the same lists",
          bench_lights},
    Entry{"dial", "what each option costs in time and memory, and what it errs", bench_dial},
};

/// An error where the table says NOT MET and the user asked for --strict.
int verdict(const Bench& bench, const BenchOptions& options, const Console& console) {
    std::size_t goals = 0;
    std::size_t met = 0;
    for (const BenchRow& row : bench.rows()) {
        goals += row.goal ? 1 : 0;
        met += row.met().value_or(false) ? 1 : 0;
    }
    console.say("\n" + counted(met, "goal") + " of " + std::to_string(goals) + " met.");
    return options.strict && met < goals ? exit_defects : exit_ok;
}

}  // namespace

std::string bench_list() {
    std::string text;
    for (const Entry& entry : entries)
        text += "  " + std::string(entry.name) + std::string(10 - std::string_view(entry.name).size(), ' ') +
                entry.sentence + '\n';
    return text + "  all       all of them";
}

int run_bench(const BenchOptions& options, const Console& console) {
    Bench bench(console, options.quick, options.data);
    bool known = options.name == "all";
    for (const Entry& entry : entries) known = known || options.name == entry.name;
    if (!known)
        throw InputError("F102", "", "There is no benchmark \"" + options.name + "\": choose one of\n" + bench_list());
    for (const Entry& entry : entries) {
        if (options.name != "all" && options.name != entry.name) continue;
        bench.begin(entry.name, entry.sentence);
        entry.run(bench);
    }
    if (!options.json.empty()) write_text(options.json, bench_json(bench).dump(1) + '\n');
    return verdict(bench, options, console);
}

}  // namespace enfilade::tools
