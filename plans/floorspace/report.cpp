#include "plans/floorspace/report.h"

namespace enfilade::plans {

std::string FloorElementIds::take(const std::string& id) {
    if (taken_.insert(id).second) return id;
    std::size_t& last = last_.try_emplace(id, 1).first->second;
    for (;;) {
        std::string numbered = id + "-" + std::to_string(++last);
        if (taken_.insert(numbered).second) return numbered;
    }
}

std::string floor_count(std::size_t count, const char* one, const char* more) {
    return std::to_string(count) + " " + (count == 1 ? one : more);
}

std::string floor_names(const std::vector<ElementRef>& elements) {
    const auto name = [&](std::size_t k) {
        return "\"" + (elements[k].name.empty() ? elements[k].id : elements[k].name) + "\"";
    };
    if (elements.empty()) return {};
    if (elements.size() == 1) return name(0);
    if (elements.size() == 2) return name(0) + " and " + name(1);
    return name(0) + ", " + name(1) + " and " + floor_count(elements.size() - 2, "other", "others");
}

}  // namespace enfilade::plans
