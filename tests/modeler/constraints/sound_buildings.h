#pragma once
// Sound buildings to put faults into, and what is expected of each fault.

#include <gtest/gtest.h>

#include <functional>
#include <optional>

#include "modeler/build.h"
#include "modeler/check.h"
#include "modeler/convexify.h"
#include "plans/generate.h"
#include "plans/random.h"
#include "plans/read.h"
#include "tests/support/fault_verdict.h"
#include "tests/support/injected_fault.h"
#include "tests/support/small_plans.h"

namespace enfilade::testing {

using Injector = std::function<std::optional<InjectedFault>(modeler::Building&, plans::Random&)>;

/// Floors of offices with 3 to 50 rooms on one to three storeys, some with walls that are curved or oblique.
inline plans::Plan random_office(plans::Random& random) {
    plans::GenerateOptions options;
    options.storeys = 1 + random.below(3);
    options.rooms = options.storeys * (3 + random.below(15));
    if (random.chance(0.3)) options.curved = random.uniform(0, 0.5);
    if (random.chance(0.3)) options.oblique = random.uniform(0, 0.5);
    options.seed = random.next();
    return plans::generate(options);
}

inline modeler::Building random_building(plans::Random& random) {
    modeler::Building building = modeler::build(random_office(random));
    return random.chance(0.5) ? modeler::convexify(building) : building;
}

/// Every finding, a line each.
inline std::string all_of(const modeler::CheckReport& report) {
    std::string text;
    for (const Finding& finding : report.findings)
        text += std::string(name_of(finding.severity)) + " " + finding.code + ": " + finding.sentence + "\n";
    return text;
}

/// Puts the fault into the small plans and into `count` random offices, whole and cut into convex cells: `check` has to
/// find it once, at its place, and nothing else.
inline void expect_found(const Injector& inject, std::uint32_t count) {
    std::uint32_t injected = 0;
    const auto expect_in = [&](modeler::Building building, plans::Random& random, const std::string& name) {
        const modeler::CheckReport before = modeler::check(building);
        const auto fault = inject(building, random);
        if (!fault) return;
        ++injected;
        const FaultVerdict verdict = judge(before, modeler::check(building), *fault);
        EXPECT_TRUE(verdict.exact() && verdict.found == 1)
            << name << ": " << verdict.text()
            << (fault->elements.empty() ? "" : "\n  wanted: " + fault->elements[0].id);
    };
    for (const plans::Plan& plan : {two_rooms(), ring_room(), two_storeys()})
        for (std::uint64_t seed = 0; seed < 4; ++seed) {
            plans::Random random{7, seed};
            const modeler::Building building = modeler::build(plan);
            expect_in(building, random, plan.name + " " + std::to_string(seed));
            expect_in(modeler::convexify(building), random, "convex " + plan.name + " " + std::to_string(seed));
        }
    for (std::uint64_t seed = 0; seed < count; ++seed) {
        plans::Random random{8, seed};
        expect_in(random_building(random), random, "office " + std::to_string(seed));
    }
    EXPECT_GE(2 * injected, count) << "the injector finds a place in too few buildings";
}

}  // namespace enfilade::testing
