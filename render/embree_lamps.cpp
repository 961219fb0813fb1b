#include "render/embree_lamps.h"

namespace enfilade::render {

std::string text(const EmbreeLitWay& way) {
    return text(way.primary) + "; shadow rays" + (way.coherent_shadows ? " coherent," : "") + " from " +
           (way.from_lamps ? "lamps" : "places");
}

std::vector<EmbreeLitWay> embree_lit_ways() {
    std::vector<EmbreeLitWay> ways;
    for (const EmbreeWay primary : embree_ways) {
        if (!primary.coherent) continue;
        for (const bool coherent : {false, true})
            for (const bool from_lamps : {false, true}) ways.push_back({primary, coherent, from_lamps});
    }
    return ways;
}

}  // namespace enfilade::render
