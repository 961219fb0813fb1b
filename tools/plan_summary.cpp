#include "tools/plan_summary.h"

#include <nlohmann/json.hpp>

#include "tools/console.h"

namespace enfilade::tools {

namespace {
template <class T>
std::size_t total(const plans::Plan& plan, std::vector<T> plans::Storey::*elements) {
    std::size_t sum = 0;
    for (const plans::Storey& storey : plan.storeys) sum += (storey.*elements).size();
    return sum;
}
}  // namespace

std::string plan_counts_text(const plans::Plan& plan) {
    return counted(plan.storeys.size(), "storey") + ", " + counted(total(plan, &plans::Storey::walls), "wall") + ", " +
           counted(total(plan, &plans::Storey::openings), "opening") + ", " +
           counted(total(plan, &plans::Storey::rooms), "room");
}

nlohmann::ordered_json plan_counts_json(const plans::Plan& plan) {
    return {{"name", plan.name},
            {"storeys", plan.storeys.size()},
            {"walls", total(plan, &plans::Storey::walls)},
            {"openings", total(plan, &plans::Storey::openings)},
            {"rooms", total(plan, &plans::Storey::rooms)},
            {"columns", total(plan, &plans::Storey::columns)},
            {"stairs", total(plan, &plans::Storey::stairs)},
            {"shafts", total(plan, &plans::Storey::shafts)},
            {"lights", total(plan, &plans::Storey::lights)},
            {"furniture", total(plan, &plans::Storey::furniture)}};
}

}  // namespace enfilade::tools
