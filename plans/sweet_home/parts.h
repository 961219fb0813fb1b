#pragma once
// What the parts of the Sweet Home 3D reader share: the plan as it grows, its ids, its storeys by level.

#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "plans/plan.h"
#include "plans/sweet_home/xml.h"

namespace enfilade::plans {

/// Gives every element of the plan an id of its own: the file's where it is the first to use it.
class HomeIds {
public:
    /// Takes note of all ids in the file, so that no made one is the same as a later given one.
    explicit HomeIds(pugi::xml_node home);
    /// The file's id; with "-2", "-3", ... behind it where it is taken; "<kind>-<count>" where the file gives none.
    [[nodiscard]] std::string take(std::string id, const std::string& kind);

private:
    [[nodiscard]] std::string numbered(const std::string& stem);

    std::unordered_set<std::string> given_;
    std::unordered_set<std::string> taken_;
    std::unordered_map<std::string, std::size_t> count_;
};

/// A door or window as the file places it: a box in the plan, which has to find its wall.
struct PlacedOpening {
    Opening opening;    ///< without its host
    Point middle;       ///< of its box
    double angle = 0;   ///< of its width, counter-clockwise
    double width = 0;   ///< of its box
    double depth = 0;   ///< of its box
    Point wall_middle;  ///< of that part of the box that is meant to stand in the wall
    double wall_width = 0;
    double wall_depth = 0;
};

struct Home {
    explicit Home(pugi::xml_node node) : ids(node) {}

    Plan plan;
    HomeIds ids;
    double wall_height = 2.5;                                ///< m, of walls that have none of their own
    std::unordered_map<std::string, std::size_t> storey_of;  ///< by the level's id in the file
    std::vector<std::vector<PlacedOpening>> openings;        ///< [storeys]
    std::vector<std::size_t> hidden;                         ///< [storeys] pieces that are not shown
    std::vector<std::vector<ElementRef>> without_size;       ///< [storeys] furniture without usable place or size

    /// Index of the storey of an element; said with a warning where its level is not in the file.
    [[nodiscard]] std::size_t storey_for(const HomeElement& element, const std::string& level);
    void report(Finding finding) { plan.findings.push_back(std::move(finding)); }
};

/// Places of the file, centimetres and y down, as the plan has them: metres and y up.
[[nodiscard]] std::optional<Point> point_of(const HomeElement& element, const char* x, const char* y);

/// A finding about one element at a place of its storey.
[[nodiscard]] Finding finding_at(const Storey& storey, const char* code, Severity severity, std::string sentence,
                                 std::string hint, const ElementRef& element, std::optional<Point> place);

/// "(3.2, -1.5)": a place in metres for a sentence.
[[nodiscard]] std::string place_text(Point place);

void read_levels(const HomeElement& home_element, Home& home);
void read_wall(const HomeElement& element, Home& home);
void read_room(const HomeElement& element, Home& home);
/// A piece of furniture, door, light or group with all that it holds; other elements are passed over.
void read_piece(const HomeElement& element, Home& home, const std::string& level_of_group);
/// Finds the walls of all doors and windows of a storey and moves them into its openings.
void bind_openings(Storey& storey, std::vector<PlacedOpening> placed, Home& home);

}  // namespace enfilade::plans
