#include "modeler/exports/indoor_gml.h"

#include <algorithm>
#include <cmath>

#include "modeler/exports/space_solid.h"
#include "modeler/exports/xml_text.h"
#include "plans/number_text.h"

namespace enfilade::modeler {

namespace {

using plans::number_text;
using Point3 = std::array<double, 3>;

constexpr double most_step = 0.5;    ///< metres: holes in walls that begin higher are no way through
constexpr double eye_height = 1.25;  ///< metres over the floor: where States lie

struct Cell {
    std::size_t solid = 0;  ///< into SpaceSolids::solids
    bool is_anchor = false;
    Point3 state = {};
    std::vector<std::size_t> boundaries;   ///< numbers
    std::vector<std::size_t> transitions;  ///< numbers
};

/// A face in which two cells touch, or in which an anchor touches the exterior.
struct Boundary {
    const SolidFace* face = nullptr;
    std::size_t cell = 0;
    std::size_t other = SIZE_MAX;  ///< none: the exterior
    std::size_t transition = SIZE_MAX;
    Point3 middle = {};
};

double distance(const Point3& a, const Point3& b) { return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]); }

class Writer {
public:
    Writer(const Building& building, IndoorGmlVersion version, const std::string& srs_name)
        : building_(building),
          version_(version),
          srs_name_(srs_name.empty() ? "urn:x-enfilade:crs:local-metres" : srs_name),
          solids_(space_solids(building, {Label::Room, Label::Stair, Label::Shaft, Label::Door, Label::Opening})) {
        find_cells();
        find_boundaries();
    }

    std::string write() {
        write_head();
        text_ += "  <core:primalSpaceFeatures>\n    <core:PrimalSpaceFeatures gml:id=\"PS\">\n";
        for (std::size_t c = 0; c < cells_.size(); ++c) write_cell(c);
        for (std::size_t b = 0; b < boundaries_.size(); ++b) write_boundary(b);
        text_ += "    </core:PrimalSpaceFeatures>\n  </core:primalSpaceFeatures>\n";
        if (!cells_.empty()) write_graph();
        return std::move(text_ += "</core:IndoorFeatures>\n");
    }

private:
    const SpacePart& part_of(std::size_t solid) const { return solids_.parts[solids_.solids[solid].part]; }
    const Space& space_of(const Cell& cell) const { return building_.spaces[part_of(cell.solid).space]; }

    bool is_way(const SpacePart& part) const {
        const Space& space = building_.spaces[part.space];
        if (space.label != Label::Door && space.label != Label::Opening) return true;
        if (space.storey >= building_.storeys.size()) return true;
        return (part.z_low - building_.storeys[space.storey].z_floor) * building_.frame.unit <= most_step;
    }

    void find_cells() {
        cell_of_part_.assign(solids_.parts.size(), SIZE_MAX);
        for (std::size_t k = 0; k < solids_.solids.size(); ++k) {
            const SpacePart& part = part_of(k);
            if (!is_way(part)) continue;
            cell_of_part_[solids_.solids[k].part] = cells_.size();
            Cell cell{k, false, {}, {}, {}};
            const auto [x, y] = label_point(building_, part);
            const double height = (part.z_high - part.z_low) * building_.frame.unit;
            cell.state = {x, y, building_.frame.world_z(part.z_low) + std::min(eye_height, height / 2)};
            cells_.push_back(std::move(cell));
        }
    }

    bool is_outside(const SolidFace& face) const {
        return face.kind == SolidFaceKind::Side && face.behind != SolidFace::solid &&
               building_.spaces[face.behind].label == Label::Exterior;
    }

    void find_boundaries() {
        for (std::size_t c = 0; c < cells_.size(); ++c)
            for (const SolidFace& face : solids_.solids[cells_[c].solid].faces) {
                Boundary boundary{&face, c, SIZE_MAX, SIZE_MAX, middle_of(face, c)};
                if (!is_outside(face)) {
                    if (face.behind_part == SolidFace::no_part) continue;
                    boundary.other = cell_of_part_[face.behind_part];
                    if (boundary.other == SIZE_MAX || boundary.other < c) continue;
                    boundary.transition = transitions_++;
                    cells_[boundary.other].boundaries.push_back(boundaries_.size());
                    for (const std::size_t end : {c, boundary.other})
                        cells_[end].transitions.push_back(boundary.transition);
                } else {
                    cells_[c].is_anchor = true;
                }
                cells_[c].boundaries.push_back(boundaries_.size());
                boundaries_.push_back(boundary);
            }
    }

    Point3 world(std::uint32_t vertex) const {
        const auto& v = solids_.vertices[vertex];
        return {building_.frame.world_x(v[0]), building_.frame.world_y(v[1]), building_.frame.world_z(v[2])};
    }

    /// Where one passes a face: over the middle of its foot, or, through a floor, at the middle of the hole.
    Point3 middle_of(const SolidFace& face, std::size_t cell) const {
        Point3 low = world(face.outer[0]);
        Point3 high = low;
        for (const std::uint32_t vertex : face.outer)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                low[axis] = std::min(low[axis], world(vertex)[axis]);
                high[axis] = std::max(high[axis], world(vertex)[axis]);
            }
        if (face.kind == SolidFaceKind::Side)
            return {(low[0] + high[0]) / 2, (low[1] + high[1]) / 2,
                    low[2] + std::min(eye_height, (high[2] - low[2]) / 2)};
        const SpacePart* hole = &part_of(cells_[cell].solid);
        if (face.behind_part != SolidFace::no_part) {
            const SpacePart& other = solids_.parts[face.behind_part];
            if (area_m2(building_, other) < area_m2(building_, *hole)) hole = &other;
        }
        const auto [x, y] = label_point(building_, *hole);
        return {x, y, low[2]};
    }

    static std::string cell_id(std::size_t c) { return "C" + std::to_string(c + 1); }
    static std::string state_id(std::size_t c) { return "S" + std::to_string(c + 1); }
    static std::string boundary_id(std::size_t b) { return "B" + std::to_string(b + 1); }
    static std::string transition_id(std::size_t t) { return "T" + std::to_string(t + 1); }

    static std::string pos(const Point3& p) {
        return number_text(p[0]) + ' ' + number_text(p[1]) + ' ' + number_text(p[2]);
    }
    std::string srs() const { return " srsName=\"" + xml_text(srs_name_) + "\" srsDimension=\"3\""; }
    void line(int depth, const std::string& text) { text_ += std::string(std::size_t(2 * depth), ' ') + text + '\n'; }
    void link(int depth, const std::string& element, const std::string& id) {
        line(depth, '<' + element + " xlink:href=\"#" + id + "\"/>");
    }

    void write_head() {
        const std::string version = version_ == IndoorGmlVersion::V1_0 ? "1.0" : "1.1";
        const std::string space = "http://www.opengis.net/indoorgml/" + version;
        const std::string schema = "http://schemas.opengis.net/indoorgml/" + version;
        text_ += "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<core:IndoorFeatures gml:id=\"IF\"\n    xmlns:core=\"" +
                 space + "/core\"\n    xmlns:navi=\"" + space +
                 "/navigation\"\n    xmlns:gml=\"http://www.opengis.net/gml/3.2\"\n"
                 "    xmlns:xlink=\"http://www.w3.org/1999/xlink\"\n"
                 "    xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\"\n    xsi:schemaLocation=\"" +
                 space + "/core " + schema + "/indoorgmlcore.xsd " + space + "/navigation " + schema +
                 "/indoorgmlnavi.xsd\">\n";
        if (!building_.name.empty()) line(1, "<gml:name>" + xml_text(building_.name) + "</gml:name>");
        if (solids_.vertices.empty()) return;
        Point3 low = world(0);
        Point3 high = low;
        for (std::uint32_t v = 0; v < solids_.vertices.size(); ++v)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                low[axis] = std::min(low[axis], world(v)[axis]);
                high[axis] = std::max(high[axis], world(v)[axis]);
            }
        text_ += "  <gml:boundedBy>\n    <gml:Envelope" + srs() + ">\n      <gml:lowerCorner>" + pos(low) +
                 "</gml:lowerCorner>\n      <gml:upperCorner>" + pos(high) +
                 "</gml:upperCorner>\n    </gml:Envelope>\n  </gml:boundedBy>\n";
    }

    static const char* cell_type(Label label, bool is_anchor) {
        if (label == Label::Stair || label == Label::Shaft) return "navi:TransitionSpace";
        if (label == Label::Room) return "navi:GeneralSpace";
        return is_anchor ? "navi:AnchorSpace" : "navi:ConnectionSpace";
    }

    void write_polygon(int depth, const SolidFace& face, const std::string& id) {
        line(depth, "<gml:Polygon gml:id=\"" + id + "\">");
        const auto ring = [&](const char* role, const std::vector<std::uint32_t>& corners) {
            std::string list;
            for (std::size_t k = 0; k <= corners.size(); ++k)
                list += (k == 0 ? "" : " ") + pos(world(corners[k % corners.size()]));
            line(depth + 1, std::string("<gml:") + role + "><gml:LinearRing><gml:posList>" + list +
                                "</gml:posList></gml:LinearRing></gml:" + role + '>');
        };
        ring("exterior", face.outer);
        for (const auto& hole : face.holes) ring("interior", hole);
        line(depth, "</gml:Polygon>");
    }

    void write_cell(std::size_t c) {
        const Cell& cell = cells_[c];
        const Space& space = space_of(cell);
        const std::string type = cell_type(space.label, cell.is_anchor);
        line(3, "<core:cellSpaceMember>");
        line(4, '<' + type + " gml:id=\"" + cell_id(c) + "\">");
        if (space.storey < building_.storeys.size()) {
            const StoreyInfo& storey = building_.storeys[space.storey];
            line(5, "<gml:description>storey " + xml_text(storey.name.empty() ? storey.id : storey.name) +
                        "</gml:description>");
        }
        line(5, "<gml:name>" + xml_text(space.name.empty() ? space.id : space.name) + "</gml:name>");
        line(5, "<core:cellSpaceGeometry>");
        line(6, "<core:Geometry3D>");
        line(7, "<gml:Solid gml:id=\"" + cell_id(c) + "-solid\"" + srs() + '>');
        line(8, "<gml:exterior>");
        line(9, "<gml:Shell>");
        std::size_t number = 0;
        for (const SolidFace& face : solids_.solids[cell.solid].faces) {
            line(10, "<gml:surfaceMember>");
            write_polygon(11, face, cell_id(c) + "-face" + std::to_string(++number));
            line(10, "</gml:surfaceMember>");
        }
        line(9, "</gml:Shell>");
        line(8, "</gml:exterior>");
        line(7, "</gml:Solid>");
        line(6, "</core:Geometry3D>");
        line(5, "</core:cellSpaceGeometry>");
        link(5, "core:duality", state_id(c));
        line(5,
             "<core:externalReference><core:informationSystem>urn:x-enfilade:plan</core:informationSystem>"
             "<core:externalObject><core:name>" +
                 xml_text(space.id) + "</core:name></core:externalObject></core:externalReference>");
        for (const std::size_t b : cell.boundaries) link(5, "core:partialboundedBy", boundary_id(b));
        const std::string function = space.kind.empty() ? accel::name_of(space.label) : xml_text(space.kind);
        line(5, std::string("<navi:class>") + accel::name_of(space.label) + "</navi:class>");
        line(5, "<navi:function>" + function + "</navi:function>");
        line(5, "<navi:usage>" + function + "</navi:usage>");
        line(4, "</" + type + '>');
        line(3, "</core:cellSpaceMember>");
    }

    void write_boundary(std::size_t b) {
        const Boundary& boundary = boundaries_[b];
        const std::string type = boundary.other == SIZE_MAX ? "navi:AnchorBoundary" : "navi:ConnectionBoundary";
        line(3, "<core:cellSpaceBoundaryMember>");
        line(4, '<' + type + " gml:id=\"" + boundary_id(b) + "\">");
        if (boundary.transition != SIZE_MAX) link(5, "core:duality", transition_id(boundary.transition));
        line(5, "<core:cellSpaceBoundaryGeometry>");
        line(6, "<core:geometry3D>");
        write_polygon(7, *boundary.face, boundary_id(b) + "-face");
        line(6, "</core:geometry3D>");
        line(5, "</core:cellSpaceBoundaryGeometry>");
        line(4, "</" + type + '>');
        line(3, "</core:cellSpaceBoundaryMember>");
    }

    void write_graph() {
        line(1, "<core:multiLayeredGraph>");
        line(2, "<core:MultiLayeredGraph gml:id=\"MG\">");
        line(3, "<core:spaceLayers gml:id=\"SLS\">");
        line(4, "<core:spaceLayerMember>");
        line(5, "<core:SpaceLayer gml:id=\"SL\">");
        line(6, "<core:class>TOPOGRAPHIC</core:class>");
        line(6, "<core:nodes gml:id=\"N\">");
        for (std::size_t c = 0; c < cells_.size(); ++c) write_state(c);
        line(6, "</core:nodes>");
        if (transitions_ > 0) {
            line(6, "<core:edges gml:id=\"E\">");
            for (const Boundary& boundary : boundaries_)
                if (boundary.transition != SIZE_MAX) write_transition(boundary);
            line(6, "</core:edges>");
        }
        line(5, "</core:SpaceLayer>");
        line(4, "</core:spaceLayerMember>");
        line(3, "</core:spaceLayers>");
        line(2, "</core:MultiLayeredGraph>");
        line(1, "</core:multiLayeredGraph>");
    }

    void write_state(std::size_t c) {
        const std::string id = state_id(c);
        line(7, "<core:stateMember>");
        line(8, "<core:State gml:id=\"" + id + "\">");
        link(9, "core:duality", cell_id(c));
        for (const std::size_t t : cells_[c].transitions) link(9, "core:connects", transition_id(t));
        line(9, "<core:geometry>");
        line(10, "<gml:Point gml:id=\"" + id + "-point\"" + srs() + "><gml:pos>" + pos(cells_[c].state) +
                     "</gml:pos></gml:Point>");
        line(9, "</core:geometry>");
        line(8, "</core:State>");
        line(7, "</core:stateMember>");
    }

    void write_transition(const Boundary& boundary) {
        const std::string id = transition_id(boundary.transition);
        const Point3& from = cells_[boundary.cell].state;
        const Point3& to = cells_[boundary.other].state;
        line(7, "<core:transitionMember>");
        line(8, "<core:Transition gml:id=\"" + id + "\">");
        line(9, "<core:weight>" + number_text(distance(from, boundary.middle) + distance(boundary.middle, to)) +
                    "</core:weight>");
        link(9, "core:connects", state_id(boundary.cell));
        link(9, "core:connects", state_id(boundary.other));
        link(9, "core:duality", boundary_id(std::size_t(&boundary - boundaries_.data())));
        line(9, "<core:geometry>");
        line(10, "<gml:LineString gml:id=\"" + id + "-line\"" + srs() + "><gml:posList>" + pos(from) + ' ' +
                     pos(boundary.middle) + ' ' + pos(to) + "</gml:posList></gml:LineString>");
        line(9, "</core:geometry>");
        line(8, "</core:Transition>");
        line(7, "</core:transitionMember>");
    }

    const Building& building_;
    IndoorGmlVersion version_;
    std::string srs_name_;
    SpaceSolids solids_;
    std::vector<Cell> cells_;
    std::vector<std::size_t> cell_of_part_;
    std::vector<Boundary> boundaries_;
    std::size_t transitions_ = 0;
    std::string text_;
};

}  // namespace

std::string to_indoorgml(const Building& building, IndoorGmlVersion version, const std::string& srs_name) {
    return Writer(building, version, srs_name).write();
}

}  // namespace enfilade::modeler
