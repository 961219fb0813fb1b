#pragma once
// The faces of a map as rings of vertices, walked along its darts, and how each lies in space.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "gmap/map.h"
#include "modeler/constraints/exact3.h"
#include "plans/grid.h"

namespace enfilade::modeler {

/// How the vertices of a face lie, exactly.
enum class Lie : std::uint8_t {
    NoRing,   ///< its darts do not hang together: the topology is at fault
    Level,    ///< in one horizontal plane
    Upright,  ///< in one vertical plane
    Tilted,   ///< in another plane
    Bent      ///< in no plane
};

class FaceRings {
public:
    /// Any arrays that `gmap::Map` takes will do: what does not close is `NoRing`. `vertices` and `map` are kept by
    /// reference. \pre vertices.size() >= map.cell_bound<0>(). Cost: one pass over the darts.
    FaceRings(const gmap::Map& map, const std::vector<Point3>& vertices);

    /// Bound of the face ids.
    [[nodiscard]] std::uint32_t size() const { return std::uint32_t(lie_.size()); }
    [[nodiscard]] std::uint32_t volume_bound() const { return std::uint32_t(first_face_.size()) - 1; }
    /// Vertex ids in order around the face; empty for `NoRing` and for ids out of use.
    [[nodiscard]] std::span<const std::uint32_t> ring(std::uint32_t face) const {
        return std::span(ring_).subspan(first_[face], count_[face]);
    }
    [[nodiscard]] Lie lie(std::uint32_t face) const { return lie_[face]; }
    /// The volumes on the two sides of the face.
    [[nodiscard]] const std::array<std::uint32_t, 2>& volumes(std::uint32_t face) const { return volumes_[face]; }
    /// The faces of a volume that have a ring, ascending.
    [[nodiscard]] std::span<const std::uint32_t> faces_of(std::uint32_t volume) const {
        return std::span(of_volume_).subspan(first_face_[volume], first_face_[volume + 1] - first_face_[volume]);
    }
    [[nodiscard]] const Point3& point(std::uint32_t vertex) const { return (*vertices_)[vertex]; }
    [[nodiscard]] const std::vector<Point3>& points() const { return *vertices_; }

    /// The ring in two coordinates of its own plane, without distortion of what crosses what: x and y of level faces,
    /// z and the longer of x and y of upright ones, all but the steepest axis of others.
    void flatten(std::uint32_t face, std::vector<plans::GridPoint>& flat) const;

private:
    void walk_faces(const gmap::MapArrays& arrays);
    void sort_into_volumes(std::size_t volumes);

    const std::vector<Point3>* vertices_;
    std::vector<std::uint32_t> ring_;
    std::vector<std::uint32_t> first_;                   ///< [face] into ring_
    std::vector<std::uint32_t> count_;                   ///< [face]
    std::vector<Lie> lie_;                               ///< [face]
    std::vector<std::array<std::uint32_t, 2>> volumes_;  ///< [face]
    std::vector<std::uint32_t> of_volume_, first_face_;  ///< [volume + 1] into of_volume_
};

/// How a ring of points lies.
[[nodiscard]] Lie lie_of(std::span<const std::uint32_t> ring, const std::vector<Point3>& points);

/// Three vertices of the ring that span a plane, the first that do; nothing where all lie on one line. `without` is
/// passed over.
[[nodiscard]] std::optional<std::array<std::uint32_t, 3>> plane_corners(std::span<const std::uint32_t> ring,
                                                                        const std::vector<Point3>& points,
                                                                        std::uint32_t without = UINT32_MAX);

/// Which faces hold each vertex; made when a fault is found, for what is to be blamed with it.
class VertexStars {
public:
    explicit VertexStars(const FaceRings& rings);
    [[nodiscard]] std::span<const std::uint32_t> faces_at(std::uint32_t vertex) const {
        return std::span(faces_).subspan(first_[vertex], first_[vertex + 1] - first_[vertex]);
    }

private:
    std::vector<std::uint32_t> first_, faces_;
};

}  // namespace enfilade::modeler
