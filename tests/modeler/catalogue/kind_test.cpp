// What a piece is, told by its name and its size.

#include <gtest/gtest.h>

#include <algorithm>

#include "modeler/catalogue/kind_table.h"
#include "modeler/catalogue/kind_words.h"
#include "modeler/furnishing/plain_words.h"

namespace enfilade::modeler::test {
namespace {

std::string kind(std::string_view name, std::array<double, 3> size = {}, double elevation = 0, std::string_view id = {},
                 std::string_view category = {}) {
    return kind_of_piece({name, id, category, size[0], size[1], size[2], elevation});
}

TEST(Kind, TheLongestWordsDecide) {
    EXPECT_EQ(kind("Coffee table"), "coffee_table");
    EXPECT_EQ(kind("Table lamp"), "table_lamp");
    EXPECT_EQ(kind("Desk"), "desk");
    EXPECT_EQ(kind("Desk lamp"), "desk_lamp");
    EXPECT_EQ(kind("OFFICE CHAIR"), "office_chair");
    EXPECT_EQ(kind("Blue washbasin with cabinet"), "wash_basin");
    EXPECT_EQ(kind("Chair with table"), "chair");
}

TEST(Kind, IsToldInFiveLanguages) {
    EXPECT_EQ(kind("K\xC3\xBC"
                   "chenschrank, Unterschrank"),
              "kitchen_unit");
    EXPECT_EQ(kind("B\xC3\xBCrostuhl"), "office_chair");
    EXPECT_EQ(kind("Chaise"), "chair");
    EXPECT_EQ(kind("Table basse"), "coffee_table");
    EXPECT_EQ(kind("Lampe de bureau"), "desk_lamp");
    EXPECT_EQ(kind("Letto matrimoniale"), "double_bed");
    EXPECT_EQ(kind("Tavolo da pranzo"), "dining_table");
    EXPECT_EQ(kind("Silla de oficina"), "office_chair");
    EXPECT_EQ(kind("Frigor\xC3\xAD"
                   "fico"),
              "fridge");
}

TEST(Kind, SizeTellsBedsTablesAndLampsApart) {
    EXPECT_EQ(kind("Bed", {0.9, 2, 0.6}), "bed");
    EXPECT_EQ(kind("Bed", {1.6, 2, 0.6}), "double_bed");
    EXPECT_EQ(kind("Bed", {0.16, 0.2, 0.06}), "");
    EXPECT_EQ(kind("Table", {1.4, 0.9, 0.74}), "dining_table");
    EXPECT_EQ(kind("Table", {1, 0.6, 0.45}), "coffee_table");
    EXPECT_EQ(kind("Lamp", {0.3, 0.3, 0.5}), "table_lamp");
    EXPECT_EQ(kind("Lamp", {0.4, 0.4, 1.6}), "floor_lamp");
    EXPECT_EQ(kind("Lamp", {0.4, 0.4, 0.5}, 2), "ceiling_lamp");
    EXPECT_EQ(kind("Fluorescent light", {1.05, 0.24, 0.11}, 2.4), "office_lamp");
    EXPECT_EQ(kind("Shelf", {0.8, 0.2, 0.3}, 1.3), "wall_shelf");
    EXPECT_EQ(kind("Chair", {80, 60, 90}), "");  // a unit error
}

TEST(Kind, WhatOnlyHoldsTheWordIsNone) {
    EXPECT_EQ(kind("Shower curtain"), "");
    EXPECT_EQ(kind("Toilet brush"), "");
    EXPECT_EQ(kind("Bathmat", {0.73, 0.47, 0.012}), "");  // no rug for libraries
    EXPECT_EQ(kind("Basin", {0.56, 0.41, 0.27}), "");     // a bowl for a worktop
    EXPECT_EQ(kind("Washbasin", {0.62, 0.62, 0.5}, 0.46), "wash_basin");
    EXPECT_EQ(kind("Pool table"), "");
    EXPECT_EQ(kind("Bedrock"), "");
    EXPECT_EQ(kind("Chairlift"), "");
    EXPECT_EQ(kind("Spiral staircase"), "");
    EXPECT_EQ(kind("Bench", {1.5, 0.5, 0.8}, 0, "", "Exterior"), "");
    EXPECT_EQ(kind("Bicycle", {0.5, 1.5, 0.9}, 0, "", "Vehicles"), "bicycle");
    EXPECT_EQ(kind(""), "");
}

TEST(Kind, TheIdMaySayMore) {
    EXPECT_EQ(kind("Chair", {0.6, 0.6, 1}, 0, "Scopia#office_chair"), "office_chair");
    EXPECT_EQ(kind("Glossy 3", {0.6, 0.35, 0.7}, 1.4, "eTeks#kitchenUpperCabinet"), "wall_cabinet");
    EXPECT_EQ(kind("Sofa", {2, 0.9, 0.8}, 0, "Kator#mid-century-bench"), "sofa");
}

TEST(Kind, EveryPhraseOfTheTableIsFoundByItself) {
    // Written as names are plainly; a phrase with an accent or a digit would never be found.
    for (const KindWords& row : kind_table()) {
        std::string_view rest = row.phrases;
        while (!rest.empty()) {
            const std::size_t end = std::min(rest.find('|'), rest.size());
            const std::string phrase(rest.substr(0, end));
            rest.remove_prefix(std::min(end + 1, rest.size()));
            EXPECT_EQ(plain_words(phrase), phrase);
            const std::array<double, 3> middle = {(row.width[0] + row.width[1]) / 2, (row.depth[0] + row.depth[1]) / 2,
                                                  (row.height[0] + row.height[1]) / 2};
            EXPECT_NE(kind(phrase, middle, (row.elevation[0] + row.elevation[1]) / 2), "")
                << row.kind << ": " << phrase;
        }
    }
}

}  // namespace
}  // namespace enfilade::modeler::test
