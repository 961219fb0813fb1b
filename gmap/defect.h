#pragma once
// What is wrong with a map, and where.

#include <string>

#include "gmap/ids.h"

namespace enfilade::gmap {

/// The kind of thing that a defect is about; a defect of a whole connected piece names its first dart.
enum class Blamed { Vertex, Edge, Face, Volume, Component };

/// One broken constraint (T1...T7), at one cell. Ids that say nothing are `none`.
struct Defect {
    std::string code;  ///< "T1" ... "T7"
    Blamed blamed = Blamed::Component;
    DartId dart = none<DartId>;  ///< a dart where it shows
    VertexId vertex = none<VertexId>;
    EdgeId edge = none<EdgeId>;
    FaceId face = none<FaceId>;
    VolumeId volume = none<VolumeId>;
    std::string sentence;
};

}  // namespace enfilade::gmap
