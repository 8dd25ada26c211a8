// SPDX-License-Identifier: GPL-3.0-or-later
// Dots: figures that their pens fill (elision/figures.h).
#include <gtest/gtest.h>
#include <numeric>

#include <fovea/elision/figures.h>
#include <fovea/runs/groups.h>

#include "elision_fixture.h"

using namespace fovea;
using namespace fovea::draw;

namespace {

constexpr float pen_px = 3.0f;

/// Upright squares of one size, each a figure of four lines, the first most important.
struct Squares {
    Sheet sheet;
    std::vector<vec2> middles;
    Groups figures;
    OwnBands own;

    Squares(std::vector<vec2> at, float size, float pen = pen_px) : middles(std::move(at)) {
        sheet.half_width = 1.5f;
        sheet.step_px = 1.0f;
        for (Index figure = 0; figure < middles.size(); ++figure) {
            for (int k = 0; k < 4; ++k) {
                const auto corner = [&](int i) { return middles[figure] + turned(vec2(0.5f * size), i); };
                sheet.line({corner(k), corner(k + 1)});
                figures.of_run.push_back(figure);
            }
            figures.size_px.push_back(size);
            figures.length_px.push_back(4.0f * size);
            figures.hidden.push_back(0);
        }
        own = sheet.own();
        mark_figures(figures, sheet.runs, sheet.ranks(), 80.0f, own);
        mark_dots(figures, std::vector<float>(sheet.runs.size(), pen), own);
    }

    static vec2 turned(vec2 v, int quarters) {
        for (int i = 0; i < quarters; ++i) v = {-v.y, v.x};
        return v;
    }

    /// Per square, the mean opacity of its lines.
    std::vector<float> opacities() const {
        const Array<float> scores = elision_scores(own, crowding(own, sheet.buffer(own)));
        const Array<float> found = elision_opacities(sheet.clipped, own, scores, {});
        std::vector<float> means;
        for (Index figure = 0; figure < middles.size(); ++figure) {
            std::vector<float> all;
            for (Index k = 0; k < 4; ++k) std::ranges::copy(sheet.of(4 * figure + k, found), std::back_inserter(all));
            means.push_back(std::accumulate(all.begin(), all.end(), 0.0f) / float(all.size()));
        }
        return means;
    }
};

/// Places in a disk, each as likely, the same every time.
std::vector<vec2> scattered(int count, float radius) {
    std::vector<vec2> places;
    for (int i = 0; i < count; ++i) {  // a spiral of equal areas in an order that jumps about
        const int k = int(std::int64_t(i) * 7919 % count);
        const float way = radius * std::sqrt((float(k) + 0.5f) / float(count)), angle = 2.399963f * float(k);
        places.push_back(vec2(100.0f, 80.0f) + way * vec2(std::cos(angle), std::sin(angle)));
    }
    return places;
}

}  // namespace

TEST(Dots, InACrowdKeepTheirDistance) {
    const Squares crowd(scattered(1000, 30.0f), 2.0f);  // 2.8 px of lines in every pixel
    const std::vector<float> left = crowd.opacities();
    EXPECT_EQ(left[0], 1.0f) << "the most important";
    std::size_t clear = 0;
    for (std::size_t i = 0; i < left.size(); ++i) {
        clear += left[i] > 0.5f;
        for (std::size_t j = 0; j < i; ++j)
            if (left[i] > 0.5f && left[j] > 0.5f) {
                EXPECT_GT(glm::distance(crowd.middles[i], crowd.middles[j]), pen_px);
            }
    }
    EXPECT_GT(clear, 40u) << "they are there";
    const float tone = std::accumulate(left.begin(), left.end(), 0.0f) * 25.0f / (3.14159f * 30.0f * 30.0f);
    EXPECT_LT(tone, 1.0f) << "pens of 3 px around squares of 2 px";
    EXPECT_GT(tone, 0.25f);
}

TEST(Dots, WithRoomAreWhole) {
    for (const float opacity : Squares({{40, 80}, {52, 80}, {64, 84}}, 2.0f).opacities()) EXPECT_EQ(opacity, 1.0f);
}

TEST(Dots, AreLostAtAnyAngle) {
    for (const vec2 aside : {vec2(2, 0), vec2(0, 2), vec2(1.4f, 1.4f)}) {
        const std::vector<float> left = Squares({{100, 80}, vec2(100, 80) + aside}, 2.0f).opacities();
        EXPECT_EQ(left[0], 1.0f);
        EXPECT_LT(left[1], 0.1f);
    }
}

TEST(Dots, GrowIntoFiguresSteadily) {
    std::vector<float> before;
    for (float size = 2.0f; size < 12.0f; size += 0.1f) {
        const std::vector<float> left = Squares({{100, 80}, {103, 80}}, size).opacities();
        EXPECT_NEAR(left[1], before.empty() ? left[1] : before[1], 0.15f) << size;
        before = left;
    }
}

TEST(Dots, AreWhatIsSmallBesideItsPen) {
    EXPECT_EQ(Squares({{100, 80}}, 2.0f).own.dot[0], 1.0f);
    EXPECT_EQ(Squares({{100, 80}}, 9.0f).own.dot[0], 0.0f);
    EXPECT_EQ(Squares({{100, 80}}, 2.0f, 0.5f).own.dot[0], 0.0f);
    EXPECT_EQ(Squares({{100, 80}}, 2.0f, 0.0f).own.dot[0], 0.0f) << "a pen without width";
}
