#pragma once
// The light of a picture.

#include "render/vec.h"

namespace enfilade::render {

/// What light there is, and what is seen where there is nothing.
struct Look {
    Vec3f sky_zenith = {0.30f, 0.47f, 0.78f};
    Vec3f sky_horizon = {0.78f, 0.86f, 0.95f};
    Vec3f ambient = {0.54f, 0.56f, 0.60f};
    Vec3f sun = {0.95f, 0.86f, 0.70f};
    Vec3f sun_direction = {0.24013f, -0.68038f, 0.69239f};  ///< towards the sun, of length 1
    Vec3f paper = {0.93f, 0.925f, 0.91f};                   ///< dollhouse: beyond the site
    Vec3f cut = {0.035f, 0.038f, 0.045f};                   ///< dollhouse: walls where they are cut through
    int ambient_samples = 6;                                ///< short rays a sample that darken corners; 0: none
    float ambient_reach = 2.0f;                             ///< metres
    float headlight = 0.16f;                                ///< a lamp at the camera, so that walls of one room differ
    float shoulder = 0.7f;  ///< from here on bright surfaces approach white softly; 1: they are clipped
};

/// The same sky, but no light other than a lamp at the eye: Lambert's shading for more than one sample a pixel.
[[nodiscard]] inline Look lambert_look(Look look) {
    look.ambient = look.sun = {0, 0, 0};
    look.sun_direction = {0, 0, -1};
    look.ambient_samples = 0;
    look.headlight = 1;
    look.shoulder = 1;
    return look;
}

}  // namespace enfilade::render
