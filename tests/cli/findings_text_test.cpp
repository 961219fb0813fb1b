// Findings as text.

#include "tools/findings_text.h"

#include <gtest/gtest.h>

#include <vector>

#include "tools/suggestion.h"

namespace enfilade::tools {
namespace {

std::vector<Finding> some_findings() {
    Finding door{"P31",
                 Severity::Error,
                 "The door stands in no wall.",
                 "Move it into one.",
                 std::array{1.0, 2.0, 0.5},
                 "ground",
                 {{"door", "d1", "Front door"}}};
    Finding wall{"P12", Severity::Note, "The wall was lengthened.", "", std::nullopt, "", {{"wall", "w1", ""}}, 12.5};
    return {wall, door, wall};
}

TEST(FindingsText, PutsErrorsFirstWithTheirPlaceAndRemedy) {
    EXPECT_EQ(findings_text(some_findings()),
              "Errors:\n"
              "  P31     The door stands in no wall.\n"
              "          at (1.00, 2.00, 0.50) in storey ground: door d1 (Front door)\n"
              "          Move it into one.\n"
              "Notes:\n"
              "  P12     The wall was lengthened.\n"
              "          wall w1, moved 12.5 mm\n"
              "  P12     The wall was lengthened.\n"
              "          wall w1, moved 12.5 mm\n");
}

TEST(FindingsText, SaysHowManyItHoldsBack) {
    EXPECT_TRUE(findings_text(some_findings(), 1).ends_with("  ... and 1 note more\n"));
    EXPECT_EQ(findings_text({}), "");
}

TEST(FindingsText, CountsBySeverity) {
    EXPECT_EQ(counts_text(some_findings()), "1 error and 2 notes");
    EXPECT_EQ(counts_text({}), "no findings");
}

TEST(Suggestion, NamesOnlyWhatIsNear) {
    const std::vector<std::string> known = {"--storeys", "--snap-mm"};
    EXPECT_EQ(suggestion("--story", known), " (did you mean \"--storeys\"?)");
    EXPECT_EQ(suggestion("--verbose", known), "");
}

}  // namespace
}  // namespace enfilade::tools
