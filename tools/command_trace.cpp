#include <nlohmann/json.hpp>
#include <optional>

#include "accel/scene_file.h"
#include "base/error.h"
#include "render/executor.h"
#include "tools/bench.h"
#include "tools/commands.h"
#include "tools/exit_code.h"
#include "tools/object_accel.h"
#include "tools/output_file.h"
#include "tools/progress.h"
#include "tools/query_rays.h"
#include "tools/scene_solids.h"

namespace enfilade::tools {

namespace {

using Json = nlohmann::ordered_json;

render::Tracer tracer_of(const std::string& name) {
    return name == "scalar" ? render::Tracer::Scalar : name == "simd" ? render::Tracer::Simd : render::Tracer::Packet;
}

/// Where the offsets of passages go: hits.npy has hits.offsets.npy beside it.
std::filesystem::path offsets_path(const std::filesystem::path& output) {
    return output.parent_path() / (output.stem().string() + ".offsets.npy");
}

void check_flags(const TraceCommandOptions& options) {
    if (options.output.extension() != ".npy")
        throw InputError("F145", options.output.string(), "Answers are written as .npy: end the name so.");
    const bool is_all = options.query == "all";
    const bool is_double = is_all || options.real == "double";
    if (is_all && options.real == "float")
        throw InputError("F146", "", "--query all is always computed in double: leave out --real float.");
    if (is_double && (options.tracer == "simd" || options.tracer == "packet"))
        throw InputError("F146", "",
                         "Double is walked ray by ray: leave out --tracer " + options.tracer + ", or give it scalar.");
    for (const std::filesystem::path& written : {options.output, offsets_path(options.output)}) {
        std::error_code ignored;
        for (const std::filesystem::path& read : {options.rays, options.scene})
            if (std::filesystem::equivalent(written, read, ignored))
                throw InputError("F147", written.string(),
                                 "This file is read: choose another name for what is written (-o).");
    }
}

QueryReport answer(const TraceCommandOptions& options, const accel::Scene& scene, const RayFile& rays,
                   const QueryOptions& query) {
    OutputFile file(options.output);
    QueryReport report;
    if (options.query == "all") {
        OutputFile offsets_file(offsets_path(options.output));
        const std::vector<NpyField> fields = passage_fields(), number = {{"", "<i8"}};
        NpyWriter passages(file.temporary(), fields, sizeof(render::Passage));
        NpyWriter offsets(offsets_file.temporary(), number, 8);
        report = query_all(scene.view(), rays, passages, offsets, query);
        passages.finish(report.passages);
        offsets.finish(report.rays + 1);
        offsets_file.commit();
    } else if (options.query == "any") {
        const std::vector<NpyField> number = {{"", "|u1"}};
        NpyWriter sights(file.temporary(), number, 1);
        report = query_any(scene.view(), rays, sights, query);
        sights.finish(report.rays);
    } else {
        const std::vector<NpyField> fields = hit_fields();
        NpyWriter hits(file.temporary(), fields, sizeof(HitRecord));
        report = query_nearest(scene.view(), rays, hits, query);
        hits.finish(report.rays);
    }
    file.commit();
    return report;
}

std::uint64_t count_of(const QueryReport& report, RayStatus status) { return report.of_status[std::size_t(status)]; }

Json report_json(const TraceCommandOptions& options, const QueryReport& report, const ObjectsSummary& seen,
                 double seconds) {
    Json json = {{"command", "trace"},
                 {"input", options.scene.string()},
                 {"rays_file", options.rays.string()},
                 {"output", options.output.string()},
                 {"query", options.query}};
    json["objects"] = seen.json();
    json["rays"] = report.rays;
    if (options.query == "all") {
        json["offsets_output"] = offsets_path(options.output).string();
        json["passages"] = report.passages;
        json["solids"] = report.solids;
        json["buried"] = count_of(report, RayStatus::Wall);
    } else {
        json["hits"] = count_of(report, RayStatus::Hit);
    }
    json["sky"] = count_of(report, RayStatus::Sky);
    json["reached"] = count_of(report, RayStatus::Reached);
    json["in_walls"] = report.in_walls;
    json["refused"] = count_of(report, RayStatus::Refused);
    json["leaks"] = count_of(report, RayStatus::Leak);
    json["seconds"] = seconds;
    json["mrays_per_second"] = seconds > 0 ? double(report.rays) / seconds / 1e6 : 0;
    json["busy_seconds"] = {{"read", report.busy.read},
                            {"locate", report.busy.locate},
                            {"trace", report.busy.trace},
                            {"write", report.busy.write}};
    return json;
}

std::string report_text(const TraceCommandOptions& options, const QueryReport& report, double seconds) {
    char rate[48];
    std::snprintf(rate, sizeof rate, " (%.1f Mrays/s)", seconds > 0 ? double(report.rays) / seconds / 1e6 : 0);
    std::string text =
        options.output.string() + ": " + counted(report.rays, "ray") + " in " + time_text(seconds) + rate;
    const auto part = [&](std::uint64_t count, const char* what) {
        if (count > 0) text += ", " + grouped(count) + ' ' + what;
    };
    if (options.query == "all") {
        text += ", " + counted(report.passages, "passage");
        part(report.solids, "of them through solids");
    } else {
        part(count_of(report, RayStatus::Hit), options.query == "any" ? "blocked" : "hits");
    }
    part(count_of(report, RayStatus::Sky), "to the sky");
    part(count_of(report, RayStatus::Reached), "as far as asked");
    part(report.in_walls, "that start in walls");
    part(count_of(report, RayStatus::Refused), "refused (no direction, or no numbers)");
    part(count_of(report, RayStatus::Leak), "leaked: please report that");
    return text + '.';
}

}  // namespace

int run_trace(const TraceCommandOptions& options, const Console& console) {
    check_flags(options);
    if (options.no_objects) refuse_object_accel(options.object_accel, "With --no-objects rays see no objects");
    if (options.query == "all")
        refuse_object_accel(options.object_accel, "--query all passes through rooms and sees no objects");
    const ObjectAccelChoice accel = object_accel_choice(options.object_accel);
    (void)output_path(options.output);  // what cannot be written is said before the work
    QueryReport report;
    ObjectsSummary seen;
    double seconds = 0;
    bool has_model = true;
    {
        Progress progress(console, {"Reading the scene", "Tracing"});
        const accel::Scene scene = accel::open(options.scene);
        const RayFile rays(options.rays);
        const std::unique_ptr<accel::Executor> cores = render::make_executor(options.threads);
        QueryOptions query;
        query.tracer = tracer_of(options.tracer);
        query.precision = options.real == "double" ? render::Precision::Double : render::Precision::Float;
        query.executor = cores.get();
        query.progress = [&](double done) { progress.fraction(done); };
        PreparedObjects prepared;
        render::ObjectTracer objects;
        if (scene.view().has_objects() && !options.no_objects && options.query != "all") {
            prepared = prepare_objects(scene.view(), accel, *cores);
            seen = prepared.summary;
            objects = prepared.accel->tracer();
            query.objects = &objects;
        }
        render::Solids solids;
        if (options.query == "all") {
            solids = solids_of(scene);
            has_model = scene.has_model();
            if (has_model) query.solids = &solids;
        }
        progress.next();
        seconds = seconds_of([&] { report = answer(options, scene, rays, query); });
    }
    if (!has_model)
        console.say("The scene was stripped: solids are named by the faces that light sees, and not told apart.");
    if (console.json()) console.print(report_json(options, report, seen, seconds).dump(2) + '\n');
    else console.say(report_text(options, report, seconds));
    return exit_ok;
}

}  // namespace enfilade::tools
