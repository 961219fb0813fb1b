#include "accel/lights/lamp_cone.h"

#include <algorithm>

namespace enfilade::accel::detail {
namespace {

constexpr std::uint32_t of_portal = 0x80000000u;

}  // namespace

void LampCones::begin_with(std::span<const ConeVector> portal) {
    lit_.clear();
    for (std::size_t i = 0; i < portal.size(); ++i)
        lit_.push_back({portal[i], of_portal | static_cast<std::uint32_t>(i)});
}

/// Sutherland and Hodgman 1974, where the plane lies outward by the slack. Returns whether anything is left.
bool LampCones::clip(const ConeVector& normal, std::uint32_t edge) {
    const auto depth = [&](const Vertex& v) { return dot(normal, v.at) + slack_; };
    if (std::ranges::all_of(lit_, [&](const Vertex& v) { return depth(v) >= 0; })) return true;
    spare_.clear();
    for (std::size_t i = 0; i < lit_.size(); ++i) {
        const Vertex& a = lit_[i];
        const Vertex& b = lit_[i + 1 == lit_.size() ? 0 : i + 1];
        const double da = depth(a), db = depth(b);
        if (da >= 0) spare_.push_back(a);
        if ((da < 0) == (db < 0)) continue;
        spare_.push_back({a.at + (da / (da - db)) * (b.at - a.at), da >= 0 ? edge : a.edge});
    }
    std::swap(lit_, spare_);
    return !lit_.empty();
}

/// The plane through the lamp and the line of an edge, turned outward about that line until all that comes within the
/// slack of the lit polygon lies inside. Nothing where the lamp is so near that no turn is enough.
std::optional<ConeVector> LampCones::plane_of(const ConeVector& from, const ConeVector& to) const {
    const ConeVector along = to - from, across = cross(from, to);
    const double square = dot(along, along), area = length(across);
    if (!(square > 0) || !(area * area > slack_ * slack_ * square)) return std::nullopt;
    ConeVector normal = (1 / area) * across;
    const ConeVector foot = from - (dot(from, along) / square) * along;
    const ConeVector forward = (1 / length(foot)) * foot;
    double lowest = 0, highest = 0;
    for (const Vertex& v : lit_) {
        lowest = std::min(lowest, dot(normal, v.at));
        highest = std::max(highest, dot(normal, v.at));
    }
    if (-lowest > highest) normal = -1.0 * normal;  // seen from behind, by less than the slack
    double turn = 0;
    for (const Vertex& v : lit_) {
        const double missing = slack_ - dot(normal, v.at);
        if (missing <= 0) continue;
        const double lever = dot(forward, v.at) - slack_;
        if (lever <= 0 || missing > 4 * lever) return std::nullopt;
        turn = std::max(turn, missing / lever);
    }
    normal = normal + turn * forward;
    // What lies behind the lamp, as seen towards the edge, comes out of the plane by the turn.
    const double least = slack_ * (1 + turn) * (1 - 1e-9);
    if (std::ranges::any_of(lit_, [&](const Vertex& v) { return dot(normal, v.at) < least; })) return std::nullopt;
    return (1 / length(normal)) * normal;
}

std::optional<ConePlanes> LampCones::behind(const ConePlanes& cone, std::span<const ConeVector> portal,
                                            const ConeVector& outward) {
    begin_with(portal);
    for (std::uint32_t k = cone.first; k < cone.first + cone.count; ++k)
        if (!clip(planes_[k], k)) return std::nullopt;
    ConePlanes next = {static_cast<std::uint32_t>(planes_.size()), 0};
    for (std::size_t i = 0; i < lit_.size(); ++i) {
        const std::uint32_t edge = lit_[i].edge;
        if (std::any_of(lit_.begin(), lit_.begin() + static_cast<std::ptrdiff_t>(i),
                        [&](const Vertex& v) { return v.edge == edge; }))
            continue;
        const std::size_t begin = edge & ~of_portal;
        if (edge < of_portal) planes_.push_back(ConeVector(planes_[edge]));
        else if (const auto plane = plane_of(portal[begin], portal[begin + 1 == portal.size() ? 0 : begin + 1])) {
            planes_.push_back(*plane);
        }
    }
    is_last_edge_on_ = dot(outward, portal[0]) <= slack_ && !is_over(portal, outward);
    if (dot(outward, portal[0]) <= 4 * slack_) add_ends(outward);
    next.count = static_cast<std::uint32_t>(planes_.size()) - next.first;
    return next;
}

/// Whether the lamp lies straight before the portal, its border included.
bool LampCones::is_over(std::span<const ConeVector> portal, const ConeVector& outward) const {
    for (std::size_t i = 0; i < portal.size(); ++i) {
        const ConeVector along = portal[i + 1 == portal.size() ? 0 : i + 1] - portal[i];
        if (dot(cross(outward, along), portal[i]) > slack_ * length(along)) return false;
    }
    return true;
}

/// Where the lamp lies in the plane of the portal, planes through edges are that plane: they do not tell where the
/// portal ends. Planes across it do.
void LampCones::add_ends(const ConeVector& outward) {
    for (const Vertex& end : lit_) {
        ConeVector across = cross(outward, end.at);
        double lowest = 0, highest = 0;
        for (const Vertex& v : lit_) {
            lowest = std::min(lowest, dot(across, v.at));
            highest = std::max(highest, dot(across, v.at));
        }
        const double spare = slack_ * length(across);
        if (lowest < -spare && highest > spare) continue;
        if (const auto plane = plane_of(end.at, end.at + outward)) planes_.push_back(*plane);
    }
}

bool LampCones::is_last_within(const ConePlanes& other) const {
    const double least = slack_ * (1 - 1e-9);
    return std::ranges::all_of(planes(other), [&](const ConeVector& plane) {
        return std::ranges::all_of(lit_, [&](const Vertex& v) { return dot(plane, v.at) >= least; });
    });
}

ConePlanes LampCones::nothing_beside(const ConeVector& normal) {
    planes_.push_back(normal);
    planes_.push_back(-1.0 * normal);
    return {static_cast<std::uint32_t>(planes_.size() - 2), 2};
}

}  // namespace enfilade::accel::detail
