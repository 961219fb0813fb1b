// Flags of the commands that read scenes.

#include "accel/octree/octree.h"
#include "tools/flags.h"

namespace enfilade::tools {

namespace {

constexpr std::uint32_t largest_leaf = 4096;

void add_object_accel(CLI::App* command, ObjectAccelFlags& flags) {
    add_value(
        command, "--object-accel", flags.kind, "KIND",
        "how rays find the triangles of objects: bvh, by Embree's tree of boxes where this was built with Embree, "
        "else as plain; plain, by our own tree of boxes; octree, by our own octree, from leaf to leaf (bvh where "
        "this was built with Embree, else octree)")
        ->check(CLI::IsMember({"bvh", "plain", "octree"}));
    add_value(command, "--octree-depth", flags.octree_depth, "N",
              "of octrees, 1 to 20: no leaf is smaller than their box halved that often (as deep as pays for the mesh)")
        ->check(CLI::Range(1u, accel::largest_octree_depth));
    add_value(
        command, "--octree-leaf", flags.octree_leaf, "N",
        "of octrees, 1 to 4096: leaves with no more triangles than this are not split (whatever costs a ray least)")
        ->check(CLI::Range(1u, largest_leaf));
    command->add_flag("--octree-balance", flags.octree_balance,
                      "of octrees: leaves that touch differ by one level at most, as in the paper; more leaves");
    add_value(
        command, "--octree-layout", flags.octree_layout, "NAME",
        "of octrees: linked, ours; ropes, as in the paper, with boxes that are computed; stored, as in the paper, "
        "with boxes that are stored (linked)")
        ->check(CLI::IsMember({"linked", "ropes", "stored"}));
    add_value(command, "--octree-real", flags.octree_real, "TYPE",
              "of the paper's layouts: float or double, the numbers by which rays leave leaves (float)")
        ->check(CLI::IsMember({"float", "double"}));
}

void add_lights(CLI::App* command, LightFlags& flags) {
    add_value(
        command, "--lights", flags.search, "HOW",
        "the scene's lamps shine, and which of them a place sees is found out so: tree, by the light tree of each "
        "lamp; pvs, by a ray to each lamp that the place's cell may see; naive, by a ray to each lamp there is. "
        "All make the same picture. none: no lamp shines (none)")
        ->check(CLI::IsMember({"none", "naive", "pvs", "tree"}));
    add_value(
        command, "--exposure", flags.exposure, "EV",
        "of pictures lit by lamps: auto, or an exposure value (of ISO 100): 5 to 7 suit rooms in the evening, and "
        "each step more halves the brightness. auto: 97 % of the lit pixels of all pictures stay under white. Without "
        "it .exr files hold candela / m2 (auto)");
    add_value(command, "--ambient", flags.ambient_lux, "LUX",
              "light of no lamp, which corners darken, where lamps shine with --shading look (a tenth of what becomes "
              "white)");
    add_value(command, "--light-clusters", flags.clusters, "ERROR",
              "for very many lamps: those that stand together shine as one where they are no larger than this share, "
              "from 0 to under 1, of their distance. 0.2 is four times as fast with 2,500 lamps outdoors (none)");
}

void add_paths(CLI::App* command, RenderOptions& options) {
    constexpr std::uint32_t most_samples = 1u << 20, most_bounces = 1000;
    PathFlags& flags = options.path;
    add_value(
        command, "--integrator", flags.integrator, "NAME",
        "direct: light straight from lamps, sun and sky; path: also what goes from surface to surface, as it is in "
        "rooms; slow, and noisy at first (direct)")
        ->check(CLI::IsMember({"direct", "path"}));
    add_value(command, "--spp", options.spp, "N",
              "samples a pixel: of direct light rounded up to 1, 4, 9, 16 ... (4); of paths at most so many (64)")
        ->check(CLI::Range(1u, most_samples));
    add_value(
        command, "--noise", flags.noise, "SHARE",
        "paths: parts of the picture with less noise than this get no more samples, like 0.03; 0: all get all (0)");
    add_value(command, "--bounces", flags.bounces, "N",
              "paths: so often light is followed from surface to surface; 0: direct light alone (32)")
        ->check(CLI::Range(0u, most_bounces));
    add_value(command, "--seed", flags.seed, "N", "paths: another number, other noise (0)");
}

}  // namespace

void add_info(CLI::App& app, Invocation& invocation, InfoOptions& options) {
    CLI::App* command = add_command(app, invocation, options, "info",
                                    "Show what a scene file holds: rooms, cells, bytes, and how they are joined.",
                                    "  enfilade info house.enf\n  enfilade info house.enf --svg cuts.svg\n"
                                    "  enfilade info house.enf --visible-from Kitchen",
                                    run_info);
    add_positional(command, "SCENE", options.scene, "the scene file (.enf)");
    CLI::Option* svg = add_value(command, "--svg", options.svg, "FILE",
                                 "draw how the rooms are cut, with cuts coloured by the area of their portal, to this "
                                 "file (.svg)");
    add_value(command, "--storey", options.storey, "STOREY",
              "draw this storey only, by its name or its number, counted from 0 (all)")
        ->needs(svg);
    add_value(command, "--visible-from", options.visible_from, "ROOM",
              "say what can be seen from the room of this name or id instead: which rooms, through how many doors and "
              "windows at least, and what share of its view each fills");
}

void add_render(CLI::App& app, Invocation& invocation, RenderOptions& options) {
    CLI::App* command = add_command(app, invocation, options, "render", "Render a picture of a scene, or of a mesh.",
                                    "  enfilade render house.enf -o house.png --camera dollhouse\n"
                                    "  enfilade render house.enf -o kitchen.png --room Kitchen\n"
                                    "  enfilade render house.enf -o tour/ --views house.views.json\n"
                                    "  enfilade render bunny.obj -o leaves.png --show leaves",
                                    run_render);
    add_positional(
        command, "SCENE", options.scene,
        "the scene file (.enf), or a mesh (.obj, .gltf, .glb, .ply, .off, .stl), which is shown by itself on a "
        "plain, 2 m large, with the middle of its bottom at 0,0,0");
    add_needed(
        command, "-o,--output", options.output, "FILE",
        "the picture to write, .png or .exr; of several views a folder, like tour/, or a name with a number, like "
        "tour-%02d.png (needed)");
    CLI::Option* camera = add_value(command, "--camera", options.camera, "VIEW", camera_help());
    CLI::Option* room =
        add_value(command, "--room", options.room, "NAME", "look into the room of this name or id, from inside it")
            ->excludes(camera);
    add_value(command, "--views", options.views, "FILE",
              "a picture of each view of this file, as \"enfilade tour\" writes it (docs/views.schema.json)")
        ->excludes(camera)
        ->excludes(room);
    add_value(command, "--up", options.up, "AXIS",
              "meshes: which axis of the file points up, y or z (y of OBJ and glTF, z of PLY, OFF and STL)")
        ->check(CLI::IsMember({"y", "z"}));
    add_value(command, "--size", options.size, "WxH", "width and height in pixels (1024x1024)");
    add_value(command, "--fov-deg", options.fov_deg, "DEGREES", "field of view across the longer side (the view's own)")
        ->check(CLI::Range(1.0, 170.0));
    add_value(
        command, "--tracer", options.tracer, "NAME",
        "scalar: through the cells, one ray at a time; simd: as many rays as a register holds; packet: whole tiles "
        "of the picture; cuda: by a CUDA card; oracle: every face against every ray, slow; simd and packet are for "
        "--shading lambert --spp 1 of a building not cut open, other pictures go ray by ray (packet)")
        ->check(CLI::IsMember({"scalar", "simd", "packet", "cuda", "oracle"}));
    add_value(
        command, "--device", options.device, "N",
        "cuda tracer: which card, counted from 0; or host: this machine's cores play the card, slowly, to look at "
        "what it would draw (0)");
    add_value(
        command, "--real", options.real, "TYPE",
        "float or double: the numbers in which rays walk; double is for the scalar tracer, and chooses it (float)")
        ->check(CLI::IsMember({"float", "double"}));
    add_value(command, "--packets", options.packets, "LARGEST:SMALLEST",
              "packet tracer: pixels a side of the tiles that it begins with, and of those that it walks ray by ray "
              "(64:8)");
    add_value(command, "--mirror-floor", options.mirror_floor, "[SHARE]",
              "floors mirror this share of the light, 0 to 1; 0.25 where the flag stands alone (0)")
        ->expected(0, 1);
    add_value(
        command, "--shading", options.shading, "NAME",
        "look: sun, sky and darkened corners, or with --lights an evening: a dim sky besides the lamps; lambert: one "
        "lamp at the eye, as the oracle has it, or with --lights the scene's lamps and nothing else (look)")
        ->check(CLI::IsMember({"look", "lambert"}));
    add_lights(command, options.lights);
    add_paths(command, options);
    add_value(command, "--threads", options.threads, "N", "how many cores to use (all)");
    add_value(command, "--show", options.show, "WHAT",
              "instead of light, in false colours what each pixel's ray costs the scalar tracer: cells, the ones it "
              "enters past all objects; sides, the vertical lines it is tested against; lamps, those that the cell it "
              "ends in may see; leaves, those of objects' "
              "octrees that it enters up to what it meets; or blocks of 16 triangles that it is tested against there. "
              "The scale takes the lowest rows of the file, and the picture the rows above it")
        ->check(CLI::IsMember({"cells", "sides", "lamps", "leaves", "blocks"}));
    add_object_accel(command, options.object_accel);
    command->add_flag("--no-objects", options.no_objects, "show the rooms without what stands in them");
    command->add_flag(
        "--stats", options.stats,
        "say what happened to the rays: cells and sides a ray, packets, recoveries; with --json it is always "
        "there");
}

void add_trace(CLI::App& app, Invocation& invocation, TraceCommandOptions& options) {
    CLI::App* command = add_command(app, invocation, options, "trace",
                                    "Answer many rays: what each meets, whether it is blocked, all it passes.",
                                    "  enfilade trace house.enf rays.npy -o hits.npy\n"
                                    "  enfilade trace house.enf links.npy -o passages.npy --query all",
                                    run_trace);
    add_positional(command, "SCENE", options.scene, "the scene file (.enf)");
    add_positional(command, "RAYS", options.rays,
                   "rays as numpy saves them (.npy): (n, 6) numbers, origin and direction in metres of the plan, or "
                   "(n, 7) with a maximal distance");
    add_needed(command, "-o,--output", options.output, "FILE", "the answers to write, .npy (needed; docs/queries.md)");
    add_value(command, "--query", options.query, "KIND",
              "nearest: the face that each ray meets; any: whether something opaque lies within its distance; all: "
              "every cell, door, pane and solid that it passes, with thicknesses (nearest)")
        ->check(CLI::IsMember({"nearest", "any", "all"}));
    add_value(command, "--real", options.real, "KIND",
              "float, or double: ray by ray, slower (float; all is always computed in double)")
        ->check(CLI::IsMember({"float", "double"}));
    add_value(command, "--tracer", options.tracer, "NAME",
              "scalar: one ray at a time; simd: as many as a register holds; packet: whichever is fastest (packet)")
        ->check(CLI::IsMember({"scalar", "simd", "packet"}));
    add_object_accel(command, options.object_accel);
    command->add_flag("--no-objects", options.no_objects,
                      "walk through rooms without what stands in them; --query all always does");
    add_value(command, "--threads", options.threads, "N", "how many cores to use (all)");
}

void add_tour(CLI::App& app, Invocation& invocation, TourCommandOptions& options) {
    CLI::App* command = add_command(app, invocation, options, "tour",
                                    "Walk through a building, from room to room, and save the views along the way.",
                                    "  enfilade tour house.enf -o house.views.json\n"
                                    "  enfilade render house.enf --views house.views.json -o tour/",
                                    run_tour);
    add_positional(command, "SCENE", options.scene, "the scene file (.enf)");
    add_needed(command, "-o,--output", options.output, "FILE",
               "the view file to write, JSON (docs/views.schema.json) (needed)");
    add_value(command, "--views", options.views, "N", "how many views (24)")->check(CLI::Range(1u, 100000u));
    add_value(command, "--rooms", options.rooms, "N", "how many rooms, or places in them, the walk leads to (8)")
        ->check(CLI::Range(1u, 1000u));
}

void add_export(CLI::App& app, Invocation& invocation, ExportOptions& options) {
    CLI::App* command = add_command(
        app, invocation, options, "export", "Write a scene in a format of other programs.",
        "  enfilade export house.enf -o house.glb\n  enfilade export house.enf -o house.graphml", run_export);
    add_positional(command, "SCENE", options.scene, "the scene file (.enf)");
    add_needed(command, "-o,--output", options.output, "FILE",
               "the file to write (needed); its ending chooses the format:" + export_list());
    add_value(command, "--level", options.level, "LEVEL", "of a .dot graph: rooms, or the convex cells (rooms)")
        ->check(CLI::IsMember({"rooms", "cells"}));
}

void add_bench(CLI::App& app, Invocation& invocation, BenchOptions& options) {
    CLI::App* command =
        add_command(app, invocation, options, "bench",
                    "Measure how fast this machine does it, against the goals and the best known relatives.",
                    "  enfilade bench cells --quick", run_bench, false);
    add_positional(command, "NAME", options.name, "which one:\n" + bench_list());
    command->add_flag("--quick", options.quick, "smaller inputs and fewer runs: at most 40 seconds");
    add_value(command, "--json", options.json, "FILE", "also write the rows to this file");
    add_value(command, "--data", options.data, "FOLDER",
              "where other people's plans lie, in sh3d, dxf and other; benchmarks of them are left out without it "
              "(../shared/data)");
    command->add_flag("--strict", options.strict, "end with 1 where a goal is not met");
}

}  // namespace enfilade::tools
