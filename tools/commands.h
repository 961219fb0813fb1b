#pragma once
// The subcommands of `enfilade`: the options of each, and the function that runs it and returns the exit code
// (exit_code.h). They throw InputError and IoError; main.cpp reads the flags and prints what they throw.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "modeler/convexify.h"
#include "plans/read.h"
#include "tools/console.h"

namespace enfilade::tools {

/// What plan files need to be told: the flags that `import`, `build` and `check` share.
struct ReadFlags {
    plans::ReadOptions options;
    bool list_layers = false;  ///< name the layers of a drawing, and do nothing else
};

/// "x0,y0,x1,y1" as a box. Throws InputError.
[[nodiscard]] plans::DrawingBox parse_crop(const std::string& text);

/// Throws InputError where no output is named.
void need_output(const std::filesystem::path& output, const std::string& command);

/// Prints the layers of a drawing. Throws InputError where the file is none.
int list_layers(const std::filesystem::path& file, const Console& console);

struct ImportOptions {
    std::filesystem::path plan;
    std::filesystem::path output;
    ReadFlags read;
    bool strict = false;
};
int run_import(const ImportOptions& options, const Console& console);

struct GenerateCommandOptions {
    std::uint32_t rooms = 46;
    std::uint32_t storeys = 1;
    double curved = 0;
    double oblique = 0;
    std::uint64_t seed = 1;
    std::filesystem::path output;
};
int run_generate(const GenerateCommandOptions& options, const Console& console);

/// How a plan becomes a model: the flags that `build` and `check` share.
struct ModelOptions {
    std::vector<std::uint32_t> storeys;
    std::optional<double> snap_mm;
    std::optional<double> sagitta_mm;
    std::optional<double> step_mm;
    bool opaque_glass = false;
    modeler::Convexifier convexifier = modeler::Convexifier::Sah;
    std::optional<double> least_thickness_mm;
};

/// "0,2" as numbers. Throws InputError.
[[nodiscard]] std::vector<std::uint32_t> parse_storeys(const std::string& list);

/// What stands in the rooms: flags of `build`.
struct FurnishFlags {
    std::optional<std::string> rules;  ///< a rule file, or empty for the program's own; nothing: none by rule
    std::uint64_t seed = 1;
    std::vector<std::filesystem::path> catalogues;
    bool cut = false;                    ///< objects are volumes that rooms are cut around; else cells list them
    std::uint32_t object_triangles = 0;  ///< meshes of more are decimated to this; 0: never
    std::uint32_t texture_side = 1024;   ///< textures have at most that many texels a side; 0: there are none
    std::uint32_t detail = 1;            ///< of our own pieces
    std::string rooms;                   ///< names: only what can be seen from them counts; empty: everything
    std::filesystem::path views;         ///< the same for cameras
    bool lit = false;                    ///< and what lamps shine through on their way there
    bool no_plan_furniture = false;      ///< the plan's own pieces stay away
    std::optional<std::string> lamps;    ///< a lamp rule file, or empty for the program's own; nothing: none by rule
};

struct BuildCommandOptions {
    std::filesystem::path plan;
    std::filesystem::path output;
    std::filesystem::path report;  ///< .html, .json or .txt; empty: none
    ReadFlags read;
    ModelOptions model;
    FurnishFlags furnish;
    bool keep_going = false;
    bool strip = false;
    bool strict = false;
};
int run_build(const BuildCommandOptions& options, const Console& console);

struct CheckOptions {
    std::filesystem::path input;   ///< a plan, a scene or a mesh
    std::filesystem::path report;  ///< .html, .json or .txt; empty: none
    ReadFlags read;
    ModelOptions model;
    std::optional<double> weld;              ///< meshes: join points this close, in the file's unit; nothing: none
    std::optional<double> planar_distance;   ///< meshes: of corners from their face's plane, in the file's unit
    std::optional<double> planar_angle_deg;  ///< meshes: within a face
    bool strict = false;
};
int run_check(const CheckOptions& options, const Console& console);

/// One object of a scene: moved, turned, added or removed; all are listed where none is named.
struct PlaceOptions {
    std::filesystem::path scene;
    std::filesystem::path output;  ///< empty: the scene file itself
    std::string move;              ///< id; with `at`
    std::string turn;              ///< id; with `angle`
    std::string remove;            ///< id
    std::string add;               ///< a model: id of a catalogue entry, or a kind; with `at`
    std::string id;                ///< of what is added; empty: made from its model
    std::string at;                ///< "X,Y" or "X,Y,Z"
    std::optional<double> angle_deg;
    std::vector<std::filesystem::path> catalogues;
    bool keep_going = false;
};
int run_place(const PlaceOptions& options, const Console& console);

struct InfoOptions {
    std::filesystem::path scene;
    std::filesystem::path svg;  ///< a drawing of the cuts; empty: none
    std::string storey;         ///< which one is drawn, by name or number; empty: all
    std::string visible_from;   ///< the room whose sight is asked for; empty: none
};
int run_info(const InfoOptions& options, const Console& console);

/// How rays find the triangles of objects: flags that `render` and `trace` share (object_accel.h).
struct ObjectAccelFlags {
    std::string kind;                           ///< "bvh", "plain" or "octree"; empty: the fastest that was built
    std::optional<std::uint32_t> octree_depth;  ///< nothing: by the mesh
    std::optional<std::uint32_t> octree_leaf;
    bool octree_balance = false;
    std::string octree_layout;  ///< "linked", "ropes" or "stored"; empty: linked
    std::string octree_real;    ///< "float" or "double"; empty: float
};

/// How lamps light pictures: flags of `render` (light_flags.h).
struct LightFlags {
    std::string search;                 ///< "none", "naive", "pvs" or "tree"; empty: none
    std::string exposure;               ///< "auto", or an exposure value; empty: auto
    std::optional<double> ambient_lux;  ///< nothing: by the exposure
    std::optional<double> clusters;     ///< how large clusters of lamps may be, over their distance; nothing: none
};

/// Light that goes from surface to surface: flags of `render` (path_pictures.h).
struct PathFlags {
    std::string integrator;  ///< "direct" or "path"; empty: direct
    std::optional<double> noise;
    std::optional<std::uint32_t> bounces;
    std::optional<std::uint64_t> seed;
};

struct RenderOptions {
    std::filesystem::path scene;   ///< or a mesh
    std::string up;                ///< of a mesh: "y" or "z"; empty: what its format usually has
    std::filesystem::path output;  ///< of several views: a folder, or a name with %02d
    std::filesystem::path views;   ///< a file of views: a picture of each; empty: none
    std::string camera;            ///< empty: chosen by `room`, or the whole building
    std::string room;
    std::string size = "1024x1024";
    std::string tracer;                       ///< empty: packets, or scalar where `real` is "double"
    std::string device;                       ///< of the cuda tracer: a card's number, or "host"; empty: card 0
    std::string real;                         ///< "float" or "double"; empty: the tracer's own
    std::string packets;                      ///< "64:8"; empty: the usual ones
    std::optional<std::string> mirror_floor;  ///< a share, or empty for the usual one; nothing: dull floors
    std::string shading = "look";
    std::string show;    ///< "cells", "sides", "lamps", "leaves" or "blocks" a ray in false colours; empty: light
    bool stats = false;  ///< say what happened to the rays
    ObjectAccelFlags object_accel;
    LightFlags lights;
    PathFlags path;
    bool no_objects = false;           ///< rooms without what stands in them
    std::optional<double> fov_deg;     ///< nothing: the view's own
    std::optional<std::uint32_t> spp;  ///< samples a pixel; nothing: 4, and 64 of paths
    std::uint32_t threads = 0;         ///< 0: all
};
/// What --camera takes.
[[nodiscard]] std::string camera_help();
int run_render(const RenderOptions& options, const Console& console);

struct TraceCommandOptions {
    std::filesystem::path scene;
    std::filesystem::path rays;    ///< .npy
    std::filesystem::path output;  ///< .npy
    std::string query = "nearest";
    std::string real;    ///< empty: what the query takes
    std::string tracer;  ///< empty: the fastest
    ObjectAccelFlags object_accel;
    bool no_objects = false;
    std::uint32_t threads = 0;
};
int run_trace(const TraceCommandOptions& options, const Console& console);

struct TourCommandOptions {
    std::filesystem::path scene;
    std::filesystem::path output;  ///< a view file
    std::uint32_t views = 24;
    std::uint32_t rooms = 8;
};
int run_tour(const TourCommandOptions& options, const Console& console);

struct ExportOptions {
    std::filesystem::path scene;
    std::filesystem::path output;
    std::string level = "rooms";  ///< of .dot: "rooms" or "cells"
};
/// The endings that `export` knows, a line each with what the format holds.
[[nodiscard]] std::string export_list();
int run_export(const ExportOptions& options, const Console& console);

struct BenchOptions {
    std::string name;
    bool quick = false;
    bool strict = false;
    std::filesystem::path json;                     ///< empty: none
    std::filesystem::path data = "../shared/data";  ///< real plans, which `convexify` reads where they are there
};
int run_bench(const BenchOptions& options, const Console& console);
/// The names that `bench` takes, each with its sentence.
[[nodiscard]] std::string bench_list();

}  // namespace enfilade::tools
