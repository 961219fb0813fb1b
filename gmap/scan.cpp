// The passes of `validate`. Speed decides their form: each touches every dart once, walks cycles of two involutions
// instead of queueing darts, shares one byte of marks per dart with the others, and leaves all rare cases to cold
// functions.
#include "gmap/scan.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace enfilade::gmap::detail {

namespace {

constexpr std::uint8_t color_mask = 3;  ///< 0: not reached, 1 and 2: the two orientations
constexpr std::uint8_t vertex_mark = 4;
constexpr std::uint8_t edge_mark = 8;

/// Shells joined to connected pieces, each turned or not against the first of its piece: union-find with a parity.
class Orientations {
public:
    std::uint32_t add() {
        parent_.push_back(static_cast<std::uint32_t>(parent_.size()));
        turned_.push_back(0);
        return parent_.back();
    }

    /// Joins two shells, one turned against the other or not; false where that contradicts what joined them before.
    bool unite(std::uint32_t a, std::uint32_t b, bool is_turned) {
        const std::uint32_t root_a = find(a);
        const std::uint32_t root_b = find(b);
        const std::uint8_t turn = static_cast<std::uint8_t>(turned_[a] ^ turned_[b] ^ (is_turned ? 1 : 0));
        if (root_a == root_b) return turn == 0;
        parent_[std::max(root_a, root_b)] = std::min(root_a, root_b);
        turned_[std::max(root_a, root_b)] = turn;
        return true;
    }

    /// The piece of each shell, numbered from 0.
    std::vector<std::uint32_t> numbered() {
        std::vector<std::uint32_t> piece(parent_.size());
        std::uint32_t count = 0;
        for (std::uint32_t shell = 0; shell < parent_.size(); ++shell) {
            const std::uint32_t root = find(shell);
            piece[shell] = root == shell ? count++ : piece[root];
        }
        return piece;
    }

private:
    /// The root; `shell` hangs directly below it afterwards, and turned_[shell] is relative to it.
    std::uint32_t find(std::uint32_t shell) {
        path_.clear();
        while (parent_[shell] != shell) {
            path_.push_back(shell);
            shell = parent_[shell];
        }
        std::uint8_t turn = 0;
        for (std::size_t k = path_.size(); k-- > 0;) {
            turn ^= turned_[path_[k]];
            turned_[path_[k]] = turn;
            parent_[path_[k]] = shell;
        }
        return shell;
    }

    std::vector<std::uint32_t> parent_;
    std::vector<std::uint8_t> turned_;
    std::vector<std::uint32_t> path_;
};

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
        shell_of_volume_.assign(volumes, none_u32);
        face_sides_.assign(map.cell_bound<2>(), 0);
    }

    Scan run() {
        scan_links();
        scan_volumes();
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

    // Volumes and sides of faces, in the order of their first darts, since wandering from neighbour to neighbour would
    // leave the caches. Every dart gets an orientation within its shell; whether those of the shells fit is a matter of
    // parity. Links that are no involution are not followed: behind them everything would look turned around.
    void scan_volumes() {
        for (std::uint32_t d = 0; d < bound_; ++d)
            if (is_dart(d) && !is_reached(d)) visit_shell({d, 1});
        const std::vector<std::uint32_t> pieces = shells_.numbered();
        for (const std::uint32_t piece : pieces) result_.piece_count = std::max(result_.piece_count, piece + 1);
        for (std::size_t c = 0; c < shell_of_volume_.size(); ++c)
            if (shell_of_volume_[c] != none_u32) result_.piece_of_volume[c] = pieces[shell_of_volume_[c]];
        for (Suspect& found : result_.suspects)
            if (found.reason == Reason::PieceNotOrientable) found.cell = pieces[found.cell];
        if (links_are_sound_) return;
        for (std::uint32_t d = 0; d < bound_; ++d)
            if (is_dart(d)) adopt_stray_volume(d);
    }

    /// A volume id that only stray darts carry was met by no walk: it belongs to the piece it strayed into.
    void adopt_stray_volume(std::uint32_t d) {
        std::uint32_t& piece = result_.piece_of_volume[volume_[d]];
        for (const std::uint32_t* alpha : {a0_, a1_, a2_, a3_})
            if (piece == none_u32) piece = result_.piece_of_volume[volume_[alpha[d]]];
        if (piece == none_u32) piece = 0;
    }

    void visit_shell(Start first) {
        shell_ = shells_.add();
        const std::uint32_t volume = volume_[first.dart];
        const bool is_second = shell_of_volume_[volume] != none_u32;
        if (is_second) suspect(Reason::VolumeManyOrbits, 3, volume, first.dart);
        else shell_of_volume_[volume] = shell_;
        --result_.euler;
        next_sides_.push_back(first);
        while (!next_sides_.empty()) {
            const Start start = next_sides_.back();
            next_sides_.pop_back();
            if (is_reached(start.dart)) continue;
            std::int32_t length = walk_side(start, is_second);
            // An open side was walked to one end; the other end is beyond alpha1 of its start.
            const std::uint32_t back = a1_[start.dart];
            if (!is_reached(back)) length += walk_side({back, other(start.color)}, is_second);
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
        if (beyond == start.dart || !is_reached(beyond) || a3_[beyond] != start.dart) return;
        if (!shells_.unite(shell_, shell_of(beyond), ((marks_[start.dart] ^ marks_[beyond]) & color_mask) == 0))
            suspect(Reason::PieceNotOrientable, 4, shell_, start.dart, 3);
    }

    /// The shell of a dart that was reached. Ids have one, but for those that T5 complains about.
    [[nodiscard]] std::uint32_t shell_of(std::uint32_t d) const {
        if (!second_shells_.empty())
            if (const auto found = second_shells_.find(d); found != second_shells_.end()) return found->second;
        const std::uint32_t shell = shell_of_volume_[volume_[d]];
        return shell == none_u32 ? shell_ : shell;
    }

    /// Colors a side of a face from `start` until it comes back or ends; returns the number of its darts.
    std::int32_t walk_side(Start start, bool is_second) {
        std::int32_t length = 0;
        for (std::uint32_t x = start.dart; !is_reached(x);) {
            marks_[x] |= start.color;
            ++length;
            const std::uint32_t r = a2_[x];
            const std::uint8_t met = marks_[r] & color_mask;
            if (met != other(start.color) && r != x && (links_are_sound_ || a2_[r] == x)) {
                if (met == 0) next_sides_.push_back({r, other(start.color)});
                else suspect(Reason::ShellNotOrientable, 3, volume_[x], x, 2);
            }
            const std::uint32_t y = a0_[x];
            if (is_second) second_shells_[x] = second_shells_[y] = shell_;
            if (is_reached(y)) break;
            marks_[y] |= other(start.color);
            ++length;
            x = a1_[y];
        }
        return length;
    }

    static std::uint8_t other(std::uint8_t color) { return color ^ color_mask; }

    // Each link is looked at from its lower dart. That tells all if as many links lead up as down: then each that leads
    // down is the way back of one that leads up. Where anything is wrong, every dart is looked at again from its own
    // side. Block by block and involution by involution, so that few arrays compete for the cache at a time.
    void scan_links() {
        constexpr std::uint32_t block = 1024;
        for (std::uint32_t begin = 0; begin < bound_ && links_are_sound_; begin += std::min(block, bound_ - begin)) {
            const std::uint32_t end = begin + std::min(block, bound_ - begin);
            links_are_sound_ = block_is_sound<0>(begin, end) && block_is_sound<1>(begin, end) &&
                               block_is_sound<2>(begin, end) && block_is_sound<3>(begin, end);
        }
        links_are_sound_ = links_are_sound_ && up_minus_down_ == 0;
        if (links_are_sound_) return;
        for (std::uint32_t d = 0; d < bound_; ++d)
            if (is_dart(d)) note_dart(d);
    }

    template <int I>
    bool block_is_sound(std::uint32_t begin, std::uint32_t end) {
        const std::uint32_t* const alpha = I == 0 ? a0_ : I == 1 ? a1_ : I == 2 ? a2_ : a3_;
        std::int64_t up_minus_down = 0;
        bool is_bad = false;
        for (std::uint32_t d = begin; d < end; ++d) {
            const std::uint32_t x = alpha[d];
            if (x == none_u32) continue;
            if (x <= d) {
                --up_minus_down;
                is_bad |= x == d;
                continue;
            }
            ++up_minus_down;
            is_bad |= alpha[x] != d;
            if constexpr (I != 0) is_bad |= vertex_[x] != vertex_[d];
            if constexpr (I != 1) is_bad |= edge_[x] != edge_[d];
            if constexpr (I < 2) is_bad |= (face_[x] != face_[d]) | (volume_[x] != volume_[d]);
            if constexpr (I == 2)
                is_bad |= (volume_[x] != volume_[d]) | (face_[x] == face_[d]) | (a0_[x] != a2_[a0_[d]]);
            if constexpr (I == 3)
                is_bad |= (face_[x] != face_[d]) | (volume_[x] == volume_[d]) | (a0_[x] != a3_[a0_[d]]) |
                          (a1_[x] != a3_[a1_[d]]);
        }
        up_minus_down_ += up_minus_down;
        return !is_bad;
    }

    void note_dart(std::uint32_t d);

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
    Orientations shells_;
    std::uint32_t shell_ = 0;                                         ///< the one being visited
    std::vector<std::uint32_t> shell_of_volume_;                      ///< its first one
    std::unordered_map<std::uint32_t, std::uint32_t> second_shells_;  ///< by dart, of ids with several shells
    bool links_are_sound_ = true;                                     ///< T1, T2, and no cell is its own neighbour
    std::int64_t up_minus_down_ = 0;
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
