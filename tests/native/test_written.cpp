// SPDX-License-Identifier: GPL-3.0-or-later
// Lines that write themselves: how much of a path is there, which part, and how it ends.
#include <gtest/gtest.h>

#include "stroke_fixture.h"

namespace fovea {
using namespace draw;
namespace {

using namespace stroke_fixture;

Pen written(double share, double taper = 0.0) {
    Pen p = pen(4.0f, Cap::butt);
    p.look.written = share;
    p.look.taper = taper;
    return p;
}

/// Length of what is drawn of lines [px].
double length_of(const ClippedPaths& clipped, const Runs& runs, const Pen& pen) {
    return area(picture(strokes_of(clipped, runs, pen), pen, 400, 200)) / pen.width_px;
}

ClippedPaths one(const std::vector<vec2>& line, bool closed = false) {
    ClippedPaths clipped;
    add_piece(clipped, line, closed);
    return clipped;
}

TEST(Written, IsAsLongAsItsShareOfTheLength) {
    const ClippedPaths bent = one({{20, 30}, {150, 30}, {250, 80}, {380, 80}});
    const ClippedPaths loop = one(circle({200, 100}, 60, 90), true);
    for (const double share : {0.0, 0.01, 0.25, 0.5, 0.77, 0.99, 1.0}) {
        const Pen pen = written(share);
        EXPECT_NEAR(length_of(bent, whole_runs(bent), pen), share * bent.path_length_px[0], 1.0) << share;
        EXPECT_NEAR(length_of(loop, whole_runs(loop), pen), share * loop.path_length_px[0], 1.0) << share;
    }
}

TEST(Written, BeginsAtTheStart) {
    const ClippedPaths line = one({{20, 50}, {380, 50}});
    const Pen half = written(0.5);
    const Strokes strokes = strokes_of(line, whole_runs(line), half);
    float last = 0.0f, first = 400.0f;
    for (const vec2& px : strokes.px) {
        last = std::max(last, px.x);
        first = std::min(first, px.x);
    }
    EXPECT_NEAR(first, 20.0f, 1.0f);
    EXPECT_NEAR(last, 200.0f, 1.0f);
}

TEST(Written, CountsTheWholePathWhateverHidesPartsOfIt) {
    const ClippedPaths line = one({{20, 50}, {380, 50}});  // u from -180 to 180
    Runs seen;
    add_run(seen, 0, -100, -40);
    add_run(seen, 0, 20, 120);
    EXPECT_EQ(length_of(line, seen, written(0.2)), 0.0) << "the pen is at -108";
    EXPECT_NEAR(length_of(line, seen, written(0.4)), 60.0, 0.5) << "at -36";
    EXPECT_NEAR(length_of(line, seen, written(0.75)), 130.0, 0.5) << "at 90";
}

TEST(Written, IncludesOvershootAndComesToItWithoutAJump) {
    const ClippedPaths line = one({{50, 50}, {250, 50}});
    Runs longer;
    add_run(longer, 0, -120, 130);
    EXPECT_NEAR(length_of(line, longer, written(1.0)), 250.0, 0.5);
    EXPECT_NEAR(length_of(line, longer, written(0.996)), 249.0, 0.5);
    EXPECT_NEAR(length_of(line, longer, written(0.5)), 125.0, 0.5);
}

TEST(Written, ChangesNothingOfWhatIsThereAlready) {
    const ClippedPaths line = one({{20, 50}, {380, 50}});
    const auto drawn = [&](double share) {
        const Pen p = written(share, 100.0);
        return picture(strokes_of(line, whole_runs(line), p), p, 400, 100);
    };
    const auto whole = drawn(1.0), part = drawn(0.9);
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 340; ++x) EXPECT_NEAR(part[y * 400 + x].a, whole[y * 400 + x].a, 1e-3f) << x << ' ' << y;
}

TEST(Written, ASmallStepOfItChangesLittle) {
    const ClippedPaths loop = one(circle({200, 100}, 60, 90), true);
    double before = 0.0;
    for (int k = 1; k <= 200; ++k) {
        const double length = length_of(loop, whole_runs(loop), written(k / 200.0));
        EXPECT_NEAR(length - before, loop.path_length_px[0] / 200.0, 1.0) << k;
        before = length;
    }
}

}  // namespace
}  // namespace fovea
