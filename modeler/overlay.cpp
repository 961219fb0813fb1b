#include "modeler/overlay.h"

#include <vector>

namespace enfilade::modeler {
namespace {

constexpr std::uint32_t no_index = UINT32_MAX;
constexpr std::uint32_t unknown = UINT32_MAX - 1;

struct Sides {
    std::uint32_t left = unknown;
    std::uint32_t right = unknown;
    [[nodiscard]] std::uint32_t of(std::uint32_t half_edge) const { return half_edge % 2 == 0 ? left : right; }
};

class Overlay {
public:
    Overlay(const PlanGraph& graph, std::span<const BandEdge> below, std::span<const BandEdge> above)
        : graph_(graph),
          below_(graph.graph.edges.size()),
          above_(graph.graph.edges.size()),
          face_(2 * below_.size(), no_index) {
        for (const BandEdge& edge : below) below_[edge.edge] = {edge.left, edge.right};
        for (const BandEdge& edge : above) above_[edge.edge] = {edge.left, edge.right};
    }

    void run(const OverlayFace& visit) {
        trace_faces();
        spread(piece_below_, below_);
        spread(piece_above_, above_);
        for (std::uint32_t f = 0; f + 1 < first_.size(); ++f)
            if (piece_below_[f] < unknown && piece_above_[f] < unknown)
                visit(std::span(ring_).subspan(first_[f], first_[f + 1] - first_[f]), piece_below_[f], piece_above_[f]);
    }

private:
    [[nodiscard]] bool is_edge(std::uint32_t e) const { return below_[e].left != unknown || above_[e].left != unknown; }

    void trace_faces() {
        first_.push_back(0);
        for (std::uint32_t start = 0; start < face_.size(); ++start) {
            if (!is_edge(start / 2) || face_[start] != no_index) continue;
            std::uint32_t below = unknown, above = unknown;
            for (std::uint32_t h = start; face_[h] == no_index; h = next_along(h)) {
                face_[h] = std::uint32_t(first_.size() - 1);
                ring_.push_back(h);
                if (below_[h / 2].of(h) != unknown) below = below_[h / 2].of(h);
                if (above_[h / 2].of(h) != unknown) above = above_[h / 2].of(h);
            }
            first_.push_back(std::uint32_t(ring_.size()));
            piece_below_.push_back(below);
            piece_above_.push_back(above);
        }
    }

    [[nodiscard]] std::uint32_t next_along(std::uint32_t h) const {
        std::uint32_t g = graph_.map.next[h];
        while (!is_edge(g / 2)) g = graph_.map.next[g ^ 1];
        return g;
    }

    /// Faces that meet none of a band's own edges lie in the piece of their neighbours.
    void spread(std::vector<std::uint32_t>& piece, const std::vector<Sides>& sides) const {
        std::vector<std::uint32_t> queue;
        for (std::uint32_t f = 0; f < piece.size(); ++f)
            if (piece[f] != unknown) queue.push_back(f);
        while (!queue.empty()) {
            const std::uint32_t f = queue.back();
            queue.pop_back();
            for (std::uint32_t k = first_[f]; k < first_[f + 1]; ++k) {
                if (sides[ring_[k] / 2].left != unknown) continue;
                const std::uint32_t g = face_[ring_[k] ^ 1];
                if (piece[g] != unknown) continue;
                piece[g] = piece[f];
                queue.push_back(g);
            }
        }
    }

    const PlanGraph& graph_;
    std::vector<Sides> below_, above_;  ///< [edge]
    std::vector<std::uint32_t> face_;   ///< [half-edge]
    std::vector<std::uint32_t> ring_, first_;
    std::vector<std::uint32_t> piece_below_, piece_above_;
};

}  // namespace

void overlay(const PlanGraph& graph, std::span<const BandEdge> below, std::span<const BandEdge> above,
             const OverlayFace& visit) {
    Overlay(graph, below, above).run(visit);
}

}  // namespace enfilade::modeler
