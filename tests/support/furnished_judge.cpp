#include "tests/support/furnished_judge.h"

#include <algorithm>
#include <cstdlib>

#include "accel/locate.h"
#include "render/oracle.h"
#include "render/trace.h"

namespace enfilade::test {
namespace {

/// The largest difference of a channel.
int difference(std::uint32_t a, std::uint32_t b) {
    int largest = 0;
    for (int shift = 0; shift < 24; shift += 8)
        largest =
            std::max(largest, std::abs(static_cast<int>(a >> shift & 255u) - static_cast<int>(b >> shift & 255u)));
    return largest;
}

/// As many pixels of a picture of some thousands may show a triangle edge-on.
constexpr std::uint64_t most_edge_on = 2;

/// Of light that nearly grazes what it falls on: a triangle seen edge-on, no wider than rounding. From nowhere beside
/// the eye it need show.
bool is_edge_on(std::uint32_t pixel) {
    for (int shift = 0; shift < 24; shift += 8)
        if ((pixel >> shift & 255u) > 4) return false;
    return true;
}

std::string colour(std::uint32_t pixel) {
    return "(" + std::to_string(pixel & 255u) + " " + std::to_string(pixel >> 8 & 255u) + " " +
           std::to_string(pixel >> 16 & 255u) + ")";
}

}  // namespace

void FurnishedVerdict::add(const FurnishedVerdict& other) {
    pixels += other.pixels;
    differing += other.differing;
    unexplained += other.unexplained;
    for (const std::string& fault : other.faults)
        if (faults.size() < 4) faults.push_back(fault);
}

std::string FurnishedVerdict::text() const {
    std::string text = std::to_string(pixels) + " pixels, " + std::to_string(differing) + " differ, " +
                       std::to_string(unexplained) + " of these unexplained";
    for (const std::string& fault : faults) text += "\n  " + fault;
    return text;
}

FurnishedJudge::FurnishedJudge(const accel::SceneView& scene, const render::ObjectTracer& objects,
                               const render::CameraFrame& frame, accel::CellId start, int width, int height,
                               float mirror_floor)
    : scene_(&scene),
      objects_(&objects),
      frame_(frame),
      start_(start),
      width_(width),
      height_(height),
      mirror_floor_(mirror_floor),
      expected_(scalar(frame, start)) {}

render::Framebuffer FurnishedJudge::scalar(const render::CameraFrame& frame, accel::CellId start) const {
    render::Framebuffer picture(width_, height_);
    render::LambertOptions options;
    options.tracer = render::Tracer::Scalar;
    options.mirror_floor = mirror_floor_;
    options.objects = objects_;
    render::trace_lambert(*scene_, frame, start, options, accel::SerialExecutor(), picture);
    return picture;
}

void FurnishedJudge::look_from_beside() {
    const auto band = static_cast<float>(render::error_band(*scene_));
    for (int k = 0; k < 27; ++k) {
        if (k == 13) continue;
        const auto shift = [&](int digit) { return band * static_cast<float>(digit % 3 - 1); };
        render::CameraFrame frame = frame_;
        frame.origin = frame.origin + render::Vec3f{shift(k), shift(k / 3), shift(k / 9)};
        const auto cell = accel::locate(*scene_, {frame.origin.x, frame.origin.y, frame.origin.z});
        if (cell) beside_.push_back(scalar(frame, *cell));
    }
}

FurnishedVerdict FurnishedJudge::compare(const render::Framebuffer& actual) {
    FurnishedVerdict verdict;
    verdict.pixels = actual.rgba.size();
    std::uint64_t edge_on = 0;
    for (std::size_t i = 0; i < actual.rgba.size(); ++i) {
        const std::uint32_t pixel = actual.rgba[i];
        if (difference(pixel, expected_.rgba[i]) <= 1) continue;
        ++verdict.differing;
        if (beside_.empty()) look_from_beside();
        const bool is_explained = std::ranges::any_of(
            beside_, [&](const render::Framebuffer& other) { return difference(pixel, other.rgba[i]) <= 2; });
        if (is_explained) continue;
        if ((is_edge_on(pixel) || is_edge_on(expected_.rgba[i])) && ++edge_on <= most_edge_on) continue;
        ++verdict.unexplained;
        if (verdict.faults.size() < 4)
            verdict.faults.push_back("pixel " + std::to_string(i % static_cast<std::size_t>(width_)) + ", " +
                                     std::to_string(i / static_cast<std::size_t>(width_)) + " is " + colour(pixel) +
                                     ", not " + colour(expected_.rgba[i]));
    }
    return verdict;
}

}  // namespace enfilade::test
