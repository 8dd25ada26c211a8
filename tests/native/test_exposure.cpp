// SPDX-License-Identifier: GPL-3.0-or-later
// Means over the moments of a shutter.
#include <gtest/gtest.h>

#include <fovea/draw/frame.h>
#include <fovea/style/json.h>

#include "drawing.h"
#include "refused.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::drawing;

namespace {

/// A box at x, with hidden lines; their passes are requested.
Job job_at(double x, int width = 120) {
    return {.scene = std::make_shared<Scene>(Scene({place(meshes::box(), moved({x, 0, 0}), 1)})),
            .view = perspective({3, -8, 4}, {0, 0, 0}, 50, width, 90),
            .style = style::read_style(R"({"schema": 1, "line_sets": [{"name": "lines", "kinds": {"contour": {},
                "crease": {}}, "least_length": 0, "pen": {"width": 40}, "hidden": [{"pen": {"width": 20}}]}]})"),
            .options = {.with_hidden = true, .with_line_sets = true},
            .assets = std::make_shared<Assets>("."),
            .backend = std::make_shared<CpuBackend>()};
}

void add(Exposure& exposure, double x, double weight) {
    Frame moment(job_at(x));
    exposure.add(moment, weight);
}

Picture picture_of(Job job) {
    Frame frame(std::move(job));
    frame.picture();
    return std::move(frame.passes);
}

void expect_mean(const Array<vec4>& mean, const Array<vec4>& one, const Array<vec4>& other, float share) {
    ASSERT_EQ(mean.size(), one.size());
    float apart = 0.0f;
    for (std::size_t i = 0; i < mean.size(); ++i) {
        for (int c = 0; c < 4; ++c) EXPECT_NEAR(mean[i][c], one[i][c] + share * (other[i][c] - one[i][c]), 1e-6f);
        apart = std::max(apart, std::abs(one[i].a - other[i].a));
    }
    EXPECT_GT(apart, 0.9f);
}

}  // namespace

TEST(Exposure, IsTheMeanOfItsMomentsByTheirWeights) {
    auto exposure = std::make_shared<Exposure>();
    EXPECT_TRUE(exposure->empty());
    add(*exposure, 0.0, 1.0);
    add(*exposure, 1.0, 2.0);
    exposure->again(1.0);
    const Picture one = picture_of(job_at(0.0)), other = picture_of(job_at(1.0));
    Job job = job_at(0.0);
    job.exposure = exposure;
    const Picture mean = picture_of(job);
    expect_mean(mean.lines, one.lines, other.lines, 0.75f);
    expect_mean(mean.of_lines.hidden, one.of_lines.hidden, other.of_lines.hidden, 0.75f);
    expect_mean(mean.of_lines.line_sets[0].second, one.of_lines.line_sets[0].second, other.of_lines.line_sets[0].second,
                0.75f);
}

TEST(Exposure, OfMomentsThatAgreeIsTheirPictureToTheLastBit) {
    const Picture still = picture_of(job_at(0.3));
    for (const bool drawn_anew : {true, false}) {
        auto exposure = std::make_shared<Exposure>();
        add(*exposure, 0.3, 0.1);
        for (int i = 0; i < 6; ++i)
            if (drawn_anew)
                add(*exposure, 0.3, 0.3);
            else
                exposure->again(0.3);
        Job job = job_at(0.3);
        job.exposure = exposure;
        const Picture mean = picture_of(job);
        EXPECT_EQ(mean.combined, still.combined);
        EXPECT_EQ(mean.lines, still.lines);
        EXPECT_EQ(mean.of_lines.hidden, still.of_lines.hidden);
        EXPECT_EQ(mean.of_lines.line_sets, still.of_lines.line_sets);
    }
}

TEST(Exposure, RefusesMomentsThatCannotBeAveraged) {
    Exposure exposure;
    EXPECT_NE(refused([&] { exposure.again(1.0); }), "");
    Frame moment(job_at(0.0)), wider(job_at(0.0, 160));
    EXPECT_NE(refused([&] { exposure.add(moment, 0.0); }), "");
    exposure.add(moment, 1.0);
    EXPECT_NE(refused([&] { exposure.add(wider, 1.0); }), "");
}
