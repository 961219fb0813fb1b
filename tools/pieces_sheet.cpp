// pieces_sheet FILE.png [--detail D] [--tile PIXELS] [--columns N] [--samples N] [--turn DEGREES] [--tones N] [ID...]:
// our own pieces of furniture, a picture each, in the light of a sky and a sun. pieces_sheet --table: their sizes and
// triangles, in Markdown (pieces.sh).

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "modeler/catalogue/own_pieces.h"
#include "plans/random.h"
#include "render/image.h"
#include "render/image_file.h"
#include "tools/pixel_font.h"

namespace {

using namespace enfilade;
using modeler::ObjectMesh;
using modeler::OwnPiece;
using render::Vec3f;

constexpr Vec3f sky = {0.92f, 0.96f, 1.0f};
constexpr Vec3f sun = {1.5f, 1.38f, 1.18f};
constexpr Vec3f ground_colour = {0.62f, 0.60f, 0.57f};
constexpr Vec3f paper = {0.86f, 0.86f, 0.85f};
constexpr Vec3f ink = {0.05f, 0.05f, 0.06f};

Vec3f times(Vec3f a, Vec3f b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

/// Numbers in [0, 1) for one sample of a pixel: the first few of all samples of a pixel are spread evenly (additive
/// recurrence of the generalised golden ratio, moved by a random offset), the others are random.
class Sample {
public:
    static constexpr int even_count = 6;
    using Offsets = std::array<double, even_count>;
    Sample(const Offsets& offsets, int number, plans::Random& random)
        : offsets_(offsets), number_(number), random_(random) {}

    double next() {
        if (used_ == even_count) return random_.uniform();
        constexpr double step[even_count] = {0.8986537126286992, 0.8075784952213448, 0.7257334129697598,
                                             0.6521830259439717, 0.5860866975779695, 0.5266889867007297};
        const double value = offsets_[used_] + number_ * step[used_];
        ++used_;
        return value - std::floor(value);
    }

private:
    const Offsets& offsets_;
    int number_;
    int used_ = 0;
    plans::Random& random_;
};

/// The mesh and a large ground under it, in Embree's scene.
class Stage {
public:
    explicit Stage(const ObjectMesh& mesh) : mesh_(mesh), device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
        const std::vector<std::array<float, 3>> ground = {
            {-60, -60, -0.0005f}, {60, -60, -0.0005f}, {60, 60, -0.0005f}, {-60, 60, -0.0005f}};
        attach(mesh.vertices, mesh.triangles);
        attach(ground, {{0, 1, 2}, {0, 2, 3}});
        rtcCommitScene(scene_);
    }
    ~Stage() { rtcReleaseScene(scene_), rtcReleaseDevice(device_); }
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    /// What comes along a ray from the sky, the sun, and by way of `bounces` diffuse surfaces.
    [[nodiscard]] Vec3f light(Vec3f origin, Vec3f direction, int bounces, Sample& random) const {
        RTCRayHit ray = ray_of(origin, direction);
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcIntersect1(scene_, &context, &ray);
        if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return sky;
        Vec3f normal = render::normalized(Vec3f{ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z});
        if (render::dot(normal, direction) > 0) normal = -normal;
        const Vec3f place = origin + ray.ray.tfar * direction + 1e-4f * normal;
        const Vec3f colour = ray.hit.geomID == 1 ? ground_colour : colour_of(ray.hit.primID);
        const auto jitter = [&] { return static_cast<float>(0.12 * random.next() - 0.06); };
        const Vec3f towards = render::normalized(Vec3f{-0.42f + jitter(), -0.55f + jitter(), 0.95f});
        Vec3f sum = {0, 0, 0};
        if (const float facing = render::dot(normal, towards); facing > 0 && is_free(place, towards)) {
            sum = facing * sun;
        }
        const Vec3f onward = cosine_direction(normal, random);
        const Vec3f around = bounces > 0 ? light(place, onward, bounces - 1, random)
                                         : (is_free(place, onward) ? sky : Vec3f{0.12f, 0.12f, 0.12f});
        return times(colour, sum + 0.62f * around);
    }

private:
    void attach(const std::vector<std::array<float, 3>>& vertices,
                const std::vector<std::array<std::uint32_t, 3>>& triangles) {
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        void* places =
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, vertices.size());
        std::ranges::copy(vertices, static_cast<std::array<float, 3>*>(places));
        void* corners =
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, triangles.size());
        std::ranges::copy(triangles, static_cast<std::array<std::uint32_t, 3>*>(corners));
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
    }

    static RTCRayHit ray_of(Vec3f origin, Vec3f direction) {
        RTCRayHit ray{};
        ray.ray.org_x = origin.x, ray.ray.org_y = origin.y, ray.ray.org_z = origin.z;
        ray.ray.dir_x = direction.x, ray.ray.dir_y = direction.y, ray.ray.dir_z = direction.z;
        ray.ray.tnear = 0, ray.ray.tfar = 1e6f, ray.ray.mask = ~0u;
        ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        return ray;
    }
    [[nodiscard]] bool is_free(Vec3f origin, Vec3f direction) const {
        RTCRay ray = ray_of(origin, direction).ray;
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcOccluded1(scene_, &context, &ray);
        return ray.tfar > 0;
    }
    [[nodiscard]] Vec3f colour_of(unsigned triangle) const {
        const auto& c = mesh_.materials[mesh_.triangle_materials[triangle]].colour;
        return {c[0], c[1], c[2]};
    }
    static Vec3f cosine_direction(Vec3f normal, Sample& random) {
        const double z = 2 * random.next() - 1, angle = 2 * 3.141592653589793 * random.next();
        const double r = std::sqrt(1 - z * z);
        const Vec3f on_ball{static_cast<float>(r * std::cos(angle)), static_cast<float>(r * std::sin(angle)),
                            static_cast<float>(z)};
        return render::normalized(normal + 0.999f * on_ball);
    }

    const ObjectMesh& mesh_;
    RTCDevice device_;
    RTCScene scene_;
};

struct SheetOptions {
    std::string file;
    std::uint32_t detail = 1;
    int tile = 240;
    int columns = 8;
    int samples = 12;
    double turn = 0;  ///< degrees by which pieces are turned before the camera
    int tones = 0;    ///< of each channel, so that what is left of noise does not fill the file; 0: as they come
    std::vector<std::string> ids;
};

constexpr int caption = 26;  ///< pixels under each picture

/// The piece from the front, from its right and from above, filling the tile.
void draw_piece(render::Image& sheet, int left, int top, const OwnPiece& piece, const SheetOptions& options) {
    const ObjectMesh mesh = piece.make(options.detail);
    const Stage stage(mesh);
    const double turn = options.turn * 3.141592653589793 / 180;
    const Vec3f straight{0.52f, -0.85f, 0.45f};
    const auto c = static_cast<float>(std::cos(turn)), s = static_cast<float>(std::sin(turn));
    const Vec3f back =
        render::normalized(Vec3f{c * straight.x - s * straight.y, s * straight.x + c * straight.y, straight.z});
    const Vec3f right = render::normalized(render::cross(Vec3f{0, 0, 1}, back)), up = render::cross(back, right);
    const Vec3f middle{0, 0, static_cast<float>(piece.entry.height / 2)};
    // As far away as makes every corner fit.
    float distance = 0;
    constexpr float slope = 0.21f;
    for (const auto& v : mesh.vertices) {
        const Vec3f p = Vec3f{v[0], v[1], v[2]} - middle;
        const float off = std::max(std::abs(render::dot(p, right)), std::abs(render::dot(p, up)));
        distance = std::max(distance, off / slope + render::dot(p, back));
    }
    const Vec3f eye = middle + 1.06f * distance * back;
    std::atomic<int> next_row = 0;
    const auto work = [&] {
        for (int y = next_row++; y < options.tile; y = next_row++) {
            plans::Random random({20260u, static_cast<std::uint64_t>(y)});
            for (int x = 0; x < options.tile; ++x) {
                Vec3f sum{0, 0, 0};
                Sample::Offsets offsets;
                for (double& offset : offsets) offset = random.uniform();
                for (int k = 0; k < options.samples; ++k) {
                    Sample sample(offsets, k, random);
                    const auto u = static_cast<float>((x + sample.next()) / options.tile * 2 - 1);
                    const auto v = static_cast<float>(1 - (y + sample.next()) / options.tile * 2);
                    const Vec3f direction = render::normalized(slope * u * right + slope * v * up - back);
                    sum = sum + stage.light(eye, direction, 1, sample);
                }
                const Vec3f colour = (0.56f / static_cast<float>(options.samples)) * sum;
                const std::size_t at = 3 * (static_cast<std::size_t>(top + y) * sheet.width + left + x);
                sheet.rgb[at] = colour.x, sheet.rgb[at + 1] = colour.y, sheet.rgb[at + 2] = colour.z;
            }
        }
    };
    std::vector<std::jthread> threads;
    for (unsigned k = 1; k < std::thread::hardware_concurrency(); ++k) threads.emplace_back(work);
    work();
    threads.clear();
    char size[64];
    std::snprintf(size, sizeof size, "%.2f x %.2f x %.2f", piece.entry.width, piece.entry.depth, piece.entry.height);
    const std::string_view name = std::string_view(piece.entry.id).substr(std::string_view("own/").size());
    tools::draw_text(sheet, left + 6, top + options.tile + 3, 1, name, ink);
    tools::draw_text(sheet, left + 6, top + options.tile + 14, 1, size, ink);
}

void reduce_tones(render::Image& sheet, int tones) {
    for (float& part : sheet.rgb) {
        const double shown = std::pow(std::clamp(static_cast<double>(part), 0.0, 1.0), 1 / 2.2);
        part = static_cast<float>(std::pow(std::round(shown * tones) / tones, 2.2));
    }
}

void draw_sheet(const SheetOptions& options) {
    std::vector<const OwnPiece*> pieces;
    for (const OwnPiece& piece : modeler::own_pieces()) {
        const auto asked = [&](const std::string& id) { return piece.entry.id.find(id) != std::string::npos; };
        if (options.ids.empty() || std::ranges::any_of(options.ids, asked)) pieces.push_back(&piece);
    }
    if (pieces.empty()) throw std::runtime_error("no piece has such a name");
    const int count = static_cast<int>(pieces.size()), columns = std::min(options.columns, count);
    const int rows = (count + columns - 1) / columns;
    render::Image sheet(columns * options.tile, rows * (options.tile + caption));
    tools::fill_rectangle(sheet, 0, 0, sheet.width, sheet.height, paper);
    for (int k = 0; k < count; ++k) {
        draw_piece(sheet, k % columns * options.tile, k / columns * (options.tile + caption), *pieces[k], options);
    }
    if (options.tones > 0) reduce_tones(sheet, options.tones);
    render::write_image(sheet, options.file);
}

void print_table() {
    std::size_t sums[3] = {};
    std::printf(
        "| id | kind | width x depth x height (m) | detail 1 | detail 2 | detail 3 |\n|---|---|---|--:|--:|--:|\n");
    for (const OwnPiece& piece : modeler::own_pieces()) {
        const modeler::CatalogueEntry& e = piece.entry;
        std::printf("| %s | %s | %.2f x %.2f x %.2f |", e.id.c_str(), e.kind.c_str(), e.width, e.depth, e.height);
        for (std::uint32_t detail = 1; detail <= 3; ++detail) {
            const std::size_t count = piece.make(detail).triangles.size();
            sums[detail - 1] += count;
            std::printf(" %zu |", count);
        }
        std::printf("\n");
    }
    std::printf("| all %zu | | | %zu | %zu | %zu |\n", modeler::own_pieces().size(), sums[0], sums[1], sums[2]);
}

SheetOptions options_of(int argc, char** argv) {
    SheetOptions options;
    for (int k = 1; k < argc; ++k) {
        const std::string_view word = argv[k];
        const auto number = [&] {
            if (++k == argc) throw std::runtime_error(std::string(word) + " needs a number");
            return std::stoi(argv[k]);
        };
        if (word == "--detail") options.detail = static_cast<std::uint32_t>(number());
        else if (word == "--tile") options.tile = number();
        else if (word == "--columns") options.columns = number();
        else if (word == "--samples") options.samples = number();
        else if (word == "--tones") options.tones = number();
        else if (word == "--turn") options.turn = number();
        else if (options.file.empty()) options.file = word;
        else options.ids.emplace_back(word);
    }
    if (options.file.empty()) throw std::runtime_error("pieces_sheet FILE.png [ID...], or pieces_sheet --table");
    return options;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc == 2 && std::string_view(argv[1]) == "--table") print_table();
        else draw_sheet(options_of(argc, argv));
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "pieces_sheet: %s\n", error.what());
        return 2;
    }
}
