// beams_figure SCENE.enf LAMP FILE.svg: a lamp's beams at the height of a table, and the tree of its light
// (figures.sh).

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "accel/lights/light_trees.h"
#include "accel/scene_file.h"
#include "base/error.h"
#include "render/executor.h"
#include "tools/output_file.h"

namespace {

using namespace enfilade;

struct Point {
    double x, y;
};
using Polygon = std::vector<Point>;

constexpr double table = 0.8;   ///< metres above the floor
constexpr double margin = 0.4;  ///< metres around what is lit
constexpr double pixels_a_metre = 56, tree_width = 420;
/// By the number of portals that light has crossed.
constexpr std::array<const char*, 6> colours = {"#ffe9a8", "#ffd166", "#f9a03f", "#ee6c4d", "#c8456b", "#7a3b8f"};

std::string number(double value) {
    std::array<char, 32> text;
    std::snprintf(text.data(), text.size(), "%.2f", value);
    return text.data();
}

Polygon floor_of(const accel::SceneView& scene, const accel::Cell& cell) {
    Polygon polygon;
    for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s)
        polygon.push_back({double{scene.section_x[s]}, double{scene.section_y[s]}});
    return polygon;
}

/// What of the polygon lies where a x + b y + c >= 0.
Polygon clipped(const Polygon& polygon, double a, double b, double c) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point& p = polygon[i];
        const Point& q = polygon[(i + 1) % polygon.size()];
        const double at_p = a * p.x + b * p.y + c, at_q = a * q.x + b * q.y + c;
        if (at_p >= 0) kept.push_back(p);
        if ((at_p >= 0) == (at_q >= 0)) continue;
        const double t = at_p / (at_p - at_q);
        kept.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    }
    return kept;
}

/// A beam of the lamp, and its place in the tree.
struct Beam {
    std::uint32_t id;
    std::size_t parent;  ///< into the beams; its own number at the lamp
    std::size_t depth;
    double x = 0;  ///< in the tree, leaves 1 apart
    Polygon lit;   ///< where a table stands in it
};

class Figure {
public:
    Figure(const accel::SceneView& scene, const std::string& lamp) : scene_(scene) {
        const auto found = std::find_if(scene.lights.begin(), scene.lights.end(),
                                        [&](const accel::Light& light) { return scene.string(light.id) == lamp; });
        if (found == scene.lights.end()) throw std::runtime_error("the scene has no lamp " + lamp);
        light_ = *found;
        if (light_.cell == none<accel::CellId>) throw std::runtime_error("the lamp hangs in a wall");
        accel::SceneView alone = scene;
        alone.lights = {&light_, 1};
        trees_ = accel::build_light_trees(alone, {}, *render::make_executor());
        height_ = double{scene.cells[index(light_.cell)].z_floor} + table;
        collect();
        place(0);
    }

    [[nodiscard]] std::string svg() {
        find_box();
        const double width = (high_.x - low_.x) * pixels_a_metre, height = (high_.y - low_.y) * pixels_a_metre;
        std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + number(width + tree_width) +
                           ' ' + number(height) +
                           "\" font-family=\"sans-serif\" font-size=\"13\">\n<rect width=\"100%\" height=\"100%\" "
                           "fill=\"#fbfaf7\"/>\n<clipPath id=\"plan\"><rect width=\"" +
                           number(width) + "\" height=\"" + number(height) +
                           "\"/></clipPath>\n<g clip-path=\"url(#plan)\">\n";
        text += site();
        for (const Beam& beam : beams_)
            if (beam.lit.size() >= 3) text += drawn(beam.lit, colour(beam), "#00000030");
        text += walls();
        const Point at = on_sheet({double{light_.position[0]}, double{light_.position[1]}});
        text += "<circle cx=\"" + number(at.x) + "\" cy=\"" + number(at.y) +
                "\" r=\"7\" fill=\"#fff\" stroke=\"#000\" stroke-width=\"2\"/>\n</g>\n";
        return text + tree(width, height) + "</svg>\n";
    }

private:
    /// The lamp's beams, parents before children.
    void collect() {
        const accel::LightTreesView view = trees_.view();
        std::vector<std::uint32_t> waiting;
        for (std::uint32_t b = 0; b < view.beams.size(); ++b)
            if (view.beams[b].parent == b) waiting.push_back(b);
        for (std::size_t k = 0; k < waiting.size(); ++k) {
            const std::uint32_t id = waiting[k];
            Beam beam = {id, 0, 0, 0, {}};
            for (std::size_t j = 0; j < beams_.size(); ++j)
                if (beams_[j].id == view.beams[id].parent) beam.parent = j, beam.depth = beams_[j].depth + 1;
            beam.lit = cross_section(id);
            beams_.push_back(std::move(beam));
            for (std::uint32_t b = 0; b < view.beams.size(); ++b)
                if (view.beams[b].parent == id && b != id) waiting.push_back(b);
        }
        if (beams_.empty()) throw std::runtime_error("the lamp has no tree");
    }

    [[nodiscard]] Polygon cross_section(std::uint32_t id) const {
        const accel::LightTreesView view = trees_.view();
        const accel::Cell& cell = scene_.cells[index(view.beams[id].cell)];
        if (double{cell.z_floor} > height_ || double{cell.z_ceiling} < height_) return {};
        Polygon polygon = floor_of(scene_, cell);
        for (const accel::BeamPlane& plane : view.planes_of(id)) {
            const double a = double{plane.x}, b = double{plane.y};
            polygon = clipped(polygon, a, b,
                              double{plane.z} * (height_ - double{light_.position[2]}) -
                                  a * double{light_.position[0]} - b * double{light_.position[1]});
        }
        return polygon;
    }

    /// Leaves side by side, inner nodes above the middle of their children. Returns the next free place.
    double place(std::size_t k, double free = 0) {
        double first = -1, last = 0;
        for (std::size_t j = k + 1; j < beams_.size(); ++j) {
            if (beams_[j].parent != k) continue;
            free = place(j, free);
            if (first < 0) first = beams_[j].x;
            last = beams_[j].x;
        }
        if (first < 0) {
            beams_[k].x = free;
            leaf_count_ = std::max(leaf_count_, free + 1);
            return free + 1;
        }
        beams_[k].x = (first + last) / 2;
        return free;
    }

    /// What is lit, and the rooms there.
    void find_box() {
        low_ = high_ = {double{light_.position[0]}, double{light_.position[1]}};
        for (const Beam& beam : beams_) {
            const accel::Cell& cell = scene_.cells[index(trees_.view().beams[beam.id].cell)];
            if (beam.lit.size() < 3 || cell.label == accel::Label::Exterior) continue;
            for (const Point& p : beam.lit) {
                low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
                high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
            }
        }
        low_ = {low_.x - margin, low_.y - margin};
        high_ = {high_.x + margin, high_.y + margin};
    }

    [[nodiscard]] Point on_sheet(Point p) const {
        return {(p.x - low_.x) * pixels_a_metre, (high_.y - p.y) * pixels_a_metre};
    }
    [[nodiscard]] const char* colour(const Beam& beam) const {
        return colours[std::min(beam.depth, colours.size() - 1)];
    }

    [[nodiscard]] std::string drawn(const Polygon& polygon, const char* fill, const char* stroke) const {
        std::string text = "<path d=\"M";
        for (const Point& p : polygon) text += number(on_sheet(p).x) + ' ' + number(on_sheet(p).y) + ' ';
        return text + "Z\" fill=\"" + fill + "\" stroke=\"" + stroke + "\"/>\n";
    }

    /// The cells at the table's height: rooms in white, what lies outside in grey.
    [[nodiscard]] std::string site() const {
        std::string text = "<rect width=\"100%\" height=\"100%\" fill=\"#33363c\"/>\n";
        for (const accel::Cell& cell : scene_.cells) {
            if (double{cell.z_floor} > height_ || double{cell.z_ceiling} < height_) continue;
            text += drawn(floor_of(scene_, cell), cell.label == accel::Label::Exterior ? "#e3e8e2" : "#ffffff", "none");
        }
        return text;
    }

    /// Solid sides as lines, doors and windows as gaps, borders between cells of a room dotted.
    [[nodiscard]] std::string walls() const {
        std::string text;
        for (const accel::Cell& cell : scene_.cells) {
            if (double{cell.z_floor} > height_ || double{cell.z_ceiling} < height_) continue;
            const Polygon polygon = floor_of(scene_, cell);
            for (std::uint32_t i = 0; i < cell.section_count; ++i) {
                const std::uint32_t s = cell.first_section + i;
                std::uint32_t f = scene_.section_tails[s].first_face;
                const std::uint32_t end = scene_.section_tails[s + 1].first_face;
                while (f + 1 < end && double{scene_.side_faces[f].z_top} <= height_) ++f;
                const accel::Target target = scene_.side_faces[f].target;
                const Point a = on_sheet(polygon[i]), b = on_sheet(polygon[(i + 1) % polygon.size()]);
                text += "<path d=\"M" + number(a.x) + ' ' + number(a.y) + 'L' + number(b.x) + ' ' + number(b.y) +
                        (target.is_portal() ? "\" stroke=\"#4a7fb5\" stroke-dasharray=\"3 4\"/>\n"
                                            : "\" stroke=\"#16181c\" stroke-width=\"2\"/>\n");
            }
        }
        return text;
    }

    [[nodiscard]] std::string tree(double left, double height) const {
        std::size_t deepest = 0;
        for (const Beam& beam : beams_) deepest = std::max(deepest, beam.depth);
        const double step_x = (tree_width - 40) / leaf_count_,
                     step_y = (height - 60) / double(std::max<std::size_t>(deepest, 1));
        const double radius = std::clamp(step_x * 0.45, 3.0, 12.0);
        const auto at = [&](const Beam& beam) {
            return Point{left + 20 + (beam.x + 0.5) * step_x, 30 + double(beam.depth) * step_y};
        };
        std::string text;
        for (const Beam& beam : beams_) {
            const Point p = at(beam), q = at(beams_[beam.parent]);
            text += "<path d=\"M" + number(p.x) + ' ' + number(p.y) + 'L' + number(q.x) + ' ' + number(q.y) +
                    "\" stroke=\"#888\"/>\n";
        }
        for (const Beam& beam : beams_) {
            const Point p = at(beam);
            text += "<circle cx=\"" + number(p.x) + "\" cy=\"" + number(p.y) + "\" r=\"" + number(radius) +
                    "\" fill=\"" + colour(beam) + "\" stroke=\"#00000080\"/>\n";
        }
        return text;
    }

    const accel::SceneView& scene_;
    accel::Light light_;
    accel::LightTrees trees_;
    double height_ = 0;
    std::vector<Beam> beams_;
    double leaf_count_ = 1;
    Point low_ = {0, 0}, high_ = {0, 0};
};

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) {
        std::fputs("usage: beams_figure SCENE.enf LAMP FILE.svg\n", stderr);
        return 2;
    }
    try {
        const accel::Scene scene = accel::open(argv[1]);
        tools::write_text(argv[3], Figure(scene.view(), argv[2]).svg());
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
