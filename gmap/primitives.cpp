#include "gmap/primitives.h"

#include <initializer_list>
#include <stdexcept>

namespace enfilade::gmap {

namespace {

void add_face(CellTuples& tuples, std::initializer_list<std::uint32_t> ring, std::uint32_t below, std::uint32_t above) {
    tuples.ring.insert(tuples.ring.end(), ring);
    tuples.ring_first.push_back(static_cast<std::uint32_t>(tuples.ring.size()));
    tuples.face_volumes.push_back({below, above});
}

/// The three faces of each grid point that lie towards higher indices, as `vertex(i, j, k)` and `volume(i, j, k)`
/// number them; `keep(axis, i, j, k)` says which of them exist.
template <class Vertex, class Volume, class Keep>
void add_grid_faces(CellTuples& tuples, std::int64_t ni, std::int64_t nj, std::int64_t nk, const Vertex& v,
                    const Volume& c, const Keep& keep) {
    tuples.ring_first.push_back(0);
    for (std::int64_t k = 0; k < nk; ++k)
        for (std::int64_t j = 0; j < nj; ++j)
            for (std::int64_t i = 0; i < ni; ++i) {
                if (keep(0, i, j, k))
                    add_face(tuples, {v(i, j, k), v(i, j + 1, k), v(i, j + 1, k + 1), v(i, j, k + 1)}, c(i - 1, j, k),
                             c(i, j, k));
                if (keep(1, i, j, k))
                    add_face(tuples, {v(i, j, k), v(i + 1, j, k), v(i + 1, j, k + 1), v(i, j, k + 1)}, c(i, j - 1, k),
                             c(i, j, k));
                if (keep(2, i, j, k))
                    add_face(tuples, {v(i, j, k), v(i + 1, j, k), v(i + 1, j + 1, k), v(i, j + 1, k)}, c(i, j, k - 1),
                             c(i, j, k));
            }
}

}  // namespace

CellTuples prism_tuples(std::uint32_t corner_count) {
    if (corner_count < 3) throw std::invalid_argument("A prism needs a polygon of at least three corners.");
    CellTuples tuples;
    tuples.vertex_count = 2 * corner_count;
    tuples.volume_count = 2;
    for (std::uint32_t v = 0; v < 2 * corner_count; ++v) tuples.ring.push_back(v);
    tuples.ring_first = {0, corner_count, 2 * corner_count};
    tuples.face_volumes = {{0, 1}, {0, 1}};
    for (std::uint32_t k = 0; k < corner_count; ++k) {
        const std::uint32_t next = (k + 1) % corner_count;
        add_face(tuples, {k, next, corner_count + next, corner_count + k}, 0, 1);
    }
    return tuples;
}

CellTuples hexahedron_tuples() { return prism_tuples(4); }

CellTuples grid_tuples(std::uint32_t nx, std::uint32_t ny, std::uint32_t nz) {
    if (nx < 1 || ny < 1 || nz < 1) throw std::invalid_argument("A grid needs a hexahedron in each direction.");
    const std::int64_t x = nx;
    const std::int64_t y = ny;
    const std::int64_t z = nz;
    if ((x + 1) * (y + 1) * (z + 1) > (std::int64_t{1} << 26))
        throw std::length_error("The grid is too large for a map.");
    CellTuples tuples;
    tuples.vertex_count = static_cast<std::uint32_t>((x + 1) * (y + 1) * (z + 1));
    tuples.volume_count = static_cast<std::uint32_t>(x * y * z + 1);
    const auto vertex = [&](std::int64_t i, std::int64_t j, std::int64_t k) {
        return static_cast<std::uint32_t>((k * (y + 1) + j) * (x + 1) + i);
    };
    const auto volume = [&](std::int64_t i, std::int64_t j, std::int64_t k) {
        const bool is_inside = 0 <= i && i < x && 0 <= j && j < y && 0 <= k && k < z;
        return static_cast<std::uint32_t>(is_inside ? (k * y + j) * x + i : x * y * z);
    };
    add_grid_faces(tuples, x + 1, y + 1, z + 1, vertex, volume,
                   [&](int axis, std::int64_t i, std::int64_t j, std::int64_t k) {
                       return (axis == 0 || i < x) && (axis == 1 || j < y) && (axis == 2 || k < z);
                   });
    return tuples;
}

CellTuples wrapped_grid_tuples(std::uint32_t nx, std::uint32_t ny, std::uint32_t nz, bool flipped) {
    if (nx < 3 || ny < 3 || nz < 3)
        throw std::invalid_argument("A wrapped grid needs three hexahedra in each direction.");
    const std::int64_t x = nx;
    const std::int64_t y = ny;
    const std::int64_t z = nz;
    if (x * y * z > (std::int64_t{1} << 26)) throw std::length_error("The grid is too large for a map.");
    CellTuples tuples;
    tuples.vertex_count = tuples.volume_count = static_cast<std::uint32_t>(x * y * z);
    // Vertex j goes to -j, and the volume between j and j + 1 to the one between -j - 1 and -j.
    const auto wrap = [&](std::int64_t i, std::int64_t j, std::int64_t k, std::int64_t mirror) {
        if (flipped && (i < 0 || i >= x)) j = mirror - j;
        return static_cast<std::uint32_t>((((k + z) % z) * y + (j % y + y) % y) * x + (i + x) % x);
    };
    add_grid_faces(
        tuples, x, y, z, [&](std::int64_t i, std::int64_t j, std::int64_t k) { return wrap(i, j, k, 0); },
        [&](std::int64_t i, std::int64_t j, std::int64_t k) { return wrap(i, j, k, -1); },
        [](int, std::int64_t, std::int64_t, std::int64_t) { return true; });
    return tuples;
}

}  // namespace enfilade::gmap
