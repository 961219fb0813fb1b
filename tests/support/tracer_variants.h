#pragma once
// Every tracer with the packet sizes at the ends of what is allowed, and between.

#include <array>

#include "render/tracer.h"

namespace enfilade::test {

struct TracerVariant {
    const char* name;
    render::Tracer tracer;
    render::PacketSizes packets;
};

inline constexpr std::array tracer_variants = {
    TracerVariant{"simd", render::Tracer::Simd, {64, 8}},
    TracerVariant{"packet 64/8", render::Tracer::Packet, {64, 8}},
    TracerVariant{"packet 16/4", render::Tracer::Packet, {16, 4}},
    TracerVariant{"packet 16/16", render::Tracer::Packet, {16, 16}},
    TracerVariant{"packet 32/8", render::Tracer::Packet, {32, 8}},
    TracerVariant{"packet 128/16", render::Tracer::Packet, {128, 16}},
    TracerVariant{"packet 256/4", render::Tracer::Packet, {256, 4}},
    TracerVariant{"packet 256/256", render::Tracer::Packet, {256, 256}},
};

}  // namespace enfilade::test
