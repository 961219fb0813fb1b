#pragma once
// Strong index types of the map: mixing two of them does not compile.

#include <cstddef>
#include <cstdint>
#include <limits>

namespace enfilade::gmap {

enum class DartId : std::uint32_t {};
enum class VertexId : std::uint32_t {};
enum class EdgeId : std::uint32_t {};
enum class FaceId : std::uint32_t {};
enum class VolumeId : std::uint32_t {};

/// The number inside an id, for indexing arrays. Plain overloads, so that they win over any template of the caller's.
[[nodiscard]] constexpr std::size_t index(DartId id) noexcept { return static_cast<std::uint32_t>(id); }
[[nodiscard]] constexpr std::size_t index(VertexId id) noexcept { return static_cast<std::uint32_t>(id); }
[[nodiscard]] constexpr std::size_t index(EdgeId id) noexcept { return static_cast<std::uint32_t>(id); }
[[nodiscard]] constexpr std::size_t index(FaceId id) noexcept { return static_cast<std::uint32_t>(id); }
[[nodiscard]] constexpr std::size_t index(VolumeId id) noexcept { return static_cast<std::uint32_t>(id); }

/// The id that names nothing.
template <class Id>
inline constexpr Id none = static_cast<Id>(std::numeric_limits<std::uint32_t>::max());

namespace detail {
inline constexpr std::uint32_t none_u32 = std::numeric_limits<std::uint32_t>::max();

template <int I>
struct CellIdOf;
template <>
struct CellIdOf<0> {
    using type = VertexId;
};
template <>
struct CellIdOf<1> {
    using type = EdgeId;
};
template <>
struct CellIdOf<2> {
    using type = FaceId;
};
template <>
struct CellIdOf<3> {
    using type = VolumeId;
};

template <class Id>
struct DimensionOf;
template <>
struct DimensionOf<VertexId> {
    static constexpr int value = 0;
};
template <>
struct DimensionOf<EdgeId> {
    static constexpr int value = 1;
};
template <>
struct DimensionOf<FaceId> {
    static constexpr int value = 2;
};
template <>
struct DimensionOf<VolumeId> {
    static constexpr int value = 3;
};
}  // namespace detail

/// The id type of the I-cells: vertices, edges, faces, volumes.
template <int I>
using CellId = typename detail::CellIdOf<I>::type;

/// The dimension of the cells that `Id` names.
template <class Id>
inline constexpr int dimension_of = detail::DimensionOf<Id>::value;

}  // namespace enfilade::gmap
