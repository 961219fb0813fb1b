#include "tools/report/code_meanings.h"

#include <gtest/gtest.h>

#include "modeler/check.h"
#include "tests/report/faulty_building.h"

namespace enfilade::tools {
namespace {

TEST(CodeMeanings, EveryConstraintThatIsCheckedHasOne) {
    for (const std::string& code : modeler::check(testing::cells_of(testing::one_room())).codes_checked)
        EXPECT_NE(meaning_of(code), "") << code;
}

TEST(CodeMeanings, AreThoseOfTheDocuments) {
    EXPECT_EQ(meaning_of("P211"), "A wall shorter than 1 cm: left out");
    EXPECT_EQ(meaning_of("X1"), "");
}

TEST(CodeMeanings, HaveNoMarks) {
    for (const char* code : {"P104", "P152", "P154", "T7", "G5"})
        EXPECT_EQ(meaning_of(code).find_first_of("`[]*|"), std::string::npos) << meaning_of(code);
}

}  // namespace
}  // namespace enfilade::tools
