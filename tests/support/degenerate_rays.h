#pragma once
// Rays for which the paper's text has no answer, and numbers at the ends of what float holds.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "accel/scene.h"
#include "render/trace_rays.h"

namespace enfilade::test {

enum class Degenerate {
    Vertical,        ///< with zeros of either sign
    NearVertical,    ///< leaning by 2^-50 to 2^-10
    SignedZeros,     ///< axis-parallel, -0.0 in the other components
    TinyLength,      ///< 1e-18
    HugeLength,      ///< 1e+18
    DenormalLength,  ///< 1e-42
    DenormalPart,    ///< one component of 1e-42
    OnFaces,         ///< starts where another ray ended
    OnCorners,       ///< starts exactly on a vertical line of a cell, at the height of a level
    Limited,         ///< random, with a limit near where they end, and 0, and beyond
    NoRay            ///< NaN, infinities, no direction, limits that are NaN
};
inline constexpr std::array degenerate_families = {
    Degenerate::Vertical,   Degenerate::NearVertical,   Degenerate::SignedZeros,  Degenerate::TinyLength,
    Degenerate::HugeLength, Degenerate::DenormalLength, Degenerate::DenormalPart, Degenerate::OnFaces,
    Degenerate::OnCorners,  Degenerate::Limited,        Degenerate::NoRay};
[[nodiscard]] const char* name_of(Degenerate family);

/// `count` of them, at numbers that float holds; the same seed gives the same rays.
[[nodiscard]] std::vector<render::RayQuery> degenerate_rays(const accel::SceneView& scene, Degenerate family,
                                                            std::size_t count, std::uint64_t seed);

}  // namespace enfilade::test
