// G2 and G3 of meshes.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "modeler/meshes/mesh_triangles.h"
#include "modeler/meshes/point_index.h"
#include "modeler/meshes/polygon_triangles.h"

namespace enfilade::modeler {
namespace {

MeshPoint minus(const MeshPoint& a, const MeshPoint& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const MeshPoint& a, const MeshPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
MeshPoint cross(const MeshPoint& a, const MeshPoint& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double length(const MeshPoint& a) { return std::sqrt(dot(a, a)); }

/// Below this share of the longest side a height is what rounding left of 0.
constexpr double flat_share = 1e-10;

/// The plane of a face: through the centre of its corners, across the sum of its triangles (Newell).
struct FacePlane {
    MeshPoint centre{};
    MeshPoint normal{};  ///< of length 1; 0 where the face has no area
};

class FaceChecker {
public:
    FaceChecker(const std::vector<std::uint32_t>& place, MeshReport& report, MeshCount& count)
        : place_(place), report_(report), mesh_(report.mesh()), count_(count) {
        out_.corners.reserve(mesh_.ring.size() - std::min(mesh_.ring.size(), 2 * mesh_.face_count()));
        out_.face.reserve(out_.corners.capacity());
        out_.missing.assign(mesh_.face_count(), false);
        cosine_ = std::cos(report.options().planar_angle_deg * std::numbers::pi / 180);
    }

    MeshTriangles run() {
        for (std::uint32_t f = 0; f < mesh_.face_count(); ++f) {
            const auto ring = mesh_.face(f);
            if (report_.blame.face[f]) {
                out_.missing[f] = true;
                count_.flat_faces += ring.size() == 3 && is_flat(ring[0], ring[1], ring[2]) ? 1 : 0;
            } else if (ring.size() == 3 && (mesh_.holes.empty() || mesh_.holes_of(f).empty())) {
                check_triangle(f, ring);
            } else {
                check_polygon(f);
            }
        }
        return std::move(out_);
    }

private:
    [[nodiscard]] bool is_flat(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        const MeshPoint ab = minus(mesh_.points[b], mesh_.points[a]), ac = minus(mesh_.points[c], mesh_.points[a]);
        const MeshPoint bc = minus(mesh_.points[c], mesh_.points[b]);
        const double longest = std::max({dot(ab, ab), dot(ac, ac), dot(bc, bc)});
        return length(cross(ab, ac)) <= flat_share * longest;
    }

    void check_triangle(std::uint32_t f, std::span<const std::uint32_t> ring) {
        if (is_flat(ring[0], ring[1], ring[2])) return report_flat(f, ring);
        out_.corners.push_back({ring[0], ring[1], ring[2]});
        out_.face.push_back(f);
    }

    void check_polygon(std::uint32_t f) {
        corners_.assign(mesh_.face(f).begin(), mesh_.face(f).end());
        ends_.assign(1, std::uint32_t(corners_.size()));
        for (const MeshHole& hole : mesh_.holes_of(f)) {
            corners_.insert(corners_.end(), mesh_.hole(hole).begin(), mesh_.hole(hole).end());
            ends_.push_back(std::uint32_t(corners_.size()));
        }
        const FacePlane plane = fit();
        if (plane.normal == MeshPoint{}) return report_flat(f, corners_);
        const bool is_flat = check_distance(f, plane);  // else its ring is hard to judge from any side
        if (!cut_quadrangle(plane) && !cut_polygon(f, plane)) return;
        for (const auto& [a, b, c] : triangles_) {
            out_.corners.push_back({corners_[a], corners_[b], corners_[c]});
            out_.face.push_back(f);
        }
        if (is_flat) check_folds(f, plane);
    }

    [[nodiscard]] FacePlane fit() const {
        FacePlane plane;
        MeshPoint sum{};
        double longest = 0;
        const MeshPoint& origin = mesh_.points[corners_[0]];
        std::uint32_t begin = 0;
        for (const std::uint32_t end : ends_) {
            for (std::uint32_t k = begin; k < end; ++k) {
                const MeshPoint p = minus(mesh_.points[corners_[k]], origin);
                const MeshPoint q = minus(mesh_.points[corners_[k + 1 < end ? k + 1 : begin]], origin);
                for (std::size_t i = 0; i < 3; ++i) plane.centre[i] += p[i] / double(corners_.size());
                if (begin != 0) continue;  // the outer ring alone says which way the face looks
                const MeshPoint add = cross(p, q);
                for (std::size_t i = 0; i < 3; ++i) sum[i] += add[i];
                longest = std::max(longest, dot(p, p));
            }
            begin = end;
        }
        for (std::size_t i = 0; i < 3; ++i) plane.centre[i] += origin[i];
        if (length(sum) <= flat_share * longest) sum = widest_turn();  // sides that cross may cancel out
        const double size = length(sum);
        if (size > flat_share * longest) plane.normal = {sum[0] / size, sum[1] / size, sum[2] / size};
        return plane;
    }

    /// Across the largest triangle of the first corner, the farthest from it, and any.
    [[nodiscard]] MeshPoint widest_turn() const {
        const MeshPoint& origin = mesh_.points[corners_[0]];
        MeshPoint far{}, widest{};
        for (std::uint32_t k = 0; k < ends_[0]; ++k)
            if (const MeshPoint p = minus(mesh_.points[corners_[k]], origin); dot(p, p) > dot(far, far)) far = p;
        for (std::uint32_t k = 0; k < ends_[0]; ++k)
            if (const MeshPoint n = cross(far, minus(mesh_.points[corners_[k]], origin));
                dot(n, n) > dot(widest, widest))
                widest = n;
        return widest;
    }

    /// The two axes that are left when the one nearest to the normal is dropped; kept so that turns stay as they are.
    [[nodiscard]] static std::array<std::size_t, 2> axes(const FacePlane& plane) {
        std::size_t drop = 0;
        for (std::size_t i = 1; i < 3; ++i)
            if (std::abs(plane.normal[i]) > std::abs(plane.normal[drop])) drop = i;
        return {(drop + 1) % 3, (drop + 2) % 3};
    }

    /// By far the most polygons: four corners whose turns are beyond doubt.
    bool cut_quadrangle(const FacePlane& plane) {
        if (corners_.size() != 4) return false;
        const auto [x, y] = axes(plane);
        std::array<double, 4> turn{};
        double doubt = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const MeshPoint &a = mesh_.points[corners_[k]], &b = mesh_.points[corners_[(k + 1) % 4]],
                            &c = mesh_.points[corners_[(k + 2) % 4]];
            const double left = (b[x] - a[x]) * (c[y] - a[y]), right = (b[y] - a[y]) * (c[x] - a[x]);
            turn[(k + 1) % 4] = left - right;
            doubt = std::max(doubt, 4e-15 * (std::abs(left) + std::abs(right)));
        }
        const bool clear = std::all_of(turn.begin(), turn.end(), [&](double t) { return std::abs(t) > doubt; });
        if (!clear) return false;
        const double way = turn[0] + turn[2] > 0 ? 1 : -1;  // twice the area
        std::size_t reflex = 4;
        for (std::size_t k = 0; k < 4; ++k) {
            if (turn[k] * way > 0) continue;
            if (reflex != 4) return false;  // two: its sides cross
            reflex = k;
        }
        // Of both diagonals of a convex one that whose end has the lowest place: the same for all who share the face.
        const auto lower = [&](std::uint32_t a, std::uint32_t b) { return place_[corners_[a]] < place_[corners_[b]]; };
        const std::uint32_t at = reflex == 4 ? std::min({0u, 1u, 2u, 3u}, lower) : static_cast<std::uint32_t>(reflex);
        triangles_ = {{at, (at + 1) % 4, (at + 2) % 4}, {at, (at + 2) % 4, (at + 3) % 4}};
        return true;
    }

    bool cut_polygon(std::uint32_t f, const FacePlane& plane) {
        const auto [x, y] = axes(plane);
        flat_.clear();
        for (const std::uint32_t v : corners_) flat_.push_back({mesh_.points[v][x], mesh_.points[v][y]});
        const PolygonVerdict verdict = triangulator_.triangulate(flat_, ends_, triangles_);
        if (verdict.fault == PolygonFault::None) return true;
        report_polygon(f, verdict);
        return false;
    }

    bool check_distance(std::uint32_t f, const FacePlane& plane) {
        double farthest = 0;
        std::uint32_t corner = corners_[0];
        for (const std::uint32_t v : corners_) {
            const double distance = std::abs(dot(plane.normal, minus(mesh_.points[v], plane.centre)));
            if (distance > farthest) farthest = distance, corner = v;
        }
        if (farthest <= report_.options().planar_distance) return true;
        report_distance(f, corner, farthest);
        return false;
    }

    void check_folds(std::uint32_t f, const FacePlane& plane) {
        double least = 1;
        std::uint32_t corner = corners_[0];
        for (const auto& [a, b, c] : triangles_) {
            const MeshPoint& o = mesh_.points[corners_[a]];
            const MeshPoint n = cross(minus(mesh_.points[corners_[b]], o), minus(mesh_.points[corners_[c]], o));
            if (length(n) == 0) continue;
            const double cosine = dot(n, plane.normal) / length(n);
            if (cosine < least) least = cosine, corner = corners_[b];
        }
        if (least < cosine_) report_angle(f, corner, std::acos(std::max(-1.0, least)) * 180 / std::numbers::pi);
    }

    Finding finding_at(const char* code, std::uint32_t f, std::uint32_t v) const {
        Finding finding{.code = code, .severity = Severity::Error};
        report_.put_at(finding, mesh_.points[v]);
        report_.name_face(finding, f);
        report_.name_vertex(finding, v);
        return finding;
    }

    void report_flat(std::uint32_t f, std::span<const std::uint32_t> ring) {
        ++count_.flat_faces;
        out_.missing[f] = true;
        report_.blame.face[f] = true;
        if (has_equal_places(ring)) return report_.suppress();  // G1, or the seam, says why
        Finding finding = finding_at("G2", f, ring[0]);
        finding.sentence = "Face " + report_.face(f) + " has no area: its corners " +
                           report_.vertices({ring.begin(), ring.end()}) + " lie on one line.";
        finding.hint = "Leave it out and join its neighbours.";
        report_.add(std::move(finding), "faces without area");
    }

    [[nodiscard]] bool has_equal_places(std::span<const std::uint32_t> ring) const {
        for (std::size_t k = 0; k < ring.size(); ++k)
            for (std::size_t j = k + 1; j < ring.size(); ++j)
                if (ring[j] != ring[k] && place_[ring[j]] == place_[ring[k]]) return true;
        return false;
    }

    void report_polygon(std::uint32_t f, const PolygonVerdict& verdict) {
        out_.missing[f] = true;
        if (report_.blame.face[f]) return report_.suppress();
        report_.blame.face[f] = true;
        if (verdict.fault == PolygonFault::NoArea) return report_flat(f, corners_);
        if (corners_.size() < 1000 && has_equal_places(corners_)) return report_.suppress();
        Finding finding = finding_at("G2", f, corners_[verdict.corner]);
        const std::string face = report_.face(f), v = report_.vertex(corners_[verdict.corner]);
        switch (verdict.fault) {
            case PolygonFault::Coincident:
                finding.sentence =
                    "Face " + face + ", seen from its front, has two corners at one place: vertex " + v + ".";
                break;
            case PolygonFault::Crossing:
                finding.sentence = "The sides of face " + face + " cross: that which begins at vertex " + v + ".";
                break;
            case PolygonFault::Touching:
                finding.sentence =
                    "The ring of face " + face + " touches itself on the side that begins at vertex " + v + ".";
                break;
            case PolygonFault::HoleOutside:
                finding.sentence = "Face " + face + " has a hole outside of it, at vertex " + v + ".";
                break;
            case PolygonFault::HoleNested:
                finding.sentence = "Face " + face + " has a hole within another hole, at vertex " + v + ".";
                break;
            default: finding.sentence = "The holes of face " + face + " leave several parts of it.";
        }
        finding.hint = "Draw the face as one or more simple polygons.";
        report_.add(std::move(finding), "faces that are no discs");
    }

    void report_distance(std::uint32_t f, std::uint32_t v, double distance) {
        report_.blame.face[f] = true;
        Finding finding = finding_at("G3", f, v);
        finding.sentence = "Face " + report_.face(f) + " is not flat: vertex " + report_.vertex(v) + " lies " +
                           short_number(distance) + " from its plane, more than " +
                           short_number(report_.options().planar_distance) + ".";
        finding.hint = "Move the vertex into the plane, or cut the face into triangles.";
        report_.add(std::move(finding), "faces that are not flat");
    }

    void report_angle(std::uint32_t f, std::uint32_t v, double angle) {
        report_.blame.face[f] = true;
        Finding finding = finding_at("G3", f, v);
        finding.sentence = "Face " + report_.face(f) + " has a fold of " + short_number(angle) + " degrees at vertex " +
                           report_.vertex(v) + ", more than " + short_number(report_.options().planar_angle_deg) + ".";
        finding.hint = "Corners very near to each other are often the reason: leave one of them out.";
        report_.add(std::move(finding), "faces with a fold");
    }

    const std::vector<std::uint32_t>& place_;
    MeshReport& report_;
    const Mesh& mesh_;
    MeshCount& count_;
    double cosine_ = 0;
    MeshTriangles out_;
    PolygonTriangulator triangulator_;
    std::vector<std::uint32_t> corners_, ends_;
    std::vector<std::array<double, 2>> flat_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace

MeshTriangles check_faces(const std::vector<std::uint32_t>& place, MeshReport& report, MeshCount& count) {
    report.applied({"G2", "G3"});
    return FaceChecker(place, report, count).run();
}

}  // namespace enfilade::modeler
