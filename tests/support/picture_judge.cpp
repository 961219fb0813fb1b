#include "tests/support/picture_judge.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "render/trace_rays.h"
#include "tests/support/error_band.h"

namespace enfilade::test {

using render::Vec3d;
using render::Vec3f;

namespace {

constexpr std::size_t most_faults = 4;
constexpr float rounding_of_light = 2e-6f;

template <class... Arguments>
std::string printed(const char* format, Arguments... arguments) {
    std::array<char, 512> buffer;
    std::snprintf(buffer.data(), buffer.size(), format, arguments...);
    return buffer.data();
}

float sum(Vec3f c) { return c.x + c.y + c.z; }

Vec3f magnitudes(Vec3f c) { return {std::abs(c.x), std::abs(c.y), std::abs(c.z)}; }

float largest_of(Vec3f c) { return std::max({c.x, c.y, c.z}); }

bool is_close(Vec3f a, Vec3f b, float relative, float absolute) {
    const Vec3f difference = magnitudes(a - b), size = magnitudes(b);
    return difference.x <= relative * size.x + absolute && difference.y <= relative * size.y + absolute &&
           difference.z <= relative * size.z + absolute;
}

/// Whether both may be one colour under different light. tolerance: of a channel.
bool is_same_hue(Vec3f a, Vec3f b, float tolerance) {
    const float sum_a = sum(a), sum_b = sum(b);
    if (std::min(sum_a, sum_b) <= 16 * tolerance) return std::max(sum_a, sum_b) <= 64 * tolerance;
    const Vec3f difference = magnitudes((1 / sum_a) * a - (1 / sum_b) * b);
    return largest_of(difference) <= 5e-4f + 2 * tolerance / std::min(sum_a, sum_b);
}

Vec3f decoded(std::uint32_t pixel) {
    const auto channel = [&](int shift) {
        const float value = static_cast<float>(pixel >> shift & 255u) / 255.0f;
        return value * value;
    };
    return {channel(0), channel(8), channel(16)};
}

bool is_within_a_step(std::uint32_t a, std::uint32_t b) {
    for (int shift = 0; shift < 32; shift += 8)
        if (std::abs(static_cast<int>(a >> shift & 255u) - static_cast<int>(b >> shift & 255u)) > 1) return false;
    return true;
}

}  // namespace

std::string PictureVerdict::text() const {
    std::string all =
        printed("%llu pixels: %llu other faces inside the band, %llu outside, %llu other shades, %llu leaks",
                static_cast<unsigned long long>(pixels), static_cast<unsigned long long>(inside_band),
                static_cast<unsigned long long>(outside_band), static_cast<unsigned long long>(other_shade),
                static_cast<unsigned long long>(leaks));
    for (const std::string& fault : faults) all += "\n  " + fault;
    return all;
}

void PictureVerdict::add(const PictureVerdict& other) {
    pixels += other.pixels;
    inside_band += other.inside_band;
    outside_band += other.outside_band;
    other_shade += other.other_shade;
    leaks += other.leaks;
    for (const std::string& fault : other.faults)
        if (faults.size() < most_faults) faults.push_back(fault);
}

std::string text_of(const render::CameraFrame& f, int width, int height) {
    return printed("%dx%d origin (%a, %a, %a) corner (%a, %a, %a) du (%a, %a, %a) dv (%a, %a, %a)", width, height,
                   double{f.origin.x}, double{f.origin.y}, double{f.origin.z}, double{f.corner.x}, double{f.corner.y},
                   double{f.corner.z}, double{f.du.x}, double{f.du.y}, double{f.du.z}, double{f.dv.x}, double{f.dv.y},
                   double{f.dv.z});
}

PictureJudge::PictureJudge(const accel::SceneView& scene)
    : scene_(&scene), oracle_(scene), band_(render::error_band(scene)), largest_(0) {
    for (int k = 0; k < 3; ++k)
        largest_ = std::max({largest_, std::abs(double{scene.locator_nodes[0].low[k]}),
                             std::abs(double{scene.locator_nodes[0].high[k]})});
}

PictureVerdict PictureJudge::compare(const render::CameraFrame& frame, accel::CellId start,
                                     const render::Image& expected, const render::Image& actual) const {
    PictureVerdict verdict;
    for (int y = 0; y < expected.height; ++y)
        for (int x = 0; x < expected.width; ++x) {
            ++verdict.pixels;
            const Vec3f e = expected.pixel(x, y), a = actual.pixel(x, y);
            if (!is_close(a, e, 1e-3f, rounding_of_light))
                judge(frame, start, {x, y, e, a, rounding_of_light}, verdict);
        }
    return verdict;
}

PictureVerdict PictureJudge::compare(const render::CameraFrame& frame, accel::CellId start,
                                     const render::Framebuffer& expected, const render::Framebuffer& actual) const {
    PictureVerdict verdict;
    for (int y = 0; y < expected.height; ++y)
        for (int x = 0; x < expected.width; ++x) {
            ++verdict.pixels;
            const std::size_t i =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(expected.width) + static_cast<std::size_t>(x);
            if (is_within_a_step(expected.rgba[i], actual.rgba[i])) continue;
            const Vec3f e = decoded(expected.rgba[i]), a = decoded(actual.rgba[i]);
            const float brightest = std::sqrt(std::max(largest_of(e), largest_of(a)));
            judge(frame, start, {x, y, e, a, 2.1f / 255.0f * (brightest + 1.0f / 255.0f)}, verdict);
        }
    return verdict;
}

void PictureJudge::judge(const render::CameraFrame& frame, accel::CellId start, const Pixel& pixel,
                         PictureVerdict& verdict) const {
    const Vec3d origin = render::vec_cast<double>(frame.origin);
    const Vec3d direction = render::vec_cast<double>(
        frame.direction(static_cast<float>(pixel.x) + 0.5f, static_cast<float>(pixel.y) + 0.5f));
    const render::RayHit hit = render::trace_ray(*scene_, {origin, direction, start});
    const Vec3f a = pixel.actual, e = pixel.expected;
    const auto note = [&](const char* what) {
        if (verdict.faults.size() >= most_faults) return;
        const double edge = oracle_.edge_distance(origin, direction, reach_of(oracle_, direction, hit, band_));
        verdict.faults.push_back(printed(
            "%s at pixel (%d, %d), direction (%a, %a, %a): (%.5f %.5f %.5f) instead of (%.5f %.5f %.5f) of face %u in "
            "cell %u at %.4f m; edge at %.6f m, band %.6f m",
            what, pixel.x, pixel.y, direction.x, direction.y, direction.z, double{a.x}, double{a.y}, double{a.z},
            double{e.x}, double{e.y}, double{e.z}, static_cast<unsigned>(hit.source_face),
            static_cast<unsigned>(hit.cell), hit.distance, edge, band_));
    };
    if (a.x > 0 && a.y == 0) {  // no face has a colour without green
        ++verdict.leaks;
        return note("a leak");
    }
    if (a.x >= 0 && is_same_hue(a, e, pixel.tolerance)) {
        // The cosine comes from the sides of a section's ends: the shorter the section, the more they round.
        double noise = 0;
        if (hit.status == render::WalkStatus::Hit && hit.exit == render::Exit::Side) {
            const accel::Cell& cell = scene_->cells[index(hit.cell)];
            const std::uint32_t next =
                hit.section + 1 == cell.first_section + cell.section_count ? cell.first_section : hit.section + 1;
            const double length = std::hypot(double{scene_->section_x[next]} - double{scene_->section_x[hit.section]},
                                             double{scene_->section_y[next]} - double{scene_->section_y[hit.section]});
            noise = 8 * 0x1p-24 * largest_ / length;
        }
        if (std::abs(sum(a) - sum(e)) <= 1e-3 * sum(e) + 3 * (noise + double{pixel.tolerance})) return;
        // Dark faces look alike, the more so with eight bits a channel.
        const bool tells_faces_apart = pixel.tolerance == rounding_of_light && std::min(sum(a), sum(e)) > 1e-3f;
        if (tells_faces_apart || !is_doubtful(oracle_, origin, direction, hit, band_)) {
            ++verdict.other_shade;
            return note("another shade");
        }
    }
    if (is_doubtful(oracle_, origin, direction, hit, band_)) {
        ++verdict.inside_band;
        return;
    }
    ++verdict.outside_band;
    note("another face");
}

}  // namespace enfilade::test
