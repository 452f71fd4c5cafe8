#include "core/synthesis/boundary_cut.h"

#include <gtest/gtest.h>

namespace chiaro::synthesis {
namespace {

// '.' nothing, '#' texture, 'o' outside.
Image<Under> layout(const std::vector<std::string>& rows) {
    Image<Under> under(int(rows[0].size()), int(rows.size()));
    for (int y = 0; y < under.height(); ++y)
        for (int x = 0; x < under.width(); ++x) {
            const char c = rows[std::size_t(y)][std::size_t(x)];
            under(x, y) = c == '#' ? Under::Texture : c == 'o' ? Under::Outside : Under::Nothing;
        }
    return under;
}

// A digit is an error.
ScalarImage errors(const std::vector<std::string>& rows) {
    ScalarImage error(int(rows[0].size()), int(rows.size()));
    for (int y = 0; y < error.height(); ++y)
        for (int x = 0; x < error.width(); ++x)
            error(x, y) = float(rows[std::size_t(y)][std::size_t(x)] - '0');
    return error;
}

// '#' stays, '.' is replaced.
std::vector<std::string> cut(const Image<Under>& under, const ScalarImage& error, int reach = 256) {
    const Image<std::uint8_t> stays = boundaryCut(under, error, reach);
    std::vector<std::string> rows;
    for (int y = 0; y < stays.height(); ++y) {
        rows.emplace_back();
        for (int x = 0; x < stays.width(); ++x) rows.back() += stays(x, y) ? '#' : '.';
    }
    return rows;
}

using Rows = std::vector<std::string>;

TEST(BoundaryCut, FollowsTheLeastErrorThroughTheLeftOverlap) {
    EXPECT_EQ(cut(layout({"###..", "###..", "###..", "###.."}), errors({"90900", "99000", "90900", "09900"})),
              Rows({"#....", "##...", "#....", "....."}));
}

TEST(BoundaryCut, StepsAsideByOnePixelAtMost) {
    // The free pixel of the last row is two columns away: it costs less to stay straight.
    EXPECT_EQ(cut(layout({"####.", "####.", "####."}), errors({"09990", "09990", "99900"})),
              Rows({".....", ".....", "....."}));
}

TEST(BoundaryCut, FollowsTheTopOverlap) {
    EXPECT_EQ(cut(layout({"####", "####", "####", "....", "...."}),
                  errors({"9999", "0990", "9009", "0000", "0000"})),
              Rows({"####", ".##.", "....", "....", "...."}));
}

TEST(BoundaryCut, CutsAnL) {
    const Rows stays = cut(layout({"#####", "#####", "##...", "##...", "##..."}),
                           errors({"98999", "80000", "90000", "90000", "90000"}));
    EXPECT_EQ(stays, Rows({"#####", "#....", "#....", "#....", "#...."}));
}

TEST(BoundaryCut, CutsAllFourSides) {
    const Rows stays = cut(layout({"######", "######", "##..##", "##..##", "######", "######"}),
                           errors({"989989", "800008", "900009", "900009", "800008", "989989"}));
    EXPECT_EQ(stays, Rows({"######", "#....#", "#....#", "#....#", "#....#", "######"}));
}

TEST(BoundaryCut, KeepsWhatLiesDeeperThanItsReach) {
    // Texture that was there before the quilting began; the cut stays within two pixels of its edge.
    EXPECT_EQ(cut(layout({"#####.", "#####.", "#####."}), errors({"000000", "000000", "000000"}), 2),
              Rows({"###...", "###...", "###..."}));
}

TEST(BoundaryCut, FollowsARaggedEdge) {
    EXPECT_EQ(cut(layout({"#####.", "##....", "......", "###..."}),
                  errors({"999900", "900000", "000000", "900000"})),
              Rows({"####..", "#.....", "......", "#....."}));
}

TEST(BoundaryCut, CutsFreelyOutside) {
    // The path runs past the end of the texture where the picture ends there, and pays nothing.
    EXPECT_EQ(cut(layout({"#oo#.", "###..", "#oo.."}), errors({"90090", "99000", "90000"})),
              Rows({"#....", "##...", "#...."}));
}

TEST(BoundaryCut, KeepsAnIsland) {
    const Rows island{".....", ".....", "..#..", ".....", "....."};
    EXPECT_EQ(cut(layout(island), errors({"00000", "00000", "00000", "00000", "00000"})), island);
}

TEST(BoundaryCut, ReplacesNothingWhereNothingIsMissing) {
    const Rows stays = cut(layout({"###", "###", "###"}), errors({"123", "456", "789"}));
    EXPECT_EQ(stays, Rows({"###", "###", "###"}));
}

TEST(BoundaryCut, LeavesAnEmptyBlockEmpty) {
    EXPECT_EQ(cut(layout({"..o", "..."}), errors({"000", "000"})), Rows({"...", "..."}));
}

}  // namespace
}  // namespace chiaro::synthesis
