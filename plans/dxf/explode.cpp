#include "plans/dxf/explode.h"

#include <cmath>

#include "base/error.h"
#include "plans/dxf/block_costs.h"
#include "plans/dxf/drawing_findings.h"
#include "plans/dxf/flat_shapes.h"
#include "plans/dxf/stroke_box.h"

namespace enfilade::plans::dxf {
namespace {

class Explosion {
public:
    Explosion(const Contents& contents, const DrawingLimits& limits, const std::string& file, Drawing& drawing)
        : contents_(contents), limits_(limits), file_(file), drawing_(drawing), shapes_(drawing, contents) {}

    void run() { block(contents_.model, {}); }

    [[nodiscard]] const FlatShapes& shapes() const { return shapes_; }

private:
    void block(const Block& block, const Placement& placement) {
        for (const Entity& entity : block.entities) {
            if (const auto* insert = std::get_if<InsertEntity>(&entity.shape)) insertions(*insert, entity, placement);
            else shapes_.add(entity, placement);
            const std::size_t made = drawing_.strokes.size() + drawing_.texts.size() + drawing_.insertions.size();
            if (made > limits_.strokes)
                throw InputError("P708", file_, entity.line, 0,
                                 "The drawing asks for more than " + std::to_string(limits_.strokes) +
                                     " lines with its insertions carried out; remove what the plan does not need.");
        }
    }

    void insertions(const InsertEntity& insert, const Entity& entity, const Placement& placement) {
        const auto place = contents_.block_index.find(insert.block);
        if (place == contents_.block_index.end()) return;
        const Block& inner = contents_.blocks[place->second];
        const double c = std::cos(insert.angle);
        const double s = std::sin(insert.angle);
        // Base point to the origin, scale, turn; the steps of an array are turned too, but not scaled.
        const Transform turned = {{c, s, 0}, {-s, c, 0}, {0, 0, 1}, insert.at};
        const Transform plane = placement.map * entity_frame(entity.normal) * turned;
        const Transform scaled = {{insert.scale.x, 0, 0}, {0, insert.scale.y, 0}, {0, 0, insert.scale.z}, {}};
        const Transform from_base = scaled * Transform{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, inner.base * -1};
        for (std::int64_t row = 0; row < insert.rows; ++row)
            for (std::int64_t column = 0; column < insert.columns; ++column) {
                const P3 step = {static_cast<double>(column) * insert.column_step,
                                 static_cast<double>(row) * insert.row_step, 0};
                const Transform cell = plane * Transform{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, step};
                insertion(insert, inner, entity, placement, cell * from_base, flat((cell * scaled).origin));
            }
    }

    void insertion(const InsertEntity& insert, const Block& inner, const Entity& entity, const Placement& placement,
                   const Transform& map, Point at) {
        if (!shapes_.within_bounds(at) || !shapes_.within_bounds(flat(map.x)) || !shapes_.within_bounds(flat(map.y)))
            return shapes_.broken.add(entity.line);
        const auto index = static_cast<std::uint32_t>(drawing_.insertions.size());
        const std::uint32_t layer = shapes_.layer_of(entity, placement);
        drawing_.insertions.push_back(
            {inner.name, layer, placement.insertion, at, flat(map.x), flat(map.y), insert.attributes});
        block(inner, {map, layer, index, placement.frozen || contents_.layers[layer].frozen});
    }

    const Contents& contents_;
    const DrawingLimits& limits_;
    const std::string& file_;
    Drawing& drawing_;
    FlatShapes shapes_;
};

}  // namespace

Drawing explode(const Contents& contents, const DrawingLimits& limits, const std::string& file_name) {
    const BlockUse use = check_costs(contents, limits, file_name);
    Drawing drawing;
    for (const LayerEntry& layer : contents.layers)
        drawing.layers.push_back({layer.name, !layer.frozen && !layer.off, 0, 0});
    drawing.declared_unit = contents.unit;
    drawing.linear_format = contents.linear_format;
    drawing.metric = contents.metric;
    Explosion explosion(contents, limits, file_name, drawing);
    explosion.run();
    drawing.bounds = bounds_of(drawing.strokes);
    add_findings(drawing, contents, use, explosion.shapes());
    return drawing;
}

}  // namespace enfilade::plans::dxf
