#include "tests/support/stream_judge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "tests/support/error_band.h"

namespace enfilade::test {

using render::RayHit;
using render::RayQuery;
using render::WalkStatus;

namespace {

constexpr std::size_t most_faults = 4;

template <class... Arguments>
std::string printed(const char* format, Arguments... arguments) {
    std::array<char, 512> buffer;
    std::snprintf(buffer.data(), buffer.size(), format, arguments...);
    return buffer.data();
}

const char* name_of(WalkStatus status) {
    switch (status) {
        case WalkStatus::Hit: return "hit";
        case WalkStatus::Reached: return "limit reached";
        case WalkStatus::Leak: return "leak";
        case WalkStatus::Refused: return "refused";
        case WalkStatus::Object: return "object";
    }
    return "no answer";
}

}  // namespace

std::string text_of(const RayQuery& ray) {
    return printed("origin (%a, %a, %a) direction (%a, %a, %a) limit %a cell %u", ray.origin.x, ray.origin.y,
                   ray.origin.z, ray.direction.x, ray.direction.y, ray.direction.z, ray.max_distance,
                   static_cast<unsigned>(ray.cell));
}

std::string StreamVerdict::text() const {
    std::string all = printed(
        "%llu rays: %llu differ, %llu of them outside the band; wrong: %llu distances, %llu cells, "
        "%llu statuses; %llu leaks",
        static_cast<unsigned long long>(rays), static_cast<unsigned long long>(differing),
        static_cast<unsigned long long>(outside_band), static_cast<unsigned long long>(wrong_distance),
        static_cast<unsigned long long>(wrong_cell), static_cast<unsigned long long>(wrong_status),
        static_cast<unsigned long long>(leaks));
    for (const std::string& fault : faults) all += "\n  " + fault;
    return all;
}

void StreamVerdict::add(const StreamVerdict& other) {
    rays += other.rays;
    differing += other.differing;
    outside_band += other.outside_band;
    wrong_distance += other.wrong_distance;
    wrong_cell += other.wrong_cell;
    wrong_status += other.wrong_status;
    leaks += other.leaks;
    for (const std::string& fault : other.faults)
        if (faults.size() < most_faults) faults.push_back(fault);
}

StreamJudge::StreamJudge(const accel::SceneView& scene)
    : scene_(&scene), oracle_(scene), band_(render::error_band(scene)), largest_(0) {
    for (int k = 0; k < 3; ++k)
        largest_ = std::max({largest_, std::abs(double{scene.locator_nodes[0].low[k]}),
                             std::abs(double{scene.locator_nodes[0].high[k]})});
}

StreamVerdict StreamJudge::compare(const std::vector<RayQuery>& rays, const std::vector<RayHit>& expected,
                                   const RayTable& table) const {
    StreamVerdict verdict;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        ++verdict.rays;
        judge({rays[i], expected[i], table.status[i], double{table.distance[i]}, table.source_face[i], table.cell[i]},
              verdict);
    }
    return verdict;
}

bool StreamJudge::is_doubtful(const RayQuery& ray, const RayHit& hit) const {
    return test::is_doubtful(oracle_, ray.origin, ray.direction, hit, band_);
}

double StreamJudge::distance_error(const Answer& a) const {
    const double sine = std::abs(dot(oracle_.normal(a.expected.source_face), normalized(a.ray.direction)));
    return 1e-5 * a.expected.distance + 8 * 0x1p-24 * largest_ / std::max(sine, 1e-5);
}

bool StreamJudge::cell_shows_face(accel::CellId id, accel::SourceFaceId face) const {
    if (index(id) >= scene_->cells.size()) return false;
    const accel::Cell& cell = scene_->cells[index(id)];
    const auto shows = [&](accel::Target target) { return !target.is_portal() && target.source_face() == face; };
    if (shows(cell.floor) || shows(cell.ceiling)) return true;
    const std::uint32_t first = scene_->section_tails[cell.first_section].first_face;
    const std::uint32_t last = scene_->section_tails[cell.first_section + cell.section_count].first_face;
    for (std::uint32_t f = first; f < last; ++f)
        if (shows(scene_->side_faces[f].target)) return true;
    return false;
}

void StreamJudge::judge(const Answer& a, StreamVerdict& verdict) const {
    const auto note = [&](const char* what) {
        if (verdict.faults.size() >= most_faults) return;
        verdict.faults.push_back(printed("%s: %s, face %u in cell %u at %.7g m, instead of %s, face %u in cell %u at "
                                         "%.7g m; ",
                                         what, name_of(a.status), static_cast<unsigned>(a.face),
                                         static_cast<unsigned>(a.cell), a.distance, name_of(a.expected.status),
                                         static_cast<unsigned>(a.expected.source_face),
                                         static_cast<unsigned>(a.expected.cell), a.expected.distance) +
                                 text_of(a.ray));
    };
    if (a.status == WalkStatus::Leak) {
        ++verdict.leaks;
        return note("a leak");
    }
    if ((a.status == WalkStatus::Refused) != (a.expected.status == WalkStatus::Refused) ||
        static_cast<std::uint32_t>(a.status) > static_cast<std::uint32_t>(WalkStatus::Refused) ||
        (a.status == WalkStatus::Refused && !std::isnan(a.distance)) ||
        (a.status != WalkStatus::Hit && a.face != none<accel::SourceFaceId>)) {
        ++verdict.wrong_status;
        return note("a wrong status");
    }
    if (a.status == WalkStatus::Refused) return;
    if (a.status == WalkStatus::Hit && !cell_shows_face(a.cell, a.face)) {
        ++verdict.wrong_cell;
        return note("a wrong cell");
    }
    if (a.status == WalkStatus::Reached && a.expected.status == WalkStatus::Reached) {
        if (std::abs(a.distance - a.ray.max_distance) <= 1e-6 * std::abs(a.ray.max_distance)) return;
        ++verdict.wrong_distance;
        return note("a wrong limit");
    }
    if (a.status != a.expected.status) {
        ++verdict.differing;
        const double met = a.status == WalkStatus::Hit ? a.distance : a.expected.distance;
        const accel::SourceFaceId face = a.status == WalkStatus::Hit ? a.face : a.expected.source_face;
        const double sine = std::abs(dot(oracle_.normal(face), normalized(a.ray.direction)));
        if (std::abs(met - a.ray.max_distance) <= 1e-5 * met + band_ / std::max(sine, 1e-5)) return;
        if (is_doubtful(a.ray, a.expected)) return;
        ++verdict.outside_band;
        return note("another end");
    }
    RayHit answered = a.expected;
    answered.source_face = a.face;
    answered.distance = a.distance;
    if (a.face != a.expected.source_face) {
        ++verdict.differing;
        if (is_doubtful(a.ray, a.expected) || is_doubtful(a.ray, answered)) return;
        ++verdict.outside_band;
        return note("another face");
    }
    if (std::abs(a.distance - a.expected.distance) <= distance_error(a)) return;
    // In the very plane of a face, a ray may meet either end of it.
    if (oracle_.plane_distance(a.ray.origin, a.face) <= band_ && is_doubtful(a.ray, answered)) return;
    ++verdict.wrong_distance;
    note("a wrong distance");
}

}  // namespace enfilade::test
