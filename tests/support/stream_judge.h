#pragma once
// Answers to streams of rays, ray by ray, against the scalar walk's.

#include <cstdint>
#include <string>
#include <vector>

#include "accel/scene.h"
#include "render/oracle.h"
#include "render/trace_rays.h"
#include "tests/support/ray_table.h"

namespace enfilade::test {

struct StreamVerdict {
    std::uint64_t rays = 0;
    std::uint64_t differing = 0;       ///< name another face, or are limited where the others are not
    std::uint64_t outside_band = 0;    ///< of those: no edge is near. A fault
    std::uint64_t wrong_distance = 0;  ///< of the same face: a fault
    std::uint64_t wrong_cell = 0;      ///< the face is not one of the last cell's: a fault
    std::uint64_t wrong_status = 0;    ///< refused or not, and what is answered then: a fault
    std::uint64_t leaks = 0;           ///< a fault
    std::vector<std::string> faults;   ///< the first few, in words

    [[nodiscard]] bool is_right() const {
        return outside_band + wrong_distance + wrong_cell + wrong_status + leaks == 0;
    }
    [[nodiscard]] std::string text() const;
    void add(const StreamVerdict& other);
};

class StreamJudge {
public:
    explicit StreamJudge(const accel::SceneView& scene);

    /// expected: of `trace_rays` in float, for the same rays. table: answered.
    [[nodiscard]] StreamVerdict compare(const std::vector<render::RayQuery>& rays,
                                        const std::vector<render::RayHit>& expected, const RayTable& table) const;

    /// Whether rounding explains two answers to one ray.
    [[nodiscard]] bool is_doubtful(const render::RayQuery& ray, const render::RayHit& hit) const;

    [[nodiscard]] const render::Oracle& oracle() const { return oracle_; }
    [[nodiscard]] double band() const { return band_; }

private:
    struct Answer {
        const render::RayQuery& ray;
        const render::RayHit& expected;
        render::WalkStatus status;
        double distance;
        accel::SourceFaceId face;
        accel::CellId cell;
    };
    void judge(const Answer& answer, StreamVerdict& verdict) const;
    [[nodiscard]] double distance_error(const Answer& answer) const;
    [[nodiscard]] bool cell_shows_face(accel::CellId cell, accel::SourceFaceId face) const;

    const accel::SceneView* scene_;
    render::Oracle oracle_;
    double band_;
    double largest_;
};

/// A ray as a test prints it: exact.
[[nodiscard]] std::string text_of(const render::RayQuery& ray);

}  // namespace enfilade::test
