// FloorspaceJS floor plans: stories of spaces that share edges without thickness become storeys of walls and rooms
// (docs/floorspace.md).
#include <algorithm>
#include <filesystem>

#include "plans/floorspace/courtyards.h"
#include "plans/floorspace/levels.h"
#include "plans/floorspace/openings.h"
#include "plans/limits.h"
#include "plans/number_text.h"
#include "plans/read.h"
#include "plans/sweet_home/words.h"

namespace enfilade::plans {
namespace {

class FloorspaceReader {
public:
    FloorspaceReader(FloorFile file, const ReadOptions& options) : file_(std::move(file)), options_(options) {}

    Plan read(const std::string& file_name) {
        plan_.name = std::filesystem::path(file_name).stem().string();
        plan_.ground_level = 0;
        const std::vector<FloorLevel> levels = find_floor_levels(file_, file_name, options_.storey_height);
        for (const FloorStory& story : file_.stories) {
            spaces_.push_back(find_spaces(story));
            graphs_.push_back(make_floor_graph(story, spaces_.back().edge_used));
            voids_.push_back(find_voids(story, spaces_.back(), graphs_.back(), options_.wall_thickness));
        }
        find_covered(spaces_, voids_);
        for (std::size_t k = 0; k < file_.stories.size(); ++k) read_story(k, levels[k]);
        report_file();
        return std::move(plan_);
    }

private:
    void read_story(std::size_t k, const FloorLevel& level) {
        const FloorStory& story = file_.stories[k];
        plan_.storeys.emplace_back();
        Storey& storey = plan_.storeys.back();
        storey.id = ids_.take(story.id.empty() ? "story-" + std::to_string(k + 1) : story.id);
        storey.name = story.name;
        storey.elevation = level.floor;
        storey.height = level.height;
        storey.slab_thickness = level.slab;
        report_level(story, storey, level, k + 1 < file_.stories.size());

        const FloorSpaces& spaces = spaces_[k];
        const FloorGraph& graph = graphs_[k];
        const FloorWalls walls = make_walls(story, spaces, graph, options_.wall_thickness);
        for (const FloorWall& from : walls.walls) {
            Wall wall;
            wall.id = ids_.take(story.edges[from.edge].id);
            wall.start = from.start;
            wall.end = from.end;
            wall.thickness = from.thickness;
            wall.height_at_start = wall.height_at_end = storey.height;
            storey.walls.push_back(std::move(wall));
        }
        for (std::uint32_t o = 0; o < spaces.outlines.size(); ++o)
            if (!std::binary_search(walls.lost.begin(), walls.lost.end(), o))
                add_room(story, spaces.outlines[o], storey);
        report_spaces(story, spaces, walls, graph, storey);
        add_courtyards(voids_[k], storey);
        place_openings(file_, story, graph, walls, level.wall_height, storey, report_);
        open_to_below(k, spaces);
        report_left_out(story, spaces, storey);
    }

    [[nodiscard]] static ElementRef ref(const FloorSpace& space) { return {"room", space.id, space.name}; }

    void add_room(const FloorStory& story, const FloorOutline& outline, Storey& storey) {
        const FloorSpace& space = story.spaces[outline.space];
        Room room;
        room.id = ids_.take(space.id.empty() ? "space-" + std::to_string(outline.space + 1) : space.id);
        room.name = space.name;
        room.kind = room_kind(space.name);
        if (room.kind == "room") room.kind = room_kind(space.type_name);
        room.polygon = outline.corners;
        storey.rooms.push_back(std::move(room));
    }

    void add_courtyards(const FloorVoids& voids, Storey& storey) {
        for (const FloorCourtyard& courtyard : voids.courtyards) {
            if (courtyard.narrow) continue;
            const Point corner = courtyard.outline.corners[0];
            Finding& finding =
                report_.add("P768", Severity::Note, storey,
                            "Spaces on storey " + called(storey) + " surround " +
                                rounded_text(courtyard.outline.area, 1) + " m2 that belong to none of them: " +
                                (courtyard.covered ? "it is a room without a name, for the storeys above cover it."
                                                   : "it is a courtyard, open to the sky."),
                            "Draw a space there if it is meant to be a room.");
            finding.point = std::array{corner.x, corner.y, storey.elevation};
            if (courtyard.covered) continue;
            Room room;
            room.id = ids_.take("courtyard-" + storey.id);
            room.kind = "courtyard";
            room.polygon = courtyard.outline.corners;
            finding.elements.push_back({"room", room.id, ""});
            storey.rooms.push_back(std::move(room));
        }
    }

    void report_level(const FloorStory& story, const Storey& storey, const FloorLevel& level, bool has_next) {
        const ElementRef element{"storey", storey.id, storey.name};
        const auto say = [&](const char* code, Severity severity, const std::string& sentence, const char* hint) {
            report_.add(code, severity, storey, "Storey " + called(storey) + sentence, hint)
                .elements.push_back(element);
        };
        if (!level.height_given)
            say("P755", Severity::Warning, " has no height: " + metres_text(level.wall_height) + " is taken.",
                "Give its floor to ceiling height in FloorspaceJS, or another one for all with --storey-height-mm.");
        if (story.multiplier > 1)
            say("P756", Severity::Warning,
                " stands for " + rounded_text(story.multiplier, 0) + " equal storeys (multiplier): it is built once.",
                "Copy the storey in FloorspaceJS where all of them are wanted.");
        if (level.plenum >= 0.05 && has_next)
            say("P758", Severity::Note,
                " has a plenum of " + metres_text(level.plenum) +
                    " between its ceiling and the next floor: it is no room here, the slab fills it.",
                "");
        std::vector<ElementRef> own;
        for (const FloorSpace& space : story.spaces)
            if (space.own_heights) own.push_back(ref(space));
        if (own.empty()) return;
        Finding& finding = report_.add("P757", Severity::Warning, storey,
                                       floor_count(own.size(), "space", "spaces") + " on storey " + called(storey) +
                                           (own.size() == 1 ? " has a floor, ceiling or plenum of its own"
                                                            : " have floors, ceilings or plenums of their own") +
                                           " (" + floor_names(own) + "): all are built as high as the storey.",
                                       "Draw them on a storey of their own where the height matters.");
        finding.elements = std::move(own);
    }

    void report_spaces(const FloorStory& story, const FloorSpaces& spaces, const FloorWalls& walls,
                       const FloorGraph& graph, const Storey& storey) {
        const std::string on_storey = " on storey " + called(storey);
        const auto say_of = [&](const char* code, const std::vector<std::uint32_t>& which, const std::string& one_has,
                                const std::string& more_have, const char* hint) {
            if (which.empty()) return;
            std::vector<ElementRef> elements;
            for (const std::uint32_t s : which) elements.push_back(ref(story.spaces[s]));
            const std::string sentence = floor_count(which.size(), "space", "spaces") + on_storey + " (" +
                                         floor_names(elements) + ") " + (which.size() == 1 ? one_has : more_have);
            report_.add(code, Severity::Warning, storey, sentence, hint).elements = std::move(elements);
        };
        say_of("P759", spaces.without_outline, "has no outline: there is nothing to build.",
               "have no outline: there is nothing to build.", "Draw or delete them in FloorspaceJS.");
        say_of("P761", spaces.doubled, "has the outline of an earlier space, which names the room.",
               "have outlines of earlier spaces, which name the rooms.", "Delete them in FloorspaceJS.");
        for (const std::uint32_t s : spaces.broken)
            report_
                .add("P760", Severity::Error, storey,
                     "The edges of space " + called(story.spaces[s]) + on_storey +
                         " do not go around it: it has walls, but no name.",
                     "Draw the space again in FloorspaceJS.")
                .elements.push_back(ref(story.spaces[s]));
        for (const auto& [a, b] : overlapping(story, spaces, graph)) {
            const FloorSpace& one_space = story.spaces[spaces.outlines[a].space];
            const FloorSpace& other = story.spaces[spaces.outlines[b].space];
            Finding& finding = report_.add("P761", Severity::Warning, storey,
                                           "Spaces " + called(one_space) + " and " + called(other) + on_storey +
                                               " overlap: the walls of both are built.",
                                           "Draw them side by side in FloorspaceJS.");
            finding.elements = {ref(one_space), ref(other)};
        }
        report_thin(story, spaces, walls, storey);
        report_edges(spaces, graph, storey);
    }

    void report_thin(const FloorStory& story, const FloorSpaces& spaces, const FloorWalls& walls,
                     const Storey& storey) {
        for (const std::uint32_t o : walls.lost) {
            const FloorOutline& outline = spaces.outlines[o];
            Finding& finding =
                report_.add("P764", Severity::Warning, storey,
                            "Space " + called(story.spaces[outline.space]) + " on storey " + called(storey) +
                                " is only " + millimetres_text(2 * outline.area / outline.perimeter) +
                                " wide, less than its walls: no room is left of it.",
                            "Widen it, or join it with the space beside it.");
            finding.elements.push_back(ref(story.spaces[outline.space]));
            finding.point = std::array{outline.corners[0].x, outline.corners[0].y, storey.elevation};
        }
        if (walls.thinned.empty()) return;
        std::vector<ElementRef> elements;
        for (const std::uint32_t o : walls.thinned) elements.push_back(ref(story.spaces[spaces.outlines[o].space]));
        Finding& finding =
            report_.add("P763", Severity::Note, storey,
                        "The walls of " + floor_count(elements.size(), "narrow space", "narrow spaces") +
                            " on storey " + called(storey) + " (" + floor_names(elements) + ") are thinner than " +
                            metres_text(options_.wall_thickness) + ", so that room is left between them.",
                        "");
        finding.elements = std::move(elements);
    }

    void report_edges(const FloorSpaces& spaces, const FloorGraph& graph, const Storey& storey) {
        std::string what;
        const auto count = [&](std::size_t n, const char* one_edge, const char* more) {
            if (n > 0) what += (what.empty() ? "" : ", ") + floor_count(n, one_edge, more);
        };
        count(graph.short_edges, "edge without length", "edges without length");
        count(graph.doubled_edges, "edge drawn twice", "edges drawn twice");
        count(graph.touched_edges, "edge on which others end", "edges on which others end");
        count(graph.crossed_edges, "crossing", "crossings");
        count(spaces.inner_edges, "edge with one space on both sides", "edges with one space on both sides");
        if (what.empty()) return;
        Finding& finding = report_.add(
            "P762", Severity::Note, storey,
            "Storey " + called(storey) + " has " + what + " among the edges of its spaces: each wall is built once.",
            "");
        if (graph.crossed_edges > 0) finding.point = std::array{graph.crossing.x, graph.crossing.y, storey.elevation};
    }

    void open_to_below(std::size_t k, const FloorSpaces& spaces) {
        const FloorStory& story = file_.stories[k];
        for (const FloorOutline& outline : spaces.outlines) {
            const FloorSpace& space = story.spaces[outline.space];
            if (!space.open_to_below) continue;
            if (k == 0) {
                report_
                    .add("P757", Severity::Warning, plan_.storeys[k],
                         "Space " + called(space) + " on storey " + called(plan_.storeys[k]) +
                             " is open to below, but there is no storey below it: it gets a floor.",
                         "")
                    .elements.push_back(ref(space));
                continue;
            }
            Shaft shaft;
            shaft.id = ids_.take((space.id.empty() ? "space" : space.id) + "-open");
            shaft.name = space.name;
            shaft.polygon = outline.corners;
            plan_.storeys[k - 1].shafts.push_back(std::move(shaft));
        }
    }

    void report_left_out(const FloorStory& story, const FloorSpaces& spaces, const Storey& storey) {
        std::string what;
        const auto count = [&](std::size_t n, const char* one_thing, const char* more) {
            if (n > 0) what += (what.empty() ? "" : ", ") + floor_count(n, one_thing, more);
        };
        count(story.shadings, "shading surface", "shading surfaces");
        count(story.roofed_spaces, "pitched roof", "pitched roofs");
        count(spaces.idle_faces, "face of no space", "faces of no space");
        count(spaces.idle_edges, "edge of no face", "edges of no face");
        if (what.empty()) return;
        report_.add("P767", Severity::Note, storey, "Left out on storey " + called(storey) + ": " + what + ".", "");
    }

    void report_file() {
        if (!file_.unit_named)
            plan_.findings.push_back({"P754",
                                      Severity::Warning,
                                      "The file names no unit: its lengths are taken for metres.",
                                      "Say which unit it is with --units.",
                                      {},
                                      "",
                                      {},
                                      0});
        std::string what;
        if (file_.north_axis != 0) what = "the north axis (" + rounded_text(file_.north_axis, 2) + " degrees)";
        if (file_.ground_slope != 0) what += std::string(what.empty() ? "" : " and ") + "the slope of the ground";
        if (!what.empty())
            plan_.findings.push_back(
                {"P767", Severity::Note, "Left out, for a plan has no place for it: " + what + ".", "", {}, "", {}, 0});
    }

    FloorFile file_;
    std::vector<FloorSpaces> spaces_;  ///< [stories], as the next two
    std::vector<FloorGraph> graphs_;
    std::vector<FloorVoids> voids_;
    const ReadOptions& options_;
    Plan plan_;
    FloorElementIds ids_;
    FloorReport report_{plan_.findings, ids_};
};

}  // namespace

Plan read_floorspace(std::string_view text, const std::string& file_name, const ReadOptions& options) {
    return FloorspaceReader(parse_floor_file(text, file_name, options.unit), options).read(file_name);
}

}  // namespace enfilade::plans
