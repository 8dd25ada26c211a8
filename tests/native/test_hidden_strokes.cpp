// SPDX-License-Identifier: GPL-3.0-or-later
// Pens by line set and invisibility, and hidden strokes below visible ones.
#include <gtest/gtest.h>
#include <random>

#include <fovea/draw/pens.h>

#include "stroke_fixture.h"

namespace fovea {
using namespace draw;
namespace {

using namespace stroke_fixture;

constexpr Index endless = 255;

/// Two crossing pieces, one of each of two line sets, in parts that 0, 1, 2, 3 and 200 surfaces hide.
struct Cross {
    ClippedPaths clipped;
    Runs runs;
    std::vector<std::uint8_t> line_set{0, 1};

    Cross() {
        add_piece(clipped, {{10.0f, 32.0f}, {60.0f, 32.0f}});
        add_piece(clipped, {{35.0f, 7.0f}, {35.0f, 57.0f}});
        const std::uint8_t hidden_by[] = {0, 1, 2, 3, 200};
        for (Index piece = 0; piece < 2; ++piece)
            for (int part = 0; part < 5; ++part)
                add_run(runs, piece, -25.0 + 10.0 * part, -15.0 + 10.0 * part, hidden_by[part]);
    }

    Array<Index> pens(std::vector<PenRange> ranges) const { return pens_of_runs(clipped, runs, line_set, ranges); }
};

TEST(HiddenStrokes, APenDrawsTheRangeOfItsLineSet) {
    const Cross cross;
    const Array<Index> pens = cross.pens({{0, 0, 0, 0}, {1, 0, 0, 1}, {0, 1, 2, 2}, {1, 3, endless, 3}});
    EXPECT_EQ(pens, (Array<Index>{0, 2, 2, none, none, 1, none, none, 3, 3}));
}

TEST(HiddenStrokes, OfTwoRangesTheFirstDraws) {
    const Array<Index> pens = Cross().pens({{0, 2, 2, 4}, {0, 0, endless, 5}});
    EXPECT_EQ(Array<Index>(pens.begin(), pens.begin() + 5), (Array<Index>{5, 5, 4, 5, 5}));
}

TEST(HiddenStrokes, WithoutRangesNothingIsDrawn) {
    const Cross cross;
    const Pen p = pen(2.0f);
    EXPECT_EQ(tessellate(cross.clipped, cross.runs, cross.pens({}), {}, {&p, 1}).count, 0u);
}

TEST(HiddenStrokes, WrongInputIsNamed) {
    Cross cross;
    cross.line_set.pop_back();
    EXPECT_THROW(cross.pens({}), std::invalid_argument);
    cross.line_set.push_back(0);
    cross.clipped.path.pop_back();
    EXPECT_THROW(cross.pens({}), std::invalid_argument);
}

TEST(HiddenStrokes, TheMostHiddenLieBelow) {
    // One piece over the same pixels as the other, each hidden by so many.
    for (const auto& [first, second] : {std::pair{0, 1}, {1, 0}, {1, 2}, {200, 3}}) {
        ClippedPaths clipped;
        for (int i = 0; i < 2; ++i) add_piece(clipped, {{10.0f, 32.0f}, {54.0f, 32.0f}});
        Runs runs;
        add_run(runs, 0, -22.0, 22.0, std::uint8_t(first));
        add_run(runs, 1, -22.0, 22.0, std::uint8_t(second));
        Pen pens[2] = {pen(8.0f), pen(8.0f)};
        pens[first < second ? 0 : 1].look.color = {1.0f, 0.0f, 0.0f};
        const std::vector<Index> pen_of_run{0, 1};
        const Array<vec4> image = rasterize(tessellate(clipped, runs, pen_of_run, {}, pens), pens, {}, 64, 64);
        EXPECT_EQ(image[32 * 64 + 32], vec4(1.0f, 0.0f, 0.0f, 1.0f)) << first << " " << second;
    }
}

TEST(HiddenStrokes, ThoseHiddenAlikeKeepTheirOrder) {
    ClippedPaths clipped;
    Runs runs;
    std::vector<Index> pen_of_run;
    std::mt19937 random(5);
    std::vector<Pen> pens(500, pen(2.0f));
    for (Index q = 0; q < 500; ++q) {
        add_piece(clipped, {{10.0f, float(q)}, {54.0f, float(q)}});
        add_run(runs, q, -22.0, 22.0, std::uint8_t(random() % 4));
        pen_of_run.push_back(q % 7 ? q : none);
    }
    const Strokes strokes = tessellate(clipped, runs, pen_of_run, {}, pens);
    int hidden_before = 255;
    Index pen_before = 0, seen = 0;
    for (const glm::uvec3 t : strokes.triangles) {
        const Index drawn = strokes.pen[t.x];
        const int hidden_by = runs.invisibility[drawn];
        ASSERT_LE(hidden_by, hidden_before);
        ASSERT_TRUE(hidden_by < hidden_before || drawn >= pen_before);
        seen += seen == 0 || drawn != pen_before;
        hidden_before = hidden_by;
        pen_before = drawn;
    }
    EXPECT_EQ(seen, 500u - 72u);
    EXPECT_EQ(strokes.count, seen);
}

}  // namespace
}  // namespace fovea
