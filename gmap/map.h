#pragma once
// The 3D generalized map: darts, four involutions, and the cells each dart belongs to. Concepts: README.md of this
// folder.

#include <array>
#include <cstddef>
#include <cstdint>
#include <ranges>
#include <span>
#include <vector>

#include "gmap/ids.h"

namespace enfilade::gmap {

namespace detail {
struct MapAccess;
}

/// The map as plain arrays, as files hold it. A slot whose eight numbers are all 0xffffffff holds no dart.
struct MapArrays {
    std::array<std::vector<std::uint32_t>, 4> alpha;    ///< [4][dart_bound]; alpha[i][d] == d: d is i-free
    std::array<std::vector<std::uint32_t>, 4> cell_id;  ///< [4][dart_bound] vertex, edge, face, volume of each dart
    std::array<std::uint32_t, 4> cell_bound{};          ///< all ids of dimension i are below cell_bound[i]
};

/// What `Map::compact` renumbered: new id of each old one, `none` where it is gone.
struct Renumbering {
    std::vector<DartId> darts;
    std::array<std::vector<std::uint32_t>, 4> cells;
};

/// A 3D generalized map, structure of arrays, 32 bytes a dart. Reading it is safe from any number of threads: no
/// algorithm writes marks into it. It is changed by the operations of `gmap/sew.h`, `gmap/insert.h`, `gmap/remove.h`,
/// `gmap/close.h` alone, which keep the cell ids equal to the orbits. Removed darts leave gaps that later ones reuse;
/// ids of cells are never reused until `compact`.
class Map {
public:
    Map() = default;

    /// Takes arrays from a file as they are; `validate` says whether they are sound.
    /// Throws std::invalid_argument where lengths differ or an index is out of range.
    explicit Map(MapArrays arrays);

    /// Darts in use, and the bound below which all their ids lie.
    [[nodiscard]] std::size_t dart_count() const noexcept { return dart_count_; }
    [[nodiscard]] std::size_t dart_bound() const noexcept { return arrays_.alpha[0].size(); }
    [[nodiscard]] bool has_gaps() const noexcept { return dart_count_ != dart_bound(); }
    [[nodiscard]] bool contains(DartId d) const noexcept {
        return index(d) < dart_bound() && arrays_.alpha[0][index(d)] != detail::none_u32;
    }

    /// The dart that differs from `d` in its I-cell alone; `d` itself where it is I-free.
    template <int I>
    [[nodiscard]] DartId alpha(DartId d) const noexcept {
        static_assert(0 <= I && I <= 3);
        return DartId{arrays_.alpha[I][index(d)]};
    }
    [[nodiscard]] DartId alpha(int i, DartId d) const noexcept {
        return DartId{arrays_.alpha[static_cast<std::size_t>(i)][index(d)]};
    }
    /// alpha<First>, then the rest: alpha<2, 3>(d) == alpha<3>(alpha<2>(d)).
    template <int First, int Second, int... Rest>
    [[nodiscard]] DartId alpha(DartId d) const noexcept {
        return alpha<Second, Rest...>(alpha<First>(d));
    }
    template <int I>
    [[nodiscard]] bool is_free(DartId d) const noexcept {
        return alpha<I>(d) == d;
    }

    /// The I-cell of a dart.
    template <int I>
    [[nodiscard]] CellId<I> cell_id(DartId d) const noexcept {
        return CellId<I>{arrays_.cell_id[I][index(d)]};
    }
    [[nodiscard]] VertexId vertex(DartId d) const noexcept { return cell_id<0>(d); }
    [[nodiscard]] EdgeId edge(DartId d) const noexcept { return cell_id<1>(d); }
    [[nodiscard]] FaceId face(DartId d) const noexcept { return cell_id<2>(d); }
    [[nodiscard]] VolumeId volume(DartId d) const noexcept { return cell_id<3>(d); }

    /// Cells in use, and the bound below which their ids lie: size arrays by the bound.
    template <int I>
    [[nodiscard]] std::size_t cell_count() const noexcept {
        return cell_count_[I];
    }
    template <int I>
    [[nodiscard]] std::size_t cell_bound() const noexcept {
        return arrays_.cell_bound[I];
    }
    [[nodiscard]] std::size_t vertex_count() const noexcept { return cell_count<0>(); }
    [[nodiscard]] std::size_t edge_count() const noexcept { return cell_count<1>(); }
    [[nodiscard]] std::size_t face_count() const noexcept { return cell_count<2>(); }
    [[nodiscard]] std::size_t volume_count() const noexcept { return cell_count<3>(); }

    /// The darts in use, ascending.
    [[nodiscard]] auto darts() const {
        return std::views::iota(std::uint32_t{0}, static_cast<std::uint32_t>(dart_bound())) |
               std::views::transform([](std::uint32_t d) { return DartId{d}; }) |
               std::views::filter([this](DartId d) { return contains(d); });
    }

    /// One dart of each I-cell, the lowest; `none` for ids out of use. [cell_bound<I>()] Cost: one pass over the darts.
    template <int I>
    [[nodiscard]] std::vector<DartId> representatives() const {
        std::vector<DartId> first(cell_bound<I>(), none<DartId>);
        for (std::size_t d = dart_bound(); d-- > 0;)
            if (arrays_.alpha[0][d] != detail::none_u32) first[arrays_.cell_id[I][d]] = DartId(d);
        return first;
    }

    /// The arrays, to write them to a file or to look at them in bulk.
    [[nodiscard]] const MapArrays& arrays() const noexcept { return arrays_; }

    /// A new dart, free in all dimensions, alone in a new vertex, edge, face and volume.
    DartId add_dart();

    /// Removes a dart that is free in all dimensions; false, and no change, where it is not.
    bool remove_dart(DartId d);

    /// Puts a copy of `other` beside this map. Its darts and cells follow: id + the old bound of their kind.
    void append(const Map& other);

    /// Closes the gaps in the numbering of darts and cells, keeping their order.
    Renumbering compact();

    /// Memory of the eight arrays, spare capacity included.
    [[nodiscard]] std::size_t memory_bytes() const noexcept;
    [[nodiscard]] static constexpr std::size_t bytes_per_dart() noexcept {
        return 4 * sizeof(DartId) + sizeof(VertexId) + sizeof(EdgeId) + sizeof(FaceId) + sizeof(VolumeId);
    }

private:
    friend struct detail::MapAccess;

    MapArrays arrays_;
    std::size_t dart_count_ = 0;
    std::array<std::size_t, 4> cell_count_{};
    std::vector<std::uint32_t> gaps_;  ///< slots without a dart, the next to be reused at the end
};

}  // namespace enfilade::gmap
