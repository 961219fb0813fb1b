#pragma once
// Which thread draws which pixel: 32 of them, a batch, are one warp's.

#include <cstdint>

#include "accel/host_device.h"

namespace enfilade::render::cuda {

enum class PixelOrder : std::uint32_t {
    Rows,   ///< a warp draws 32 pixels of a row
    Tiles,  ///< a warp draws 8 x 4 pixels, whose rays have more in common; tiles by rows
    Morton  ///< such tiles along a Z curve in squares of 64 x 64 pixels: warps that follow each other are neighbours,
            ///< too
};

/// The pixels of an image in that order. Orders that draw tiles have lanes without a pixel at the image's borders.
struct PixelBatches {
    static constexpr std::uint32_t tile_width = 8, tile_height = 4, square = 64;
    static constexpr std::uint32_t tiles_of_square = square * square / (tile_width * tile_height);

    PixelOrder order;
    std::uint32_t width, height;
    std::uint32_t columns = 0;  ///< of tiles, or of squares
    std::uint32_t count = 0;    ///< batches

    PixelBatches(PixelOrder order_, int width_, int height_)
        : order(order_), width(static_cast<std::uint32_t>(width_)), height(static_cast<std::uint32_t>(height_)) {
        const auto pieces = [](std::uint32_t length, std::uint32_t piece) { return (length + piece - 1) / piece; };
        switch (order) {
            case PixelOrder::Rows:
                columns = pieces(width, 32);
                count = columns * height;
                break;
            case PixelOrder::Tiles:
                columns = pieces(width, tile_width);
                count = columns * pieces(height, tile_height);
                break;
            case PixelOrder::Morton:
                columns = pieces(width, square);
                count = columns * pieces(height, square) * tiles_of_square;
                break;
        }
    }

    /// The pixel of a lane; false: it has none.
    ENFILADE_HD bool pixel(std::uint32_t batch, std::uint32_t lane, std::uint32_t& x, std::uint32_t& y) const {
        if (order == PixelOrder::Rows) {
            x = batch % columns * 32 + lane;
            y = batch / columns;
        } else {
            std::uint32_t tile_x, tile_y;
            if (order == PixelOrder::Tiles) {
                tile_x = batch % columns;
                tile_y = batch / columns;
            } else {
                // Of a square's 128 tiles, 8 stand side by side: bits y x y x y x y of their number.
                const std::uint32_t in_square = batch % tiles_of_square, of_image = batch / tiles_of_square;
                tile_y = (of_image / columns) * (square / tile_height) +
                         ((in_square & 1u) | (in_square >> 1 & 2u) | (in_square >> 2 & 4u) | (in_square >> 3 & 8u));
                tile_x = (of_image % columns) * (square / tile_width) +
                         ((in_square >> 1 & 1u) | (in_square >> 2 & 2u) | (in_square >> 3 & 4u));
            }
            x = tile_x * tile_width + lane % tile_width;
            y = tile_y * tile_height + lane / tile_width;
        }
        return x < width && y < height;
    }
};

}  // namespace enfilade::render::cuda
