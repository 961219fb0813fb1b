#pragma once
// A vertex out of place disturbs all that holds it, and nothing else: faults of geometry are blamed on stars of
// vertices.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "modeler/constraints/constraints.h"

namespace enfilade::modeler {

class StarBlame {
public:
    /// The index of stars is made when the first fault needs it.
    StarBlame(const Subject& subject, Blame& blame) : subject_(subject), blame_(blame) {}

    /// Blames the vertices, the faces that hold them and the volumes of these.
    void blame(std::span<const std::uint32_t> vertices);

    /// Names what meets in a vertex: the elements of the plan, rooms and walls before slabs; ground and exterior where
    /// nothing else is there. The point is the vertex, where the finding has none yet.
    void place(std::uint32_t vertex, Finding& finding);

    /// `room "Kitchen", wall "w3" and door "d1"`: up to three of what meets in the vertex.
    [[nodiscard]] std::string names(std::uint32_t vertex);

    /// The faces that hold a vertex.
    [[nodiscard]] std::span<const std::uint32_t> faces_at(std::uint32_t vertex);

private:
    /// Spaces at a vertex, those that people know best first.
    [[nodiscard]] std::vector<std::uint32_t> spaces_at(std::uint32_t vertex);

    const Subject& subject_;
    Blame& blame_;
    std::optional<VertexStars> stars_;
};

/// `1.23 mm`, from grid units.
[[nodiscard]] std::string millimetres(const Building& building, double units);

}  // namespace enfilade::modeler
