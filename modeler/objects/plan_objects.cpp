#include "modeler/objects/plan_objects.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "modeler/objects/object_box.h"
#include "modeler/objects/piece_models.h"
#include "modeler/objects/space_finder.h"
#include "plans/read.h"

namespace enfilade::modeler {
namespace {

constexpr std::uint32_t nowhere = UINT32_MAX;
constexpr double least_size = 1e-3;  ///< metres: of a sheet

using Rows = std::array<double, 9>;

Rows product(const Rows& a, const Rows& b) {
    Rows rows{};
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t k = 0; k < 3; ++k) rows[3 * r + c] += a[3 * r + k] * b[3 * k + c];
    return rows;
}

/// About the piece's own axes: pitch, or else roll.
Rows tilt_of(const plans::Furniture& piece) {
    const double angle = piece.pitch != 0 ? piece.pitch : piece.roll;
    const double c = std::cos(angle), s = std::sin(angle);
    if (piece.pitch != 0) return {1, 0, 0, 0, c, s, 0, -s, c};
    return {c, 0, s, 0, 1, 0, -s, 0, c};
}

/// A tilted piece: its mesh is scaled and mirrored before it is tilted, so that all of it goes into `turned`.
void tilt(const plans::Furniture& piece, const ObjectMesh& mesh, FurnishedObject& object) {
    const std::array<double, 3> own = piece.model_size.value_or(object.size);
    const TurnedBox box = turned_box(object.turned, mesh);
    Rows scaled = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    for (std::size_t k = 0; k < 3; ++k)
        if (const double extent = box.high[k] - box.low[k]; extent > 1e-6) scaled[4 * k] = own[k] / extent;
    if (piece.mirrored) scaled[0] = -scaled[0];
    object.turned = product(tilt_of(piece), product(scaled, object.turned));
    object.mirrored = false;
    const TurnedBox tilted = turned_box(object.turned, mesh);
    for (std::size_t k = 0; k < 3; ++k) object.size[k] = std::max(tilted.high[k] - tilted.low[k], least_size);
}

std::string called(const plans::Furniture& piece) { return '"' + (piece.name.empty() ? piece.id : piece.name) + '"'; }

/// Pieces of one storey that were treated alike, told at once.
struct Told {
    std::vector<const plans::Furniture*> pieces;

    [[nodiscard]] Finding finding(const StoreyInfo& storey, const char* code, const std::string& one,
                                  const std::string& several, std::string hint) const {
        Finding finding{.code = code, .severity = Severity::Warning};
        const std::string count = std::to_string(pieces.size());
        finding.sentence = (pieces.size() == 1 ? "The piece of furniture " + called(*pieces.front()) + " " + one
                                               : count + " pieces of furniture " + several) +
                           " (storey \"" + storey.name + "\").";
        finding.hint = std::move(hint);
        finding.storey = storey.id;
        constexpr std::size_t most = 20;
        for (std::size_t k = 0; k < std::min(most, pieces.size()); ++k)
            finding.elements.push_back({"furniture", pieces[k]->id, pieces[k]->name});
        return finding;
    }
};

class PlanPieces {
public:
    PlanPieces(const Building& building, const Catalogue& catalogue, std::span<const std::uint32_t> spaces,
               std::vector<Finding>& findings)
        : building_(building), finder_(building), models_(catalogue), spaces_(spaces), findings_(findings) {}

    Furnishing run() {
        const plans::Plan plan = plans::read_json(building_.plan_json, "");
        for (const plans::Storey& storey : plan.storeys) {
            const auto at = std::find_if(building_.storeys.begin(), building_.storeys.end(),
                                         [&](const StoreyInfo& info) { return info.id == storey.id; });
            if (at != building_.storeys.end()) place_storey(storey, *at);
        }
        std::sort(furnishing_.objects.begin(), furnishing_.objects.end(),
                  [](const FurnishedObject& a, const FurnishedObject& b) { return a.id < b.id; });
        furnishing_.meshes = std::move(models_.meshes());
        return std::move(furnishing_);
    }

private:
    void place_storey(const plans::Storey& storey, const StoreyInfo& info) {
        Told own, boxes, outside;
        for (const plans::Furniture& piece : storey.furniture) {
            FurnishedObject object = standing(piece, building_.frame.world_z(info.z_floor));
            // By its box in the plan first: meshes are loaded for what is asked for alone.
            object.space = finder_.of(box_of(object));
            if (object.space == nowhere) {
                outside.pieces.push_back(&piece);
                continue;
            }
            if (!spaces_.empty() && std::find(spaces_.begin(), spaces_.end(), object.space) == spaces_.end()) continue;
            const PieceModel model = models_.of(piece);
            if (!model.unread.empty()) tell_unread(piece, info, model.unread);
            if (model.source == ModelSource::Own) own.pieces.push_back(&piece);
            if (model.source == ModelSource::Box) boxes.pieces.push_back(&piece);
            object.model = model.id;
            object.mesh = model.mesh;
            if (piece.model_rotation && !model.is_turned) object.turned = *piece.model_rotation;
            if (piece.pitch != 0 || piece.roll != 0) tilt(piece, *models_.meshes()[model.mesh], object);
            furnishing_.objects.push_back(std::move(object));
        }
        tell(info, own, boxes, outside);
    }

    static FurnishedObject standing(const plans::Furniture& piece, double floor) {
        FurnishedObject object;
        object.id = piece.id;
        object.name = piece.name;
        object.position = {piece.position.x, piece.position.y, floor + piece.elevation};
        object.angle = piece.angle;
        object.size = {std::max(piece.width, least_size), std::max(piece.depth, least_size),
                       std::max(piece.height, least_size)};
        object.mirrored = piece.mirrored;
        object.colour = piece.colour;
        return object;
    }

    void tell_unread(const plans::Furniture& piece, const StoreyInfo& storey, const std::string& why) {
        Finding finding{.code = "P512", .severity = Severity::Warning};
        finding.sentence = "The mesh of " + called(piece) + " cannot be read: " + why;
        finding.hint = "Give a catalogue in which it is whole.";
        finding.storey = storey.id;
        finding.elements = {{"furniture", piece.id, piece.name}};
        findings_.push_back(std::move(finding));
    }

    void tell(const StoreyInfo& storey, const Told& own, const Told& boxes, const Told& outside) {
        const char* give = "Give the library or the home that holds the models with --catalogue.";
        if (!own.pieces.empty())
            findings_.push_back(
                own.finding(storey, "P510", "has a model that no catalogue has: our own piece of its kind stands there",
                            "have models that no catalogue has: our own pieces of their kinds stand there", give));
        if (!boxes.pieces.empty())
            findings_.push_back(boxes.finding(storey, "P510",
                                              "has a model that no catalogue has: a plain box stands there",
                                              "have models that no catalogue has: plain boxes stand there", give));
        if (!outside.pieces.empty())
            findings_.push_back(outside.finding(
                storey, "P511", "stands wholly inside walls, slabs or the ground, or off the site: it is left out",
                "stand wholly inside walls, slabs or the ground, or off the site: they are left out",
                "Move it into a room."));
    }

    const Building& building_;
    SpaceFinder finder_;
    PieceModels models_;
    std::span<const std::uint32_t> spaces_;
    std::vector<Finding>& findings_;
    Furnishing furnishing_;
};

}  // namespace

Furnishing plan_objects(const Building& building, const Catalogue& catalogue, std::span<const std::uint32_t> spaces,
                        std::vector<Finding>& findings) {
    return PlanPieces(building, catalogue, spaces, findings).run();
}

std::uint32_t space_at(const Building& building, double x, double y, double z) {
    const std::uint32_t space = SpaceFinder(building).at(x, y, z);
    if (space == nowhere) return nowhere;
    const Label label = building.spaces[space].label;
    return label == Label::Room || label == Label::Exterior ? space : nowhere;
}

}  // namespace enfilade::modeler
