// SPDX-License-Identifier: GPL-3.0-or-later
// Strokes on their way from the pen in focus to the one out of focus.
#include <gtest/gtest.h>

#include "stroke_fixture.h"

namespace fovea {
using namespace draw;
namespace {

using namespace stroke_fixture;

constexpr int count = 100;  // samples along the line

/// A straight line of 200 px with a sample every 2 px.
ClippedPaths sampled_line() {
    ClippedPaths clipped;
    add_piece(clipped, {{20, 20}, {220, 20}});
    clipped.sample_start = {0, count};
    clipped.sample_count = {count, 0};
    clipped.samples = count;
    return clipped;
}

struct Drawn {
    ClippedPaths clipped = sampled_line();
    std::vector<Pen> pens;
    Strokes strokes;

    Drawn(const Pen& in_focus, const Pen& out_of_focus, const Emphasis& emphasis) : pens{in_focus, out_of_focus} {
        pens[0].away = 1;
        const Index pen[] = {0};
        strokes = tessellate(clipped, whole_runs(clipped), pen, {}, pens, {}, emphasis);
    }

    /// out(way along the line in [0,1], vertex) for each vertex between the caps.
    template <typename Out>
    void each(const Out& out) const {
        for (Index i = 0; i < strokes.px.size(); ++i) {
            const float t = (strokes.arc[i].x + 100.0f) / 200.0f;
            if (t > 0.01f && t < 0.99f) out(t, i);
        }
    }
};

Pen pen_of(float width, float opacity) {
    Pen made;
    made.width_px = width;
    made.look.opacity = opacity;
    return made;
}

/// t squared: it bends everywhere, so that there are vertices to ask.
std::vector<float> rising() {
    std::vector<float> f(count);
    for (int i = 0; i < count; ++i) f[i] = (i + 0.5f) / count * ((i + 0.5f) / count);
    return f;
}

TEST(Emphasis, LeadsWidthAndOpacityFromOnePenToTheOther) {
    const std::vector<float> f = rising();
    Emphasis emphasis;
    emphasis.focus = f;
    const Drawn drawn(pen_of(2, 1.0f), pen_of(6, 0.5f), emphasis);
    int seen = 0;
    drawn.each([&](float t, Index i) {
        EXPECT_NEAR(drawn.strokes.half_width[i], 1.0f + 2.0f * t * t, 0.06f);
        EXPECT_NEAR(drawn.strokes.opacity[i], 1.0f - 0.5f * t * t, 0.03f);
        EXPECT_NEAR(drawn.strokes.mix[i].x, t * t, 0.03f);
        ++seen;
    });
    EXPECT_GT(seen, 0);
}

TEST(Emphasis, TransfersDecideHowFar) {
    const std::vector<float> f(count, 1.0f);
    Emphasis emphasis;
    emphasis.focus = f;
    emphasis.width = Transfer(0, 1, 0.5f, {});
    emphasis.opacity = Transfer(0, 1, 0.0f, {});
    emphasis.color = Transfer(0, 1, 0.25f, {});
    const Drawn drawn(pen_of(2, 1.0f), pen_of(6, 0.5f), emphasis);
    drawn.each([&](float, Index i) {
        EXPECT_FLOAT_EQ(drawn.strokes.half_width[i], 2.0f);
        EXPECT_FLOAT_EQ(drawn.strokes.opacity[i], 1.0f);
        EXPECT_EQ(drawn.strokes.mix[i], vec4(0.25f, 1.0f, 0.0f, 0.0f));
    });
}

TEST(Emphasis, DistanceAndFocusActTogether) {
    const std::vector<float> half(count, 0.5f);
    Emphasis emphasis;
    emphasis.focus = emphasis.distance = half;
    emphasis.distance_width = Transfer(0, 1, 0.0f, {});
    const Drawn drawn(pen_of(2, 1.0f), pen_of(6, 0.0f), emphasis);
    drawn.each([&](float, Index i) {
        EXPECT_FLOAT_EQ(drawn.strokes.half_width[i], 2.0f);
        EXPECT_FLOAT_EQ(drawn.strokes.opacity[i], 0.25f);
    });
}

TEST(Emphasis, WithoutItStrokesAreThoseOfThePenInFocus) {
    const Drawn drawn(pen_of(2, 0.7f), pen_of(6, 0.5f), {});
    const Pen alone = pen_of(2, 0.7f);
    const Strokes expected = strokes_of(drawn.clipped, whole_runs(drawn.clipped), alone);
    EXPECT_EQ(drawn.strokes.half_width, expected.half_width);
    EXPECT_EQ(drawn.strokes.opacity, expected.opacity);
    EXPECT_EQ(drawn.strokes.px, expected.px);
}

TEST(Emphasis, WhatIsNotShownFadesWhereItEnds) {
    std::vector<float> shown(count, 1.0f);
    for (int i = 50; i < count; ++i) shown[i] = 0.0f;
    Emphasis emphasis;
    emphasis.shown = shown;
    const Drawn drawn(pen_of(2, 1.0f), pen_of(2, 1.0f), emphasis);
    drawn.each([&](float t, Index i) {
        if (t < 0.49f || t > 0.51f) {
            EXPECT_FLOAT_EQ(drawn.strokes.opacity[i], t < 0.5f ? 1.0f : 0.0f) << t;
        }
    });
}

TEST(Emphasis, OfOneRunShowsNothingOfWhatIsBesideIt) {
    // Samples lie at -99, -97, ...: where no run is, elision takes nothing away.
    const ClippedPaths clipped = sampled_line();
    for (const auto& [start, end] :
         {std::pair(-21.5, 29.5), {-20.5, 30.5}, {-21.9, -21.6}, {-20.2, -19.8}, {-100.0, -99.7}, {99.9, 100.0}}) {
        std::vector<float> shown(count, 1.0f);
        for (int i = 0; i < count; ++i)
            if (start < 2 * i - 98 && end > 2 * i - 100) shown[i] = 0.25f;
        Emphasis emphasis;
        emphasis.shown = shown;
        EmphasisAlong along;
        find_emphasis(clipped, emphasis, 0, start, end, along);
        ASSERT_FALSE(along.shown.empty());
        for (float left : along.shown) EXPECT_EQ(left, 0.25f) << start;
    }
}

TEST(Emphasis, PictureBlendsColorsAndInk) {
    const std::vector<float> half(count, 0.5f);
    Emphasis emphasis;
    emphasis.focus = half;
    Pen red = pen_of(8, 1.0f), blue = pen_of(8, 1.0f);
    red.look.color = {1, 0, 0};
    blue.look.color = {0, 0, 1};
    blue.texture = 0;
    const PenTexture faint{1, 1, {0.5f}};
    const Drawn drawn(red, blue, emphasis);
    const Array<vec4> image = rasterize(drawn.strokes, drawn.pens, {&faint, 1}, 240, 40);
    const vec4 middle = image[20 * 240 + 120];
    EXPECT_NEAR(middle.a, 0.75f, 1e-5f);
    EXPECT_NEAR(middle.r, 0.375f, 1e-5f);
    EXPECT_NEAR(middle.b, 0.375f, 1e-5f);
}

TEST(Emphasis, RefusesArraysOfAnotherLength) {
    const std::vector<float> few(3, 0.5f);
    Emphasis emphasis;
    emphasis.focus = few;
    EXPECT_THROW(Drawn(pen_of(2, 1), pen_of(3, 1), emphasis), std::invalid_argument);
}

}  // namespace
}  // namespace fovea
