#pragma once
// Strong index types: mixing two of them does not compile (4-style, rule 6).

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace enfilade {

template <class T>
concept Id = std::is_enum_v<T> && std::same_as<std::underlying_type_t<T>, std::uint32_t>;

/// The number inside an id, for indexing arrays.
template <Id T>
[[nodiscard]] constexpr std::size_t index(T id) noexcept {
    return static_cast<std::uint32_t>(id);
}

/// The id that names nothing.
template <Id T>
inline constexpr T none = static_cast<T>(std::numeric_limits<std::uint32_t>::max());

}  // namespace enfilade
