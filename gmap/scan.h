#pragma once
// For `validate` only: linear passes over the darts that count cells and note what looks wrong, without judging it.

#include <array>
#include <cstdint>
#include <vector>

#include "gmap/map.h"

namespace enfilade::gmap::detail {

/// Why a cell is suspected. The order is that in which they are judged.
enum class Reason : std::uint8_t {
    NoInvolution,
    NotCommuting,
    TwoIds,  ///< alpha_i changed another id than the i-th
    Free,
    ShellNotOrientable,
    PieceNotOrientable,
    DanglingFace,  ///< judged before T4, which it would trip, and reported as T6
    FaceManyOrbits,
    FaceInOneVolume,
    DanglingEdge,  ///< likewise
    EdgeManyOrbits,
    EdgeInOneFace,
    EdgeTwiceOnShell,
    VertexManyOrbits,
    VolumeManyOrbits,
    VertexTwiceOnShell,
    FewEdges,
    FewFaces,
    ShellEuler,
    LinkNoSphere
};

/// A suspicion: dimension 4 stands for a connected piece, whose cell is its number.
struct Suspect {
    Reason reason;
    std::uint8_t dimension;
    std::uint8_t alpha = 0;  ///< the involution in question, where one is
    std::uint32_t cell;
    std::uint32_t dart;      ///< 0xffffffff where any dart of the cell will do
    std::int64_t value = 0;  ///< the number that is wrong, where one is
};

/// What the passes found. Counts are indexed by cell id.
struct Scan {
    std::vector<Suspect> suspects;
    std::vector<std::uint32_t> one_volume_darts;  ///< volume(d) == volume(alpha3(d))
    std::vector<std::uint32_t> one_face_darts;    ///< face(d) == face(alpha2(d))
    std::vector<std::uint32_t> piece_of_volume;   ///< connected piece of each volume
    std::uint32_t piece_count = 0;
    std::vector<std::int32_t> volume_darts;
    std::vector<std::int32_t> volume_faces;      ///< sides of faces on the shell
    std::vector<std::int32_t> volume_umbrellas;  ///< vertices of the shell
    std::int64_t euler = 0;                      ///< V - E + F - C over orbits
};

[[nodiscard]] Scan scan(const Map& map);

/// Per vertex id, Euler's number of its link: ends of edges - corners of faces + umbrellas; a sphere has 2.
[[nodiscard]] std::vector<std::int32_t> link_euler(const Map& map);

}  // namespace enfilade::gmap::detail
