#include "gmap/dangling.h"

#include <algorithm>
#include <map>
#include <set>

#include "gmap/orbit.h"

namespace enfilade::gmap::detail {

namespace {

/// The lowest dart of each cell among those given.
std::map<std::uint32_t, std::uint32_t> first_darts(const Map& map, std::size_t dimension,
                                                   std::span<const std::uint32_t> darts) {
    std::map<std::uint32_t, std::uint32_t> result;
    for (const std::uint32_t d : darts) {
        const auto [at, is_new] = result.try_emplace(map.arrays().cell_id[dimension][d], d);
        if (!is_new) at->second = std::min(at->second, d);
    }
    return result;
}

/// Takes suspects off one after another as long as one is alone at a support: an edge for faces, an end for edges.
/// Cells that are no suspects hold their supports for good.
class Pruning {
public:
    /// `cells` meet at one support.
    void add_support(const std::set<std::uint32_t>& cells) {
        for (const std::uint32_t cell : cells) supports_of_[cell].push_back(supports_.size());
        supports_.push_back(cells);
    }

    std::set<std::uint32_t> run(const std::map<std::uint32_t, std::uint32_t>& suspects) {
        std::vector<std::size_t> queue(supports_.size());
        for (std::size_t i = 0; i < queue.size(); ++i) queue[i] = i;
        std::set<std::uint32_t> dangling;
        while (!queue.empty()) {
            const std::set<std::uint32_t>& cells = supports_[queue.back()];
            queue.pop_back();
            if (cells.size() != 1 || !suspects.contains(*cells.begin())) continue;
            const std::uint32_t cell = *cells.begin();
            dangling.insert(cell);
            for (const std::size_t support : supports_of_[cell]) {
                supports_[support].erase(cell);
                queue.push_back(support);
            }
        }
        return dangling;
    }

private:
    std::vector<std::set<std::uint32_t>> supports_;
    std::map<std::uint32_t, std::vector<std::size_t>> supports_of_;
};

std::vector<SelfNeighbour> listed(const std::map<std::uint32_t, std::uint32_t>& suspects,
                                  const std::set<std::uint32_t>& dangling) {
    std::vector<SelfNeighbour> result;
    for (const auto& [cell_id, dart] : suspects) result.push_back({cell_id, dart, dangling.contains(cell_id)});
    return result;
}

}  // namespace

std::vector<SelfNeighbour> judge_faces(const Map& map, std::span<const std::uint32_t> one_volume_darts) {
    const auto suspects = first_darts(map, 2, one_volume_darts);
    Pruning pruning;
    std::set<EdgeId> done;
    for (const std::uint32_t d : one_volume_darts) {
        if (!done.insert(map.edge(DartId{d})).second) continue;
        std::set<std::uint32_t> faces;
        for (const DartId x : cell<1>(map, DartId{d})) faces.insert(static_cast<std::uint32_t>(map.face(x)));
        pruning.add_support(faces);
    }
    return listed(suspects, pruning.run(suspects));
}

std::vector<SelfNeighbour> judge_edges(const Map& map, std::span<const std::uint32_t> one_face_darts) {
    const auto suspects = first_darts(map, 1, one_face_darts);
    Pruning pruning;
    std::set<DartId> done;
    for (const std::uint32_t d : one_face_darts) {
        if (done.contains(DartId{d})) continue;
        std::set<std::uint32_t> edges;
        for (const DartId x : cell_in_volume<0>(map, DartId{d})) {
            done.insert(x);
            edges.insert(static_cast<std::uint32_t>(map.edge(x)));
        }
        pruning.add_support(edges);
    }
    return listed(suspects, pruning.run(suspects));
}

}  // namespace enfilade::gmap::detail
