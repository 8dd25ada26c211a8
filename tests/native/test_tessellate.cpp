// SPDX-License-Identifier: GPL-3.0-or-later
// Strokes state geometry: areas, bends, ends, and u that stays where it is.
#include <algorithm>
#include <gtest/gtest.h>
#include <random>
#include <tbb/global_control.h>

#include "stroke_fixture.h"

namespace fovea {
using namespace draw;
namespace {

using namespace stroke_fixture;

/// u where a horizontal stroke passes x, read off its vertices on the left side.
float u_at(const Strokes& strokes, float x) {
    for (const glm::uvec3 t : strokes.triangles)
        for (int k = 0; k < 3; ++k) {
            Index a = t[k], b = t[(k + 1) % 3];
            if (strokes.px[a].x > strokes.px[b].x) std::swap(a, b);
            const vec2 p = strokes.px[a], q = strokes.px[b];
            if (strokes.arc[a].y < 0.0f || strokes.arc[b].y < 0.0f || !(p.x <= x && x < q.x)) continue;
            return glm::mix(strokes.arc[a].x, strokes.arc[b].x, (x - p.x) / (q.x - p.x));
        }
    return NAN;
}

double triangle_area(const Strokes& s) {
    double sum = 0.0;
    for (const glm::uvec3 t : s.triangles) {
        const dvec2 a = s.px[t.x], b = dvec2(s.px[t.y]) - a, c = dvec2(s.px[t.z]) - a;
        sum += std::abs(b.x * c.y - b.y * c.x) / 2.0;
    }
    return sum;
}

TEST(Tessellate, StraightButtStrokeCoversLengthTimesWidth) {
    for (const float width : {1.0f, 2.0f, 3.7f, 12.0f})
        for (const double angle : {0.0, 0.3, 0.75, 1.2, 2.5}) {
            const vec2 along(float(100.0 * std::cos(angle)), float(100.0 * std::sin(angle)));
            const Pen p = pen(width, Cap::butt);
            const auto image = picture(strokes_of({vec2(150.3f) - along, vec2(150.3f) + along}, p), p, 300, 300);
            EXPECT_NEAR(area(image), 200.0 * width, 0.004 * 200.0 * width) << width << " " << angle;
        }
}

TEST(Tessellate, RoundCapsAddADisc) {
    for (const float width : {2.0f, 5.0f, 14.0f}) {
        const Pen p = pen(width);
        const auto image = picture(strokes_of({{40.2f, 60.7f}, {160.9f, 93.1f}}, p), p, 200, 150);
        const double length = glm::distance(dvec2(40.2, 60.7), dvec2(160.9, 93.1));
        const double disc = std::numbers::pi * width * width / 4.0;
        EXPECT_NEAR(area(image) - length * width, disc, 0.05 * disc + 0.005 * length * width) << width;
    }
}

TEST(Tessellate, PenBelowOnePixelIsOnePixelWideAndFainter) {
    const Pen p = pen(0.25f, Cap::butt);
    const Strokes strokes = strokes_of({{10.0f, 20.0f}, {110.0f, 33.0f}}, p);
    for (const float h : strokes.half_width) EXPECT_EQ(h, 0.5f);
    for (const float o : strokes.opacity) EXPECT_EQ(o, 0.25f);
    EXPECT_NEAR(area(picture(strokes, p, 120, 50)), 0.25 * std::hypot(100.0, 13.0), 0.3);
}

TEST(Tessellate, RightAngleIsMitredAndDrawnOnce) {
    const Pen p = pen(10.0f, Cap::butt, 0.5f);
    const auto image = picture(strokes_of({{20.0f, 20.0f}, {80.0f, 20.0f}, {80.0f, 80.0f}}, p), p, 100, 100);
    EXPECT_FLOAT_EQ(largest_alpha(image), 0.5f);
    // Two arms of 60 x 10 and the outer quarter of the corner; the inner quarter belongs to both
    // arms.
    EXPECT_NEAR(area(image) / 0.5, 2 * 60 * 10, 2.0);
    for (int y = 16; y < 24; ++y)
        for (int x = 76; x < 84; ++x) EXPECT_FLOAT_EQ(image[y * 100 + x].a, 0.5f) << x << " " << y;
}

TEST(Tessellate, SharpBendsAreDrawnOnce) {
    for (int degrees = 5; degrees < 150; degrees += 5)
        for (const double sign : {-1.0, 1.0}) {
            const double a = sign * degrees * std::numbers::pi / 180.0;
            const vec2 corner(150.3f, 150.6f);
            const vec2 out(float(120.0 * std::cos(a)), float(120.0 * std::sin(a)));
            const Pen p = pen(8.0f, Cap::round, 0.5f);
            const auto image = picture(strokes_of({corner - vec2(120.0f, 0.0f), corner, corner + out}, p), p, 300, 300);
            EXPECT_LE(largest_alpha(image), 0.5f + 1e-6f) << degrees * sign;
            EXPECT_FLOAT_EQ(image[150 * 300 + 150].a, 0.5f) << degrees * sign;
        }
}

TEST(Tessellate, ShortStepsInSharpBendsLeaveNoSpikesAndNoHoles) {
    // Bends tighter than the pen: every drawn pixel is near the line, every pixel well inside the
    // pen is drawn.
    std::mt19937 random(7);
    std::uniform_real_distribution<float> step(0.5f, 9.0f), turn(-1.2f, 1.2f);
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<vec2> line{{100.0f, 100.0f}};
        float a = 0.0f;
        for (int i = 0; i < 12; ++i) {
            const float length = step(random);
            line.push_back(line.back() + length * vec2(std::cos(a), std::sin(a)));
            a += turn(random);
        }
        const Pen p = pen(10.0f);
        const auto image = picture(strokes_of(line, p), p, 200, 200);
        for (int y = 0; y < 200; ++y)
            for (int x = 0; x < 200; ++x) {
                const vec2 q(x + 0.5f, y + 0.5f);
                float distance = 1e9f;
                for (std::size_t i = 1; i < line.size(); ++i) {
                    const vec2 d = line[i] - line[i - 1];
                    const float t = glm::clamp(glm::dot(q - line[i - 1], d) / glm::dot(d, d), 0.0f, 1.0f);
                    distance = std::min(distance, glm::distance(q, line[i - 1] + t * d));
                }
                const float alpha = image[y * 200 + x].a;
                if (distance < 3.5f) {
                    EXPECT_GT(alpha, 0.9f) << trial << " " << x << " " << y << " " << distance;
                }
                if (distance > 8.5f) {
                    EXPECT_EQ(alpha, 0.0f) << trial << " " << x << " " << y << " " << distance;
                }
            }
    }
}

TEST(Tessellate, ClosedCircleIsTheSameAllAround) {
    for (const int points : {12, 90, 2000}) {
        const Pen p = pen(6.0f, Cap::round, 0.5f);
        const auto image = picture(strokes_of(circle({100.25, 100.5}, 70.0, points), p, true), p, 200, 200);
        EXPECT_LE(largest_alpha(image), 0.5f + 1e-6f);
        if (points < 90) continue;
        EXPECT_NEAR(area(image), 0.5 * 2.0 * std::numbers::pi * 70.0 * 6.0, 0.005 * area(image));
        for (int k = 0; k < 720; ++k) {
            const double a = k * std::numbers::pi / 360.0;
            const int x = int(100.25 + 70.0 * std::cos(a)), y = int(100.5 + 70.0 * std::sin(a));
            EXPECT_FLOAT_EQ(image[y * 200 + x].a, 0.5f) << points << " " << k;
        }
    }
}

TEST(Tessellate, ClippedRunKeepsU) {
    std::vector<vec2> line;
    for (int i = 0; i <= 40; ++i) line.push_back({10.0f + 5.0f * i, 50.0f + 0.4f * (i % 2)});
    ClippedPaths clipped;
    add_piece(clipped, line);
    const Pen p = pen(3.0f);
    const Strokes whole = strokes_of(clipped, whole_runs(clipped), p);
    Runs runs;
    add_run(runs, 0, -37.3, 61.9);
    const Strokes part = strokes_of(clipped, runs, p);
    EXPECT_FLOAT_EQ(part.arc[0].z, -37.3f);
    EXPECT_FLOAT_EQ(part.arc[0].w, 61.9f);
    for (float x = 80.0f; x < 165.0f; x += 1.7f) EXPECT_NEAR(u_at(part, x), u_at(whole, x), 0.05f) << x;
}

TEST(Tessellate, ZigzagOfADenseMeshBecomesStraight) {
    std::vector<vec2> line;
    for (int i = 0; i <= 2000; ++i) line.push_back({10.0f + 0.1f * i, 50.0f + (i % 2 ? 0.08f : -0.08f)});
    const Strokes strokes = strokes_of(line, pen(2.0f));
    EXPECT_LE(strokes.triangles.size(), 40u);
    for (const vec2 px : strokes.px) EXPECT_NEAR(std::abs(px.y - 50.0f), 1.5f, 0.21f);
}

TEST(Tessellate, TurnBackIsKept) {
    const Pen p = pen(4.0f);
    const auto image = picture(strokes_of({{20.0f, 50.0f}, {80.0f, 50.0f}, {40.0f, 50.0f}}, p), p, 100, 100);
    EXPECT_GT(image[50 * 100 + 79].a, 0.99f);
    EXPECT_GT(image[50 * 100 + 81].a, 0.5f) << "rounded at the turn";
    EXPECT_EQ(image[50 * 100 + 84].a, 0.0f);
}

TEST(Tessellate, TapersAtTheEndsOnly) {
    Pen p = pen(8.0f);
    p.look.taper = 40.0f;
    const Strokes strokes = strokes_of({{20.0f, 20.0f}, {220.0f, 20.0f}}, p);
    for (std::size_t i = 0; i < strokes.px.size(); ++i) {
        const float end = std::min(strokes.px[i].x - 20.0f, 220.0f - strokes.px[i].x);
        EXPECT_NEAR(strokes.half_width[i],
                    end > 40.0f ? 4.0f : 4.0f - 3.2f * std::pow(1.0f - std::max(end, 0.0f) / 40.0f, 2.0f), 1e-4f);
    }
    EXPECT_LT(area(picture(strokes, p, 240, 40)), 0.92 * 200.0 * 8.0);
    for (const float h : strokes_of({{20.0f, 20.0f}, {28.0f, 20.0f}}, p).half_width) EXPECT_GT(h, 3.6f) << "too short";
}

TEST(Tessellate, EndsThatTouchOtherLinesKeepTheirWidth) {
    Pen p = pen(8.0f);
    p.look.taper = 40.0f;
    ClippedPaths clipped;
    add_piece(clipped, {{20.0f, 20.0f}, {220.0f, 20.0f}});
    clipped.free_ends[0] = 2;
    Runs runs;
    add_run(runs, 0, -100.0, 100.0);
    const Strokes strokes = strokes_of(clipped, runs, p);
    for (std::size_t i = 0; i < strokes.px.size(); ++i) {
        if (strokes.px[i].x < 120.0f) {
            EXPECT_EQ(strokes.half_width[i], 4.0f);
        }
        if (strokes.px[i].x > 219.0f) {
            EXPECT_LT(strokes.half_width[i], 1.0f);
        }
    }
    runs.end_px[0] = 50.0;  // hidden from there on: something stands before it
    for (const float h : strokes_of(clipped, runs, p).half_width) EXPECT_EQ(h, 4.0f);
}

TEST(Tessellate, StrengthIsOpacityAlongThePath) {
    ClippedPaths clipped;
    add_piece(clipped, {{10.0f, 20.0f}, {60.0f, 20.0f}, {110.0f, 20.0f}});
    const std::vector<float> strength{0.0f, 1.0f, 0.0f};
    const Pen p = pen(4.0f, Cap::butt);
    Runs runs;
    add_run(runs, 0, -25.0, 50.0);
    const auto image = picture(strokes_of(clipped, runs, p, strength), p, 120, 40);
    EXPECT_NEAR(image[20 * 120 + 36].a, 0.53f, 0.01f);
    EXPECT_NEAR(image[20 * 120 + 60].a, 0.99f, 0.01f);
    EXPECT_NEAR(image[20 * 120 + 85].a, 0.49f, 0.01f);
    EXPECT_EQ(image[20 * 120 + 30].a, 0.0f);
}

TEST(Tessellate, StrengthMayThinInsteadOfFade) {
    ClippedPaths clipped;
    add_piece(clipped, {{10.0f, 20.0f}, {60.0f, 20.0f}, {210.0f, 20.0f}});
    const std::vector<float> strength{0.25f, 0.25f, 1.0f};
    for (const float share : {0.0f, 0.5f, 1.0f}) {
        Pen p = pen(8.0f, Cap::butt);
        p.look.strength_width = share;
        const Strokes strokes = strokes_of(clipped, whole_runs(clipped), p, strength);
        for (std::size_t i = 0; i < strokes.px.size(); ++i) {
            const float s = glm::mix(0.25f, 1.0f, std::clamp((strokes.px[i].x - 60.0f) / 150.0f, 0.0f, 1.0f));
            EXPECT_NEAR(strokes.half_width[i], 4.0f * (1.0f - share * (1.0f - s)), 0.02f) << share;
            EXPECT_NEAR(strokes.opacity[i], 1.0f - (1.0f - share) * (1.0f - s), 0.005f) << share;
        }
    }
}

TEST(Tessellate, InkFollowsStrengthHoweverItIsDrawn) {
    // Down to nothing, through widths below a pixel: as much ink whether the line fades or thins.
    ClippedPaths clipped;
    add_piece(clipped, {{10.0f, 20.0f}, {210.0f, 20.0f}});
    const std::vector<float> strength{0.0f, 1.0f};
    for (const float width : {0.6f, 2.0f, 6.0f})
        for (const float share : {0.0f, 1.0f}) {
            Pen p = pen(width, Cap::butt);
            p.look.strength_width = share;
            const auto image = picture(strokes_of(clipped, whole_runs(clipped), p, strength), p, 230, 40);
            EXPECT_NEAR(area(image), 200.0 * width / 2.0, 0.02 * 200.0 * width / 2.0) << width << " " << share;
        }
}

TEST(Tessellate, DegenerateInputDrawsNothing) {
    const Pen p = pen(3.0f);
    EXPECT_EQ(strokes_of(ClippedPaths{}, Runs{}, p).count, 0u);
    EXPECT_EQ(strokes_of(std::vector<vec2>{{5.0f, 5.0f}}, p).count, 0u);
    EXPECT_EQ(strokes_of(std::vector<vec2>(6, {5.0f, 5.0f}), p).count, 0u);
    EXPECT_EQ(strokes_of(std::vector<vec2>(6, {5.0f, 5.0f}), p, true).count, 0u);
    EXPECT_EQ(strokes_of({{NAN, 5.0f}, {5.0f, INFINITY}}, p).count, 0u);
    ClippedPaths clipped;
    add_piece(clipped, {{5.0f, 5.0f}, {20.0f, 5.0f}});
    Runs runs;
    add_run(runs, 0, 3.0, 3.0);
    add_run(runs, 0, 4.0, 2.0);
    add_run(runs, 0, 30.0, 40.0);
    EXPECT_EQ(strokes_of(clipped, runs, p).count, 0u);
    const std::vector<Index> nothing{none};
    EXPECT_EQ(tessellate(clipped, whole_runs(clipped), nothing, {}, {}).count, 0u);
}

TEST(Tessellate, BrokenInputNeverCrashes) {
    std::mt19937 random(13);
    const float values[] = {0.0f, 1.0f, 5.0f, 5.01f, 40.0f, -3.0f, 1e-20f, 1e7f, -1e30f, NAN, INFINITY};
    std::uniform_int_distribution<std::size_t> pick(0, std::size(values) - 1);
    for (int trial = 0; trial < 3000; ++trial) {
        ClippedPaths clipped;
        std::vector<vec2> line;
        for (std::size_t i = 0; i < 1 + pick(random); ++i) line.push_back({values[pick(random)], values[pick(random)]});
        add_piece(clipped, line, trial % 3 == 0);
        if (trial % 5 == 0)
            for (double& arc : clipped.arc_px) arc = values[pick(random)];
        Runs runs = whole_runs(clipped);
        add_run(runs, 0, values[pick(random)], values[pick(random)]);
        Pen p = pen(0.01f + 9.0f * float(pick(random)), trial % 2 ? Cap::butt : Cap::round);
        p.look.taper = float(pick(random)) * 5.0f;
        p.look.strength_width = trial % 2 ? 0.7f : 0.0f;
        std::vector<float> strength;
        for (std::size_t i = 0; i < line.size(); ++i) strength.push_back(values[pick(random)]);
        for (const vec4& pixel : picture(strokes_of(clipped, runs, p, strength), p, 48, 32))
            ASSERT_TRUE(pixel.a >= 0.0f && pixel.a <= 1.0f + 1e-5f) << trial;
    }
}

TEST(Tessellate, RepeatedPointsChangeNothing) {
    const Pen p = pen(5.0f);
    const Strokes once = strokes_of({{10.0f, 10.0f}, {50.0f, 12.0f}, {60.0f, 40.0f}}, p);
    const Strokes twice =
        strokes_of({{10.0f, 10.0f}, {10.0f, 10.0f}, {50.0f, 12.0f}, {50.0f, 12.0f}, {60.0f, 40.0f}}, p);
    EXPECT_NEAR(triangle_area(once), triangle_area(twice), 1e-3);
    EXPECT_EQ(once.triangles.size(), twice.triangles.size());
}

TEST(Tessellate, WrongInputIsNamed) {
    ClippedPaths clipped;
    add_piece(clipped, {{5.0f, 5.0f}, {20.0f, 5.0f}});
    const Pen p = pen(3.0f);
    const std::vector<Index> wrong_pen{3};
    EXPECT_THROW(tessellate(clipped, whole_runs(clipped), wrong_pen, {}, {&p, 1}), std::invalid_argument);
    EXPECT_THROW(tessellate(clipped, whole_runs(clipped), {}, {}, {&p, 1}), std::invalid_argument);
    const std::vector<float> too_short{1.0f};
    EXPECT_THROW(strokes_of(clipped, whole_runs(clipped), p, too_short), std::invalid_argument);
    Runs runs;
    add_run(runs, 9, 0.0, 1.0);
    EXPECT_THROW(strokes_of(clipped, runs, p), std::invalid_argument);
}

TEST(Tessellate, SameForAnyNumberOfThreads) {
    ClippedPaths clipped;
    std::mt19937 random(3);
    std::uniform_real_distribution<float> at(0.0f, 400.0f), step(-6.0f, 6.0f);
    for (int q = 0; q < 2000; ++q) {
        std::vector<vec2> line{{at(random), at(random)}};
        for (int i = 0; i < 20; ++i) line.push_back(line.back() + vec2(step(random), step(random)));
        add_piece(clipped, line);
    }
    const Pen p = pen(3.0f);
    const Runs runs = whole_runs(clipped);
    const Strokes many = strokes_of(clipped, runs, p);
    const Array<vec4> many_image = picture(many, p, 400, 400);
    tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const Strokes single = strokes_of(clipped, runs, p);
    EXPECT_EQ(many.count, 2000u);
    EXPECT_EQ(many.px, single.px);
    EXPECT_EQ(many.arc, single.arc);
    EXPECT_EQ(many.triangles, single.triangles);
    EXPECT_EQ(many_image, picture(single, p, 400, 400));
}

}  // namespace
}  // namespace fovea
