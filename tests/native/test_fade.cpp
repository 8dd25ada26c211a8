// SPDX-License-Identifier: GPL-3.0-or-later
// Partial visibility blends one pen into the other, and nothing fades where samples are whole.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include <fovea/stroke/fade.h>

#include "stroke_fixture.h"

namespace fovea {
using namespace draw;
namespace {

using namespace stroke_fixture;

/// A straight horizontal piece of 100 px with its middle at x = 60, one sample each 2 px, in two segments.
struct Line {
    ClippedPaths clipped;
    std::vector<float> visibility;

    explicit Line(std::vector<float> samples) : visibility(std::move(samples)) {
        add_piece(clipped, {{10.0f, 20.0f}, {40.0f, 20.0f}, {110.0f, 20.0f}});
        clipped.sample_start = {0, 15, 50};
        clipped.sample_count = {15, 35, 0};
        clipped.samples = 50;
    }

    static double arc(int sample) { return -49.0 + 2.0 * sample; }

    Fade fade(double start, double end, bool hidden = false) const {
        Fade found;
        find_fade(clipped, visibility, 0, start, end, hidden, found);
        return found;
    }

    /// Alpha along the middle of the piece, of the visible run with its pen and the hidden rest with another.
    std::vector<float> drawn(const Runs& runs, bool visible_pen, bool hidden_pen) const {
        const Pen pens[2] = {pen(4.0f, Cap::butt), pen(4.0f, Cap::butt)};
        std::vector<Index> pen_of_run;
        for (std::uint8_t hidden_by : runs.invisibility)
            pen_of_run.push_back(hidden_by ? (hidden_pen ? 1 : none) : (visible_pen ? 0 : none));
        const Strokes strokes = tessellate(clipped, runs, pen_of_run, {}, pens, visibility);
        const Array<vec4> image = rasterize(strokes, pens, {}, 120, 40);
        std::vector<float> row;
        for (int x = 0; x < 120; ++x) row.push_back(image[20 * 120 + x].a);
        return row;
    }
};

/// Seen as far as sample `first`, then as `ramp` says, then hidden.
std::vector<float> falling(int first, const std::vector<float>& ramp) {
    std::vector<float> samples(50, 0.0f);
    std::fill_n(samples.begin(), first, 1.0f);
    std::copy(ramp.begin(), ramp.end(), samples.begin() + first);
    return samples;
}

Runs parts(double change) {
    Runs runs;
    runs.push(0, -50.0, change, 0);
    runs.push(0, change, 50.0, 1);
    return runs;
}

TEST(Fade, FollowsTheSamplesAroundAnEnd) {
    const Line line(falling(20, {0.9f, 0.6f, 0.2f}));
    const Fade fade = line.fade(-50.0, Line::arc(21) + 0.5);
    EXPECT_EQ(fade.share, (Array<float>{1.0f, 0.9f, 0.6f, 0.2f, 0.0f}));
    ASSERT_EQ(fade.arc.size(), 5u);
    for (int k = 0; k < 5; ++k) EXPECT_NEAR(fade.arc[k], Line::arc(19 + k), 1e-9);
    EXPECT_EQ(fade.start_px, -50.0);
    EXPECT_NEAR(fade.end_px, Line::arc(23), 1e-9);
    EXPECT_FALSE(fade.at_start);
}

TEST(Fade, OfTheHiddenPartIsWhatIsLeft) {
    const Line line(falling(20, {0.9f, 0.6f, 0.2f}));
    const double change = Line::arc(21) + 0.5;
    const Fade seen = line.fade(-50.0, change), hidden = line.fade(change, 50.0, true);
    ASSERT_EQ(seen.arc, hidden.arc);
    for (std::size_t k = 0; k < seen.share.size(); ++k) EXPECT_NEAR(seen.share[k] + hidden.share[k], 1.0, 1e-6);
    EXPECT_NEAR(hidden.start_px, Line::arc(19), 1e-9);
}

TEST(Fade, OneEndMayBeginAndTheOtherEndIt) {
    std::vector<float> samples(50, 0.0f);
    const std::vector<float> hump{0.3f, 0.7f, 1.0f, 0.8f, 0.1f};
    std::copy(hump.begin(), hump.end(), samples.begin() + 12);  // across the two segments
    const Fade fade = Line(samples).fade(Line::arc(13) - 1.0, Line::arc(15) + 1.0);
    EXPECT_EQ(fade.share, (Array<float>{0.0f, 0.3f, 0.7f, 1.0f, 0.8f, 0.1f, 0.0f}));
    EXPECT_NEAR(fade.start_px, Line::arc(11), 1e-9);
    EXPECT_NEAR(fade.end_px, Line::arc(17), 1e-9);
}

TEST(Fade, WholeSamplesAndNoneLeaveEndsSharp) {
    EXPECT_TRUE(Line(falling(20, {})).fade(-50.0, Line::arc(19) + 1.0).arc.empty());
    EXPECT_TRUE(Line(std::vector<float>(50, 1.0f)).fade(-50.0, 50.0).arc.empty());
    const Line partial(falling(20, {0.5f}));
    EXPECT_TRUE(partial.fade(-50.0, Line::arc(10)).arc.empty()) << "a halo moved the end to where all is seen";
    EXPECT_TRUE(partial.fade(-50.0, Line::arc(30)).arc.empty()) << "overshoot moved it to where nothing is";
    Fade none_given;
    find_fade(partial.clipped, {}, 0, -50.0, 0.0, false, none_given);
    EXPECT_TRUE(none_given.arc.empty());
    EXPECT_EQ(none_given.end_px, 0.0);
}

TEST(Fade, AtTheEndsOfAPieceItStaysAsItIs) {
    const Line line(std::vector<float>(50, 0.6f));
    const Fade fade = line.fade(-50.0, 50.0);
    EXPECT_EQ(fade.arc.size(), 50u);
    const std::vector<float> row = line.drawn(parts(50.0), true, false);
    for (int x = 11; x < 109; ++x) EXPECT_NEAR(row[x], 0.6f, 1e-5f) << x;
}

TEST(Fade, BrokenSamplesAreHidden) {
    const Line line(falling(20, {0.6f, NAN, -3.0f}));
    EXPECT_EQ(line.fade(-50.0, Line::arc(20) + 0.3).share, (Array<float>{1.0f, 0.6f, 0.0f}));
}

TEST(Fade, InkFollowsVisibilityAndBothPensTogetherCoverTheLine) {
    const Line line(falling(20, {0.75f, 0.5f, 0.25f}));
    const Runs runs = parts(Line::arc(21));
    const std::vector<float> seen = line.drawn(runs, true, false), hidden = line.drawn(runs, false, true);
    for (int x = 12; x < 108; ++x) {
        const double sample = (x + 0.5 - 60.0 + 49.0) / 2.0;
        const double expected = std::clamp(1.0 - (sample - 19.0) / 4.0, 0.0, 1.0);
        EXPECT_NEAR(seen[x], expected, 0.02) << x;
        EXPECT_NEAR(seen[x] + hidden[x], 1.0, 0.02) << x;
    }
}

TEST(Fade, SamplesOfOtherPathsAreRefused) {
    const Line line(std::vector<float>(49, 1.0f));
    EXPECT_THROW(line.drawn(parts(0.0), true, true), std::invalid_argument);
}

TEST(Overshoot, RunsBeyondTheirPieceGoStraightOn) {
    ClippedPaths clipped;
    add_piece(clipped, {{40.0f, 20.0f}, {60.0f, 20.0f}, {60.0f, 60.0f}});
    Runs runs;
    add_run(runs, 0, -30.0 - 12.0, 30.0 + 7.0);
    const Pen p = pen(4.0f, Cap::butt);
    const auto image = picture(strokes_of(clipped, runs, p), p, 100, 100);
    const auto at = [&](int x, int y) { return image[y * 100 + x].a; };
    EXPECT_EQ(at(29, 20), 1.0f);
    EXPECT_EQ(at(26, 20), 0.0f);
    EXPECT_EQ(at(60, 65), 1.0f);
    EXPECT_EQ(at(60, 69), 0.0f);
    EXPECT_NEAR(area(image), 4.0 * (60.0 + 19.0), 1.0);
}

}  // namespace
}  // namespace fovea
