#include "gmap/text.h"

#include <sstream>
#include <stdexcept>

#include "gmap/insert.h"
#include "maps.h"

namespace enfilade::gmap {
namespace {

Map read(const std::string& text) {
    std::istringstream in(text);
    return read_text(in);
}

std::string message_for(const std::string& text) {
    try {
        (void)read(text);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "read without complaint";
}

TEST(Text, ReadsWhatItWrote) {
    for (const Map& map : {grid(2, 1, 2), built(prism_tuples(5)), Map()}) {
        std::ostringstream out;
        write_text(map, out);
        const Map again = read(out.str());
        EXPECT_EQ(again.arrays().alpha, map.arrays().alpha);
        EXPECT_EQ(again.arrays().cell_id, map.arrays().cell_id);
        EXPECT_EQ(cell_counts(again), cell_counts(map));
    }
}

TEST(Text, WritesAMapWithGapsCompacted) {
    Map map = grid(2, 2, 1);
    const auto changes = insert_vertex(map, DartId{0});
    ASSERT_TRUE(changes && remove_vertex(map, changes->dart));
    std::ostringstream out;
    write_text(map, out);
    map.compact();
    EXPECT_EQ(read(out.str()).arrays().alpha, map.arrays().alpha);
}

TEST(Text, KeepsUnsoundMapsAsTheyAre) {
    const Map broken = edited(cube(), [](MapArrays& arrays) { arrays.alpha[2][5] = 5; });
    std::ostringstream out;
    write_text(broken, out);
    EXPECT_EQ(read(out.str()).arrays().alpha, broken.arrays().alpha);
}

TEST(Text, AllowsCommentsAndBlankLines) {
    const Map map = read(
        "# a dart\nenfilade-gmap 1\n\ndarts 1 vertices 1 edges 1 faces 1 volumes 1 # counts\n0 0 0 0  0 0 0 0\n\n");
    EXPECT_EQ(map.dart_count(), 1u);
}

TEST(Text, SaysWhichLineIsWrong) {
    const std::string head = "enfilade-gmap 1\ndarts 1 vertices 1 edges 1 faces 1 volumes 1\n";
    EXPECT_NE(message_for("").find("Line 1"), std::string::npos);
    EXPECT_NE(message_for("enfilade-gmap 2\n").find("Line 1"), std::string::npos);
    EXPECT_NE(message_for("enfilade-gmap 1\ndarts x\n").find("Line 2"), std::string::npos);
    EXPECT_NE(message_for(head + "0 0 0 0 0 0 0\n").find("Line 3"), std::string::npos);
    EXPECT_NE(message_for(head + "0 0 0 0 0 0 0 -1\n").find("Line 3"), std::string::npos);
    EXPECT_NE(message_for(head + "0 0 0 0 0 0 0 0 0\n").find("Line 3"), std::string::npos);
    EXPECT_NE(message_for(head + "0 0 0 0 0 0 0 0\n0 0 0 0 0 0 0 0\n").find("Line 4"), std::string::npos);
    EXPECT_NE(message_for(head).find("Line 3"), std::string::npos);
    EXPECT_NE(message_for(head + "0 0 0 1 0 0 0 0\n").find("alpha3 of dart 0"), std::string::npos);
    EXPECT_NE(message_for(head + "99999999999 0 0 1 0 0 0 0\n").find("Line 3"), std::string::npos);
}

}  // namespace
}  // namespace enfilade::gmap
