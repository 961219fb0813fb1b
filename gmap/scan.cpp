// The passes of `validate`. Speed decides their form: each touches every dart once, walks cycles of two involutions
// instead of queueing darts, shares one byte of marks per dart with the others, and leaves all rare cases to cold
// functions.
#include "gmap/scan.h"

#include <utility>

namespace enfilade::gmap::detail {

namespace {

constexpr std::uint8_t color_mask = 3;  ///< 0: not reached, 1 and 2: the two orientations
constexpr std::uint8_t vertex_mark = 4;
constexpr std::uint8_t edge_mark = 8;

class Scanner {
public:
    explicit Scanner(const Map& map)
        : map_(map),
          a0_(map.arrays().alpha[0].data()),
          a1_(map.arrays().alpha[1].data()),
          a2_(map.arrays().alpha[2].data()),
          a3_(map.arrays().alpha[3].data()),
          vertex_(map.arrays().cell_id[0].data()),
          edge_(map.arrays().cell_id[1].data()),
          face_(map.arrays().cell_id[2].data()),
          volume_(map.arrays().cell_id[3].data()),
          bound_(static_cast<std::uint32_t>(map.dart_bound())),
          marks_(bound_, 0) {
        const std::size_t volumes = map.cell_bound<3>();
        result_.volume_darts.assign(volumes, 0);
        result_.volume_faces.assign(volumes, 0);
        result_.volume_umbrellas.assign(volumes, 0);
        result_.piece_of_volume.assign(volumes, none_u32);
        stamps_.assign(volumes, none_u32);
        face_sides_.assign(map.cell_bound<2>(), 0);
    }

    Scan run() {
        scan_volumes();
        scan_links();
        scan_vertices();
        scan_edges();
        judge_counts();
        return std::move(result_);
    }

private:
    [[nodiscard]] bool is_dart(std::uint32_t d) const { return a0_[d] != none_u32; }
    void suspect(Reason reason, int dimension, std::uint32_t cell, std::uint32_t d, int alpha = 0,
                 std::int64_t value = 0) {
        result_.suspects.push_back(
            {reason, static_cast<std::uint8_t>(dimension), static_cast<std::uint8_t>(alpha), cell, d, value});
    }

    /// A dart still to be reached, with the orientation it will get.
    struct Start {
        std::uint32_t dart;
        std::uint8_t color;
    };

    [[nodiscard]] bool is_reached(std::uint32_t d) const { return (marks_[d] & color_mask) != 0; }

    // Pieces, volumes and sides of faces; every dart gets an orientation on the way. Links that are no involution are
    // not followed, so that a broken one does not turn what lies behind it around.
    void scan_volumes() {
        std::uint32_t piece = 0;
        for (std::uint32_t d = 0; d < bound_; ++d) {
            if (!is_dart(d) || is_reached(d)) continue;
            next_volumes_.push_back({d, 1});
            while (!next_volumes_.empty()) {
                const Start start = next_volumes_.back();
                next_volumes_.pop_back();
                if (!is_reached(start.dart)) visit_volume(start, piece);
            }
            ++piece;
        }
    }

    void visit_volume(Start first, std::uint32_t piece) {
        const std::uint32_t volume = volume_[first.dart];
        if (result_.piece_of_volume[volume] != none_u32) suspect(Reason::VolumeManyOrbits, 3, volume, first.dart);
        else result_.piece_of_volume[volume] = piece;
        --result_.euler;
        next_sides_.push_back(first);
        while (!next_sides_.empty()) {
            const Start start = next_sides_.back();
            next_sides_.pop_back();
            if (is_reached(start.dart)) continue;
            std::int32_t length = walk_side(start);
            // An open side was walked to one end; the other end is beyond alpha1 of its start.
            const std::uint32_t back = a1_[start.dart];
            if (!is_reached(back)) length += walk_side({back, other(start.color)});
            note_side(start, length);
        }
    }

    void note_side(Start start, std::int32_t length) {
        const std::uint32_t c = volume_[start.dart];
        const std::uint32_t f = face_[start.dart];
        result_.volume_darts[c] += length;
        ++result_.volume_faces[c];
        ++face_sides_[f];
        if (length < 6) suspect(Reason::FewEdges, 2, f, start.dart, 0, length / 2);
        const std::uint32_t beyond = a3_[start.dart];
        if (!is_reached(beyond) && a3_[beyond] == start.dart) next_volumes_.push_back({beyond, other(start.color)});
    }

    /// Colors a side of a face from `start` until it comes back or ends; returns the number of its darts.
    std::int32_t walk_side(Start start) {
        std::int32_t length = 0;
        for (std::uint32_t x = start.dart; !is_reached(x);) {
            marks_[x] |= start.color;
            ++length;
            const std::uint32_t r = a2_[x];
            if (!is_reached(r) && a2_[r] == x) next_sides_.push_back({r, other(start.color)});
            const std::uint32_t y = a0_[x];
            if (is_reached(y)) break;
            marks_[y] |= other(start.color);
            ++length;
            x = a1_[y];
        }
        return length;
    }

    static std::uint8_t other(std::uint8_t color) { return color ^ color_mask; }

    // One look at each dart and its four neighbours.
    void scan_links() {
        for (std::uint32_t d = 0; d < bound_; ++d) {
            if (!is_dart(d)) continue;
            const std::uint32_t p = a0_[d];
            const std::uint32_t s = a1_[d];
            const std::uint32_t r = a2_[d];
            const std::uint32_t q = a3_[d];
            const bool is_broken = (a0_[p] != d) | (a1_[s] != d) | (a2_[r] != d) | (a3_[q] != d) | (a2_[p] != a0_[r]) |
                                   (a3_[p] != a0_[q]) | (a3_[s] != a1_[q]);
            const std::uint32_t v = vertex_[d];
            const std::uint32_t e = edge_[d];
            const std::uint32_t f = face_[d];
            const std::uint32_t c = volume_[d];
            const std::uint8_t color = marks_[d] & color_mask;
            const bool ids_differ = (v != vertex_[s]) | (v != vertex_[r]) | (v != vertex_[q]) | (e != edge_[p]) |
                                    (e != edge_[r]) | (e != edge_[q]) | (f != face_[p]) | (f != face_[s]) |
                                    (f != face_[q]) | (c != volume_[p]) | (c != volume_[s]) | (c != volume_[r]);
            const bool touches_itself = (f == face_[r]) | (c == volume_[q]);
            const bool is_twisted = (color == (marks_[p] & color_mask)) | (color == (marks_[s] & color_mask)) |
                                    (color == (marks_[r] & color_mask)) | (color == (marks_[q] & color_mask));
            if (is_broken | ids_differ | touches_itself | is_twisted) note_dart(d);
        }
    }

    void note_dart(std::uint32_t d);
    void note_twist(std::uint32_t d);

    // Umbrellas (cycles of alpha1, alpha2) and vertices (what alpha3 joins of them).
    void scan_vertices() {
        std::vector<std::uint8_t> seen(map_.cell_bound<0>(), 0);
        for (std::uint32_t d = 0; d < bound_; ++d) {
            if (!is_dart(d) || (marks_[d] & vertex_mark) != 0) continue;
            const std::uint32_t v = vertex_[d];
            ++result_.euler;
            if (seen[v] != 0) suspect(Reason::VertexManyOrbits, 0, v, d);
            seen[v] = 1;
            stack_.assign(1, d);
            while (!stack_.empty()) {
                const std::uint32_t start = stack_.back();
                stack_.pop_back();
                if ((marks_[start] & vertex_mark) != 0) continue;
                walk_umbrella(start);
                walk_umbrella(a2_[start]);
                const std::uint32_t c = volume_[start];
                ++result_.volume_umbrellas[c];
                if (stamps_[c] == v) suspect(Reason::VertexTwiceOnShell, 0, v, start, 0, c);
                stamps_[c] = v;
            }
        }
    }

    void walk_umbrella(std::uint32_t start) {
        for (std::uint32_t x = start; (marks_[x] & vertex_mark) == 0;) {
            marks_[x] |= vertex_mark;
            const std::uint32_t q = a3_[x];
            if ((marks_[q] & vertex_mark) == 0) stack_.push_back(q);
            const std::uint32_t y = a1_[x];
            marks_[y] |= vertex_mark;
            x = a2_[y];
        }
    }

    // Edges: cycles of alpha2, alpha3, marked together with their images under alpha0.
    void scan_edges() {
        stamps_.assign(stamps_.size(), none_u32);
        std::vector<std::uint8_t> seen(map_.cell_bound<1>(), 0);
        for (std::uint32_t d = 0; d < bound_; ++d) {
            if (!is_dart(d) || (marks_[d] & edge_mark) != 0) continue;
            const std::uint32_t e = edge_[d];
            --result_.euler;
            if (seen[e] != 0) suspect(Reason::EdgeManyOrbits, 1, e, d);
            seen[e] = 1;
            walk_edge(d, e);
            walk_edge(a3_[d], e);
        }
    }

    void walk_edge(std::uint32_t start, std::uint32_t e) {
        for (std::uint32_t x = start; (marks_[x] & edge_mark) == 0;) {
            const std::uint32_t y = a2_[x];
            marks_[x] |= edge_mark;
            marks_[a0_[x]] |= edge_mark;
            marks_[y] |= edge_mark;
            marks_[a0_[y]] |= edge_mark;
            const std::uint32_t c = volume_[x];
            if (stamps_[c] == e) suspect(Reason::EdgeTwiceOnShell, 1, e, x, 0, c);
            stamps_[c] = e;
            x = a3_[y];
        }
    }

    void judge_counts() {
        std::int64_t sides = 0;
        for (std::uint32_t f = 0; f < face_sides_.size(); ++f) {
            sides += face_sides_[f];
            if (face_sides_[f] != 0 && face_sides_[f] != 2)
                suspect(Reason::FaceManyOrbits, 2, f, none_u32, 0, face_sides_[f]);
        }
        result_.euler += sides / 2;
        for (std::uint32_t c = 0; c < result_.volume_faces.size(); ++c) {
            const std::int64_t faces = result_.volume_faces[c];
            if (faces == 0) continue;
            if (faces < 4) suspect(Reason::FewFaces, 3, c, none_u32, 0, faces);
            const std::int64_t euler4 = 4 * (result_.volume_umbrellas[c] + faces) - result_.volume_darts[c];
            if (euler4 != 8) suspect(Reason::ShellEuler, 3, c, none_u32, 0, euler4 / 4);
        }
    }

    const Map& map_;
    const std::uint32_t* a0_;
    const std::uint32_t* a1_;
    const std::uint32_t* a2_;
    const std::uint32_t* a3_;
    const std::uint32_t* vertex_;
    const std::uint32_t* edge_;
    const std::uint32_t* face_;
    const std::uint32_t* volume_;
    std::uint32_t bound_;
    std::vector<std::uint8_t> marks_;
    std::vector<std::uint32_t> stamps_;  ///< per volume: the last vertex or edge that met it
    std::vector<std::int32_t> face_sides_;
    std::vector<std::uint32_t> stack_;
    std::vector<Start> next_sides_;
    std::vector<Start> next_volumes_;
    Scan result_;
};

/// The cell in which a broken alpha_i is blamed.
constexpr int blamed_dimension(int i) { return i == 0 || i == 2 ? 1 : 2; }
/// The cell in which a free dart is blamed: an open shell is one fault, however long its rim.
constexpr int opened_dimension(int i) {
    constexpr int dimension[4] = {1, 2, 3, 2};
    return dimension[i];
}

void Scanner::note_dart(std::uint32_t d) {
    const std::uint32_t* alpha[4] = {a0_, a1_, a2_, a3_};
    const std::uint32_t* cell[4] = {vertex_, edge_, face_, volume_};
    // An id that only stray darts carry was met by no walk: it belongs to the piece it strayed into.
    for (int i = 0; i < 4 && result_.piece_of_volume[volume_[d]] == none_u32; ++i)
        result_.piece_of_volume[volume_[d]] = result_.piece_of_volume[volume_[alpha[i][d]]];
    if (result_.piece_of_volume[volume_[d]] == none_u32) result_.piece_of_volume[volume_[d]] = 0;
    for (int i = 0; i < 4; ++i) {
        const std::uint32_t image = alpha[i][d];
        if (image == d) suspect(Reason::Free, opened_dimension(i), cell[opened_dimension(i)][d], d, i);
        if (alpha[i][image] != d)
            suspect(Reason::NoInvolution, blamed_dimension(i), cell[blamed_dimension(i)][d], d, i);
        for (int j = 0; j < 4; ++j)
            if (j != i && cell[j][d] != cell[j][image])
                suspect(Reason::TwoIds, j, cell[j][d] < cell[j][image] ? cell[j][d] : cell[j][image], d, i);
    }
    if (a2_[a0_[d]] != a0_[a2_[d]]) suspect(Reason::NotCommuting, 1, edge_[d], d, 2);
    if (a3_[a0_[d]] != a0_[a3_[d]]) suspect(Reason::NotCommuting, 1, edge_[d], d, 3);
    if (a3_[a1_[d]] != a1_[a3_[d]]) suspect(Reason::NotCommuting, 2, face_[d], d, 1);
    if (a2_[d] != d && face_[d] == face_[a2_[d]]) result_.one_face_darts.push_back(d);
    if (a3_[d] != d && volume_[d] == volume_[a3_[d]]) result_.one_volume_darts.push_back(d);
    note_twist(d);
}

void Scanner::note_twist(std::uint32_t d) {
    const std::uint32_t* alpha[4] = {a0_, a1_, a2_, a3_};
    for (int i = 0; i < 4; ++i) {
        const std::uint32_t image = alpha[i][d];
        if (image == d || alpha[i][image] != d || ((marks_[d] ^ marks_[image]) & color_mask) != 0) continue;
        if (i < 3) suspect(Reason::ShellNotOrientable, 3, volume_[d], d, i);
        else suspect(Reason::PieceNotOrientable, 4, result_.piece_of_volume[volume_[d]], d, i);
    }
}

}  // namespace

Scan scan(const Map& map) { return Scanner(map).run(); }

std::vector<std::int32_t> link_euler(const Map& map) {
    const MapArrays& arrays = map.arrays();
    std::vector<std::int32_t> corners(map.cell_bound<0>(), 0);
    std::vector<std::int32_t> cycles(map.cell_bound<0>(), 0);
    for (const std::uint32_t v : arrays.cell_id[0])
        if (v != none_u32) ++corners[v];
    for (const auto& [i, j] : {std::pair<std::size_t, std::size_t>{1, 2}, std::pair<std::size_t, std::size_t>{2, 3}}) {
        std::vector<bool> seen(map.dart_bound(), false);
        for (std::uint32_t d = 0; d < seen.size(); ++d) {
            if (arrays.alpha[0][d] == none_u32 || seen[d]) continue;
            ++cycles[arrays.cell_id[0][d]];
            for (std::uint32_t x = d; !seen[x]; x = arrays.alpha[j][x]) {
                seen[x] = true;
                x = arrays.alpha[i][x];
                seen[x] = true;
            }
        }
    }
    for (std::size_t v = 0; v < cycles.size(); ++v) cycles[v] -= corners[v] / 4;
    return cycles;
}

}  // namespace enfilade::gmap::detail
