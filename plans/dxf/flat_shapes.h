#pragma once
// Entities brought into the plane of the drawing, one at a time.

#include "plans/dxf/drawing.h"
#include "plans/dxf/entities.h"

namespace enfilade::plans::dxf {

/// Where an entity stands: the block around it in the drawing's space, and what it takes from its insertion.
struct Placement {
    Transform map;
    std::uint32_t layer = UINT32_MAX;  ///< of the insertion, for what stands on "0"; none in model space
    std::uint32_t insertion = UINT32_MAX;
    bool frozen = false;  ///< an insertion around it stands on a frozen layer
};

/// Adds shapes, texts and dimensions to a drawing. What has no extent or leaves the bounds of numbers is counted in
/// `broken` instead, what is not level at 0 in `raised`.
class FlatShapes {
public:
    FlatShapes(Drawing& drawing, const Contents& contents);

    /// \pre no insertion
    void add(const Entity& entity, const Placement& placement);
    [[nodiscard]] std::uint32_t layer_of(const Entity& entity, const Placement& placement) const;
    [[nodiscard]] bool within_bounds(Point p) const;

    Tally broken;
    Tally raised;

private:
    void begin(ShapeKind kind, const Entity& entity, const Placement& placement);
    void end(const Entity& entity);
    void stroke(Point a, Point b, double bulge);
    Point seen(const Transform& map, P3 p);
    void chain(const std::vector<Point>& points);

    void line(const LineEntity& line, const Transform& map);
    void path(const PathEntity& path, const Transform& map);
    void round(Point centre, Point u, Point v, double start, double sweep);
    void face(const FaceEntity& face, const Transform& map);
    void text(const TextEntity& text, const Entity& entity, const Placement& placement, const Transform& map);
    void dimension(const DimensionEntity& dimension, const Entity& entity, const Placement& placement);
    [[nodiscard]] std::string written(const DimensionEntity& dimension) const;

    Drawing& drawing_;
    const Contents& contents_;
    std::uint32_t zero_layer_ = UINT32_MAX;  ///< the one called "0"
    Shape shape_;
    bool is_raised_ = false;
};

}  // namespace enfilade::plans::dxf
