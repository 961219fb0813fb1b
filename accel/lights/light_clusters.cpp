#include "accel/lights/light_clusters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace enfilade::accel {
namespace {

struct Box {
    std::array<double, 3> low, high;
};

/// Lamps [first, first + count) of the order, which stand together in one cell.
struct Cluster {
    Box box;
    std::uint32_t first = 0, count = 0;
    std::uint32_t left = 0, right = 0;  ///< halves; 0 where it is one lamp
    LightId light = none<LightId>;      ///< itself, as a lamp
};

double size_of(const Box& box) {
    return std::hypot(box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2]);
}

double distance(const Box& a, const Box& b) {
    std::array<double, 3> gap;
    for (std::size_t k = 0; k < 3; ++k) gap[k] = std::max({0.0, a.low[k] - b.high[k], b.low[k] - a.high[k]});
    return std::hypot(gap[0], gap[1], gap[2]);
}

Box box_of(const SceneView& view, const Cell& cell) {
    constexpr double far = std::numeric_limits<double>::infinity();
    Box box = {{far, far, cell.z_floor}, {-far, -far, cell.z_ceiling}};
    for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s) {
        box.low[0] = std::min(box.low[0], double{view.section_x[s]});
        box.high[0] = std::max(box.high[0], double{view.section_x[s]});
        box.low[1] = std::min(box.low[1], double{view.section_y[s]});
        box.high[1] = std::max(box.high[1], double{view.section_y[s]});
    }
    return box;
}

/// Clusters of the lamps of each cell, halved down to single lamps.
class ClusterTrees {
public:
    explicit ClusterTrees(const SceneView& view) : lights_(view.lights.begin(), view.lights.end()) {
        for (std::uint32_t l = 0; l < view.lights.size(); ++l)
            if (view.lights[l].cell != none<CellId> && view.lights[l].radius == 0) order_.push_back(l);
        std::ranges::stable_sort(order_, {}, [&](std::uint32_t l) { return lights_[l].cell; });
        for (std::uint32_t begin = 0, end = 0; begin < order_.size(); begin = end) {
            while (end < order_.size() && lights_[order_[end]].cell == lights_[order_[begin]].cell) ++end;
            roots_.push_back(build(begin, end));
        }
        place_.assign(view.lights.size(), UINT32_MAX);
        for (std::uint32_t k = 0; k < order_.size(); ++k) place_[order_[k]] = k;
    }

    [[nodiscard]] const std::vector<Cluster>& clusters() const { return clusters_; }
    [[nodiscard]] const std::vector<std::uint32_t>& roots() const { return roots_; }
    /// Where the lamp stands in the order; 2^32 - 1: it stays alone.
    [[nodiscard]] std::uint32_t place(LightId light) const { return place_[index(light)]; }
    /// The scene's lights, and the clusters.
    [[nodiscard]] std::vector<Light> take_lights() { return std::move(lights_); }

private:
    std::uint32_t build(std::uint32_t begin, std::uint32_t end) {
        const auto number = static_cast<std::uint32_t>(clusters_.size());
        clusters_.push_back({});
        Cluster cluster;
        cluster.first = begin;
        cluster.count = end - begin;
        cluster.box = box_of_lamps(begin, end);
        if (cluster.count == 1) {
            cluster.light = static_cast<LightId>(order_[begin]);
        } else {
            std::size_t axis = 0;
            for (std::size_t k = 1; k < 3; ++k)
                if (cluster.box.high[k] - cluster.box.low[k] > cluster.box.high[axis] - cluster.box.low[axis]) axis = k;
            std::sort(order_.begin() + begin, order_.begin() + end, [&](std::uint32_t a, std::uint32_t b) {
                return std::pair(lights_[a].position[axis], a) < std::pair(lights_[b].position[axis], b);
            });
            cluster.light = add_light(begin, end);
            const std::uint32_t middle = begin + cluster.count / 2;
            cluster.left = build(begin, middle);
            cluster.right = build(middle, end);
        }
        clusters_[number] = cluster;
        return number;
    }

    [[nodiscard]] Box box_of_lamps(std::uint32_t begin, std::uint32_t end) const {
        Box box;
        for (std::size_t k = 0; k < 3; ++k) {
            box.low[k] = box.high[k] = double{lights_[order_[begin]].position[k]};
            for (std::uint32_t i = begin; i < end; ++i) {
                box.low[k] = std::min(box.low[k], double{lights_[order_[i]].position[k]});
                box.high[k] = std::max(box.high[k], double{lights_[order_[i]].position[k]});
            }
        }
        return box;
    }

    /// Their intensities at their mean place, weighted by these: in the cell, as it is convex.
    LightId add_light(std::uint32_t begin, std::uint32_t end) {
        std::array<double, 3> intensity = {}, position = {};
        double all = 0;
        for (std::uint32_t i = begin; i < end; ++i) {
            const Light& lamp = lights_[order_[i]];
            const double weight = double{lamp.intensity[0]} + double{lamp.intensity[1]} + double{lamp.intensity[2]};
            const double share = std::max(weight, 1e-30);
            all += share;
            for (std::size_t k = 0; k < 3; ++k) {
                intensity[k] += double{lamp.intensity[k]};
                position[k] += share * double{lamp.position[k]};
            }
        }
        Light light = lights_[order_[begin]];
        light.carrier = none<ObjectId>;
        for (std::size_t k = 0; k < 3; ++k) {
            light.intensity[k] = static_cast<float>(intensity[k]);
            light.position[k] = static_cast<float>(position[k] / all);
        }
        lights_.push_back(light);
        return static_cast<LightId>(lights_.size() - 1);
    }

    std::vector<Light> lights_;
    std::vector<std::uint32_t> order_;  ///< lamps that may stand in clusters
    std::vector<std::uint32_t> place_;
    std::vector<std::uint32_t> roots_;
    std::vector<Cluster> clusters_;
};

/// How a cell sees a lamp that it lists.
enum class Sight : std::uint8_t {
    Partly,  ///< where a beam's planes and objects let it
    Whole,   ///< from everywhere, past nothing
    Unknown  ///< a walk finds out
};

/// What a walk costs, in planes that are asked; measured outdoors, where walks are short.
constexpr std::uint32_t cost_of_walk = 16;

/// A lamp in the list of a cell, by its place in the order of clusters.
struct Listed {
    std::uint32_t place;
    std::uint32_t beam;  ///< the first one
    Sight sight;
    std::uint32_t cost;  ///< of asking whether it is seen: beams and their planes
};

/// The list of one cell.
class ListShortener {
public:
    ListShortener(const ClusterTrees& clusters, const LightTreesView& trees, double error)
        : trees_(clusters), beams_(trees), error_(error) {}

    std::vector<CellLight> shorten(std::span<const CellLight> list, const Box& cell) {
        listed_.clear();
        for (std::size_t k = 0; k < list.size(); ++k) {
            const std::uint32_t place = trees_.place(list[k].light);
            if (place == UINT32_MAX) continue;
            if (k == 0 || list[k - 1].light != list[k].light)
                listed_.push_back({place, list[k].beam, sight_of(list[k].beam), 0});
            else listed_.back().sight = Sight::Partly;
            listed_.back().cost += cost_of(list[k].beam);
        }
        std::ranges::sort(listed_, {}, &Listed::place);
        chosen_.clear();
        beams_of_chosen_.clear();
        for (const std::uint32_t root : trees_.roots()) choose(root, cell);
        std::vector<CellLight> shorter;
        for (const CellLight& entry : list)
            if (!is_in_cluster(trees_.place(entry.light))) shorter.push_back(entry);
        for (std::size_t k = 0; k < chosen_.size(); ++k)
            shorter.push_back({trees_.clusters()[chosen_[k]].light, beams_of_chosen_[k]});
        std::stable_sort(shorter.begin(), shorter.end(),
                         [](const CellLight& a, const CellLight& b) { return a.light < b.light; });
        return shorter;
    }

private:
    void choose(std::uint32_t number, const Box& cell) {
        const Cluster& cluster = trees_.clusters()[number];
        if (cluster.count < 2) return;
        const auto begin = std::ranges::lower_bound(listed_, cluster.first, {}, &Listed::place);
        const auto end = std::ranges::lower_bound(listed_, cluster.first + cluster.count, {}, &Listed::place);
        if (end - begin < 2) return;
        if (end - begin == cluster.count && size_of(cluster.box) <= error_ * distance(cluster.box, cell)) {
            const bool is_whole = are_seen_whole({begin, end});
            if (is_whole || is_walk_cheaper({begin, end})) {
                chosen_.push_back(number);  // by ascending place: halves are asked in order
                beams_of_chosen_.push_back(is_whole ? begin->beam : no_beam);
                return;
            }
        }
        choose(cluster.left, cell);
        choose(cluster.right, cell);
    }

    [[nodiscard]] Sight sight_of(std::uint32_t beam) const {
        if (beam == no_beam) return Sight::Unknown;
        const bool is_past_objects = beams_.beam_object_lists.size() != 0 && beams_.objects_of(beam).count != 0;
        return beams_.beams[beam].plane_count == 0 && !is_past_objects ? Sight::Whole : Sight::Partly;
    }

    [[nodiscard]] std::uint32_t cost_of(std::uint32_t beam) const {
        return beam == no_beam ? cost_of_walk : 1 + beams_.beams[beam].plane_count;
    }

    /// Whether one of them can stand for all: a beam that holds all of the cell does so for any lamp.
    [[nodiscard]] bool are_seen_whole(std::span<const Listed> lamps) const {
        return std::ranges::all_of(lamps, [&](const Listed& lamp) {
            return lamp.sight == Sight::Whole && beams_.beams[lamp.beam].tint == beams_.beams[lamps.front().beam].tint;
        });
    }

    [[nodiscard]] static bool is_walk_cheaper(std::span<const Listed> lamps) {
        std::uint64_t cost = 0;
        for (const Listed& lamp : lamps) cost += lamp.cost;
        return cost > cost_of_walk;
    }

    [[nodiscard]] bool is_in_cluster(std::uint32_t place) const {
        if (place == UINT32_MAX) return false;
        const auto after =
            std::ranges::upper_bound(chosen_, place, {}, [&](std::uint32_t c) { return trees_.clusters()[c].first; });
        if (after == chosen_.begin()) return false;
        const Cluster& cluster = trees_.clusters()[*std::prev(after)];
        return place < cluster.first + cluster.count;
    }

    const ClusterTrees& trees_;
    const LightTreesView& beams_;
    double error_;
    std::vector<Listed> listed_;
    std::vector<std::uint32_t> chosen_;
    std::vector<std::uint32_t> beams_of_chosen_;  ///< [chosen]
};

}  // namespace

LightTreesView LightClusters::lists(LightTreesView trees) const {
    trees.cell_offsets = {cell_offsets_.data(), cell_offsets_.size()};
    trees.cell_lights = {cell_lights_.data(), cell_lights_.size()};
    return trees;
}

std::size_t LightClusters::bytes() const {
    return lights_.size() * sizeof lights_[0] + cell_offsets_.size() * sizeof cell_offsets_[0] +
           cell_lights_.size() * sizeof cell_lights_[0];
}

LightClusters cluster_lights(const SceneView& view, const LightTreesView& trees, const LightClusterOptions& options,
                             const Executor& executor) {
    ClusterTrees clusters(view);
    std::vector<std::vector<CellLight>> lists(view.cells.size());
    parallel_for(executor, lists.size(), 64, [&](std::size_t begin, std::size_t end) {
        ListShortener shortener(clusters, trees, options.error);
        for (std::size_t c = begin; c < end; ++c) {
            const std::uint32_t first = trees.cell_offsets[c];
            const std::span<const CellLight> list = {trees.cell_lights.first + first,
                                                     trees.cell_offsets[c + 1] - first};
            if (!list.empty()) lists[c] = shortener.shorten(list, box_of(view, view.cells[c]));
        }
    });
    LightClusters all;
    all.lamp_count_ = view.lights.size();
    all.lights_ = clusters.take_lights();
    all.cell_offsets_.push_back(0);
    for (const std::vector<CellLight>& list : lists) {
        all.cell_lights_.insert(all.cell_lights_.end(), list.begin(), list.end());
        all.cell_offsets_.push_back(static_cast<std::uint32_t>(all.cell_lights_.size()));
    }
    std::vector<bool> is_listed(all.lights_.size());
    for (const CellLight& entry : all.cell_lights_) is_listed[index(entry.light)] = true;
    all.listed_count_ = static_cast<std::size_t>(
        std::count(is_listed.begin() + std::ptrdiff_t(all.lamp_count_), is_listed.end(), true));
    return all;
}

}  // namespace enfilade::accel
