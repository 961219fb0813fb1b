#pragma once
// Lamps as Embree is given them: the lists of the light trees, the same light, and whatever makes it fastest.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "render/embree_reference.h"
#include "render/framebuffer.h"
#include "render/lamp_lists.h"
#include "render/lamps.h"

namespace enfilade::render {

/// How Embree is asked for lit pictures.
struct EmbreeLitWay {
    EmbreeWay primary;  ///< its lanes are those of shadow rays, too
    bool coherent_shadows = true;
    bool from_lamps = false;  ///< shadow rays start at lamps, sixteen at one point, instead of at the places
};
/// "16, coherent, quads; shadow rays coherent, from lamps".
[[nodiscard]] std::string text(const EmbreeLitWay& way);

/// Every way to ask for lit pictures; primary rays of pictures are coherent.
[[nodiscard]] std::vector<EmbreeLitWay> embree_lit_ways();

/// The first hits of a picture, in blocks of 4 x 4 pixels from left to right, then down: block b's pixel (x, y) is
/// 16 b + 4 y + x.
struct SeenPlaces {
    template <class T>
    using Column = std::vector<T, CacheAligned<T>>;

    std::array<Column<float>, 3> point;   ///< metres
    std::array<Column<float>, 3> normal;  ///< of length 1, towards the eye
    std::array<Column<float>, 3> colour;  ///< square roots of the diffuse reflectance
    Column<std::uint8_t> is_lit;          ///< 0: sky, or nothing
    std::size_t lit_count = 0;
};

/// A lit picture to be drawn by Embree.
struct EmbreeLamps {
    accel::ArrayView<accel::Light> lights;
    const LampLists* lists = nullptr;
    float exposure = 1;
    /// [width * height]: the cell of what each pixel sees; given to Embree, which has none, for nothing.
    const std::uint32_t* cells = nullptr;
    const SeenPlaces* seen = nullptr;  ///< nullptr: primary rays are traced
};

}  // namespace enfilade::render
