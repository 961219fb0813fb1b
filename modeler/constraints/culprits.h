#pragma once
// One vertex out of place spoils every face that holds it: from the spoilt faces back to the vertex.

#include <cstdint>
#include <vector>

#include "modeler/building.h"
#include "modeler/constraints/face_rings.h"

namespace enfilade::modeler {

/// A face at fault, and those of its vertices of which each alone would explain it.
struct FaceFault {
    std::uint32_t face = 0;
    std::vector<std::uint32_t> suspects;  ///< may be empty
    bool decisive = true;                 ///< else it only adds weight to vertices that decisive faces suspect
};

struct Culprit {
    std::uint32_t vertex = UINT32_MAX;  ///< none: no vertex of the face alone explains it
    std::vector<std::uint32_t> faults;  ///< positions in what was given, decisive ones first
};

/// Explains all decisive faults by as few vertices as greed finds: first the vertex that most faces suspect, of equal
/// ones that which stands over no point of the plan, then that without which most of its faces would be level or
/// upright, then the lowest. Deterministic.
[[nodiscard]] std::vector<Culprit> culprits(const Building& building, const FaceRings& rings,
                                            const std::vector<FaceFault>& faults);

/// The vertices without each of which the rest of the ring is flat: none where it takes more than one, and none for
/// flat rings. Linear.
[[nodiscard]] std::vector<std::uint32_t> bent_corners(std::span<const std::uint32_t> ring,
                                                      const std::vector<Point3>& points);

}  // namespace enfilade::modeler
