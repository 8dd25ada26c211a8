// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <tbb/global_control.h>

#include <fovea/elision/in_time.h>

#include "wires.h"

using namespace fovea;
using namespace fovea::draw;

namespace {

/// Lines of the scene before a camera, wholly visible unless said otherwise.
struct TimedFrame {
    wires::Wires lines;
    View view;
    ClippedPaths clipped;
    Runs runs;
    Array<float> shown;

    explicit TimedFrame(const std::vector<std::vector<dvec3>>& points, dmat4 to_world = dmat4(1.0),
                        double step_px = 2.0)
        : lines(points, to_world), view(wires::camera()), clipped(lines.project(view, {.sample_step_px = step_px})) {
        for (Index q = 0; q < clipped.path.size(); ++q)
            runs.push(q, clipped.arc_px[wires::first_of(clipped, q)], clipped.arc_px[wires::last_of(clipped, q)]);
        shown.resize(clipped.samples);
        std::ranges::fill(shown, 1.0f);
    }
    TimedFrame& with(float value) {
        std::ranges::fill(shown, value);
        return *this;
    }
    /// A run over a share of the first piece.
    TimedFrame& only(double from, double to, std::uint8_t hidden_by = 0) {
        const double begin = clipped.arc_px[wires::first_of(clipped, 0)],
                     end = clipped.arc_px[wires::last_of(clipped, 0)];
        runs = {};
        runs.push(0, glm::mix(begin, end, from), glm::mix(begin, end, to), hidden_by);
        return *this;
    }
    ShownLines told() const {
        return shown_lines(clipped, lines.paths, lines.scene, runs, shown, view.width, view.height);
    }
};

const std::vector<dvec3> across{{-0.6, 0.1, -1.0}, {0.6, 0.1, -1.0}};

TimedFrame plain(float value) { return TimedFrame({across}).with(value); }

/// The middle frame of some, smoothed.
Array<float> middle_of(const std::vector<TimedFrame>& frames, int reach) {
    std::vector<std::shared_ptr<const ShownLines>> told;
    for (const TimedFrame& frame : frames) told.push_back(std::make_shared<ShownLines>(frame.told()));
    const int middle = int(frames.size()) / 2;
    std::vector<FrameNear> near;
    for (int k = 0; k < int(frames.size()); ++k)
        if (k != middle) near.push_back({k - middle, told[k]});
    return smoothed_in_time(frames[middle].shown, *told[middle], near, reach);
}

}  // namespace

TEST(ElisionInTime, AStepBecomesTheSumOfATriangle) {
    for (const int reach : {1, 2, 3, 8}) {
        double before = 0.0, largest = 0.0;
        for (int at = -reach - 1; at <= reach + 1; ++at) {  // of the frame, where 0 is the first after the step
            std::vector<TimedFrame> frames;
            double sum = 0.0, total = 0.0;
            for (int k = -reach; k <= reach; ++k) {
                frames.push_back(plain(at + k >= 0 ? 1.0f : 0.0f));
                total += reach + 1 - std::abs(k);
                if (at + k >= 0) sum += reach + 1 - std::abs(k);
            }
            for (const float shown : middle_of(frames, reach)) EXPECT_FLOAT_EQ(shown, float(sum / total));
            largest = std::max(largest, sum / total - before);
            before = sum / total;
        }
        EXPECT_NEAR(largest, 1.0 / (reach + 1), 1e-12);
        EXPECT_EQ(before, 1.0);
    }
}

TEST(ElisionInTime, AFrameAloneIsAsItWas) {
    TimedFrame frame({across});
    std::mt19937 random(3);
    std::uniform_real_distribution<float> any(0.0f, 1.0f);
    for (float& shown : frame.shown) shown = any(random);
    EXPECT_EQ(middle_of({frame}, 3), frame.shown);
    // And so are frames in which nothing changes.
    EXPECT_EQ(middle_of({frame, frame, frame, frame, frame}, 2), frame.shown);
}

TEST(ElisionInTime, FramesThatDoNotSeeThePlaceAreLeftOut) {
    // Only the left half of the line is there a frame before, and nothing of it a frame after.
    TimedFrame before = plain(0.0f).only(0.0, 0.5), after = plain(0.0f);
    after.runs = {};
    const TimedFrame now = plain(1.0f);
    const Array<float> smooth = middle_of({before, now, after}, 1);
    for (std::size_t s = 0; s < smooth.size(); ++s) {
        const double share = (double(s) + 0.5) / double(smooth.size());
        if (std::abs(share - 0.5) < 0.01) continue;  // the run ends within a sample
        EXPECT_FLOAT_EQ(smooth[s], share < 0.5 ? 2.0f / 3.0f : 1.0f) << s;
    }
}

TEST(ElisionInTime, WhatIsHiddenThereIsNotWhatIsVisibleHere) {
    const TimedFrame hidden = plain(0.0f).only(0.0, 1.0, 2);
    for (const float shown : middle_of({hidden, plain(1.0f), hidden}, 1)) EXPECT_EQ(shown, 1.0f);
    TimedFrame also = plain(1.0f).only(0.0, 1.0, 1);
    for (const float shown : middle_of({hidden, also, hidden}, 1)) EXPECT_FLOAT_EQ(shown, 0.5f);
}

TEST(ElisionInTime, WhatLiesOutsideOfThePictureSaysNothing) {
    // Moved to the right, the line leaves the picture, whose half width is .8: lines go on beyond it.
    const TimedFrame now = plain(0.0f);
    const TimedFrame moved = TimedFrame({across}, glm::translate(dmat4(1.0), dvec3(0.25, 0.0, 0.0)));
    const Array<float> smooth = middle_of({moved, now, moved}, 1);
    const double last = (0.8 - 0.25 + 0.6) / 1.2 * double(smooth.size());
    for (std::size_t s = 0; s < smooth.size(); ++s) {
        if (std::abs(double(s) - last) < 1.5) continue;
        EXPECT_FLOAT_EQ(smooth[s], double(s) < last ? 0.5f : 0.0f) << s;
    }
    const Array<float> outside = middle_of({now, moved, now}, 1);
    EXPECT_EQ(outside.back(), 1.0f);
    EXPECT_FLOAT_EQ(outside.front(), 0.5f);
}

TEST(ElisionInTime, ThePlaceIsFoundWhereverTheLineIsAndHoweverItIsSampled) {
    // Opacity is a function of the place: the mean over frames is that function, up to steps of samples.
    const std::vector<dvec3> bent{{-0.5, -0.2, -1.0}, {0.1, 0.1, -1.6}, {0.4, -0.3, -1.2}};
    const double length = glm::distance(bent[0], bent[1]) + glm::distance(bent[1], bent[2]);
    const auto seen = [&](dmat4 to_world, double step_px) {
        TimedFrame frame({bent}, to_world, step_px);
        for (const LinePlaces::Sample& at : frame.told().places.samples)
            frame.shown[at.number] = float(at.arc / length);
        return frame;
    };
    const dmat4 nearer = glm::translate(dmat4(1.0), dvec3(0.05, -0.03, 0.2));
    const dmat4 turned = glm::rotate(dmat4(1.0), 0.1, dvec3(0, 1, 0));
    const TimedFrame now = seen(dmat4(1.0), 2.0);
    for (const bool across_triangles : {false, true}) {
        std::vector<TimedFrame> frames{seen(nearer, 3.1), now, seen(turned, 0.7)};
        if (across_triangles)
            for (TimedFrame& frame : frames) std::ranges::fill(frame.lines.paths.place, Index(1000));
        const Array<float> smooth = middle_of(frames, 1);
        ASSERT_EQ(smooth.size(), now.shown.size());
        EXPECT_NE(smooth, now.shown);
        for (std::size_t i = 2; i + 2 < smooth.size(); ++i) EXPECT_NEAR(smooth[i], now.shown[i], 1e-5);
        EXPECT_LT(smooth.front(), 0.01f);
        EXPECT_GT(smooth.back(), 0.99f);
    }
}

TEST(ElisionInTime, ThePlaceIsFoundOnPathsThatBeginElsewhereOrGoTheOtherWay) {
    const std::vector<dvec3> all{{-0.6, 0.1, -1.0}, {0.0, 0.2, -1.0}, {0.6, 0.1, -1.0}};
    TimedFrame now({all}), later({{all[1], all[2]}}), earlier({{all[2], all[1]}});
    // These have the second edge alone, one from its second vertex.
    std::ranges::fill(later.lines.paths.place, Index(1));
    earlier.lines.paths.place = later.lines.paths.place;
    earlier.lines.paths.edge_t = {1.0f, 0.0f};
    for (TimedFrame* frame : {&now, &later, &earlier}) {
        frame->lines.scene = now.lines.scene;
        for (const LinePlaces::Sample& at : frame->told().places.samples)
            frame->shown[at.number] = frame == &now ? 1.0f : float(at.share);
    }
    const Array<float> smooth = middle_of({earlier, now, later}, 1);
    for (const LinePlaces::Sample& at : now.told().places.samples) {
        const bool first_edge = at.arc < glm::distance(all[0], all[1]);
        EXPECT_NEAR(smooth[at.number], first_edge ? 1.0 : 0.5 + 0.5 * at.share, 5e-3) << at.arc;
    }
}

TEST(ElisionInTime, LinesOfTheViewStay) {
    TimedFrame now({across, {{-0.6, 0.2, -1}, {0.6, 0.2, -1}}}), other = TimedFrame(now).with(0.0f);
    now.lines.paths.of_view = other.lines.paths.of_view = {1, 0};
    const Array<float> smooth = middle_of({other, now, other}, 1);
    for (std::size_t s = 0; s < smooth.size(); ++s) EXPECT_FLOAT_EQ(smooth[s], s < smooth.size() / 2 ? 1.0f : 0.5f);
}

TEST(ElisionInTime, TheSameForAnyNumberOfThreads) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> x(-0.9, 0.9), z(-3.0, -1.0);
    std::uniform_real_distribution<float> any(0.0f, 1.0f);
    std::vector<std::vector<dvec3>> lines;
    for (int k = 0; k < 400; ++k)
        lines.push_back({{x(random), x(random), z(random)}, {x(random), x(random), z(random)}});
    std::vector<TimedFrame> frames;
    for (int k = 0; k < 5; ++k) {
        frames.emplace_back(lines, glm::rotate(dmat4(1.0), 0.01 * k, dvec3(0, 1, 0)));
        for (float& shown : frames.back().shown) shown = any(random);
    }
    const Array<float> many = middle_of(frames, 2);
    EXPECT_NE(many, frames[2].shown);
    tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(many, middle_of(frames, 2));
}

TEST(ElisionInTime, RefusesWhatMakesNoSense) {
    const TimedFrame frame = plain(1.0f);
    const auto told = std::make_shared<ShownLines>(frame.told());
    EXPECT_THROW(smoothed_in_time(frame.shown, *told, std::vector<FrameNear>{{0, told}}, 1), std::invalid_argument);
    EXPECT_THROW(smoothed_in_time(frame.shown, *told, std::vector<FrameNear>{{-2, told}}, 1), std::invalid_argument);
    EXPECT_THROW(smoothed_in_time(std::vector<float>{1.0f}, *told, {}, 1), std::invalid_argument);
    EXPECT_THROW(
        shown_lines(frame.clipped, frame.lines.paths, frame.lines.scene, frame.runs, std::vector<float>{1.0f}, 10, 10),
        std::invalid_argument);
}
