// SPDX-License-Identifier: GPL-3.0-or-later
// Pens whose width, opacity and color change along a stroke, by its direction, by distance and by noise.
#include <gtest/gtest.h>

#include "stroke_fixture.h"

namespace fovea {
using namespace draw;
namespace {

using namespace stroke_fixture;

constexpr double line_length = 200.0;

Pen wide() { return pen(8.0f, Cap::butt); }

style::Transfer whole(std::vector<dvec2> curve = {}) { return {0.0, 1.0, 1.0, std::move(curve)}; }

/// A line of 200 px at an angle.
std::vector<vec2> line_at(double degrees) {
    const double a = glm::radians(degrees);
    const vec2 half = vec2(0.5 * line_length * dvec2(std::cos(a), std::sin(a)));
    return {vec2(150) - half, vec2(150) + half};
}

/// Widths and opacities between the ends of a stroke, by place along it (0 to 1); thinner than a pixel is fainter.
struct Along {
    std::vector<std::array<float, 4>> points;  // place, width, opacity, share of the second color

    explicit Along(const Strokes& strokes) {
        for (std::size_t i = 0; i < strokes.px.size(); ++i) {
            const vec4& arc = strokes.arc[i];
            if (arc.x >= arc.z && arc.x <= arc.w)
                points.push_back({(arc.x - arc.z) / (arc.w - arc.z), 2.0f * strokes.half_width[i], strokes.opacity[i],
                                  strokes.mix[i].z});
        }
    }
    float least(int k) const {
        return std::ranges::min_element(points, {}, [k](const auto& p) { return p[k]; })->at(k);
    }
    float most(int k) const {
        return std::ranges::max_element(points, {}, [k](const auto& p) { return p[k]; })->at(k);
    }
};

bool equal(const Strokes& a, const Strokes& b) {
    return a.px == b.px && a.arc == b.arc && a.half_width == b.half_width && a.opacity == b.opacity && a.mix == b.mix &&
           a.triangles == b.triangles;
}

TEST(Along, APenWithoutModifiersDrawsTheSameWhateverTheirSettings) {
    Pen plain = wide(), set = wide();
    set.look.nib_angle = 10.0;
    set.look.noise_length = 3.0;
    set.look.distance_far = 1.0;
    set.look.second_color = dvec3(1, 0, 0);
    set.look.along_width = {0.2, 0.3, 0.0, {{0, 1}, {1, 1}}};
    for (const auto& line : {line_at(30), circle({150, 150}, 80, 40)})
        EXPECT_TRUE(equal(strokes_of(line, plain), strokes_of(line, set)));
}

TEST(Along, WidthFallsFromStartToEndOfAStroke) {
    Pen pen = wide();
    pen.look.along_width = whole();
    for (const auto& [place, width, opacity, tint] : Along(strokes_of(line_at(0), pen)).points)
        EXPECT_NEAR(width * opacity, 8.0f * (1.0f - place), 0.05f) << place;
}

TEST(Along, StartAndEndSayWhichPartOfTheStrokeChanges) {
    Pen pen = wide();
    pen.look.along_opacity = {0.25, 0.5, 0.5, {}};
    const Along found(strokes_of(line_at(0), pen));
    for (const auto& [place, width, opacity, tint] : found.points)
        EXPECT_NEAR(opacity, 1.0 - 0.5 * std::clamp((place - 0.25) / 0.25, 0.0, 1.0), 0.01) << place;
    EXPECT_EQ(found.least(1), 8.0f);
}

TEST(Along, ACurveSaysHowMuchIsTakenAtEachPlace) {
    Pen pen = wide();
    pen.look.along_color = whole({{0, 0}, {0.5, 1}, {1, 0}});
    const Transfer curve = focus::transfer_of(pen.look.along_color);
    const Along found(strokes_of(line_at(0), pen));
    EXPECT_GT(found.points.size(), 60u);
    EXPECT_GT(found.most(3), 0.98f);
    for (const auto& [place, width, opacity, tint] : found.points) EXPECT_NEAR(tint, curve(place), 0.01f) << place;
}

TEST(Nib, OfFortyFiveDegreesDrawsThinAlongAndThickAcross) {
    Pen pen = wide();
    pen.look.nib_angle = 45.0;
    pen.look.nib_width = 0.75;
    const auto width = [&](double angle) {
        const Along found(strokes_of(line_at(angle), pen));
        EXPECT_NEAR(found.least(1), found.most(1), 1e-3f);
        return found.most(1);
    };
    EXPECT_NEAR(width(45), 2.0f, 1e-3f);
    EXPECT_NEAR(width(225), 2.0f, 1e-3f);
    EXPECT_NEAR(width(135), 8.0f, 1e-3f);
    EXPECT_NEAR(width(0), 8.0 * (1.0 - 0.75 * (1.0 - std::sqrt(0.5))), 1e-3);
}

TEST(Nib, ChangesWithinItsOwnWidthOfACorner) {
    Pen pen = wide();
    pen.look.nib_angle = 0.0;
    pen.look.nib_opacity = 0.5;
    int seen = 0;
    for (const auto& [place, width, opacity, tint] : Along(strokes_of({{20, 20}, {120, 20}, {120, 120}}, pen)).points) {
        if (std::abs(place - 0.5) * line_length <= 6.0) continue;
        EXPECT_NEAR(opacity, place < 0.5 ? 0.5f : 1.0f, 0.01f) << place;
        ++seen;
    }
    EXPECT_GE(seen, 4);
}

TEST(Nib, OfAClosedStrokeIsTheSameOnBothSidesOfItsSeam) {
    Pen pen = wide();
    pen.look.nib_width = 1.0;
    const std::vector<vec2> square{{50, 50}, {150, 50}, {150, 150}, {50, 150}, {50, 50}};
    float start = -1.0f, end = -2.0f;
    const Strokes strokes = strokes_of(square, pen, true);
    float first = 1e9f, last = -1e9f;
    for (std::size_t i = 0; i < strokes.px.size(); ++i) {
        if (strokes.arc[i].x < first) first = strokes.arc[i].x, start = strokes.half_width[i];
        if (strokes.arc[i].x > last) last = strokes.arc[i].x, end = strokes.half_width[i];
    }
    EXPECT_NEAR(start, end, 1e-3f);
}

TEST(Distance, FadesAStrokeThatRecedes) {
    Pen pen = wide();
    pen.look.distance_near = 2.0;
    pen.look.distance_far = 6.0;
    pen.look.distance_opacity = 1.0;
    ClippedPaths clipped;
    add_piece(clipped, line_at(0));
    clipped.position_view = {vec3(0, 0, -2), vec3(0, 0, -10)};
    for (const bool flat : {false, true}) {
        clipped.orthographic = flat;
        const Along found(strokes_of(clipped, whole_runs(clipped), pen));
        for (const auto& [place, width, opacity, tint] : found.points) {
            // In perspective 1 / distance is linear on the screen.
            const double away = flat ? 2.0 + 8.0 * place : 1.0 / glm::mix(1.0 / 2.0, 1.0 / 10.0, double(place));
            EXPECT_NEAR(opacity, 1.0 - std::clamp((away - 2.0) / 4.0, 0.0, 1.0), 0.05) << place;
        }
        EXPECT_EQ(found.most(2), 1.0f);
        EXPECT_EQ(found.least(2), 0.0f);
    }
}

TEST(Distance, OfALineThatEndsFarBeyondItsStartIsANumberUpToItsEnds) {
    Pen pen = wide();
    pen.look.distance_far = 1e18;
    pen.look.distance_width = pen.look.distance_opacity = 0.5;
    ClippedPaths clipped;
    add_piece(clipped, line_at(0));
    for (const bool recedes : {false, true}) {
        clipped.position_view = {vec3(0, 0, recedes ? -0.1f : -5e17f), vec3(0, 0, recedes ? -5e17f : -0.1f)};
        const Along found(strokes_of(clipped, whole_runs(clipped), pen));
        for (const auto& [place, width, opacity, tint] : found.points) {
            EXPECT_TRUE(std::isfinite(place + width)) << place;
            EXPECT_LE(opacity, 1.0f) << place;
        }
    }
}

/// Widths at places of the path where the whole and a part of it both have points.
std::vector<std::pair<float, float>> both(const Strokes& a, const Strokes& b) {
    std::vector<std::pair<float, float>> found;
    for (std::size_t i = 0; i < a.px.size(); ++i)
        for (std::size_t k = 0; k < b.px.size(); ++k)
            if (std::abs(a.arc[i].x - b.arc[k].x) < 1e-4f && a.arc[i].y * b.arc[k].y > 0.0f)
                found.emplace_back(a.half_width[i], b.half_width[k]);
    return found;
}

TEST(Noise, OfAPathIsTheSameInTwoFramesAndOfOtherPathsAnother) {
    Pen pen = wide();
    pen.look.noise_length = 20.0;
    pen.look.noise_width = 0.8;
    ClippedPaths clipped;
    add_piece(clipped, line_at(0));
    const Runs seen = whole_runs(clipped);
    Runs part;
    add_run(part, 0, -60.0, 80.0);  // less of it is visible in the other frame
    const std::vector<Index> pens(1, 0);
    const std::vector<std::uint64_t> id{77}, other{78};
    const auto drawn = [&](const Runs& runs, In<std::uint64_t> ids) {
        return tessellate(clipped, runs, pens, {}, {&pen, 1}, {}, {}, ids);
    };
    const auto same = both(drawn(seen, id), drawn(part, id));
    EXPECT_GT(same.size(), 60u);
    for (const auto& [a, b] : same) EXPECT_NEAR(a, b, 1e-4f);
    float apart = 0.0f;
    for (const auto& [a, b] : both(drawn(seen, id), drawn(seen, other))) apart = std::max(apart, std::abs(a - b));
    EXPECT_GT(apart, 0.5f);
    const Along found(drawn(seen, id));
    EXPECT_GE(found.least(1), 8.0f * 0.2f);
    EXPECT_LE(found.most(1), 8.0f);
    EXPECT_GT(found.most(1) - found.least(1), 3.0f);
}

TEST(Along, PensInAndOutOfFocusAreMixedWithTheirModifiers) {
    Pen pens[] = {pen(8.0f, Cap::butt), pen(4.0f, Cap::butt)};
    pens[0].away = 1;
    pens[0].look.nib_angle = pens[1].look.nib_angle = 0.0;
    pens[0].look.nib_width = 0.5;   // 4 px
    pens[1].look.nib_width = 0.25;  // 3 px
    pens[1].look.nib_color = 1.0;
    ClippedPaths clipped;
    add_piece(clipped, line_at(0));
    clipped.sample_start = {0, 100};
    clipped.sample_count = {100, 0};
    clipped.samples = 100;
    const std::vector<float> half(100, 0.5f);
    Emphasis emphasis;
    emphasis.focus = half;
    const Index first[] = {0};
    const Along found(tessellate(clipped, whole_runs(clipped), first, {}, pens, {}, emphasis));
    EXPECT_NEAR(found.least(1), 3.5f, 1e-4f);
    EXPECT_NEAR(found.most(1), 3.5f, 1e-4f);
    EXPECT_NEAR(found.most(3), 0.5f, 1e-4f);
}

TEST(Along, TheSecondColorIsDrawn) {
    Pen red = wide();
    red.look.color = dvec3(1, 0, 0);
    red.look.second_color = dvec3(0, 0, 1);
    red.look.along_color = whole();
    const Array<vec4> image = picture(strokes_of(line_at(0), red), red, 300, 300);
    const auto at = [&](int x) { return image[150 * 300 + x]; };
    for (const int x : {60, 150, 240}) {
        const float share = float((x + 0.5 - 50.0) / line_length);
        EXPECT_NEAR(at(x).r, 1.0f - share, 0.01f);
        EXPECT_NEAR(at(x).b, share, 0.01f);
        EXPECT_NEAR(at(x).a, 1.0f, 0.01f);
    }
}

}  // namespace
}  // namespace fovea
