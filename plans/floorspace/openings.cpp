#include "plans/floorspace/openings.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "plans/limits.h"
#include "plans/vector2.h"

namespace enfilade::plans {
namespace {

constexpr double inch = 0.0254;              ///< OpenStudio leaves an inch around the glass that a ratio asks for
constexpr double corner_gap = 0.01;          ///< metres between an opening and the wall that meets its own
constexpr double narrowest = 0.05;           ///< metres; what is left of less is no opening
constexpr double moved_by_walls = 0.1;       ///< metres that walls alone explain, for the file's have no thickness
constexpr double least_size = 0.01;          ///< metres
constexpr std::size_t most_in_rows = 10000;  ///< that a storey's rows may come to

/// A stretch of an edge within one wall: [from, to] along the edge, and where that lies in the wall.
struct Run {
    std::uint32_t wall = 0;
    double from = 0;
    double to = 0;
    double offset = 0;  ///< in the wall, of `from`
    bool forward = true;

    [[nodiscard]] double in_wall(double along_edge) const {
        return forward ? offset + (along_edge - from) : offset - (along_edge - from);
    }
};

class OpeningPlacer {
public:
    OpeningPlacer(const FloorFile& file, const FloorStory& story, const FloorGraph& graph, const FloorWalls& walls,
                  double wall_height, Storey& storey, FloorReport& report)
        : file_(file),
          story_(story),
          graph_(graph),
          walls_(walls),
          wall_height_(wall_height),
          storey_(storey),
          report_(report) {}

    void place(const FloorAperture& aperture) {
        aperture_ = &aperture;
        definition_ = nullptr;
        Opening opening;
        opening.kind = aperture.door ? OpeningKind::Door : OpeningKind::Window;
        if (aperture.definition == no_floor_item)
            return lose("names a definition that the file does not have (\"" + aperture.definition_id + "\")",
                        "Give it a definition in FloorspaceJS, or delete it.");
        definition_ = &(aperture.door ? file_.doors : file_.windows)[aperture.definition];
        opening.name = aperture.name.empty() ? definition_->name : aperture.name;
        if (aperture.edge == no_floor_item)
            return lose("names an edge that its story does not have (\"" + aperture.edge_id + "\")",
                        "Place it again in FloorspaceJS, or delete it.");
        const auto [known, fresh] = runs_.try_emplace(aperture.edge);
        if (fresh) known->second = runs_of(aperture.edge);
        const std::vector<Run>& runs = known->second;
        if (runs.empty())
            return lose("stands on an edge without a space beside it", "Place it on a wall of a space, or delete it.");
        switch (definition_->fill) {
            case FloorFill::Ratio: return place_ratio(runs, opening);
            case FloorFill::Unknown:
                return lose("is of a kind that is not known", "Make it single, repeating or a ratio.");
            case FloorFill::Single:
            case FloorFill::Repeating:
            case FloorFill::Door: return place_sized(runs, opening);
        }
    }

private:
    [[nodiscard]] std::vector<Run> runs_of(std::uint32_t edge) const {
        std::vector<Run> runs;
        for (const FloorPieceUse& use : graph_.of_edge[edge]) {
            const FloorPiecePlace& place = walls_.of_piece[use.piece];
            const double at_first =
                place.offset + (use.forward ? 0 : (place.forward ? 1 : -1) * graph_.length(use.piece));
            if (!runs.empty() && runs.back().wall == place.wall) runs.back().to = use.to;
            else runs.push_back({place.wall, use.from, use.to, at_first, use.forward == place.forward});
        }
        return runs;
    }

    [[nodiscard]] const char* kind() const { return aperture_->door ? "Door" : "Window"; }
    [[nodiscard]] ElementRef ref() const {
        const std::string& name =
            !aperture_->name.empty() || definition_ == nullptr ? aperture_->name : definition_->name;
        return {"opening", aperture_->id.empty() ? aperture_->edge_id : aperture_->id, name};
    }
    [[nodiscard]] std::string title() const {
        const ElementRef element = ref();
        return std::string(kind()) + " \"" + (element.name.empty() ? element.id : element.name) + "\" on storey " +
               called(storey_);
    }
    [[nodiscard]] std::optional<std::array<double, 3>> middle_of_edge() const {
        if (aperture_->edge == no_floor_item) return {};
        const auto& ends = story_.edges[aperture_->edge].ends;
        const Point middle = (story_.vertices[ends[0]].at + story_.vertices[ends[1]].at) * 0.5;
        return std::array{middle.x, middle.y, storey_.elevation};
    }

    void lose(const std::string& why, const char* hint) {
        Finding& finding =
            report_.add("P765", Severity::Error, storey_, title() + " " + why + ": it is left out.", hint);
        finding.elements.push_back(ref());
        finding.point = middle_of_edge();
    }

    void place_sized(const std::vector<Run>& runs, Opening& opening) {
        const double width = definition_->width.value_or(0);
        const double height = definition_->height.value_or(0);
        if (!(width >= least_size && height >= least_size))
            return lose("has no width or no height", "Give its definition a width and a height in FloorspaceJS.");
        opening.sill = aperture_->door ? 0 : definition_->sill.value_or(0);
        opening.head = opening.sill + height;
        opening.width = width;
        const double length = runs.back().to;
        std::vector<double> middles;
        if (definition_->fill == FloorFill::Repeating && !aperture_->alpha_list) {
            middles = row(length, width);
        } else {
            for (const double alpha : aperture_->alphas) middles.push_back(alpha * length);
            if (aperture_->alphas.empty() && !aperture_->alpha_list) middles.push_back(length / 2);
        }
        if (middles.empty()) return no_room(length);
        if (middles.size() > std::max<std::size_t>(1, aperture_->alphas.size()) && too_many(middles.size())) return;
        for (const double middle : middles) place_at(runs, middle, opening);
    }

    /// The middles of a row as FloorspaceJS spreads it: as many as fit from one end on, then moved to the middle.
    [[nodiscard]] std::vector<double> row(double length, double width) const {
        const double spacing = definition_->spacing.value_or(0) > 0 ? *definition_->spacing : unit_spacing;
        std::vector<double> middles;
        for (double at = width / 2; at + width / 2 < length && middles.size() <= most_in_rows; at += width + spacing)
            middles.push_back(at);
        if (middles.empty()) return middles;
        const double margin = (length - middles.back() - width / 2) / 2;
        for (double& at : middles) at += margin;
        return middles;
    }

    /// One entry of the file may stand for many windows: they are counted, lest a small file asks for any number.
    bool too_many(std::size_t windows) {
        in_rows_ += windows;
        if (in_rows_ <= most_in_rows) return false;
        lose("is one of more than " + std::to_string(most_in_rows) + " windows in rows on this storey",
             "Make the windows of its definition wider, or space them wider.");
        return true;
    }

    void no_room(double length) {
        Finding& finding = report_.add(
            "P769", Severity::Warning, storey_,
            title() + " has no room on its edge, which is " + metres_text(length) + " long: it is left out.",
            "Make it narrower, or place it on a longer edge.");
        finding.elements.push_back(ref());
        finding.point = middle_of_edge();
    }

    void place_at(const std::vector<Run>& runs, double middle, Opening opening) {
        const auto behind = std::upper_bound(runs.begin() + 1, runs.end(), middle,
                                             [](double at, const Run& run) { return at <= run.from; });
        const Run& run = *(behind - 1);
        set_in_wall(run, run.in_wall(middle), opening);
    }

    /// Into the part of the wall that no other wall takes up.
    void set_in_wall(const Run& run, double offset, Opening& opening) {
        const FloorWall& wall = walls_.walls[run.wall];
        const double length = distance(wall.start, wall.end);
        const double low = wall.taken_at_start > 0 ? wall.taken_at_start + corner_gap : 0;
        const double high = length - (wall.taken_at_end > 0 ? wall.taken_at_end + corner_gap : 0);
        if (!(high - low >= narrowest)) return no_room(length);
        const double width = std::min(opening.width, high - low);
        const double fitted = std::clamp(offset, low + width / 2, std::max(low + width / 2, high - width / 2));
        report_fit(wall, opening.width, width, offset, fitted);
        opening.width = width;
        opening.offset = fitted;
        opening.wall = storey_.walls[run.wall].id;
        add(opening);
    }

    void report_fit(const FloorWall& wall, double was, double width, double offset, double fitted) {
        const double moved = std::abs(fitted - offset);
        const bool cut = width < was;
        if (moved <= floor_tolerance && !cut) return;
        const bool slight = moved <= moved_by_walls && was - width <= 2 * moved_by_walls;
        std::string sentence = title() + " reaches into the walls beside its own: it is ";
        if (cut) sentence += "made " + metres_text(width) + " wide instead of " + metres_text(was);
        if (cut && moved > floor_tolerance) sentence += " and ";
        if (moved > floor_tolerance) sentence += "moved by " + millimetres_text(moved);
        Finding& finding =
            report_.add("P766", slight ? Severity::Note : Severity::Warning, storey_, sentence + ".",
                        "Edges have no thickness in FloorspaceJS; keep doors and windows off the corners.");
        finding.elements.push_back(ref());
        const Point at = wall.start + (wall.end - wall.start) * (fitted / distance(wall.start, wall.end));
        finding.point = std::array{at.x, at.y, storey_.elevation};
        finding.moved_mm = 1000 * std::max(moved, was - width);
    }

    void add(Opening opening) {
        opening.id = report_.ids.take(
            aperture_->id.empty() ? aperture_->edge_id + "-" + (aperture_->door ? "door" : "window") : aperture_->id);
        opening.head = std::min(opening.head, limits::height);
        storey_.openings.push_back(std::move(opening));
    }

    /// One pane in each wall of the edge, of the area asked for: as wide as the walls beside it leave room, at the sill
    /// asked for, or lower where it would not fit under the ceiling. After `applyViewAndDaylightingGlassRatios` of
    /// OpenStudio, which knows no walls beside.
    void place_ratio(const std::vector<Run>& runs, Opening& opening) {
        const double ratio = definition_->ratio.value_or(0);
        if (!(ratio > 0 && ratio < 1))
            return lose("asks for no share of glass between 0 and 1", "Set its window to wall ratio in FloorspaceJS.");
        if (runs.size() > 1 && too_many(runs.size())) return;
        bool placed = false;
        for (const Run& run : runs) placed = place_pane(run, ratio, opening) || placed;
        if (!placed) no_room(runs.back().to);
    }

    bool place_pane(const Run& run, double ratio, Opening opening) {
        const FloorWall& wall = walls_.walls[run.wall];
        const double length = distance(wall.start, wall.end);
        const double ends[] = {run.in_wall(run.from), run.in_wall(run.to)};
        const double low = std::max(std::min(ends[0], ends[1]), wall.taken_at_start) + inch;
        const double high = std::min(std::max(ends[0], ends[1]), length - wall.taken_at_end) - inch;
        if (!(high - low >= narrowest)) return false;
        const double wanted = ratio * (run.to - run.from) * wall_height_;
        const double room = storey_.height - 2 * inch;
        if (!(room >= narrowest)) return false;
        const double height = std::min(wanted / (high - low), room);
        if (height < wanted / (high - low) - floor_tolerance) report_small_pane(wanted, height * (high - low));
        opening.sill = std::clamp(definition_->sill.value_or(0), inch, storey_.height - inch - height);
        opening.head = opening.sill + height;
        opening.width = high - low;
        opening.offset = (low + high) / 2;
        opening.wall = storey_.walls[run.wall].id;
        if (height < least_size) return false;
        add(std::move(opening));
        return true;
    }

    void report_small_pane(double wanted, double got) {
        Finding& finding = report_.add("P769", Severity::Warning, storey_,
                                       title() + " asks for " + rounded_text(wanted, 2) + " m2 of glass where " +
                                           rounded_text(got, 2) + " m2 fit: it is made as large as that.",
                                       "Lower its window to wall ratio.");
        finding.elements.push_back(ref());
        finding.point = middle_of_edge();
    }

    static constexpr double unit_spacing = 0.3048;  ///< FloorspaceJS takes one unit, mostly a foot

    const FloorFile& file_;
    const FloorStory& story_;
    const FloorGraph& graph_;
    const FloorWalls& walls_;
    double wall_height_;
    Storey& storey_;
    FloorReport& report_;
    const FloorAperture* aperture_ = nullptr;
    const FloorDefinition* definition_ = nullptr;
    std::unordered_map<std::uint32_t, std::vector<Run>> runs_;  ///< by edge
    std::size_t in_rows_ = 0;                                   ///< windows that rows without given places have come to
};

}  // namespace

void place_openings(const FloorFile& file, const FloorStory& story, const FloorGraph& graph, const FloorWalls& walls,
                    double wall_height, Storey& storey, FloorReport& report) {
    OpeningPlacer placer(file, story, graph, walls, wall_height, storey, report);
    for (const FloorAperture& aperture : story.apertures) placer.place(aperture);
}

}  // namespace enfilade::plans
