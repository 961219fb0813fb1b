#pragma once
// What pictures of a device show, and how its threads share the work. The schedule changes no pixel.

#include <optional>

#include "accel/octree/octree.h"
#include "accel/parallel_for.h"
#include "render/cuda/device_objects.h"
#include "render/cuda/octree_options.h"
#include "render/cuda/packets.h"
#include "render/cuda/pixel_order.h"
#include "render/trace.h"

namespace enfilade::render::cuda {

/// Which warps draw which batches of pixels.
enum class WarpWork {
    Once,       ///< a warp a batch
    Persistent  ///< as many warps as the card holds, each taking the next batch when it is done: for uneven work
};

/// How a frame is started.
enum class FrameStart {
    Launch,  ///< a launch of its own
    Graph    ///< a recorded graph of one kernel, whose camera is exchanged: for small frames, one after the other
};

/// Threads of a block and registers of a thread, of the kernel of bare rooms with a lamp at the eye. That of furnished
/// ones has blocks of 128, and 96 registers for the last two; all others have one shape.
enum class KernelShape {
    Blocks128,      ///< as many registers as the compiler likes
    Blocks64,       ///< the same
    Blocks256,      ///< the same
    FewRegisters,   ///< so few that 24 warps are held by a multiprocessor: 80 of a thread
    LeastRegisters  ///< 32 warps: 64 of a thread
};

struct PictureSchedule {
    PixelOrder order = PixelOrder::Tiles;
    WarpWork work = WarpWork::Once;
    FrameStart start = FrameStart::Launch;
    KernelShape shape = KernelShape::Blocks128;
};

struct PictureOptions {
    bool has_objects = true;                 ///< false: rooms are seen without what stands in them
    InsideKind inside = InsideKind::Octree;  ///< of objects
    accel::OctreeOptions octrees = device_octree_options();
    Precision precision = Precision::Float;
    float mirror_floor = 0;                           ///< share of light that floors reflect, 0 to 1
    std::optional<LampOptions> lamps = std::nullopt;  ///< nothing: a lamp at the eye
    PictureSchedule schedule = {};
    /// Frames (`draw`) by tiles of corner rays, where these know all that is shown: one lamp at the eye, or in bare
    /// rooms lamps with trees; in float. Pixels within the noise of an edge may differ (packets.h).
    std::optional<PacketTiles> packets = std::nullopt;
    const accel::Executor* executor = nullptr;  ///< builds trees of objects and lamps; nullptr: all cores
};

}  // namespace enfilade::render::cuda
