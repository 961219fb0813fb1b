#include "modeler/meshes/mesh_map.h"

#include <algorithm>

#include "base/disjoint_sets.h"

namespace enfilade::modeler {
namespace {

using Ring = std::vector<std::uint32_t>;
using Point = std::array<double, 3>;

/// Twice the area of a ring as a vector (Newell).
Point area_vector(const Mesh& mesh, const Ring& ring) {
    Point sum{};
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Point &o = mesh.points[ring[0]], &p = mesh.points[ring[k]], &q = mesh.points[ring[(k + 1) % ring.size()]];
        const Point a{p[0] - o[0], p[1] - o[1], p[2] - o[2]}, b{q[0] - o[0], q[1] - o[1], q[2] - o[2]};
        for (std::size_t i = 0; i < 3; ++i) sum[i] += a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
    }
    return sum;
}

/// Fills the tuples of one map, vertices numbered in order of use.
class TupleBuilder {
public:
    TupleBuilder(const Mesh& mesh, MeshMap& out, Ring& local) : mesh_(mesh), out_(out), local_(local) {
        out_.tuples.ring_first = {0};
    }

    void add(std::uint32_t face, const Ring& outer, std::vector<Ring> holes) {
        Ring ring;
        for (const std::uint32_t v : outer) ring.push_back(vertex(v));
        // Each hole is joined to the outer ring by two cuts, which leave two discs. A cut has a point of its own, so
        // that it never runs along another edge; where it runs in space does not matter to the map.
        for (Ring& hole : holes) {
            // Inner rings run the other way round, else the cut faces would cross over (val3dity 208).
            const Point a = area_vector(mesh_, outer), b = area_vector(mesh_, hole);
            if (a[0] * b[0] + a[1] * b[1] + a[2] * b[2] > 0) std::reverse(hole.begin(), hole.end());
            for (std::uint32_t& v : hole) v = vertex(v);
            ring = touches(ring, hole) ? joined(ring, std::move(hole)) : cut(face, ring, hole);
        }
        push(face, ring);
    }

private:
    std::uint32_t vertex(std::uint32_t v) {
        if (local_[v] == UINT32_MAX) {
            local_[v] = static_cast<std::uint32_t>(out_.vertex.size());
            out_.vertex.push_back(v);
        }
        return local_[v];
    }

    void push(std::uint32_t face, const Ring& ring) {
        out_.tuples.ring.insert(out_.tuples.ring.end(), ring.begin(), ring.end());
        out_.tuples.ring_first.push_back(static_cast<std::uint32_t>(out_.tuples.ring.size()));
        out_.face.push_back(face);
    }

    [[nodiscard]] static bool touches(const Ring& ring, const Ring& hole) {
        return std::find_first_of(ring.begin(), ring.end(), hole.begin(), hole.end()) != ring.end();
    }

    /// A hole that shares a vertex with the ring: one ring that goes around it there.
    [[nodiscard]] static Ring joined(Ring ring, Ring hole) {
        const auto at = std::find_first_of(ring.begin(), ring.end(), hole.begin(), hole.end());
        std::rotate(hole.begin(), std::find(hole.begin(), hole.end(), *at) + 1, hole.end());
        ring.insert(at + 1, hole.begin(), hole.end());
        return ring;
    }

    /// Adds the disc between corners 0 ... 1 of the ring and the hole; returns the rest, which goes round the other
    /// way.
    Ring cut(std::uint32_t face, const Ring& ring, const Ring& hole) {
        const auto first = static_cast<std::uint32_t>(out_.vertex.size()), second = first + 1;
        out_.vertex.insert(out_.vertex.end(), 2, UINT32_MAX);
        // Holes run against the ring: corner 1 of the hole is reached from corner 0 of the ring's side.
        push(face, {ring[0], ring[1], second, hole[0], hole[1], first});
        Ring rest(ring.begin() + 1, ring.end());
        rest.push_back(ring[0]);
        rest.push_back(first);
        rest.insert(rest.end(), hole.begin() + 1, hole.end());
        rest.push_back(hole[0]);
        rest.push_back(second);
        return rest;
    }

    const Mesh& mesh_;
    MeshMap& out_;
    Ring& local_;
};

/// Pieces are connected by vertices; piece p lies between volumes 2p and 2p + 1.
void number_pieces(MeshMap& out) {
    gmap::CellTuples& t = out.tuples;
    DisjointSets pieces(out.vertex.size());
    for (std::size_t f = 0; f < out.face.size(); ++f)
        for (std::uint32_t r = t.ring_first[f] + 1; r < t.ring_first[f + 1]; ++r) pieces.join(t.ring[r - 1], t.ring[r]);
    Ring number(out.vertex.size(), UINT32_MAX);
    t.face_volumes.resize(out.face.size());
    for (std::size_t f = 0; f < out.face.size(); ++f) {
        std::uint32_t& piece = number[pieces.find(t.ring[t.ring_first[f]])];
        if (piece == UINT32_MAX) piece = out.piece_count++;
        t.face_volumes[f] = {2 * piece, 2 * piece + 1};
    }
    t.volume_count = 2 * out.piece_count;
    t.vertex_count = static_cast<std::uint32_t>(out.vertex.size());
}

void derive_edges(MeshMap& out) {
    const std::size_t count = out.tuples.ring.size();
    out.entry_face.resize(count);
    out.edge.resize(count);
    out.uses.assign(out.map.cell_bound<1>(), 0);
    out.entries.assign(out.map.cell_bound<1>(), {UINT32_MAX, UINT32_MAX});
    for (std::uint32_t f = 0; f < out.face.size(); ++f)
        for (std::uint32_t r = out.tuples.ring_first[f]; r < out.tuples.ring_first[f + 1]; ++r) {
            out.entry_face[r] = f;
            const auto e = static_cast<std::uint32_t>(out.map.edge(out.dart(r, 0)));
            out.edge[r] = e;
            if (out.uses[e] < 2) out.entries[e][out.uses[e]] = r;
            ++out.uses[e];
        }
}

}  // namespace

MeshMap MeshMapBuilder::build(const MeshBody& body, const CleanRings& rings, const std::vector<bool>& left_out) {
    MeshMap out;
    TupleBuilder builder(mesh_, out, local_);
    for (std::uint32_t f = body.first_face; f < body.first_face + body.face_count; ++f) {
        if (!left_out.empty() && left_out[f - body.first_face]) continue;
        const Ring outer = rings.outer(f);
        if (outer.empty()) continue;
        std::vector<Ring> holes;
        if (!mesh_.holes.empty())
            for (const MeshHole& hole : mesh_.holes_of(f))
                if (Ring inner = rings.inner(hole); !inner.empty()) holes.push_back(std::move(inner));
        builder.add(f, outer, std::move(holes));
    }
    for (const std::uint32_t v : out.vertex)
        if (v != UINT32_MAX) local_[v] = UINT32_MAX;
    number_pieces(out);
    // What the builder refuses are edges with one face, or with more than two: they are counted below.
    std::vector<gmap::Defect> refused;
    out.map = gmap::build_map(out.tuples, refused);
    derive_edges(out);
    return out;
}

}  // namespace enfilade::modeler
