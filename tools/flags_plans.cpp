// Flags of the commands that read plans and make or change scenes.

#include "tools/flags.h"

#include <array>

#include "tools/convexifiers.h"

namespace enfilade::tools {
namespace {

constexpr const char* plan_text =
    "the plan: our JSON, a Sweet Home 3D home (.sh3d), a DXF drawing, or FloorspaceJS JSON";

constexpr const char* report_text =
    "write all findings to this file: .html is a page with the plan drawn, .json is for programs, .txt is plain";

/// Whole numbers: CLI11 would take -1 for the largest one.
std::string not_negative(const std::string& text) {
    return text.starts_with('-') ? "\"" + text + "\" is negative: give a whole number from 0 on" : "";
}

void add_strict(CLI::App* command, bool& strict) { command->add_flag("--strict", strict, "warnings count as errors"); }

void add_read_flags(CLI::App* command, ReadFlags& read) {
    command
        ->add_option_function<std::string>(
            "--units", [&read](const std::string& name) { read.options.unit = plans::unit_of(name); },
            "drawings and FloorspaceJS: unit of the numbers in the file, whatever it says itself: mm, cm, dm, m, km, "
            "in, ft, yd or mi")
        ->option_text("UNIT")
        ->check(CLI::IsMember({"mm", "cm", "dm", "m", "km", "in", "ft", "yd", "mi"}));
    command
        ->add_option("--layer", read.options.layers,
                     "drawings: read this layer only; * and ? match, and it may be given several times (all)")
        ->option_text("NAME")
        ->allow_extra_args(false);
    command->add_flag("--list-layers", read.list_layers, "drawings: name the layers with what is on them, and end");
    command
        ->add_option_function<std::string>(
            "--crop", [&read](const std::string& box) { read.options.crop = parse_crop(box); },
            "drawings: read only what lies in this box of the drawing's own numbers, for sheets with several plans")
        ->option_text("X0,Y0,X1,Y1");
    add_value(command, "--mapping", read.options.mapping, "FILE",
              "drawings: JSON that says which layers and blocks are walls, doors, windows (docs/dxf.md)");
    command
        ->add_option_function<double>(
            "--wall-thickness-mm", [&read](double mm) { read.options.wall_thickness = mm / 1000; },
            "thickness of walls that the file draws as single lines (100)")
        ->option_text("MM")
        ->check(CLI::PositiveNumber);
    command
        ->add_option_function<double>(
            "--storey-height-mm", [&read](double mm) { read.options.storey_height = mm / 1000; },
            "floor to ceiling where the file does not say (2500)")
        ->option_text("MM")
        ->check(CLI::PositiveNumber);
}

void add_model_flags(CLI::App* command, ModelOptions& model) {
    command
        ->add_option_function<std::string>(
            "--storeys", [&model](const std::string& list) { model.storeys = parse_storeys(list); },
            "model these storeys only, counted from 0 upward, like 0,2 (all)")
        ->option_text("LIST");
    add_value(command, "--snap-mm", model.snap_mm, "MM",
              "grid on which all corners lie, rounded down to a power of two of a metre (0.122)")
        ->check(CLI::PositiveNumber);
    add_value(command, "--sagitta-mm", model.sagitta_mm, "MM",
              "largest distance of a curved wall from its straight pieces (2)")
        ->check(CLI::PositiveNumber);
    add_value(command, "--step-mm", model.step_mm, "MM", "height of the steps that sloped wall tops are cut into (250)")
        ->check(CLI::PositiveNumber);
    add_value(command, "--least-thickness-mm", model.least_thickness_mm, "MM",
              "warn of walls and slabs that are thinner (10)")
        ->check(not_negative);
    command
        ->add_option_function<std::string>(
            "--glass", [&model](const std::string& kind) { model.opaque_glass = kind == "opaque"; },
            "clear: light passes windows; opaque: it does not (clear)")
        ->option_text("KIND")
        ->check(CLI::IsMember({"clear", "opaque"}));
    command
        ->add_option_function<std::string>(
            "--convexify", [&model](const std::string& name) { model.convexifier = convexifier_of(name); },
            "how rooms are cut into the cells that rays walk through. sah: few of them, at the least cost to a ray; "
            "hertel-mehlhorn: a triangulation, thinned; diagonals: one cell after the other along the walls (sah)")
        ->option_text("METHOD");
}

void add_furnish_flags(CLI::App* command, FurnishFlags& furnish) {
    add_value(command, "--furnish", furnish.rules, "[RULES]",
              "furnish the rooms by rule: by this file (docs/furnishing.md), or by our own rules where the flag stands "
              "alone; name the plan before it. Without it only the plan's own pieces stand there")
        ->expected(0, 1);
    add_value(command, "--seed", furnish.seed, "N", "of --furnish: another number, other furniture (1)")
        ->check(not_negative)
        ->needs("--furnish");
    command
        ->add_option("--catalogue", furnish.catalogues,
                     "where furniture comes from besides our own pieces: a library of Sweet Home 3D (.sh3f), a home "
                     "(.sh3d), a mesh (.obj, .gltf, .glb, .ply, .off, .stl) or a folder of them; may be given several "
                     "times")
        ->option_text("PATH")
        ->allow_extra_args(false);
    command
        ->add_option_function<std::string>(
            "--objects", [&furnish](const std::string& kind) { furnish.cut = kind == "cut"; },
            "list: rooms stay whole and their cells list what stands in them; cut: each object is a volume of its own, "
            "around which its room is cut (list)")
        ->option_text("KIND")
        ->check(CLI::IsMember({"list", "cut"}));
    add_value(command, "--object-triangles", furnish.object_triangles, "N",
              "decimate meshes of more triangles to this many, where they can be (never)")
        ->check(CLI::Range(4u, 1000000000u));
    command
        ->add_option_function<std::string>(
            "--textures",
            [&furnish](const std::string& side) {
                furnish.texture_side = side == "none" ? 0 : static_cast<std::uint32_t>(std::stoul(side));
            },
            "pictures on furniture, walls and floors, scaled down to this many texels a side: sharper ones take more "
            "memory; none: plain colours (1024)")
        ->option_text("SIZE")
        ->check(CLI::IsMember({"none"}) | CLI::Range(1u, 16384u));
    add_value(command, "--detail", furnish.detail, "N", "of our own pieces: 1 plain, 2 and more rounder and finer (1)")
        ->check(CLI::Range(1u, 8u));
    add_value(
        command, "--rooms", furnish.rooms, "NAME,...",
        "furnish only what can be seen from these rooms, by name or id: pictures from there are those of the full "
        "scene, at a fraction of its time and memory (all)");
    add_value(command, "--views", furnish.views, "FILE",
              "the same for the cameras of this file, as \"enfilade tour\" writes it");
    command->add_flag(
        "--lit", furnish.lit,
        "with --rooms or --views: also what the lamps of the plan and of --lamps shine through on their way there");
    add_value(command, "--lamps", furnish.lamps, "[RULES]",
              "hang lamps by rule: by this file (docs/lamps.md), or by our own rules where the flag stands alone; name "
              "the plan before it. Rooms that the plan lights keep to its lamps")
        ->expected(0, 1);
    command->add_flag("--no-plan-furniture", furnish.no_plan_furniture, "leave out the plan's own pieces");
}

}  // namespace

void add_import(CLI::App& app, Invocation& invocation, ImportOptions& options) {
    CLI::App* command = add_command(app, invocation, options, "import",
                                    "Read a plan in any format and write it as our JSON, with what was repaired.",
                                    "  enfilade import house.sh3d -o house.json", run_import);
    add_positional(command, "PLAN", options.plan, plan_text);
    add_value(command, "-o,--output", options.output, "FILE", "the JSON file to write (needed)");
    add_read_flags(command, options.read);
    add_strict(command, options.strict);
}

void add_generate(CLI::App& app, Invocation& invocation, GenerateCommandOptions& options) {
    CLI::App* command =
        add_command(app, invocation, options, "generate", "Invent the plan of an office building of any size.",
                    "  enfilade generate --rooms 200 --storeys 2 --curved 0.1 -o office.json", run_generate);
    add_value(command, "--rooms", options.rooms, "N", "rooms of the whole building, corridors counted (needed)")
        ->required()
        ->check(CLI::Range(1u, 2000000u));
    add_value(command, "--storeys", options.storeys, "N", "storeys over which they are spread (1)")
        ->check(CLI::Range(1u, 200u));
    add_value(command, "--curved", options.curved, "SHARE", "share of the inner walls that are arcs, 0 to 1 (0)")
        ->check(CLI::Range(0.0, 1.0));
    add_value(command, "--oblique", options.oblique, "SHARE", "share of the inner walls that are turned, 0 to 1 (0)")
        ->check(CLI::Range(0.0, 1.0));
    add_value(command, "--seed", options.seed, "N", "another number, another building (1)")->check(not_negative);
    add_needed(command, "-o,--output", options.output, "FILE", "the JSON file to write (needed)");
}

void add_build(CLI::App& app, Invocation& invocation, BuildCommandOptions& options) {
    CLI::App* command = add_command(
        app, invocation, options, "build", "Model a building from its plan, check it, and write it as a scene.",
        "  enfilade build house.sh3d -o house.enf --report house.txt\n"
        "  enfilade build office.json -o office.enf --furnish --seed 3 --rooms \"Office 0.012\"",
        run_build);
    add_positional(command, "PLAN", options.plan, plan_text);
    add_value(command, "-o,--output", options.output, "FILE", "the scene file to write, .enf (needed)");
    add_furnish_flags(command, options.furnish);
    add_model_flags(command, options.model);
    add_read_flags(command, options.read);
    command->add_flag("--keep-going", options.keep_going, "write the scene even where the check finds errors");
    command->add_flag("--strip", options.strip,
                      "leave out the model group: a smaller file that can be traced, but not checked");
    add_value(command, "--report", options.report, "FILE", report_text);
    add_strict(command, options.strict);
}

void add_check(CLI::App& app, Invocation& invocation, CheckOptions& options) {
    CLI::App* command =
        add_command(app, invocation, options, "check",
                    "Say whether the model of a plan, or a scene file, is sound, and what is wrong where.",
                    "  enfilade check house.sh3d\n  enfilade check house.enf --json", run_check);
    add_positional(command, "INPUT", options.input,
                   "a plan, a scene file (.enf), or a mesh of closed bodies (.obj, .off, .ply, .stl, .city.json)");
    add_value(command, "--report", options.report, "FILE", report_text);
    add_model_flags(command, options.model);
    add_read_flags(command, options.read);
    add_value(command, "--weld", options.weld, "DISTANCE",
              "meshes: join points this close, in the file's unit; 0 joins equal points (none; STL: 0)")
        ->check(not_negative);
    add_value(command, "--planar-distance", options.planar_distance, "DISTANCE",
              "meshes: how far a corner may lie from the plane of its face, in the file's unit (0.01)")
        ->check(not_negative);
    add_value(command, "--planar-angle-deg", options.planar_angle_deg, "DEGREES",
              "meshes: by how much a face may be folded (20)")
        ->check(CLI::Range(0.0, 180.0));
    add_strict(command, options.strict);
}

void add_place(CLI::App& app, Invocation& invocation, PlaceOptions& options) {
    CLI::App* command = add_command(app, invocation, options, "place",
                                    "Move, turn, add or remove one object of a scene, or list them all.",
                                    "  enfilade place house.enf\n"
                                    "  enfilade place house.enf --move living-room/chair-2 --at 3.2,1.5\n"
                                    "  enfilade place house.enf --add own/plant --at 1,4 --angle 30 -o greener.enf",
                                    run_place);
    add_positional(command, "SCENE", options.scene, "the scene file (.enf), with its model group");
    add_value(command, "-o,--output", options.output, "FILE", "the scene file to write (SCENE itself)");
    CLI::Option* move = add_value(command, "--move", options.move, "ID", "move this object --at a place");
    CLI::Option* turn = add_value(command, "--turn", options.turn, "ID", "turn this object by --angle");
    CLI::Option* add = add_value(command, "--add", options.add, "MODEL",
                                 "add an object --at a place: the id of a catalogue entry, like own/chair, or a kind");
    CLI::Option* remove =
        add_value(command, "--remove", options.remove, "ID", "remove this object, and what stands on it");
    const std::array<CLI::Option*, 4> edits = {move, turn, add, remove};
    for (CLI::Option* one : edits)
        for (CLI::Option* other : edits)
            if (one != other) one->excludes(other);
    add_value(
        command, "--at", options.at, "X,Y[,Z]",
        "where the middle of its bottom comes to stand: metres, as in the plan. Without Z a moved object keeps its "
        "height, and an added one stands on the lowest floor there");
    add_value(
        command, "--angle", options.angle_deg, "DEGREES",
        "--turn, counter-clockwise: by so much; --add and --move: so stands its front, 0 towards -y (0; as it is)");
    add_value(command, "--id", options.id, "ID", "what the added object is called (its model, with a number)");
    command
        ->add_option(
            "--catalogue", options.catalogues,
            "where --add looks for its model besides our own pieces: a library (.sh3f), a home (.sh3d), a mesh "
            "or a folder of them; may be given several times")
        ->option_text("PATH")
        ->allow_extra_args(false);
    command->add_flag("--keep-going", options.keep_going, "write the scene even where the check finds errors");
}

}  // namespace enfilade::tools
