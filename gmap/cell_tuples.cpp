#include "gmap/cell_tuples.h"

#include <algorithm>
#include <compare>
#include <iterator>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include "gmap/access.h"

namespace enfilade::gmap {

namespace {

using U32s = std::vector<std::uint32_t>;

/// Calls body(begin, end, worker) on `threads` consecutive parts of [0, count).
template <class Body>
void in_parts(std::size_t count, unsigned threads, const Body& body) {
    if (threads <= 1) return body(std::size_t{0}, count, 0u);
    std::vector<std::jthread> pool;
    for (unsigned worker = 0; worker < threads; ++worker)
        pool.emplace_back([=, &body] { body(count * worker / threads, count * (worker + 1) / threads, worker); });
}

void check_ranges(const CellTuples& t) {
    const bool offsets_fit = t.ring_first.size() == t.face_count() + 1 && t.ring_first.front() == 0 &&
                             t.ring_first.back() == t.ring.size() &&
                             std::is_sorted(t.ring_first.begin(), t.ring_first.end());
    if (!offsets_fit && !(t.ring_first.empty() && t.face_volumes.empty() && t.ring.empty()))
        throw std::invalid_argument("The rings of the cell tuples do not add up to their faces.");
    if (t.dart_count() >= detail::none_u32) throw std::length_error("A map holds fewer than 2^32 - 1 darts.");
    for (const std::uint32_t v : t.ring)
        if (v >= t.vertex_count) throw std::invalid_argument("A ring names vertex " + std::to_string(v) + ".");
    for (const auto& sides : t.face_volumes)
        if (sides[0] >= t.volume_count || sides[1] >= t.volume_count)
            throw std::invalid_argument("A face lies between volumes that do not exist.");
}

/// Items 0 ... keys.size() grouped by their key: group k is items[first[k] ... first[k + 1]], ascending.
struct Groups {
    U32s first;
    U32s items;
};

Groups group_by(const U32s& keys, std::size_t key_count) {
    Groups groups{U32s(key_count + 1, 0), U32s(keys.size())};
    for (const std::uint32_t key : keys) ++groups.first[key + 1];
    for (std::size_t k = 0; k < key_count; ++k) groups.first[k + 1] += groups.first[k];
    U32s next(groups.first.begin(), groups.first.end() - 1);
    for (std::size_t item = 0; item < keys.size(); ++item)
        groups.items[next[keys[item]]++] = static_cast<std::uint32_t>(item);
    return groups;
}

/// Groups are mostly of a handful: an insertion sort beats the call. Hubs with thousands go to std::sort.
template <class Iterator>
void sort_small(Iterator begin, Iterator end) {
    if (end - begin > 32) return std::sort(begin, end);
    for (Iterator i = begin; i != end; ++i)
        for (Iterator j = i; j != begin && *j < *(j - 1); --j) std::iter_swap(j, j - 1);
}

/// The rings with what is derived from them: face, next vertex and edge of each ring entry.
struct Rings {
    explicit Rings(const CellTuples& t) : tuples(t), face(t.ring.size()), next(t.ring.size()) {
        for (std::size_t f = 0; f < t.face_count(); ++f)
            for (std::uint32_t r = t.ring_first[f]; r < t.ring_first[f + 1]; ++r) {
                face[r] = static_cast<std::uint32_t>(f);
                next[r] = t.ring[r + 1 < t.ring_first[f + 1] ? r + 1 : t.ring_first[f]];
            }
        number_edges();
    }

    /// First of the two darts of ring entry `r` on side `s`.
    [[nodiscard]] std::uint32_t dart(std::uint32_t r, std::uint32_t s) const {
        const std::uint32_t first = tuples.ring_first[face[r]];
        const std::uint32_t length = tuples.ring_first[face[r] + 1] - first;
        return 4 * first + 2 * s * length + 2 * (r - first);
    }

    const CellTuples& tuples;
    U32s face;
    U32s next;
    U32s edge;
    std::uint32_t edge_count = 0;

private:
    /// Edges by vertex pair: ring entries are grouped by their lower vertex, then sorted by the higher one.
    void number_edges() {
        U32s low(face.size());
        for (std::size_t r = 0; r < low.size(); ++r) low[r] = std::min(tuples.ring[r], next[r]);
        const Groups at_low = group_by(low, tuples.vertex_count);
        U32s first_use(low.size());
        std::vector<std::pair<std::uint32_t, std::uint32_t>> entries;  // (higher vertex, ring entry)
        for (std::size_t v = 0; v < tuples.vertex_count; ++v) {
            entries.clear();
            for (std::uint32_t i = at_low.first[v]; i < at_low.first[v + 1]; ++i) {
                const std::uint32_t r = at_low.items[i];
                entries.emplace_back(std::max(tuples.ring[r], next[r]), r);
            }
            sort_small(entries.begin(), entries.end());
            for (std::size_t i = 0; i < entries.size(); ++i) {
                const bool same = i > 0 && entries[i].first == entries[i - 1].first;
                first_use[entries[i].second] = same ? first_use[entries[i - 1].second] : entries[i].second;
            }
        }
        edge = std::move(first_use);
        for (std::size_t r = 0; r < edge.size(); ++r) edge[r] = edge[r] == r ? edge_count++ : edge[edge[r]];
    }
};

/// Everything but alpha<2>, which stays free.
void fill_faces(const Rings& rings, MapArrays& out, std::size_t face_begin, std::size_t face_end) {
    const CellTuples& t = rings.tuples;
    for (std::size_t f = face_begin; f < face_end; ++f) {
        const std::uint32_t first = t.ring_first[f];
        const std::uint32_t length = t.ring_first[f + 1] - first;
        for (std::uint32_t s = 0; s < 2; ++s)
            for (std::uint32_t k = 0; k < length; ++k) {
                const std::uint32_t side = 4 * first + 2 * s * length;
                const std::uint32_t other_side = 4 * first + 2 * (1 - s) * length;
                for (std::uint32_t end = 0; end < 2; ++end) {
                    const std::uint32_t d = side + 2 * k + end;
                    const std::uint32_t neighbour = end == 0 ? (k + length - 1) % length : (k + 1) % length;
                    out.alpha[0][d] = side + 2 * k + 1 - end;
                    out.alpha[1][d] = side + 2 * neighbour + 1 - end;
                    out.alpha[2][d] = d;
                    out.alpha[3][d] = other_side + 2 * k + end;
                    out.cell_id[0][d] = end == 0 ? t.ring[first + k] : rings.next[first + k];
                    out.cell_id[1][d] = rings.edge[first + k];
                    out.cell_id[2][d] = static_cast<std::uint32_t>(f);
                    out.cell_id[3][d] = t.face_volumes[f][s];
                }
            }
    }
}

/// One side of one ring entry, seen from its edge.
struct EdgeUse {
    std::uint32_t volume;
    std::uint32_t ring_entry;
    std::uint32_t side;
    friend auto operator<=>(const EdgeUse&, const EdgeUse&) = default;
};

class FaceLinker {
public:
    FaceLinker(const Rings& rings, const Groups& at_edge, MapArrays& out)
        : rings_(rings), at_edge_(at_edge), out_(out) {}

    void link(std::size_t edge_begin, std::size_t edge_end, std::vector<Defect>& defects) const {
        std::vector<EdgeUse> uses;
        for (std::size_t e = edge_begin; e < edge_end; ++e) {
            uses.clear();
            for (std::uint32_t i = at_edge_.first[e]; i < at_edge_.first[e + 1]; ++i) {
                const std::uint32_t r = at_edge_.items[i];
                for (std::uint32_t s = 0; s < 2; ++s)
                    uses.push_back({rings_.tuples.face_volumes[rings_.face[r]][s], r, s});
            }
            if (rings_.tuples.ring[uses[0].ring_entry] == rings_.next[uses[0].ring_entry]) {
                defects.push_back(defect("T6", Blamed::Edge, uses[0], " joins a vertex to itself."));
                continue;
            }
            sort_small(uses.begin(), uses.end());
            link_edge(uses, defects);
        }
    }

private:
    void link_edge(const std::vector<EdgeUse>& uses, std::vector<Defect>& defects) const {
        for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
            while (end < uses.size() && uses[end].volume == uses[begin].volume) ++end;
            if (end - begin == 1) {
                defects.push_back(defect("T2", Blamed::Edge, uses[begin], " has only one face in this volume."));
                continue;
            }
            link_pair(uses[begin], uses[begin + 1]);
            for (std::size_t i = begin + 2; i < end; ++i)
                defects.push_back(defect("T4", Blamed::Edge, uses[i], " has more than two faces in this volume."));
        }
    }

    void link_pair(const EdgeUse& a, const EdgeUse& b) const {
        const std::uint32_t da = rings_.dart(a.ring_entry, a.side);
        const std::uint32_t db = rings_.dart(b.ring_entry, b.side);
        const std::uint32_t flip = rings_.tuples.ring[a.ring_entry] == rings_.tuples.ring[b.ring_entry] ? 0 : 1;
        for (std::uint32_t end = 0; end < 2; ++end) {
            out_.alpha[2][da + end] = db + (end ^ flip);
            out_.alpha[2][db + (end ^ flip)] = da + end;
        }
    }

    [[nodiscard]] Defect defect(const char* code, Blamed blamed, const EdgeUse& use, const char* fault) const {
        const std::uint32_t r = use.ring_entry;
        Defect found{code,
                     blamed,
                     DartId{rings_.dart(r, use.side)},
                     VertexId{rings_.tuples.ring[r]},
                     EdgeId{rings_.edge[r]},
                     FaceId{rings_.face[r]},
                     VolumeId{use.volume},
                     {}};
        found.sentence = "Edge " + std::to_string(rings_.edge[r]) + " (vertices " +
                         std::to_string(rings_.tuples.ring[r]) + " and " + std::to_string(rings_.next[r]) +
                         ") of face " + std::to_string(rings_.face[r]) + ", volume " + std::to_string(use.volume) +
                         "," + fault;
        return found;
    }

    const Rings& rings_;
    const Groups& at_edge_;
    MapArrays& out_;
};

void report_empty_faces(const CellTuples& t, std::vector<Defect>& defects) {
    for (std::size_t f = 0; f < t.face_count(); ++f) {
        if (t.ring_first[f] != t.ring_first[f + 1]) continue;
        Defect found{"T6",
                     Blamed::Face,
                     none<DartId>,
                     none<VertexId>,
                     none<EdgeId>,
                     FaceId(f),
                     VolumeId{t.face_volumes[f][0]},
                     "Face " + std::to_string(f) + " has no edge."};
        defects.push_back(std::move(found));
    }
}

std::size_t count_used(const U32s& ids, std::size_t bound) {
    std::vector<bool> used(bound, false);
    for (const std::uint32_t id : ids) used[id] = true;
    return static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
}

}  // namespace

Map build_map(const CellTuples& tuples, std::vector<Defect>& defects, unsigned threads) {
    check_ranges(tuples);
    threads = std::max(1u, std::min<unsigned>(threads, static_cast<unsigned>(tuples.ring.size() / 4096 + 1)));
    const Rings rings(tuples);
    MapArrays out;
    out.cell_bound = {tuples.vertex_count, rings.edge_count, static_cast<std::uint32_t>(tuples.face_count()),
                      tuples.volume_count};
    for (std::size_t i = 0; i < 4; ++i) {
        out.alpha[i].resize(tuples.dart_count());
        out.cell_id[i].resize(tuples.dart_count());
    }
    in_parts(tuples.face_count(), threads,
             [&](std::size_t begin, std::size_t end, unsigned) { fill_faces(rings, out, begin, end); });

    const Groups at_edge = group_by(rings.edge, rings.edge_count);
    std::vector<std::vector<Defect>> found(threads);
    in_parts(rings.edge_count, threads, [&](std::size_t begin, std::size_t end, unsigned worker) {
        FaceLinker(rings, at_edge, out).link(begin, end, found[worker]);
    });
    for (auto& part : found) std::move(part.begin(), part.end(), std::back_inserter(defects));
    report_empty_faces(tuples, defects);

    const std::size_t vertices_used = count_used(tuples.ring, tuples.vertex_count);
    U32s volumes;
    std::size_t faces_used = 0;
    for (std::size_t f = 0; f < tuples.face_count(); ++f) {
        if (tuples.ring_first[f] == tuples.ring_first[f + 1]) continue;
        ++faces_used;
        volumes.insert(volumes.end(), tuples.face_volumes[f].begin(), tuples.face_volumes[f].end());
    }
    return detail::MapAccess::adopt(
        std::move(out), {vertices_used, rings.edge_count, faces_used, count_used(volumes, tuples.volume_count)});
}

}  // namespace enfilade::gmap
