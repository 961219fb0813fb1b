#include "plans/dxf/events.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace enfilade::plans::dxf {
namespace {

double radians(double degrees) { return degrees * (std::numbers::pi / 180); }

P3 direction_of(const DL_Extrusion& extrusion) {
    double d[3];
    extrusion.getDirection(d);
    return {d[0], d[1], d[2]};
}

std::optional<Unit> unit_of_code(int code) {
    switch (code) {
        case 1:
        case 22: return Unit::Inch;  // 21 to 24: those of the US survey, 2 millionths longer
        case 2:
        case 21: return Unit::Foot;
        case 3:
        case 24: return Unit::Mile;
        case 4: return Unit::Millimetre;
        case 5: return Unit::Centimetre;
        case 6: return Unit::Metre;
        case 7: return Unit::Kilometre;
        case 10:
        case 23: return Unit::Yard;
        case 14: return Unit::Decimetre;
        default: return std::nullopt;
    }
}

}  // namespace

/// Takes one from what is left, and one more for each 64 bytes of text.
bool Events::spend(std::size_t text_bytes) {
    const std::size_t cost = 1 + text_bytes / 64;
    if (full_line_ == 0 && cost > left_) full_line_ = source_.line();
    if (full_line_ == 0) left_ -= cost;
    return full_line_ == 0;
}

Block& Events::block() {
    if (refusing_) return refused_;
    return block_ == SIZE_MAX ? contents_.model : contents_.blocks[block_];
}

/// What takes more parts, if there is room for one.
Shape3* Events::last() {
    return open_ && spend() && !block().entities.empty() ? &block().entities.back().shape : nullptr;
}

void Events::add(Shape3 shape) {
    open_ = spend();
    if (!open_) return;
    block().entities.push_back(
        {std::move(shape), layer_of(attributes.getLayer()), source_.line(), direction_of(*extrusion)});
}

/// Names ignore case; layers that no table lists are added as they come.
std::uint32_t Events::layer_of(const std::string& raw_name) {
    if (last_layer_index_ != UINT32_MAX && raw_name == last_layer_) return last_layer_index_;
    if (!spend(raw_name.size())) return 0;
    const std::string name = raw_name.empty() ? "0" : words_.utf8(raw_name);
    const auto next = static_cast<std::uint32_t>(contents_.layers.size());
    const auto [place, is_new] = contents_.layer_index.try_emplace(folded(name), next);
    if (is_new) contents_.layers.push_back({name, false, false});
    last_layer_ = raw_name;
    last_layer_index_ = place->second;
    return place->second;
}

void Events::setVariableString(const std::string& key, const std::string& value, int /*code*/) {
    if (key == "$ACADVER") words_.set_version(value);
    else if (key == "$DWGCODEPAGE" && !words_.set_code_page(value)) contents_.code_page = words_.utf8(value);
}

void Events::setVariableInt(const std::string& key, int value, int /*code*/) {
    if (key == "$INSUNITS") {
        contents_.unit_code = value;
        contents_.unit = unit_of_code(value);
    } else if (key == "$LUNITS") {
        contents_.linear_format = value;
    } else if (key == "$MEASUREMENT") {
        contents_.metric = value != 0;
    }
}

void Events::addLayer(const DL_LayerData& data) {
    const std::uint32_t index = layer_of(data.name);
    if (full_line_ != 0) return;
    contents_.layers[index].frozen = (data.flags & 1) != 0;
    contents_.layers[index].off = data.off || attributes.getColor() < 0;
}

void Events::addBlock(const DL_BlockData& data) {
    open_ = false;
    if (!spend(data.name.size())) return;
    std::string key = folded(data.name);
    const auto [place, is_new] = contents_.block_index.try_emplace(key, contents_.blocks.size());
    refusing_ = !is_new;
    if (refusing_) return;
    block_ = place->second;
    contents_.blocks.push_back({words_.utf8(data.name), std::move(key), {data.bpx, data.bpy, data.bpz}, {}});
}

void Events::endBlock() {
    open_ = false;
    refusing_ = false;
    refused_.entities.clear();
    block_ = SIZE_MAX;
}

void Events::addLine(const DL_LineData& data) {
    add(LineEntity{{data.x1, data.y1, data.z1}, {data.x2, data.y2, data.z2}});
}

void Events::addArc(const DL_ArcData& data) {
    add(ArcEntity{{data.cx, data.cy, data.cz}, data.radius, radians(data.angle1), radians(data.angle2), false});
}

void Events::addCircle(const DL_CircleData& data) {
    add(ArcEntity{{data.cx, data.cy, data.cz}, data.radius, 0, 2 * std::numbers::pi, true});
}

void Events::addEllipse(const DL_EllipseData& data) {
    add(EllipseEntity{{data.cx, data.cy, data.cz}, {data.mx, data.my, data.mz}, data.ratio, data.angle1, data.angle2});
}

/// Both kinds; in the plane of a polyline all vertices have its elevation.
void Events::addPolyline(const DL_PolylineData& data) {
    PathEntity path;
    path.closed = (data.flags & 1) != 0;
    path.in_space = (data.flags & 8) != 0;
    path.elevation = extrusion->getElevation();
    add(std::move(path));
}

void Events::addVertex(const DL_VertexData& data) {
    Shape3* const shape = last();
    if (shape == nullptr) return;
    auto* const path = std::get_if<PathEntity>(shape);
    if (path == nullptr) return;
    path->vertices.push_back({{data.x, data.y, path->in_space ? data.z : path->elevation}, data.bulge});
}

void Events::addSpline(const DL_SplineData& data) {
    SplineEntity spline;
    spline.degree = data.degree;
    spline.closed = (data.flags & 1) != 0;
    spline.start_tangent = {data.tangentStartX, data.tangentStartY, data.tangentStartZ};
    spline.end_tangent = {data.tangentEndX, data.tangentEndY, data.tangentEndZ};
    add(std::move(spline));
}

void Events::addControlPoint(const DL_ControlPointData& data) {
    Shape3* const shape = last();
    if (shape == nullptr) return;
    if (auto* const spline = std::get_if<SplineEntity>(shape)) {
        spline->control.push_back({data.x, data.y, data.z});
        spline->weights.push_back(data.w);
    }
}

void Events::addFitPoint(const DL_FitPointData& data) {
    Shape3* const shape = last();
    if (shape == nullptr) return;
    if (auto* const spline = std::get_if<SplineEntity>(shape)) spline->fit.push_back({data.x, data.y, data.z});
}

void Events::addKnot(const DL_KnotData& data) {
    Shape3* const shape = last();
    if (shape == nullptr) return;
    if (auto* const spline = std::get_if<SplineEntity>(shape)) spline->knots.push_back(data.k);
}

void Events::addInsert(const DL_InsertData& data) {
    InsertEntity insert;
    insert.block = folded(data.name);
    insert.name = words_.utf8(data.name);
    insert.at = {data.ipx, data.ipy, data.ipz};
    insert.scale = {data.sx, data.sy, data.sz};
    insert.angle = radians(data.angle);
    insert.columns = std::max(1, data.cols);
    insert.rows = std::max(1, data.rows);
    insert.column_step = data.colSp;
    insert.row_step = data.rowSp;
    add(std::move(insert));
}

/// The texts of an insertion follow it, up to the end of the sequence.
void Events::addAttribute(const DL_AttributeData& data) {
    Shape3* const shape = last();
    if (shape == nullptr) return;
    if (auto* const insert = std::get_if<InsertEntity>(shape); insert != nullptr && spend(data.text.size()))
        insert->attributes.push_back(plain_text(words_.utf8(data.text)));
}

void Events::endSequence() { open_ = false; }

void Events::add_face(const DL_TraceData& data, bool in_space) {
    FaceEntity face;
    for (std::size_t k = 0; k < 4; ++k) face.corners[k] = {data.x[k], data.y[k], data.z[k]};
    face.in_space = in_space;
    add(face);
}

void Events::addSolid(const DL_SolidData& data) { add_face(data, false); }
void Events::addTrace(const DL_TraceData& data) { add_face(data, false); }
void Events::add3dFace(const DL_3dFaceData& data) { add_face(data, true); }

/// Justified texts stand at their second point; the first is where their letters begin. dxflib gives NaN for what the
/// second one lacks.
void Events::addText(const DL_TextData& data) {
    const bool spread = data.hJustification == 3 || data.hJustification == 5;
    const bool justified = (data.hJustification != 0 || data.vJustification != 0) && !spread;
    const bool moved = justified && std::isfinite(data.apx) && std::isfinite(data.apy);
    const P3 first = {data.ipx, data.ipy, data.ipz};
    const P3 second = {data.apx, data.apy, std::isfinite(data.apz) ? data.apz : 0};
    add(TextEntity{plain_text(words_.utf8(data.text)), moved ? second : first, data.height, false});
}

void Events::addMTextChunk(const std::string& text) { chunks_ += text; }

void Events::addMText(const DL_MTextData& data) {
    const std::string whole = std::exchange(chunks_, {}) + data.text;
    add(TextEntity{plain_mtext(words_.utf8(whole)), {data.ipx, data.ipy, data.ipz}, data.height, true});
}

/// What was typed; nothing where the program writes the length itself.
std::string Events::dimension_text(const std::string& raw) {
    std::string text = plain_mtext(words_.utf8(raw));
    return text == "<>" ? std::string() : text;
}

/// `style` is the name of the block that draws it (record_source.cpp).
void Events::addDimAlign(const DL_DimensionData& data, const DL_DimAlignedData& points) {
    add(DimensionEntity{{points.epx1, points.epy1, points.epz1},
                        {points.epx2, points.epy2, points.epz2},
                        {},
                        dimension_text(data.text),
                        folded(data.style)});
}

void Events::addDimLinear(const DL_DimensionData& data, const DL_DimLinearData& points) {
    const double angle = radians(points.angle);
    add(DimensionEntity{{points.dpx1, points.dpy1, points.dpz1},
                        {points.dpx2, points.dpy2, points.dpz2},
                        {std::cos(angle), std::sin(angle), 0},
                        dimension_text(data.text),
                        folded(data.style)});
}

}  // namespace enfilade::plans::dxf
