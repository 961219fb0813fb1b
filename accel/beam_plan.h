#pragma once
// A beam seen from above: which lines of the plan start in its source and cross its portals, exactly, in integers
// (README.md of this folder, "Beams").

#include <cstdint>
#include <optional>
#include <vector>

#include "accel/beam_source.h"

namespace enfilade::accel {

/// A portal as its beam crosses it: where it ends on the left and on the right.
struct Gate {
    PlanPoint left;
    PlanPoint right;
};

/// A directed line through two different grid points; or none.
struct PlanLine {
    PlanPoint from;
    PlanPoint to;
    bool is_gate = false;  ///< as a bound: the line of the gate that was crossed last

    [[nodiscard]] bool exists() const { return !(from == to); }
    /// Positive for points on its left.
    [[nodiscard]] std::int64_t side(const PlanPoint& p) const { return turn(from, to, p); }
};

/// What bounds a beam behind the last gate that it crossed: everything that its lines reach there lies right of (or on)
/// `left` and left of (or on) `right`. Neither exists before the first gate.
struct PlanBeam {
    PlanLine left;
    PlanLine right;
    std::uint32_t left_chain = UINT32_MAX;   ///< ends of crossed gates that can still bound it, in a PlanHistory
    std::uint32_t right_chain = UINT32_MAX;  ///< on the other side
};

/// The ends of the gates that beams have crossed: chains that share their beginnings, as the beams do.
class PlanHistory {
public:
    /// One end of a gate, and its other end.
    struct End {
        PlanPoint at;
        PlanPoint other;
        std::uint32_t before;  ///< the end before it in its chain, 2^32 - 1 for none
    };
    [[nodiscard]] const End& operator[](std::uint32_t i) const { return ends_[i]; }
    /// The chain, longer by this end; ends that it hides from all that comes are left out. side: +1 for right ends of
    /// gates, -1 for left ones.
    std::uint32_t add(std::uint32_t chain, const PlanPoint& at, const PlanPoint& other, int side);
    [[nodiscard]] std::size_t size() const { return ends_.size(); }
    /// Forgets the ends from number `size` on.
    void shrink(std::size_t size) { ends_.resize(size); }

private:
    std::vector<End> ends_;
};

/// The beam behind one more gate; nothing where no line of it gets there. Exact for margin 0: of a sequence of gates,
/// those are reached that a line can cross without touching their ends, and no other; the two bounds are then lines of
/// the beam's closure. `margin`: lines may pass each end of a gate this many units beside it, for tracers that round.
[[nodiscard]] std::optional<PlanBeam> cross(const BeamSource& source, const PlanBeam& beam, const Gate& gate,
                                            std::int64_t margin, PlanHistory& history);

}  // namespace enfilade::accel
