#pragma once
// What --tracer, --device, --real, --packets and --mirror-floor ask for.

#include <optional>
#include <string>

#include "render/trace.h"
#include "tools/commands.h"

namespace enfilade::tools {

/// A tracer with what belongs to it, sound as `render::trace` wants it.
struct TracerChoice {
    /// A card, or this machine's cores that play one.
    struct Device {
        bool is_host = false;
        int card = 0;
    };

    bool is_oracle = false;        ///< brute force instead of cells; `tracer` and `packets` mean nothing then
    std::optional<Device> device;  ///< kernels instead of loops; `tracer` and `packets` mean nothing then
    render::Tracer tracer = render::Tracer::Packet;
    render::Precision precision = render::Precision::Float;
    render::PacketSizes packets;
    float mirror_floor = 0;

    /// As --tracer takes it.
    [[nodiscard]] const char* name() const;
    /// Whether `packets` means something.
    [[nodiscard]] bool has_packets() const { return !is_oracle && !device && tracer == render::Tracer::Packet; }
};

/// Reads and checks the flags, before any work. Where no tracer is named, double precision chooses the scalar one, and
/// everything else packets; --show asks for
/// the scalar one. Throws InputError (F130 to F133, F138, F149) with one sentence for what is wrong or contradicts
/// itself.
[[nodiscard]] TracerChoice tracer_choice(const RenderOptions& options);

}  // namespace enfilade::tools
