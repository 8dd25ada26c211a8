// SPDX-License-Identifier: GPL-3.0-or-later
// Lines that break up through the texture of their pen.
#include <gtest/gtest.h>
#include <random>

#include <fovea/stroke/ink.h>

#include "stroke_fixture.h"

namespace fovea {
using namespace draw;
namespace {

using namespace stroke_fixture;

constexpr int width = 240, height = 40, samples = 100;

/// Noise of ink from 0.2 to 0.9, as fine as pixels.
PenTexture grain() {
    PenTexture texture{64, 8, {}};
    std::mt19937 random(5);
    std::uniform_real_distribution<float> ink(0.2f, 0.9f);
    for (int i = 0; i < 64 * 8; ++i) texture.ink.push_back(ink(random));
    return texture;
}

Pen pen_with(const PenTexture& texture) {
    Pen made = pen(8.0f, Cap::butt);
    made.texture = 0;
    made.texture_length_px = 64.0f;
    made.ink_levels = ink_levels(fit_texture(texture, made.texture_length_px, made.width_px));
    return made;
}

/// A line of 200 pixels, of which these shares are seen.
Array<vec4> drawn(const Pen& pen, const std::vector<float>& seen, const PenTexture& texture = grain()) {
    ClippedPaths clipped;
    add_piece(clipped, {{20, 20}, {220, 20}});
    clipped.sample_start = {0, samples};
    clipped.sample_count = {samples, 0};
    clipped.samples = samples;
    const Runs runs = whole_runs(clipped);
    const Index pens[] = {0};
    Emphasis emphasis;
    emphasis.seen = seen;
    Moment moment;
    moment.vanish = style::Vanish::break_up;
    const Inking inking{.clipped = clipped,
                        .runs = runs,
                        .pen_of_run = pens,
                        .strength = {},
                        .pens = {&pen, 1},
                        .emphasis = emphasis,
                        .moment = moment};
    return picture(tessellate(inking), pen, width, height, {&texture, 1});
}

Array<vec4> drawn_all(const Pen& pen, float seen) { return drawn(pen, std::vector<float>(samples, seen)); }

/// Pixels within the line with any ink, as a share of all.
double inked(const Array<vec4>& image) {
    int count = 0, all = 0;
    for (int y = 17; y < 23; ++y)
        for (int x = 30; x < 210; ++x, ++all) count += image[std::size_t(y) * width + x].a > 0.01f;
    return double(count) / all;
}

TEST(Vanish, OfATextureSoMuchIsLeftAsIsSeen) {
    const Pen pen = pen_with(grain());
    for (const float seen : {0.1f, 0.25f, 0.5f, 0.75f, 0.9f})
        EXPECT_NEAR(inked(drawn_all(pen, seen)), seen, 0.12) << seen;
    EXPECT_EQ(inked(drawn_all(pen, 0.0f)), 0.0);
    const Array<vec4> whole = drawn_all(pen, 1.0f);
    EXPECT_EQ(inked(whole), 1.0);
    EXPECT_EQ(whole, drawn(pen, {}));
}

TEST(Vanish, InkGoesOnceAndForAllWhereItIsFaintest) {
    const Pen pen = pen_with(grain());
    Array<vec4> before = drawn_all(pen, 1.0f);
    const Array<vec4> whole = before;
    double gone_first = 0.0, left_last = 0.0;
    int firsts = 0, lasts = 0;
    for (float seen = 0.95f; seen >= 0.0f; seen -= 0.05f) {
        const Array<vec4> now = drawn_all(pen, seen);
        for (std::size_t i = 0; i < now.size(); ++i) {
            ASSERT_LE(now[i].a, before[i].a + 1e-6f);
            if (std::abs(seen - 0.75f) < 0.01f && now[i].a == 0.0f && whole[i].a > 0.1f) {
                gone_first += whole[i].a;
                ++firsts;
            }
            if (std::abs(seen - 0.25f) < 0.01f && now[i].a > 0.0f) {
                left_last += whole[i].a;
                ++lasts;
            }
        }
        before = now;
    }
    ASSERT_GT(firsts, 100);
    ASSERT_GT(lasts, 100);
    EXPECT_LT(gone_first / firsts + 0.2, left_last / lasts);
}

TEST(Vanish, AlongARampTheTextureThinsOutSteadily) {
    std::vector<float> seen(samples);
    for (int i = 0; i < samples; ++i) seen[i] = (i + 0.5f) / samples;
    const Array<vec4> image = drawn(pen_with(grain()), seen);
    double quarters[4] = {};
    for (int y = 17; y < 23; ++y)
        for (int x = 20; x < 220; ++x) quarters[(x - 20) / 50] += image[std::size_t(y) * width + x].a > 0.01f;
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(quarters[k] / 300.0, 0.125 + 0.25 * k, 0.12) << k;
}

TEST(Vanish, OfAnEvenTextureItIsAFade) {
    const PenTexture even{8, 2, Array<float>(16, 0.6f)};
    for (const float seen : {0.25f, 0.5f, 0.75f}) {
        const Array<vec4> image = drawn(pen_with(even), std::vector<float>(samples, seen), even);
        EXPECT_NEAR(image[20 * width + 120].a, 0.6f * seen, 1e-3f);
    }
}

TEST(Vanish, OfASolidPenBlotsAreLeft) {
    const Pen solid = pen(8.0f, Cap::butt);
    const Array<vec4> half = drawn_all(solid, 0.5f);
    EXPECT_GT(inked(half), 0.2);
    EXPECT_LT(inked(half), 0.95);
    EXPECT_EQ(area(drawn_all(solid, 0.0f)), 0.0);
    EXPECT_EQ(drawn_all(solid, 1.0f), drawn(solid, {}));
}

}  // namespace
}  // namespace fovea
