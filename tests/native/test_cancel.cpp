// SPDX-License-Identifier: GPL-3.0-or-later
// Cancellation: every stage of a picture, and everything that is read from a mesh, polls it often enough, told by
// counts of polls, and ends at once when it is asked.
#include <algorithm>
#include <array>
#include <atomic>
#include <gtest/gtest.h>
#include <map>
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_group.h>

#include <fovea/base/cancel.h>
#include <fovea/base/parallel.h>
#include <fovea/draw/frame.h>
#include <fovea/field/fields.h>
#include <fovea/line/streamlines.h>
#include <fovea/mesh/refine.h>
#include <fovea/mesh/spheres.h>
#include <fovea/repair/repair.h>
#include <fovea/scene/bvh.h>
#include <fovea/style/json.h>

#include "drawing.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::drawing;
using namespace fovea::meshes;

namespace {

/// Counts polls, and asks for cancellation from the `last` on.
struct Counting : Cancel {
    explicit Counting(std::int64_t until = std::int64_t(1) << 60) : last(until) {}
    bool asked() const override { return ++polls >= last; }

    const std::int64_t last;
    mutable std::atomic<std::int64_t> polls{0};
};

constexpr const char* everything =
    R"({"schema": 1, "elision": {"enabled": true}, "line_sets": [{"least_length": 0, "halo": 3, "overshoot": 2,
    "kinds": {"contour": {}, "smooth_contour": {}, "crease": {}, "border": {}, "intersection": {},
    "suggestive_contour": {}, "ridge": {}, "apparent_ridge": {}, "image_edge": {}, "abstracted_shading": {}},
    "pen": {"width": 2}, "hidden": [{"pen": {"width": 1}}]}],
    "color": {"shading": "smooth"},
    "focus": {"model": "image", "points": [{"at": [0.5, 0.5, 0], "near": 0.1, "far": 0.5}]}})";

Job job_of(std::shared_ptr<const Cancel> cancel, int size) {
    const auto scene = std::make_shared<Scene>(
        Scene({place(sphere(size)), place(grid(size, 3.0f), dmat4(1.0), 2), place(box(), moved({0.6, 0.2, 0.3}), 3)}));
    Options options;
    options.with_depth = options.with_focus = true;
    return {.scene = scene,
            .view = perspective({3, -8, 4}, {0, 0, 0}, 50, 160, 120),
            .style = style::read_style(everything),
            .options = options,
            .assets = std::make_shared<Assets>("."),
            .backend = std::make_shared<CpuBackend>(),
            .colors = ColorSources{.surfaces = SceneColor(3), .lights = {}},
            .cancel = std::move(cancel)};
}

/// Number of polls in each stage of a picture.
std::map<std::string, std::int64_t> polls_of_stages(int size) {
    const auto counting = std::make_shared<Counting>();
    Job job = job_of(counting, size);
    std::map<std::string, std::int64_t> polls;
    std::string now;
    std::int64_t before = 0;
    const auto enter = [&](const std::string& next) {
        if (!now.empty()) polls[now] += counting->polls - before;
        before = counting->polls;
        now = next;
    };
    job.progress = [&](double, const std::string& stage) { enter(stage); };
    Frame frame(std::move(job));
    frame.picture();
    enter("");
    return polls;
}

/// How often body() polls, and whether it can be cancelled at its last poll.
template <typename Body>
std::int64_t polls_of(const Body& body) {
    const Counting all;
    {
        const Cancelling scope(&all);
        body();
    }
    const Counting until(all.polls);
    const Cancelling scope(&until);
    EXPECT_THROW(body(), Cancelled);
    return all.polls;
}

}  // namespace

TEST(Cancel, EveryStageOfAPicturePollsIt) {
    const auto polls = polls_of_stages(24);
    for (const char* stage : {"bvh", "lines", "project", "visibility", "runs", "elision", "shape", "strokes", "color",
                              "focus", "paper", "depth"}) {
        ASSERT_TRUE(polls.contains(stage)) << stage;
        EXPECT_GE(polls.at(stage), 2) << stage;
    }
}

TEST(Cancel, EndsAPictureAtWhicheverPollItIsAsked) {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const auto counting = std::make_shared<Counting>();
    Frame(job_of(counting, 12)).picture();
    const std::int64_t all = counting->polls;
    ASSERT_GT(all, 100);
    for (std::int64_t last = 1; last < all; last += std::max<std::int64_t>(1, all / 60)) {
        const auto until = std::make_shared<Counting>(last);
        EXPECT_THROW(Frame(job_of(until, 12)).picture(), Cancelled) << last;
        EXPECT_LE(until->polls, last + 2) << "it went on";
    }
}

TEST(Cancel, LeavesSurfacesAsGoodAsNew) {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    Job whole = job_of(std::make_shared<Cancel>(), 12);
    Frame expected(job_of(std::make_shared<Cancel>(), 12));
    expected.picture();
    for (const std::int64_t last : {3, 20, 60, 150, 300}) {
        Job cut = whole;
        cut.cancel = std::make_shared<Counting>(last);
        EXPECT_THROW(Frame(std::move(cut)).picture(), Cancelled) << last;
    }
    Frame after(whole);
    after.picture();
    EXPECT_EQ(after.passes.combined, expected.passes.combined);
}

TEST(Cancel, IsPolledTheMoreOftenTheMoreThereIsToRead) {
    const auto surface = [](int n) { return [n] { grid(n).surface(); }; };
    EXPECT_GE(polls_of(surface(200)), 2 * polls_of(surface(50)));
    const auto fields = [](int n) {
        return [n] {
            const auto made = grid(n).surface();
            made->set_field_options({.estimator = Estimator::jets});
            field::fields_of(*made);
        };
    };
    EXPECT_GE(polls_of(fields(120)), 2 * polls_of(fields(40)));
    const auto bvh = [](int n) {
        const auto made = grid(n).surface();
        return [made] { const scene::SurfaceBvh built(*made); };
    };
    EXPECT_GE(polls_of(bvh(300)), 2);
    const auto resampled = [](int steps) {
        return [steps] { repair::repaired("box", box().arrays(), {.resample = steps, .edge_length = 0.02}); };
    };
    EXPECT_GE(polls_of(resampled(6)), 2 * polls_of(resampled(4)));
    const auto streams = [](int power) {
        return [power] { line::streamlines(*sphere(12).surface(), std::array{0.3, 1.0}, power); };
    };
    EXPECT_GE(polls_of(streams(-6)), 3 * polls_of(streams(-4)));
}

TEST(Cancel, OfATaskLeavesNoLoopWithinItHalfDone) {
    // A loop that ends early as if it were done would leave what it has not filled in a surface's cache.
    const auto surface = sphere(12).surface();
    constexpr std::size_t count = 100'000;
    std::atomic<std::size_t> done = 0, kept = 0;
    bool invoked[2] = {};
    std::vector<std::size_t> numbers(count);
    for (std::size_t i = 0; i < count; ++i) numbers[i] = i * 7919 % count;
    tbb::task_group_context outer;
    const auto body = [&](const tbb::blocked_range<int>&) {
        outer.cancel_group_execution();  // as where a task beside it throws
        parallel_for(count, 100, [&](std::size_t) { ++done; });
        parallel_invoke([&] { invoked[0] = true; }, [&] { invoked[1] = true; });
        parallel_sort(numbers.begin(), numbers.end());
        for (const auto& lines : line::streamlines(*surface, std::array{0.3, 1.0}, -4)) kept += lines->count();
    };
    tbb::parallel_for(tbb::blocked_range<int>(0, 1), body, outer);
    EXPECT_EQ(done, count);
    EXPECT_TRUE(invoked[0] && invoked[1]);
    EXPECT_TRUE(std::ranges::is_sorted(numbers));
    EXPECT_EQ(kept, 2 * surface->triangles.size());
}

TEST(Cancel, OfAScopeIsForgottenAfterIt) {
    const Counting outer, inner;
    const Cancelling first(&outer);
    {
        const Cancelling second(&inner);
        Cancelling::poll();
    }
    Cancelling::poll();
    EXPECT_EQ(inner.polls, 1);
    EXPECT_EQ(outer.polls, 1);
    const Cancelling none(nullptr);
    Cancelling::poll();
    EXPECT_EQ(outer.polls, 1);
}
