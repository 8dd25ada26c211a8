// SPDX-License-Identifier: GPL-3.0-or-later
// Textures anchored to their path: octaves that keep their places while a path grows in the image.
#include <gtest/gtest.h>
#include <random>

#include <fovea/stroke/anchor.h>
#include <fovea/stroke/fragment.h>
#include <fovea/stroke/hand.h>
#include <fovea/stroke/ink.h>
#include <fovea/stroke/octaves.h>

#include "stroke_fixture.h"
#include "wires.h"

namespace fovea {
using namespace draw;
namespace {

using namespace stroke_fixture;

constexpr float length_px = 100.0f;  // of one repetition

/// Fitted to a pen of this size, with octaves.
PenTexture fitted(const PenTexture& texture, float width_px = 1000.0f, float repetition_px = 1000.0f) {
    PenTexture made = fit_texture(texture, repetition_px, width_px);
    made.octaves = octaves_of(made);
    return made;
}

/// Blurred noise, as grain is: rows of their own mean.
PenTexture grain() {
    PenTexture texture{128, 4, {}};
    std::mt19937 random(3);
    std::uniform_real_distribution<float> noise(0.0f, 1.0f);
    for (int y = 0; y < 4; ++y) {
        std::vector<float> row(128);
        for (float& value : row) value = noise(random);
        for (int x = 0; x < 128; ++x) {
            float sum = 0.0f;
            for (int k = -2; k <= 2; ++k) sum += row[std::size_t(x + k + 128) % 128] / 5.0f;
            texture.ink.push_back(0.2f + 0.1f * float(y) + 0.5f * (sum - 0.5f));
        }
    }
    return fitted(texture);
}

/// Dashes of so many of 96 columns around u = 0, and softened by a texel.
PenTexture dashes(int dash) {
    PenTexture texture{96, 1, Array<float>(96)};
    for (int x = 0; x < 96; ++x) {
        const float out = std::abs(std::min(float(x) + 0.5f, 95.5f - float(x))) - 0.5f * float(dash);
        texture.ink[std::size_t(x)] = std::clamp(0.5f - out, 0.0f, 1.0f);
    }
    return fitted(texture);
}

/// Repetitions of the finer octave, and its share.
vec2 octave(float path_px) { return formulas::Stroke{}.stroke_octave(path_px, length_px); }

/// Ink along a path of so many pixels, at places that are the same shares of it.
std::vector<float> along(const PenTexture& texture, float path_px, double from, double to, int count) {
    std::vector<float> ink;
    for (int i = 0; i < count; ++i)
        ink.push_back(anchored_ink(texture, float(from + (to - from) * i / count), 0.3f, 2.0f, path_px, length_px));
    return ink;
}

double mean_of(const std::vector<float>& values) {
    double sum = 0.0;
    for (const float v : values) sum += v / double(values.size());
    return sum;
}

double correlation(const std::vector<float>& a, const std::vector<float>& b, int shift) {
    const double mean_a = mean_of(a), mean_b = mean_of(b);
    double ab = 0.0, aa = 0.0, bb = 0.0;
    for (int i = 0; i < int(a.size()); ++i) {
        const int k = i + shift;
        if (k < 0 || k >= int(b.size())) continue;
        ab += (a[i] - mean_a) * (b[k] - mean_b);
        aa += (a[i] - mean_a) * (a[i] - mean_a);
        bb += (b[k] - mean_b) * (b[k] - mean_b);
    }
    return ab / std::sqrt(aa * bb);
}

TEST(Anchor, RepetitionsAreAPowerOfTwoNoLongerThanThePenSays) {
    for (float path = 1.5f; path < 40000.0f; path *= 1.037f) {
        const vec2 o = octave(path);
        int exponent = 0;
        EXPECT_EQ(std::frexp(o.x, &exponent), 0.5f) << path;
        EXPECT_GT(path / o.x, length_px * 0.4999f) << path;
        EXPECT_LE(path / o.x, length_px * 1.0001f) << path;
        EXPECT_GE(o.y, 0.0f);
        EXPECT_LE(o.y, 1.0f);
    }
    EXPECT_EQ(octave(800.0f).x, 8.0f);
    EXPECT_EQ(octave(800.0f).y, 1.0f);
    EXPECT_EQ(octave(800.0f * std::sqrt(2.0f)).x, 16.0f);
    EXPECT_NEAR(octave(800.0f * std::sqrt(2.0f)).y, 0.5f, 1e-6f) << "as far from both lengths";
    EXPECT_EQ(octave(0.0f).x, octave(1.0f).x) << "no path, no infinities";
}

TEST(Anchor, AtTheEndOfAnOctaveOnlyTheFinerOneIsLeftWhichIsTheNextOnesCoarser) {
    const PenTexture texture = grain();
    for (const float path : {50.0f, 400.0f, 6400.0f}) {
        const auto before = along(texture, path, -0.5, 0.5, 997);
        const auto after = along(texture, path * 1.00001f, -0.5, 0.5, 997);
        for (int i = 0; i < 997; ++i) {
            const float repeats = path / length_px;
            EXPECT_NEAR(before[i], ink(texture, (float(i) / 997.0f - 0.5f) * repeats, 0.3f, 2.0f), 2e-3f);
            EXPECT_NEAR(before[i], after[i], 2e-3f);
        }
    }
}

TEST(Anchor, InAZoomInkChangesLittleAStepAndStaysWhereItIs) {
    // Three octaves, 64 steps each; the window lies far from the middle, whence textures on the screen slide most.
    const PenTexture texture = grain();
    constexpr int count = 2000;
    std::vector<float> before;
    double largest = 0.0, least_correlation = 1.0;
    for (int k = 0; k <= 192; ++k) {
        const float path = 370.0f * std::exp2(float(k) / 64.0f);
        const auto now = along(texture, path, 0.3, 0.45, count);
        if (k > 0) {
            for (int i = 0; i < count; ++i) largest = std::max(largest, double(std::abs(now[i] - before[i])));
            const double here = correlation(before, now, 0);
            least_correlation = std::min(least_correlation, here);
            for (const int shift : {-40, -10, -4, 4, 10, 40})
                EXPECT_GT(here, correlation(before, now, shift)) << k << " " << shift;
        }
        before = now;
    }
    RecordProperty("largest_change", std::to_string(largest));
    RecordProperty("least_correlation", std::to_string(least_correlation));
    EXPECT_LT(largest, 0.01);
    EXPECT_GT(least_correlation, 0.995);
}

TEST(Anchor, DarknessAndContrastStayAllThroughAnOctave) {
    const PenTexture texture = grain();
    const auto spread = [](const std::vector<float>& ink) {
        const double mean = mean_of(ink);
        double sum = 0.0;
        for (const float v : ink) sum += (v - mean) * (v - mean) / double(ink.size());
        return std::sqrt(sum);
    };
    const auto whole = along(texture, 12800.0f, -0.5, 0.5, 20000);
    formulas::Stroke stroke{&texture};
    const float mean = stroke.mean_stroke_ink(0, stroke.size(), 0.3f, 2.0f);
    for (float path = 6500.0f; path < 12800.0f; path += 500.0f) {
        const auto ink = along(texture, path, -0.5, 0.5, 20000);
        EXPECT_NEAR(mean_of(ink), mean_of(whole), 0.01) << path;
        EXPECT_NEAR(spread(ink), spread(whole), 0.15 * spread(whole)) << path;
        EXPECT_NEAR(mean_of(ink), mean, 0.01) << path;
    }
}

/// Ink along two repetitions of the coarser octave, at every weight of the finer one from 0 to 1 in steps of 1 / 64.
std::vector<std::vector<float>> zoomed(const PenTexture& texture, int count) {
    formulas::Stroke stroke{&texture};
    std::vector<std::vector<float>> ink(65);
    for (int k = 0; k <= 64; ++k)
        for (int i = 0; i < count; ++i)
            ink[std::size_t(k)].push_back(stroke.dividing_dash_ink(
                0, stroke.size(), 4.0f * (float(i) + 0.5f) / float(count), 0.0f, 2.0f, float(k) / 64.0f));
    return ink;
}

TEST(Anchor, DashesAreNeverGrayWhileTheyDivideAndCoverAsMuch) {
    for (const int dash : {24, 48, 60, 72}) {
        const PenTexture texture = dashes(dash);
        const auto zoom = zoomed(texture, 4 * 96 * 4);
        for (std::size_t k = 0; k < zoom.size(); ++k) {
            const auto gray = std::ranges::count_if(zoom[k], [](float ink) { return ink > 0.02f && ink < 0.98f; });
            // Eight ends of dashes a texel wide, or as many again where gaps close beside others that open.
            EXPECT_LT(double(gray) / double(zoom[k].size()), 0.08) << dash << " " << k;
            EXPECT_NEAR(mean_of(zoom[k]), dash / 96.0, 0.02) << dash << " " << k;
        }
    }
}

TEST(Anchor, ADashBecomesTwoThatAreHalfAsLongInTheImageAtRest) {
    const auto zoom = zoomed(dashes(60), 1536);
    const auto dashes_of = [](const std::vector<float>& ink) {
        int count = 0;
        for (std::size_t i = 0; i < ink.size(); ++i) count += ink[i] < 0.5f && ink[(i + 1) % ink.size()] >= 0.5f;
        return count;
    };
    EXPECT_EQ(dashes_of(zoom.front()), 2);
    EXPECT_EQ(dashes_of(zoom.back()), 4);
    int changes = 0;
    for (std::size_t k = 1; k < zoom.size(); ++k) changes += dashes_of(zoom[k]) != dashes_of(zoom[k - 1]);
    EXPECT_EQ(changes, 1) << "all at one moment";
}

TEST(Anchor, GapsStayGapsThroughAZoomOfManyOctaves) {
    const PenTexture texture = dashes(60);
    const auto gaps_of = [&](float path_px) {
        const auto ink = along(texture, path_px, -0.5, 0.5, 6400);
        std::vector<double> gaps;  // their middles, as places on the path
        for (std::size_t i = 0; i < ink.size(); ++i) {
            std::size_t end = i;
            while (end < ink.size() && ink[end] < 0.5f) ++end;
            if (end > i && i > 0 && end < ink.size()) gaps.push_back(0.5 * double(i + end) / 6400.0);
            i = end;
        }
        return gaps;
    };
    std::vector<double> before;
    for (float path_px = 210.0f; path_px < 1650.0f; path_px *= 1.013f) {
        const std::vector<double> now = gaps_of(path_px);
        for (const double gap : before)
            EXPECT_NEAR(std::ranges::min(now, {}, [&](double g) { return std::abs(g - gap); }), gap, 3e-4) << path_px;
        EXPECT_GE(now.size(), before.size());
        before = now;
    }
    EXPECT_GE(before.size(), 15u);
}

TEST(Anchor, ShortPathsOfDashesStayVisible) {
    const PenTexture texture = dashes(60);
    for (float path_px = 1.0f; path_px < 0.3f * length_px; path_px *= 1.1f)
        EXPECT_GT(along(texture, path_px, 0.0, 1e-3, 1).front(), 0.9f) << path_px;
}

TEST(Anchor, OctavesOfAnEvenTextureAreEven) {
    const PenTexture even = fitted(PenTexture{16, 2, Array<float>(32, 0.4f)}), one = fitted(PenTexture{1, 1, {0.7f}}),
                     none = fitted(PenTexture{8, 2, Array<float>(16, 0.0f)});
    EXPECT_TRUE(none.dashed);
    for (const float path : {130.0f, 170.0f, 200.0f}) {
        for (const float ink : along(even, path, -0.5, 0.5, 50)) EXPECT_EQ(ink, 0.4f);
        for (const float ink : along(one, path, -0.5, 0.5, 50)) EXPECT_EQ(ink, 0.7f);
        for (const float ink : along(none, path, -0.5, 0.5, 50)) EXPECT_EQ(ink, 0.0f);
    }
}

TEST(Anchor, LengthAndPlacesOfAPathAreTheSameHoweverItIsClipped) {
    std::vector<dvec3> line;
    for (int i = 0; i <= 300; ++i) line.push_back({-9.0 + 0.06 * i, 4.5 * std::sin(0.11 * i) + 0.8, -5.0 - 0.004 * i});
    const View narrow = wires::camera(), wide = wires::cropped(narrow, -1280, -960, 1920, 1440);
    const ClippedPaths cut = wires::project_line(line, narrow), whole = wires::project_line(line, wide);
    ASSERT_GT(cut.pieces.count(), 1u);
    ASSERT_EQ(whole.pieces.count(), 1u);
    EXPECT_NEAR(whole.path_length_px[0], whole.arc_px.back() - whole.arc_px.front(), 1e-6);
    std::map<Index, double> place;
    for (Index i = 0; i < whole.px.size(); ++i) place[whole.source[i]] = whole.arc_px[i];
    for (Index q = 0; q < cut.pieces.count(); ++q) EXPECT_NEAR(cut.path_length_px[q], whole.path_length_px[0], 1e-6);
    for (Index i = 0; i < cut.px.size(); ++i)
        if (cut.source_t[i] == 0.0f) {
            EXPECT_NEAR(cut.arc_px[i], place.at(cut.source[i]), 1e-6);
        }
}

TEST(Anchor, StrokesHaveTheLengthOfTheirWholePath) {
    const PenTexture texture = grain();
    Pen p = pen(6.0f, Cap::butt);
    p.texture = 0;
    p.texture_length_px = 33.0f;
    p.look.texture_anchor = Anchor::path;
    ClippedPaths clipped;
    add_piece(clipped, {{10.0f, 20.0f}, {170.0f, 20.0f}});
    Runs part;
    add_run(part, 0, -60.0, 10.0);
    const Strokes strokes = strokes_of(clipped, part, p);
    for (const vec2 anchor : strokes.anchor) EXPECT_EQ(anchor.y, 160.0f);
    const auto some = picture(strokes, p, 180, 40, {&texture, 1});
    const auto all = picture(strokes_of(clipped, whole_runs(clipped), p), p, 180, 40, {&texture, 1});
    const PenTexture own = fitted(texture, 6.0f, 33.0f);
    for (int x = 32; x < 98; ++x)
        for (int y = 18; y < 22; ++y) {
            EXPECT_NEAR(some[y * 180 + x].a, all[y * 180 + x].a, 1e-5f);
            const float u = float(x) + 0.5f - 90.0f, v = float(y) + 0.5f - 20.0f;
            EXPECT_NEAR(some[y * 180 + x].a, anchored_ink(own, u / 160.0f, v, 3.0f, 160.0f, 33.0f), 1e-4f);
        }
}

/// The middle line of a wire as a pen that is fixed to its path has it.
CenterLine placed(const wires::Wires& wires, const View& view, double window_px = length_px) {
    const ClippedPaths clipped = wires.project(view);
    EXPECT_EQ(clipped.pieces.count(), 1u);
    CenterLine line;
    cut(clipped, {}, 0, clipped.first_arc(0), clipped.last_arc(0), line);
    PathAnchor(clipped, &wires.paths, nullptr, 0, window_px).place(line);
    return line;
}

/// A straight edge, two units long, that has turned by `angle` towards the camera.
std::vector<dvec3> turned(double angle) {
    const dvec3 way(std::cos(angle), 0.2, std::sin(angle)), middle(0.1, 0.3, -3.0);
    return {middle - way, middle + way};
}

TEST(Anchor, MarksOfAnEdgeThatTurnsTowardsTheCameraStayAtTheirPointsOfIt) {
    const View view = wires::camera();
    for (const double angle : {0.0, 0.5, 1.0, 1.4}) {
        const std::vector<dvec3> edge = turned(angle);
        const CenterLine line = placed(wires::Wires({edge}), view);
        ASSERT_GT(line.size(), 4u);
        for (std::size_t i = 0; i + 1 < line.size(); ++i)
            for (const double between : {0.0, 0.5}) {
                const double along = glm::mix(line[i].along, line[i + 1].along, between);
                const dvec3 point = glm::mix(edge[0], edge[1], along + 0.5);
                const dvec2 px = to_pixels(view, view.view_to_clip * dvec4(point, 1.0));
                const double off = glm::distance(px, glm::mix(line[i].px, line[i + 1].px, between));
                EXPECT_LT(off, between > 0.0 ? 0.05 : 1e-3) << angle << " " << i;
            }
    }
}

TEST(Anchor, InAZoomOfFourDashesStayWithinHalfAnOctaveOfTheirLength) {
    const wires::Wires wires({{{-0.3, 0.1, -3.0}, {0.4, 0.1, -3.0}}});
    const CenterLine far = placed(wires, wires::camera());
    for (double zoom = 1.0; zoom <= 4.0; zoom *= 1.07) {
        View view = wires::camera();
        view.view_to_clip = glm::scale(dmat4(1.0), dvec3(zoom, zoom, 1.0)) * view.view_to_clip;
        const CenterLine line = placed(wires, view);
        EXPECT_NEAR(line.front().whole_px, zoom * far.front().whole_px, 1e-2);
        EXPECT_NEAR(line.front().along, -0.5, 1e-6);
        EXPECT_NEAR(line.back().along, 0.5, 1e-6);
        const vec2 of = formulas::Stroke{}.stroke_octave(float(line.front().whole_px), 18.0f);
        const double dash = line.front().whole_px / (of.y >= 0.5f ? of.x : of.x / 2.0f);
        EXPECT_LT(std::abs(std::log2(dash / 18.0)), 0.5001) << zoom;
    }
}

TEST(Anchor, TheFarEndOfALineIntoDepthHasMarksAsLongInTheImageAsTheNearOne) {
    const CenterLine line = placed(wires::Wires({turned(1.2)}), wires::camera(), 20.0);
    EXPECT_LT(line.back().whole_px / line.front().whole_px, 4.0);
    const auto end = std::ranges::minmax(line, {}, &CenterPoint::whole_px);
    EXPECT_GT(end.max.whole_px / end.min.whole_px, 2.0) << "so that each has its own octave";
}

TEST(Anchor, LinesOfTheViewAreMeasuredInTheImage) {
    wires::Wires wires({turned(1.2)});
    wires.paths.of_view[0] = 1;
    for (const CenterPoint& p : placed(wires, wires::camera())) EXPECT_NEAR(p.along, p.arc / p.whole_px, 1e-12);
}

TEST(Anchor, MarksAreFixedToArcLengthsOfTheRestShape) {
    wires::Wires wires({{{-0.5, 0.0, -3.0}, {0.0, 0.0, -3.0}, {0.5, 0.0, -3.0}}});
    wires.paths.arc_obj = {0.0, 3.0, 4.0};  // its first half is pressed together
    const CenterLine line = placed(wires, wires::camera(), 2.0);
    const auto middle = std::ranges::find(line, 0.0, &CenterPoint::arc);
    ASSERT_NE(middle, line.end());
    EXPECT_NEAR(middle->along, 0.25, 1e-9);
    EXPECT_NEAR(line.front().whole_px, 1.0 / 3.0 * line.back().whole_px, 1e-3);
}

TEST(Anchor, WobbleOfAPenFixedToItsPathGrowsWithTheLineInSteps) {
    const auto wobbled = [](double whole_px) {
        CenterLine line;
        for (int i = 0; i <= 400; ++i) {
            const double along = i / 400.0 - 0.5;
            line.push_back({{whole_px * along, 0.0}, whole_px * along, 2.0f});
            line.back().along = along;
            line.back().whole_px = whole_px;
        }
        wobble(line, 5.0, 40.0, 7);
        return line;
    };
    const auto at = [](const CenterLine& line, double along) {
        const auto p = std::ranges::min_element(line, {}, [&](const auto& q) { return std::abs(q.along - along); });
        return p->px.y;
    };
    const CenterLine before = wobbled(640.0), after = wobbled(650.0);
    for (double along = -0.4; along < 0.4; along += 0.05) EXPECT_NEAR(at(before, along), at(after, along), 0.4);
}

TEST(Anchor, PenTableHasWhatOctavesAreMadeOfAfterTheInk) {
    const std::vector<PenTexture> textures{{2, 2, {0.25f, 0.25f, 0.0f, 1.0f}}, {2, 2, {0.0f, 1.0f, 0.25f, 0.75f}}};
    Pen dashed = pen(6.0f), plain = pen(6.0f), rough = pen(6.0f);
    dashed.texture = plain.texture = 0;
    rough.texture = 1;
    dashed.look.texture_anchor = rough.look.texture_anchor = Anchor::path;
    const std::vector<Pen> pens{dashed, plain, rough};
    const PenTable table = pen_table(pens, textures);
    const auto values = [&](std::size_t first, std::size_t count) {
        return std::vector<float>(table.ink.begin() + std::ptrdiff_t(first),
                                  table.ink.begin() + std::ptrdiff_t(first + count));
    };
    EXPECT_EQ(table.pens[1].w, 1.0f);
    EXPECT_EQ(table.pens[5].w, 0.0f);
    EXPECT_EQ(table.pens[2].z, 1.0f);
    EXPECT_EQ(table.pens[10].z, 0.0f);
    const std::size_t of_dashes = 4 + 4 + 2 * 17;
    EXPECT_EQ(table.pens[5].z, float(4 + of_dashes));
    EXPECT_EQ(table.ink.size(), 4 + of_dashes + 4 + 4 + 2);
    EXPECT_EQ(values(4, 8), (std::vector<float>{0.5f, 0.5f, 0.25f, 0.75f, 0.25f, 0.25f, 0.0f, 1.0f}));
    EXPECT_EQ(values(table.ink.size() - 2, 2), (std::vector<float>{0.5f, 0.5f}));
}

}  // namespace
}  // namespace fovea
