#include "core/export/frame_sequence.h"

#include "core/base/error.h"

#include <gtest/gtest.h>

namespace chiaro::exporting {
namespace {

TEST(FrameSequence, NumbersItsFiles) {
    const FrameSequence sequence("shots/a.b.####.png");
    EXPECT_EQ(sequence.path(7), "shots/a.b.0007.png");
    EXPECT_EQ(sequence.path(123456), "shots/a.b.123456.png");
    EXPECT_EQ(FrameSequence("#.exr").path(3), "3.exr");
}

TEST(FrameSequence, RefusesNamesWithoutAPlaceForTheNumber) {
    EXPECT_THROW(FrameSequence("a.png"), Error);
    EXPECT_THROW(FrameSequence("a#b#.png"), Error);
    EXPECT_THROW(FrameSequence("a.####"), Error);
    EXPECT_THROW(FrameSequence("a.####.doc"), Error);
    EXPECT_THROW(FrameSequence("####/a.png"), Error);
}

TEST(FrameRange, ReadsOneFrameOrTwo) {
    EXPECT_EQ(FrameRange::parse("12").first, 12);
    EXPECT_EQ(FrameRange::parse("12").count(), 1);
    EXPECT_EQ(FrameRange::parse("3-9").count(), 7);
    for (const char* wrong : {"", "0", "0-3", "5-3", "a", "1-", "-3", "1-2-3", "1.5", "1-99999999999"})
        EXPECT_THROW(FrameRange::parse(wrong), Error) << wrong;
}

}  // namespace
}  // namespace chiaro::exporting
