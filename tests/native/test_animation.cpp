// SPDX-License-Identifier: GPL-3.0-or-later
// Which drawing stands at a frame, and which one of the boil.
#include <gtest/gtest.h>

#include <fovea/style/json.h>

namespace fovea::style {
namespace {

TEST(Animation, OnTwosAndThreesADrawingStandsForAsManyFrames) {
    const Animation ones, twos{.hold = 2}, threes{.hold = 3, .start_frame = 101};
    for (int k = -10; k < 10; ++k) {
        EXPECT_EQ(ones.held(k), k);
        EXPECT_EQ(twos.held(2 * k + 1), 2 * k + 1);
        EXPECT_EQ(twos.held(2 * k + 2), 2 * k + 1);
        for (int frame = 0; frame < 3; ++frame) EXPECT_EQ(threes.held(101 + 3 * k + frame), 101 + 3 * k);
    }
}

TEST(Animation, DrawingsOfTheBoilFollowEachOtherInACycle) {
    const Animation boil{.boil = 0.5, .boil_hold = 2, .boil_cycle = 3};
    const int expected[] = {0, 0, 1, 1, 2, 2};
    for (int frame = -17; frame < 40; ++frame) EXPECT_EQ(boil.boil_drawing(frame + 1), expected[(frame + 60) % 6]);
}

TEST(Animation, WithoutBoilEveryDrawingIsTheFirst) {
    const Animation still{.boil_hold = 1};
    for (int frame = -5; frame < 5; ++frame) EXPECT_EQ(still.boil_drawing(frame), 0);
}

TEST(Animation, KeysOfMarksAreAsFarApartAsItSaysFromTheStartFrameOn) {
    const Animation marks{.start_frame = 5, .marks_frames = 4};
    for (int k = -5; k < 5; ++k)
        for (int since = 0; since < 4; ++since) EXPECT_EQ(marks.since_key(5 + 4 * k + since), since);
    EXPECT_EQ(Animation().since_key(7), 0);
}

TEST(Animation, StaysInAFile) {
    Style style;
    style.animation = {.hold = 3,
                       .boil = 0.25,
                       .boil_hold = 4,
                       .boil_cycle = 5,
                       .start_frame = -7,
                       .written = 0.5,
                       .marks_frames = 12};
    style.line_sets[0].pen.written = 0.75;
    EXPECT_EQ(read_style(write_style(style)), style);
}

}  // namespace
}  // namespace fovea::style
