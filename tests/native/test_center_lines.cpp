// SPDX-License-Identifier: GPL-3.0-or-later
// Strokes of a frame as polylines in space: where they are, and what their pens make of them.
#include <algorithm>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <fovea/style/json.h>
#include <fovea/vector/center_lines.h>

#include "drawing.h"

using namespace fovea;
using namespace fovea::drawing;
using namespace fovea::vector;

namespace {

/// Two boxes, the one behind half hidden; its hidden lines are red.
Job job_of(const std::string& pen, const std::string& more = "") {
    return {
        .scene = std::make_shared<Scene>(
            Scene({place(meshes::box(), moved({0, 0, 0}), 1), place(meshes::box(), moved({1.5, 2.5, 0.3}), 2)})),
        .view = perspective({3, -8, 4}, {0, 1, 0}, 50, 240, 180),
        .style = style::read_style(
            R"({"schema": 1, "line_sets": [{"kinds": {"contour": {}, "crease": {"angle": 40}}, "least_length": 0, )" +
            more + R"( "pen": )" + pen + R"(, "hidden": [{"pen": {"width": 2, "color": [1, 0, 0]}}]}]})"),
        .assets = std::make_shared<Assets>("."),
        .backend = std::make_shared<CpuBackend>()};
}

/// Calls visit(line, point) for all points of visible lines.
template <typename Visit>
void each_visible(const CenterLines& lines, const Visit& visit) {
    for (Index r = 0; r < lines.rows.count(); ++r)
        for (Index i = lines.rows.begin(r); i < lines.rows.end(r) && lines.invisibility[r] == 0; ++i) visit(r, i);
}

}  // namespace

TEST(CenterLines, LieOnTheEdgesThatTheyDrawAsWideAsThePen) {
    Frame frame(job_of(R"({"width": 12, "opacity": 0.5, "color": [0, 0.25, 1]})"));
    const CenterLines lines = center_lines_of(frame);
    const dmat4 to_world = glm::inverse(frame.job.view.world_to_view);
    std::size_t points = 0;
    each_visible(lines, [&](Index, Index i) {
        const dvec3 at(to_world * dvec4(dvec3(lines.position_view[i]), 1.0));
        const auto off = [&](const dvec3& center) {
            dvec3 away = glm::abs(glm::abs(at - center) - 1.0);
            if (away.x > away.y) std::swap(away.x, away.y);
            if (away.y > away.z) std::swap(away.y, away.z);
            return std::max(away.x, away.y);  // two coordinates of a place on an edge are those of its faces
        };
        EXPECT_LT(std::min(off({0, 0, 0}), off({1.5, 2.5, 0.3})), 0.02);
        EXPECT_NEAR(lines.width_px[i], 12.0f, 1e-4f);
        EXPECT_NEAR(lines.opacity[i], 0.5f, 1e-5f);
        EXPECT_EQ(lines.color[i], vec3(0, 0.25f, 1));
        EXPECT_NE(lines.kinds[i], 0u);
        ++points;
    });
    EXPECT_GT(points, 20u);
}

TEST(CenterLines, OfHiddenPartsHaveTheirPen) {
    Frame frame(job_of(R"({"width": 12})"));
    const CenterLines lines = center_lines_of(frame);
    EXPECT_GT(std::ranges::count(lines.invisibility, 1), 3);
    for (Index r = 0; r < lines.rows.count(); ++r) {
        EXPECT_EQ(lines.pen[r], lines.invisibility[r] > 0 ? 1u : 0u);
        EXPECT_EQ(lines.color[lines.rows.begin(r)], vec3(lines.invisibility[r] > 0, 0, 0));
    }
}

TEST(CenterLines, AreSortedByTheIdsOfTheirPathsWhateverTheNumberOfThreads) {
    Frame many(job_of(R"({"width": 12})"));
    const CenterLines lines = center_lines_of(many);
    EXPECT_TRUE(std::ranges::is_sorted(lines.path_id));
    tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    Frame alone(job_of(R"({"width": 12})"));
    const CenterLines same = center_lines_of(alone);
    EXPECT_EQ(lines.rows.offsets, same.rows.offsets);
    EXPECT_EQ(lines.path_id, same.path_id);
    EXPECT_EQ(lines.position_view, same.position_view);
}

TEST(CenterLines, TaperAndOvershootAsStrokesDo) {
    const auto least_and_longest = [](Job job) {
        Frame frame(std::move(job));
        const CenterLines lines = center_lines_of(frame);
        float least = 1e9f, longest = 0.0f;
        each_visible(lines, [&](Index r, Index i) {
            least = std::min(least, lines.width_px[i]);
            const Index first = lines.rows.begin(r), last = lines.rows.end(r) - 1;
            longest = std::max(longest, glm::distance(lines.position_view[first], lines.position_view[last]));
        });
        return std::pair(least, longest);
    };
    const auto [plain, edge] = least_and_longest(job_of(R"({"width": 24})"));
    EXPECT_NEAR(edge, 2.0f, 1e-3f);
    EXPECT_LT(least_and_longest(job_of(R"({"width": 24, "pressure": 0.8})")).first, 0.5f * plain);
    EXPECT_GT(least_and_longest(job_of(R"({"width": 24})", R"("overshoot": 40,)")).second, 1.05f * edge);
}

TEST(CenterLines, AreOfThePenOutOfFocusAsFarAsFocusHasIt) {
    Job job = job_of(R"({"width": 12, "color": [1, 1, 1]})");
    style::LineSet& set = job.style.line_sets[0];
    set.pen_away = set.pen;
    set.pen_away->color = dvec3(0.0);
    job.style.focus.model = style::FocusModel::scene;
    style::FocusPlace& place = job.style.focus.points.emplace_back();
    place.at = {0, 1, 0};
    place.near = 0.0;
    place.far = 4.0;
    Frame frame(std::move(job));
    const CenterLines lines = center_lines_of(frame);
    const dvec3 center(frame.job.view.world_to_view * dvec4(0, 1, 0, 1));
    float least = 1.0f, most = 0.0f;
    each_visible(lines, [&](Index, Index i) {
        const float focus = std::min(float(glm::distance(dvec3(lines.position_view[i]), center)) / 4.0f, 1.0f);
        EXPECT_NEAR(lines.color[i].x, 1.0f - focus, 0.06f);
        least = std::min(least, lines.color[i].x), most = std::max(most, lines.color[i].x);
    });
    EXPECT_GT(most - least, 0.3f);
}

TEST(CenterLines, EndWhereNothingIsDrawnAndGoOnAfterIt) {
    const std::string gap = R"({"width": 12, "along_opacity": {"start": 0, "end": 1, "strength": 1,
        "curve": [[0, 0], [0.3, 0], [0.4, 1], [0.6, 1], [0.7, 0], [1, 0]]}})";
    Frame whole(job_of(R"({"width": 12})")), parted(job_of(gap));
    const CenterLines one = center_lines_of(whole), two = center_lines_of(parted);
    const auto visible = [](const CenterLines& lines) { return std::ranges::count(lines.invisibility, 0); };
    EXPECT_EQ(visible(two), 2 * visible(one));
    each_visible(two, [&](Index r, Index i) {
        const bool inside = i > two.rows.begin(r) && i + 1 < two.rows.end(r);
        EXPECT_TRUE(!inside || two.opacity[i] > 0.0f);
    });
}
