#include "tools/view_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <system_error>

#include "accel/locate.h"
#include "base/error.h"
#include "plans/json_fields.h"
#include "plans/limits.h"
#include "plans/number_text.h"
#include "tools/console.h"

namespace enfilade::tools {

namespace {

using render::Vec3d;

constexpr std::uintmax_t max_file_bytes = std::uintmax_t{64} << 20;  // some 400,000 views
constexpr double usual_fov_deg = 75;
constexpr double least_fov_deg = 1;
constexpr double largest_fov_deg = 170;
constexpr std::string_view file_list[] = {"format_version", "views"};
constexpr std::string_view view_list[] = {"name", "eye", "target", "fov_deg", "cell"};
constexpr plans::JsonKeys file_keys{"view file", file_list};
constexpr plans::JsonKeys view_keys{"view", view_list};

Vec3d origin_of(const accel::SceneView& scene) { return {scene.origin[0], scene.origin[1], scene.origin[2]}; }

std::string read_text(const std::filesystem::path& path) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error))
        throw IoError("The view file " + path.string() + " is a folder; name a file in it.");
    std::ifstream stream(path, std::ios::binary);
    if (!stream) throw IoError("The view file " + path.string() + " cannot be opened; check its name.");
    if (std::filesystem::file_size(path, error) > max_file_bytes && !error)
        throw InputError("F134", path.string(), "The file is larger than 64 MiB, which no view file needs.");
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (stream.bad()) throw IoError("Reading the view file " + path.string() + " failed half way.");
    return text;
}

/// [x, y, z] in metres.
Vec3d read_point(const plans::Fields& fields, std::string_view key, const plans::JsonSource& source) {
    const plans::JsonValue& value = fields.at(key);
    const plans::JsonValue::Array* items = value.array();
    if (items == nullptr || items->size() != 3) fields.wrong_kind(key, value, "a point [x, y, z]");
    std::array<double, 3> point = {};
    for (std::size_t k = 0; k < 3; ++k) {
        const double* number = (*items)[k].number();
        if (number == nullptr) fields.wrong_kind(key, value, "a point [x, y, z] of three numbers");
        if (!(std::abs(*number) <= plans::limits::coordinate))
            plans::refuse(source, "P105", (*items)[k].place,
                          "A coordinate must be within " + plans::rounded_text(plans::limits::coordinate, 0) +
                              " m of the origin, but is " + plans::number_text(*number) + " m.");
        point[k] = *number;
    }
    return {point[0], point[1], point[2]};
}

/// The index that the file gives; nothing where it gives none.
std::optional<std::uint64_t> read_cell(const plans::Fields& fields) {
    if (!fields.has("cell")) return std::nullopt;
    const double number = fields.number("cell", {0, 4294967295.0});
    if (number != std::floor(number)) fields.wrong_kind("cell", fields.at("cell"), "a whole number");
    return static_cast<std::uint64_t>(number);
}

std::array<double, 3> eye_as_traced(const render::Camera& camera) {
    const render::Vec3f eye = render::vec_cast<float>(camera.eye);
    return {eye.x, eye.y, eye.z};
}

/// What is wrong with a camera, or nothing.
std::optional<std::string> fault_of(const render::Camera& camera) {
    try {
        (void)render::make_frame(camera);
    } catch (const InputError& error) {
        return error.what();
    }
    return std::nullopt;
}

std::string text_of(const Vec3d& p) {
    return '(' + plans::rounded_text(p.x, 3) + ", " + plans::rounded_text(p.y, 3) + ", " + plans::rounded_text(p.z, 3) +
           ')';
}

std::string stands_nowhere(const accel::SceneView& scene, const std::string& name, const Vec3d& eye_in_plan) {
    // Tours are of rooms: a mesh by itself has none.
    const bool has_rooms = std::any_of(scene.spaces.begin(), scene.spaces.end(),
                                       [](const accel::Space& space) { return space.label == accel::Label::Room; });
    return "The eye of the view \"" + name + "\" at " + text_of(eye_in_plan) +
           " stands in a wall, a slab or the ground, or outside the site: move it" +
           (has_rooms ? ", or make the views again with \"enfilade tour\"." : ".");
}

class Reader {
public:
    Reader(const accel::SceneView& scene, const std::string& name) : scene_(scene), source_{name, 1} {}

    ViewFile read(const plans::JsonValue& json) {
        const plans::Fields file(json, file_keys, source_);
        if (file.number("format_version", {0, 1e9}) != 1)
            plans::refuse(source_, "P105", file.at("format_version").place,
                          "This version of Enfilade reads view files of \"format_version\" 1.");
        const plans::JsonValue& list = file.at("views");
        for (const plans::JsonValue& value : file.list("views")) read_view(value);
        if (result_.views.empty())
            plans::refuse(source_, "F134", list.place,
                          "This file holds no view: \"enfilade tour SCENE.enf -o FILE\" makes some.");
        return std::move(result_);
    }

private:
    void read_view(const plans::JsonValue& value) {
        const plans::Fields fields(value, view_keys, source_);
        SavedView view;
        view.name = fields.text("name", "view " + std::to_string(result_.views.size() + 1));
        const Vec3d eye = read_point(fields, "eye", source_);
        view.camera.eye = eye - origin_of(scene_);
        view.camera.target = read_point(fields, "target", source_) - origin_of(scene_);
        view.camera.fov_deg = fields.number("fov_deg", {least_fov_deg, largest_fov_deg}, usual_fov_deg);
        if (!names_.insert(view.name).second)
            plans::refuse(source_, "F134", fields.place(), "There are two views named \"" + view.name + "\".");
        if (const auto fault = fault_of(view.camera))
            plans::refuse(source_, "F135", fields.place(), "The view \"" + view.name + "\" is none: " + *fault + '.');
        view.cell = cell_of(view, read_cell(fields), fields.at("eye").place, eye);
        result_.views.push_back(std::move(view));
    }

    accel::CellId cell_of(const SavedView& view, std::optional<std::uint64_t> named, plans::JsonPlace place,
                          const Vec3d& eye_in_plan) {
        const std::array<double, 3> eye = eye_as_traced(view.camera);
        if (named && *named < scene_.cells.size() && accel::contains(scene_, accel::CellId(*named), eye))
            return accel::CellId(*named);
        const std::optional<accel::CellId> found = accel::locate(scene_, eye);
        if (!found) plans::refuse(source_, "F135", place, stands_nowhere(scene_, view.name, eye_in_plan));
        if (named && *named != index(*found)) result_.relocated.push_back(view.name);
        return *found;
    }

    const accel::SceneView& scene_;
    plans::JsonSource source_;
    ViewFile result_;
    std::set<std::string> names_;
};

std::string json_text(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') result += '\\';
        if (byte >= 0x20) {
            result += c;
        } else {
            constexpr std::string_view digits = "0123456789abcdef";
            result += std::string("\\u00") + digits[byte >> 4] + digits[byte & 15u];
        }
    }
    return result + '"';
}

std::string list_of(const Vec3d& p) {
    return '[' + plans::rounded_text(p.x, 4) + ", " + plans::rounded_text(p.y, 4) + ", " + plans::rounded_text(p.z, 4) +
           ']';
}

double rounded(double value, double step) { return std::round(value / step) * step; }

Vec3d rounded(const Vec3d& p) { return {rounded(p.x, 1e-4), rounded(p.y, 1e-4), rounded(p.z, 1e-4)}; }

}  // namespace

std::string ViewFile::warning(const std::filesystem::path& path) const {
    if (relocated.empty()) return {};
    return path.string() + ": " + counted(relocated.size(), "view") + " of " + grouped(views.size()) +
           (relocated.size() == 1 ? " stands" : " stand") + " in another cell than the file says, \"" +
           relocated.front() + (relocated.size() == 1 ? "\"" : "\" first") +
           ": the scene was cut in another way since; their cells were looked for anew.";
}

ViewFile parse_views(std::string_view text, const std::string& name, const accel::SceneView& scene) {
    return Reader(scene, name).read(plans::parse_json(text, name));
}

ViewFile read_views(const std::filesystem::path& path, const accel::SceneView& scene) {
    return parse_views(read_text(path), path.string(), scene);
}

std::string view_file_text(std::span<const SavedView> views, const accel::SceneView& scene) {
    std::string text = "{\n  \"format_version\": 1,\n  \"views\": [";
    const char* separator = "\n";
    for (const SavedView& view : views) {
        text += separator;
        text += "    {\"name\": " + json_text(view.name) + ", \"eye\": " + list_of(view.camera.eye + origin_of(scene)) +
                ", \"target\": " + list_of(view.camera.target + origin_of(scene)) +
                ", \"fov_deg\": " + plans::rounded_text(view.camera.fov_deg, 2) +
                ", \"cell\": " + std::to_string(index(view.cell)) + '}';
        separator = ",\n";
    }
    return text + "\n  ]\n}\n";
}

SavedView as_saved(const SavedView& view, const accel::SceneView& scene) {
    SavedView saved = view;
    const Vec3d eye = rounded(view.camera.eye + origin_of(scene));
    saved.camera.eye = eye - origin_of(scene);
    saved.camera.target = rounded(view.camera.target + origin_of(scene)) - origin_of(scene);
    saved.camera.fov_deg = rounded(view.camera.fov_deg, 1e-2);
    const std::optional<accel::CellId> cell = accel::locate(scene, eye_as_traced(saved.camera));
    if (!cell) throw InputError("F135", "", stands_nowhere(scene, view.name, eye));
    saved.cell = *cell;
    return saved;
}

}  // namespace enfilade::tools
