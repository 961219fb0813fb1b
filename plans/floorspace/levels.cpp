#include "plans/floorspace/levels.h"

#include <algorithm>

#include "base/error.h"
#include "plans/limits.h"
#include "plans/number_text.h"

namespace enfilade::plans {
namespace {

constexpr double usual_slab = 0.2;
constexpr double least_plenum = 0.05;

}  // namespace

std::vector<FloorLevel> find_floor_levels(const FloorFile& file, const std::string& file_name, double usual_height) {
    std::vector<FloorLevel> levels;
    double base = file.floor_offset;
    for (const FloorStory& story : file.stories) {
        FloorLevel level;
        level.height_given = story.height > 0;
        level.wall_height = level.height_given ? story.height : usual_height;
        level.height = level.wall_height;
        level.floor = base + story.plenum_below;
        level.plenum = story.plenum_above;
        level.slab = usual_slab;
        base = level.floor + level.wall_height + story.plenum_above;
        if (!(base <= limits::elevation))
            throw InputError("P105", file_name, story.line, story.column,
                             "The stories up to this one are " + rounded_text(base, 3) + " m high, at most " +
                                 rounded_text(limits::elevation, 0) + " m are read; check the unit of the plan.");
        levels.push_back(level);
    }
    for (std::size_t k = 0; k + 1 < levels.size(); ++k) {
        FloorLevel& below = levels[k];
        FloorLevel& above = levels[k + 1];
        below.plenum = above.floor - below.floor - below.wall_height;
        if (below.plenum >= least_plenum) {
            above.slab = std::min(usual_slab, below.plenum);
        } else {
            above.slab = std::min(usual_slab, below.wall_height / 10);
            below.height = above.floor - above.slab - below.floor;
        }
    }
    return levels;
}

}  // namespace enfilade::plans
