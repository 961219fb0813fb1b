#include "plans/dxf/block_costs.h"

#include <algorithm>

#include "base/error.h"
#include "plans/dxf/words.h"

namespace enfilade::plans::dxf {
namespace {

/// What a name or text adds: long ones in many copies fill memory too.
double text_cost(const std::string& text) { return static_cast<double>(text.size() / 64); }

/// The least number of strokes that an entity other than an insertion makes; texts count as one.
double own_cost(const Shape3& shape) {
    if (const auto* path = std::get_if<PathEntity>(&shape)) return 1 + static_cast<double>(path->vertices.size());
    if (const auto* spline = std::get_if<SplineEntity>(&shape))
        return 1 + static_cast<double>(spline->control.size() + spline->fit.size());
    if (const auto* text = std::get_if<TextEntity>(&shape)) return 1 + text_cost(text->text);
    if (const auto* dimension = std::get_if<DimensionEntity>(&shape)) return 1 + text_cost(dimension->text);
    if (std::holds_alternative<FaceEntity>(shape)) return 4;
    return 1;
}

class Costs {
public:
    Costs(const Contents& contents, const DrawingLimits& limits, const std::string& file)
        : contents_(contents), limits_(limits), file_(file), blocks_(contents.blocks.size()) {
        use_.used.resize(blocks_.size());
    }

    BlockUse run() {
        cost_of(contents_.model, 0);
        return std::move(use_);
    }

private:
    struct Known {
        bool open = false;
        bool done = false;
        double cost = 0;
        std::uint32_t height = 0;  ///< of insertions in it
    };

    double cost_of(const Block& block, std::uint32_t depth) {
        double sum = 0;
        for (const Entity& entity : block.entities) {
            const auto* insert = std::get_if<InsertEntity>(&entity.shape);
            sum += insert == nullptr ? own_cost(entity.shape) : insert_cost(*insert, entity.line, depth);
            if (sum > limits_.strokes)
                throw InputError("P708", file_, entity.line, 0,
                                 "The drawing asks for more than " + std::to_string(limits_.strokes) +
                                     " lines with its insertions carried out; remove what the plan does not need.");
        }
        return sum;
    }

    double insert_cost(const InsertEntity& insert, int line, std::uint32_t depth) {
        const auto place = contents_.block_index.find(insert.block);
        if (place == contents_.block_index.end()) {
            const bool listed = use_.missing.size() < 20 || use_.missing.contains(insert.name);
            use_.missing[listed ? insert.name : "and others"].add(line);
            return 0;
        }
        const Known& child = known(place->second, line, depth + 1);
        double each = 1 + child.cost + text_cost(contents_.blocks[place->second].name);
        for (const std::string& text : insert.attributes) each += 1 + text_cost(text);
        return each * static_cast<double>(insert.columns) * static_cast<double>(insert.rows);
    }

    const Known& known(std::size_t index, int line, std::uint32_t depth) {
        Known& entry = blocks_[index];
        const std::string& name = contents_.blocks[index].name;
        if (entry.open)
            throw InputError("P706", file_, line, 0,
                             "The block \"" + shortened(name) + "\" stands in itself; take that insertion out.");
        if (depth + entry.height > limits_.depth)
            throw InputError("P707", file_, line, 0,
                             "The block \"" + shortened(name) + "\" is nested deeper than " +
                                 std::to_string(limits_.depth) + " blocks; explode some of them.");
        if (entry.done) return entry;
        use_.used[index] = true;
        entry.open = true;
        entry.cost = cost_of(contents_.blocks[index], depth);
        for (const Entity& entity : contents_.blocks[index].entities)
            if (const auto* insert = std::get_if<InsertEntity>(&entity.shape))
                if (const auto place = contents_.block_index.find(insert->block); place != contents_.block_index.end())
                    entry.height = std::max(entry.height, blocks_[place->second].height + 1);
        entry.open = false;
        entry.done = true;
        return entry;
    }

    const Contents& contents_;
    const DrawingLimits& limits_;
    const std::string& file_;
    std::vector<Known> blocks_;
    BlockUse use_;
};

}  // namespace

BlockUse check_costs(const Contents& contents, const DrawingLimits& limits, const std::string& file_name) {
    return Costs(contents, limits, file_name).run();
}

}  // namespace enfilade::plans::dxf
