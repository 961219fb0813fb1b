#pragma once
// SHA-256 (FIPS 180-4), on the processor's own instructions where it has them.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace enfilade::accel {

using Sha256 = std::array<std::uint8_t, 32>;

[[nodiscard]] Sha256 sha256(std::span<const std::byte> bytes);

/// The same with instructions that every machine has: what the tests compare with.
[[nodiscard]] Sha256 sha256_portable(std::span<const std::byte> bytes);

/// 64 lower-case digits.
[[nodiscard]] std::string hex(const Sha256& hash);

}  // namespace enfilade::accel
