// SPDX-License-Identifier: GPL-3.0-or-later
// Visibility over frames, from a scene to its picture: a bar passes before the edge of a plate.
#include <cmath>
#include <gtest/gtest.h>

#include <fovea/draw/polylines.h>
#include <fovea/vector/center_lines.h>
#include <fovea/vector/compose.h>

#include "over_frames.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::drawing;
using namespace fovea::over_frames;

namespace {

style::Style style_of(int frames, style::Vanish vanish = style::Vanish::fade, bool elided = false) {
    return over_frames::style_of("border", frames, vanish, elided);
}

/// A plate of 2 x 2 units, and a bar before it, whose middle is at `x`; none without.
Job job_at(std::optional<double> x, double bar_width, const style::Style& style) {
    std::vector<Placement> placed{place(meshes::grid(1), moved({0, 0, 0}), 1)};
    if (x)
        placed.push_back(
            place(meshes::box(vec3(-0.5f * float(bar_width), -3, 1), vec3(0.5f * float(bar_width), 3, 1.1f)),
                  moved({*x, 0, 0}), 2, usage_occlude));
    return job_of(std::move(placed), {0, 0, 10}, style);
}

/// Frame 0 of those that place(frame) makes, over so many frames to each side.
template <typename Place>
std::unique_ptr<Frame> middle_of(int frames, const style::Style& style, const Place& place, double bar_width = 0.2) {
    return over_frames::middle_of(frames, [&](int k) { return job_at(place(k), bar_width, style); });
}

/// Calls visit(x, sample) for the samples along the upper and the lower edge of the plate.
template <typename Visit>
void each_sample_of_edges(const Frame& frame, const Visit& visit) {
    each_sample(frame, [&](const dvec2& at, Index s) {
        if (std::abs(std::abs(at.y) - 1.0) < 1e-3 && std::abs(at.x) < 0.999) visit(at.x, s);
    });
}

/// Ink of the picture where the line is in the middle, per column.
std::vector<float> ink_along(const Frame& frame) {
    const int row = int((1.0 / (across * height / width) + 0.5) * height);
    std::vector<float> ink;
    for (int x = 0; x < width; ++x) ink.push_back(frame.passes.lines[std::size_t(row) * width + x].w);
    return ink;
}

}  // namespace

TEST(OverFrames, VisibilityBlurEqualsTheAnalyticTrapezoid) {
    for (const int frames : {1, 2, 4})
        for (const double bar_width : {0.08, 0.2, 0.6}) {
            const double speed = 0.15;
            const auto frame =
                middle_of(frames, style_of(frames), [&](int k) { return std::optional(speed * k); }, bar_width);
            double largest = 0.0;
            int count = 0;
            each_sample_of_edges(*frame, [&](double x, Index s) {
                largest = std::max(largest, std::abs(frame->seen[s] - trapezoid(x, bar_width, speed, frames)));
                ++count;
            });
            EXPECT_GT(count, 100);
            EXPECT_LT(largest, 0.02) << frames << " frames, a bar of " << bar_width;
        }
}

TEST(OverFrames, TheInkIsTheTrapezoid) {
    const auto frame = middle_of(2, style_of(2), [&](int k) { return std::optional(0.15 * k); });
    const std::vector<float> ink = ink_along(*frame);
    for (int column = 0; column < width; ++column) {
        const double x = ((column + 0.5) / width - 0.5) * across;
        if (std::abs(x) < 0.98) {
            EXPECT_NEAR(ink[column], trapezoid(x, 0.2, 0.15, 2), 0.03) << x;
        }
    }
}

TEST(OverFrames, CenterLinesForGreasePencilAndPathsOfFilesFadeAsWell) {
    const auto frame = middle_of(2, style_of(2), [&](int k) { return std::optional(0.15 * k); });
    const vector::CenterLines lines = vector::center_lines_of(*frame);
    int partial = 0;
    for (std::size_t i = 0; i < lines.opacity.size(); ++i) {
        const vec3& at = lines.position_view[i];
        if (std::abs(std::abs(at.y) - 1.0f) > 1e-3f || std::abs(at.x) > 0.98f) continue;
        EXPECT_NEAR(lines.opacity[i], trapezoid(at.x, 0.2, 0.15, 2), 0.03) << at.x;
        partial += lines.opacity[i] > 0.1f && lines.opacity[i] < 0.9f;
    }
    EXPECT_GE(partial, 4) << "both ends of what the bar hides all the same, on both edges";
    const vector::Drawing drawing = vector::compose(*frame, {});
    int faded = 0;
    vector::for_each_path(drawing.document.layers, [&](const vector::Path& path) {
        faded += path.look.opacity > 0.1 && path.look.opacity < 0.9;
    });
    EXPECT_GT(faded, 4);
}

TEST(OverFrames, WithoutItNothingOfFramesNearCounts) {
    const auto bar = [&](int k) { return std::optional(0.15 * k); };
    Frame alone(job_at(0.0, 0.2, style_of(0)));
    alone.picture();
    EXPECT_EQ(middle_of(2, style_of(0), bar)->passes.combined, alone.passes.combined);
    Frame without_near(job_at(0.0, 0.2, style_of(2)));
    without_near.picture();
    EXPECT_EQ(without_near.passes.combined, alone.passes.combined);
}

TEST(OverFrames, WhereNothingMovesThePictureIsThatOfTheFrameAlone) {
    for (const auto how :
         {style::Vanish::fade, style::Vanish::shrink, style::Vanish::break_up, style::Vanish::retract}) {
        Frame alone(job_at(0.1, 0.2, style_of(0)));
        alone.picture();
        EXPECT_EQ(middle_of(2, style_of(2, how), [](int) { return std::optional(0.1); })->passes.combined,
                  alone.passes.combined);
    }
}

TEST(OverFrames, ABarOfOneFrameLeavesMostOfTheInk) {
    for (const int frames : {1, 2, 3}) {
        const auto blink = [](int of) { return [of](int k) { return k == of ? std::optional(0.0) : std::nullopt; }; };
        const double at_once = ink_along(*middle_of(frames, style_of(frames), blink(0)))[width / 2];
        EXPECT_NEAR(at_once, 1.0 - 0.5 / frames, 0.01);
        EXPECT_GE(at_once, double(frames) / (frames + 1) - 0.01);
        EXPECT_NEAR(ink_along(*middle_of(frames, style_of(frames), blink(frames)))[width / 2], 1.0 - 0.25 / frames,
                    0.01);
    }
}

TEST(OverFrames, DrawnPolylinesGoOnWhereABarOfOneFrameHidesTheLine) {
    const auto frame = middle_of(2, style_of(2), [](int k) { return k == 0 ? std::optional(0.0) : std::nullopt; });
    const auto ends_under_the_bar = [&](bool drawn) {
        const Polylines lines = polylines_of(*frame, drawn);
        EXPECT_EQ(lines.pen.size(), lines.path.size());
        std::size_t ends = 0;
        for (std::size_t r = 0; r < lines.path.size(); ++r)
            for (const auto i : {lines.rows.begin(r), lines.rows.end(r) - 1})
                ends += std::abs(units_of(lines.px[i]).x) < 0.2;
        return ends;
    };
    EXPECT_EQ(ends_under_the_bar(false), 4u) << "of two edges";
    EXPECT_EQ(ends_under_the_bar(true), 0u);
}

TEST(OverFrames, LinesShrinkBreakUpOrRetractInstead) {
    const auto bar = [&](int k) { return std::optional(0.15 * k); };
    const auto drawn = [&](style::Vanish how) { return middle_of(2, style_of(2, how), bar, 0.5); };
    const auto amount = [](const Frame& frame) {
        double sum = 0.0;
        for (const vec4& pixel : frame.passes.lines) sum += pixel.w;
        return sum;
    };
    const auto fades = drawn(style::Vanish::fade), shrinks = drawn(style::Vanish::shrink);
    EXPECT_NEAR(amount(*shrinks) / amount(*fades), 1.0, 0.01);
    const auto half = [](float ink) { return ink > 0.1f && ink < 0.9f; };
    const auto partial = [&](const Frame& frame) { return std::ranges::count_if(ink_along(frame), half); };
    EXPECT_GT(partial(*fades), 50);
    EXPECT_LT(2 * partial(*shrinks), partial(*fades));
    const auto retracts = drawn(style::Vanish::retract), breaks = drawn(style::Vanish::break_up);
    EXPECT_LE(partial(*retracts), 4);
    EXPECT_GT(amount(*breaks), 0.5 * amount(*fades));
    EXPECT_NE(breaks->passes.lines, shrinks->passes.lines);
    // The bar hides 0.5 in the middle of its way for more than half of the time, so ends are where it is half.
    const std::vector<float> ink = ink_along(*retracts);
    for (int column = 0; column < width; ++column) {
        const double x = ((column + 0.5) / width - 0.5) * across, share = trapezoid(x, 0.5, 0.15, 2);
        if (std::abs(x) < 0.98 && std::abs(share - 0.5) > 0.05) {
            EXPECT_NEAR(ink[column], share > 0.5 ? 1.0 : 0.0, 0.01) << x;
        }
    }
}

TEST(OverFrames, BeyondACutTheLastFrameBeforeItGoesOn) {
    const style::Style style = style_of(2);
    const auto bar = [&](int k) { return std::optional(0.15 * std::min(k, 0)); };
    Job job = job_at(bar(0), 0.2, style);
    for (const int k : {-2, -1}) job.near.emplace_back(k, Frame(job_at(bar(k), 0.2, style)).found_lines()->lines);
    Frame cut(std::move(job));
    cut.picture();
    EXPECT_EQ(cut.passes.combined, middle_of(2, style, bar)->passes.combined);
}

TEST(OverFrames, WhatIsElidedStaysSoWhereItIsHiddenNow) {
    const auto bar = [&](int k) { return std::optional(0.15 * k); };
    const auto frame = middle_of(2, style_of(2, style::Vanish::fade, true), bar);
    ASSERT_FALSE(frame->shown.empty());
    each_sample_of_edges(*frame, [&](double, Index s) { EXPECT_EQ(frame->shown[s], 1.0f); });
    // As if it were elided by half in all frames near by.
    style::Style style = style_of(2, style::Vanish::fade, true);
    Job job = job_at(bar(0), 0.2, style);
    for (const int k : {-2, -1, 1, 2}) {
        NearLines lines = Frame(job_at(bar(k), 0.2, style)).found_lines()->lines;
        ShownLines half = *lines.shown;
        std::ranges::fill(half.shown, 0.5f);
        lines.shown = std::make_shared<ShownLines>(half);
        job.near.emplace_back(k, lines);
    }
    Frame elided(std::move(job));
    elided.picture();
    each_sample_of_edges(elided, [&](double x, Index s) {
        if (std::abs(std::abs(x) - 0.1) > 0.02) {
            EXPECT_EQ(elided.shown[s], std::abs(x) < 0.1 ? 0.5f : 1.0f) << x;
        }
    });
}

TEST(OverFrames, SampledVisibilityFadesTheSameWay) {
    const style::Style style = style_of(2);
    const auto job = [&](int k) {
        Job made = job_at(0.15 * k, 0.2, style);
        made.options.visibility = Visibility::atlas;
        return made;
    };
    const auto frame = over_frames::middle_of(2, job);
    const std::vector<float> ink = ink_along(*frame);
    for (int column = 0; column < width; ++column) {
        const double x = ((column + 0.5) / width - 0.5) * across;
        if (std::abs(x) < 0.98) {
            EXPECT_NEAR(ink[column], trapezoid(x, 0.2, 0.15, 2), 0.06) << x;
        }
    }
}
