// SPDX-License-Identifier: GPL-3.0-or-later
// Marks of lines of the view, handed on from frame to frame.
#include <gtest/gtest.h>

#include <fovea/draw/frame.h>
#include <fovea/stroke/anchor.h>
#include <fovea/style/json.h>

#include "drawing.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::drawing;

namespace {

constexpr double period = 18.0;
using Lines = std::shared_ptr<const MarkedLines>;

meshes::Mesh bumps(double phase = 0.0) {
    return meshes::relief(90,
                          [phase](double x, double y) { return 0.3 * std::sin(4 * x + 1) * std::cos(3 * y + phase); });
}

Lines lines_of(const std::vector<Placement>& placements, const View& view,
               const std::vector<const char*>& names = {"smooth_contour"}, double length = period) {
    const Drawing drawing(placements, view, {line_set(names)});
    const auto of_view = std::make_shared<ViewLines>(view_lines(drawing.clipped, drawing.paths, drawing.scene, view));
    return std::make_shared<MarkedLines>(
        marked_lines(of_view, drawing.clipped, drawing.paths, drawing.scene, std::vector<double>{length}));
}

View orbit(double degrees) {
    const double a = glm::radians(degrees);
    return perspective({8 * std::sin(a), -8 * std::cos(a), 1.5}, {0, 0, 0}, 80);
}

/// Frames of a camera that turns by a quarter of a degree a frame around bumps.
std::vector<Lines> turning(int count) {
    std::vector<Lines> frames;
    for (int k = 0; k < count; ++k) frames.push_back(lines_of({place(bumps(), dmat4(1.0), 7)}, orbit(10 + 0.25 * k)));
    return frames;
}

/// Of one of some frames, the first of which is a key.
Marks marks_at(const std::vector<Lines>& frames, int k, int apart) {
    std::vector<MarkedNear> near;
    for (int i = 0; i < int(frames.size()); ++i)
        if (i != k && i / apart * apart >= k / apart * apart - apart) near.emplace_back(i - k, frames[i]);
    return marks_in_time(frames[k], near, k % apart, apart);
}

double wrapped(double difference) { return difference - period * std::round(difference / period); }

/// By how much marks slide, at points that stay on their surface while the camera goes from a frame to the next, with
/// whole periods; ascending. `moved`: of a point of the object, where it was in the image of the earlier one.
template <typename Moved>
std::vector<double> slides_of_numbers(const Marks& before, const Marks& after, const Moved& moved) {
    const ViewLines &a = *before.of->lines, &b = *after.of->lines;
    std::vector<double> found;
    for (std::size_t j = 0; j < b.places.size(); ++j) {
        const dvec2 px = moved(b.places[j]);
        double nearest = 3.0;
        std::size_t at = none;
        for (std::size_t i = 0; i < a.places.size(); ++i) {
            const double away = glm::distance(a.places[i].px, px);
            if (away < nearest && std::abs(glm::dot(a.places[i].way, b.places[j].way)) > 0.9) nearest = away, at = i;
        }
        if (at == none) continue;
        const std::size_t beside = at + 1 < a.rows.end(a.places[at].piece) ? at + 1 : at - 1;
        const double slope = (before.at[beside] - before.at[at]) / (a.places[beside].arc - a.places[at].arc);
        const double there = before.at[at] + slope * glm::dot(px - a.places[at].px, a.places[at].way);
        found.push_back(std::abs(after.at[j] - there));
    }
    std::ranges::sort(found);
    return found;
}

std::vector<double> slides_of_numbers(const Marks& before, const Marks& after) {
    const ViewLines& a = *before.of->lines;
    return slides_of_numbers(before, after, [&](const ViewLines::Place& place) {
        return to_pixels(a.pose.view, a.pose.view.view_to_clip *
                                          (a.pose.placed[0].object_to_view * dvec4(place.point.position, 1.0)));
    });
}

/// The same to the nearest mark; `moved` as above, if it is given.
template <typename... Moved>
std::vector<double> slides(const Marks& before, const Marks& after, const Moved&... moved) {
    std::vector<double> found = slides_of_numbers(before, after, moved...);
    for (double& slide : found) slide = std::abs(wrapped(slide));
    std::ranges::sort(found);
    return found;
}

double share_of(const std::vector<double>& sorted, double share) {
    return sorted[std::size_t(share * (sorted.size() - 1))];
}

}  // namespace

TEST(Marks, AreThoseOfTheFrameAloneInAKeyAndWithoutFramesNearIt) {
    const std::vector<Lines> frames = turning(3);
    for (const Marks& marks : {marks_at(frames, 0, 8), marks_in_time(frames[1], {}, 1, 8)}) {
        ASSERT_FALSE(marks.of->own.empty());
        EXPECT_EQ(marks.share, 0.0);
        for (std::size_t j = 0; j < marks.at.size(); ++j) EXPECT_EQ(marks.at[j], marks.of->own[j]);
    }
}

TEST(Marks, StayWithTheSurfaceAfterAKey) {
    const std::vector<Lines> frames = turning(8);
    for (int k = 1; k < 8; ++k) {
        const std::vector<double> found = slides(marks_at(frames, k - 1, 64), marks_at(frames, k, 64));
        ASSERT_GT(found.size(), 0.95 * frames[k]->own.size());
        EXPECT_LT(share_of(found, 0.5), 0.02) << k;
        EXPECT_LT(share_of(found, 0.9), 0.5) << k;
    }
}

TEST(Marks, KeepTheirNumbersWhereLinesGetOtherIds) {
    // Noise differs from one mark to the next: places stay in the same one, not only at the same place of one.
    const std::vector<Lines> frames = turning(12);
    std::size_t others = 0;
    for (int k = 2; k < 12; ++k) {
        const Marks before = marks_at(frames, k - 1, 64), after = marks_at(frames, k, 64);
        std::size_t changed = 0;
        for (const double slide : slides_of_numbers(before, after)) changed += slide > 0.5 * period;
        EXPECT_LT(changed, 0.05 * frames[k]->own.size()) << k;
        for (const double slide : slides_of_numbers(marks_at(frames, k - 1, 1), marks_at(frames, k, 1)))
            others += slide > 0.5 * period;
    }
    EXPECT_GT(others, frames[0]->own.size());
}

TEST(Marks, OfAFrameAloneSlideWithTheEndsOfItsLines) {
    const std::vector<Lines> frames = turning(4);
    double most = 0.0;
    for (int k = 1; k < 4; ++k)
        most = std::max(most, share_of(slides(marks_at(frames, k - 1, 1), marks_at(frames, k, 1)), 0.5));
    EXPECT_GT(most, 0.5);
}

TEST(Marks, GoOverToThoseOfTheNextKeyByAtMostHalfAPeriodInAllTheFrames) {
    constexpr int apart = 8;
    const std::vector<Lines> frames = turning(2 * apart + 1);
    std::vector<double> all;
    for (int k = 1; k <= 2 * apart; ++k) {
        const std::vector<double> found = slides(marks_at(frames, k - 1, apart), marks_at(frames, k, apart));
        EXPECT_LT(share_of(found, 0.85), 0.5 * period / apart + 0.1) << k;
        all.insert(all.end(), found.begin(), found.end());
    }
    std::ranges::sort(all);
    EXPECT_GT(share_of(all, 0.5), 0.1);  // they do go over
}

TEST(Marks, DoNotDependOnFramesBeyondTheirKeys) {
    const std::vector<Lines> frames = turning(9);
    const auto with = [&](int from, int to) {
        std::vector<MarkedNear> near;
        for (int i = from; i < to; ++i)
            if (i != 6) near.emplace_back(i - 6, frames[i]);
        return marks_in_time(frames[6], near, 2, 4).at;
    };
    EXPECT_EQ(with(0, 9), with(4, 9));
    EXPECT_NE(with(0, 9), with(5, 9));
}

TEST(Marks, BeginAtACutAndHoldWhatTheyAreTowardsOne) {
    const std::vector<Lines> frames = turning(5);
    const auto at = [&](int k, int first, int last) {
        std::vector<MarkedNear> near;
        for (int i = first; i <= last; ++i)
            if (i != k) near.emplace_back(i - k, frames[i]);
        return marks_in_time(frames[k], near, k, 4);
    };
    const Marks after = at(2, 2, 4);  // frames 0 and 1 are beyond a cut
    EXPECT_EQ(after.share, 0.0);
    for (std::size_t j = 0; j < after.at.size(); ++j) EXPECT_EQ(after.at[j], frames[2]->own[j]);
    EXPECT_EQ(at(3, 2, 4).share, 0.5);  // of the way from the cut to the key
    const Marks towards = at(2, 0, 3);  // frame 4 is
    EXPECT_EQ(towards.share, 0.0);
    EXPECT_EQ(towards.at, towards.last);
    EXPECT_LT(share_of(slides(at(1, 0, 3), towards), 0.5), 0.02);
}

TEST(Marks, OfAMomentAreThoseOfItsFrameWhichIsThenAmongTheNeighbors) {
    const std::vector<Lines> frames = turning(5);
    std::vector<MarkedNear> near;
    for (int i = 0; i < 5; ++i) near.emplace_back(i - 2, frames[i]);
    const Marks still = marks_in_time(frames[2], near, 2, 4);
    const Marks itself = marks_at(frames, 2, 4);
    EXPECT_EQ(still.share, itself.share);
    for (std::size_t j = 0; j < still.at.size(); ++j) ASSERT_NEAR(wrapped(still.at[j] - itself.at[j]), 0.0, 0.3);
    const Lines later = lines_of({place(bumps(), dmat4(1.0), 7)}, orbit(10 + 0.25 * 2.1));
    const std::vector<double> found = slides(itself, marks_in_time(later, near, 2, 4));
    EXPECT_LT(share_of(found, 0.9), 0.1);
}

TEST(Marks, MoveWithASurfaceThatDeforms) {
    // A sheet that bends upwards, whose rest shape is another one.
    std::vector<Lines> frames;
    std::vector<std::vector<vec3>> at;
    const meshes::Mesh rest = bumps();
    for (int k = 0; k < 6; ++k) {
        meshes::Mesh mesh = rest;
        for (vec3& p : mesh.positions) p = vec3(p.x, p.y + 0.01 * k, p.z + 0.02 * k * p.x * p.x);
        Placement placed = place(mesh, dmat4(1.0), 7);
        const auto surface = mesh.surface();
        surface->set_rest(rest.positions);
        placed.surface = surface;
        frames.push_back(lines_of({placed}, orbit(10)));
        at.push_back(mesh.positions);
        ASSERT_FALSE(frames.back()->lines->pose.placed[0].at().empty());
    }
    for (int k = 1; k < 6; ++k) {
        const ViewLines& a = *frames[k - 1]->lines;
        const auto moved = [&](const ViewLines::Place& place) {
            dvec3 sum(0.0);
            for (int c = 0; c < 3; ++c) sum += place.point.shares[c] * dvec3(at[k - 1][place.point.vertices[c]]);
            return to_pixels(a.pose.view,
                             a.pose.view.view_to_clip * (a.pose.placed[0].object_to_view * dvec4(sum, 1.0)));
        };
        const std::vector<double> found = slides(marks_at(frames, k - 1, 64), marks_at(frames, k, 64), moved);
        ASSERT_GT(found.size(), 0.9 * frames[k]->own.size());
        EXPECT_LT(share_of(found, 0.5), 0.05) << k;
        EXPECT_LT(share_of(found, 0.9), 1.0) << k;
    }
}

TEST(Marks, OfClosedLinesHaveWholePeriods) {
    std::vector<Lines> frames;
    for (int k = 0; k < 4; ++k)
        frames.push_back(lines_of({place(meshes::sphere(40), moved({0.03 * k, 0, 0}), 3)},
                                  perspective({0, -9 + 0.1 * k, 1}, {0, 0, 0}, 60)));
    for (int k = 0; k < 4; ++k) {
        const Marks marks = marks_at(frames, k, 3);
        Index closed = 0;
        const ViewLines& lines = *marks.of->lines;
        for (Index q = 0; q < lines.rows.count(); ++q) {
            if (!lines.closed[q] || lines.rows.size(q) == 0) continue;
            ++closed;
            const double around = marks.last[lines.rows.end(q) - 1] - marks.last[lines.rows.begin(q)];
            EXPECT_GT(std::abs(around), 10 * period);
            EXPECT_NEAR(wrapped(around), 0.0, 1e-6) << k;
        }
        EXPECT_GE(closed, 1u);
    }
}

TEST(Marks, OfAClosedLineShorterThanAPeriodHaveOne) {
    const Lines lines =
        lines_of({place(meshes::sphere(40), scaled(dvec3(0.02)), 3)}, perspective({0, -9, 1}, {0, 0, 0}, 60));
    ASSERT_GT(lines->own.size(), 2u);
    EXPECT_NEAR(std::abs(lines->own.back() - lines->own.front()), period, 1e-6);
}

TEST(Marks, RunTheSameWayHoweverALineIsChained) {
    // What bounds the surface is on the same side of the line, in both halves of a turn and in a mirrored object.
    for (const double degrees : {0.0, 90.0, 180.0, 270.0})
        for (const double mirror : {1.0, -1.0}) {
            const Lines lines = lines_of({place(meshes::sphere(40), scaled({mirror, 1, 1}), 3)}, orbit(degrees));
            const auto& places = lines->lines->places;
            ASSERT_GT(places.size(), 20u);
            dvec2 middle(0.0);
            for (const auto& place : places) middle += place.px / double(places.size());
            double around = 0.0;
            for (Index j = 0; j + 1 < places.size(); ++j) {
                const auto &here = places[j], &next = places[j + 1];
                if (here.piece == next.piece)
                    around +=
                        cross(here.px - middle, next.px - middle) * (lines->own[j + 1] > lines->own[j] ? 1.0 : -1.0);
            }
            EXPECT_GT(around, 0.0) << degrees << ", " << mirror;
        }
}

TEST(Marks, OfLinesWithoutThemAreNowhereAndPartsOfTonesAndLinesOfTheMeshHaveNoPlaces) {
    const std::vector<Placement> scene{place(bumps(), dmat4(1.0), 7), place(meshes::box(), moved({3, 0, 0}), 8)};
    EXPECT_FALSE(lines_of(scene, orbit(10))->own.empty());
    EXPECT_NE(lines_of(scene, orbit(10))->content(), 0u);
    const Lines without = lines_of(scene, orbit(10), {"smooth_contour"}, 0.0);
    EXPECT_EQ(without->content(), 0u);
    const Marks marks = marks_in_time(without, std::vector<MarkedNear>{{-1, lines_of(scene, orbit(9.75))}}, 1, 8);
    for (Index q = 0; q < without->period.size(); ++q) EXPECT_FALSE(has_marks(&marks, q));
    EXPECT_TRUE(lines_of(scene, orbit(10), {"crease", "border"})->own.empty());
    EXPECT_TRUE(lines_of(scene, orbit(10), {"hatching"})->own.empty());
}

TEST(Marks, AreNotHandedOnToAnotherObjectOrDefinition) {
    const auto of = [](std::uint64_t id, const char* name) {
        return lines_of({place(bumps(), dmat4(1.0), id)}, orbit(10), {name});
    };
    const auto handed = [&](const Lines& from) {
        return marks_in_time(of(7, "smooth_contour"), std::vector<MarkedNear>{{-1, from}}, 1, 64).at;
    };
    const Array<double> own = of(7, "smooth_contour")->own;
    EXPECT_EQ(handed(of(8, "smooth_contour")), own);
    EXPECT_EQ(handed(of(7, "suggestive_contour")), own);
}

TEST(Marks, OfManyLinesInOnePlaceTakeNoLongerThanTheyAreMany) {
    // 4,000 edges of one mesh in the same place: each would be compared with all places of all others.
    meshes::Mesh mesh("crowd", {});
    for (int i = 0; i < 2000; ++i) {
        const int first = int(mesh.positions.size());
        for (const vec3& p : {vec3(-1, 0, -1), vec3(1, 0, -1), vec3(0, 0.2f, 1)}) mesh.positions.push_back(p);
        mesh.add_polygon({first, first + 1, first + 2});
    }
    const View view = perspective({0, -8, 1}, {0, 0, 0}, 60);
    const Lines lines = lines_of({place(mesh)}, view, {"silhouette", "contour"});
    ASSERT_GT(lines->own.size(), 100'000u);
    const Marks marks = marks_in_time(lines, std::vector<MarkedNear>{{-1, lines}}, 1, 8);
    for (const double at : marks.at) ASSERT_TRUE(std::isfinite(at));
}

namespace {

Job job_at(int k, int frames) {
    const std::string dashed = R"({"schema": 1, "animation": {"marks_frames": )" + std::to_string(frames) + R"(},
        "line_sets": [{"kinds": {"smooth_contour": {}}, "pen": {"width": 3, "wobble": 8, "wobble_length": 60,
        "texture_anchor": "path"}}]})";
    return {.scene = std::make_shared<Scene>(Scene({place(bumps(), dmat4(1.0), 7)})),
            .view = orbit(10 + 0.25 * k),
            .style = style::read_style(dashed),
            .assets = std::make_shared<Assets>("."),
            .backend = std::make_shared<CpuBackend>()};
}

/// Frames of an animation, each drawn with what the others found.
std::vector<Array<vec4>> pictures_of(int count, int frames) {
    std::vector<NearLines> found;
    for (int k = 0; k < count; ++k) found.push_back(Frame(job_at(k, frames)).found_lines()->lines);
    std::vector<Array<vec4>> pictures;
    for (int k = 0; k < count; ++k) {
        Job job = job_at(k, frames);
        job.since_key = job.style.animation.since_key(1 + k);
        for (int i = 0; i < count; ++i)
            if (i != k) job.near.emplace_back(i - k, found[i]);
        Frame frame(std::move(job));
        frame.picture();
        pictures.push_back(std::move(frame.passes.lines));
    }
    return pictures;
}

/// Ink that is in one of two pictures alone, of that in both.
double apart(const Array<vec4>& a, const Array<vec4>& b) {
    double differs = 0.0, all = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        differs += std::abs(a[i].w - b[i].w);
        all += a[i].w + b[i].w;
    }
    return differs / all;
}

}  // namespace

TEST(Marks, OfWobbleDoNotJumpAtAKey) {
    constexpr int key = 6;
    const auto steady = pictures_of(2 * key, key), alone = pictures_of(2 * key, 0);
    double most = 0.0, jumps = 0.0;
    for (int k = 1; k < 2 * key; ++k) {
        if (k != key) most = std::max(most, apart(steady[k - 1], steady[k]));
        jumps = std::max(jumps, apart(alone[k - 1], alone[k]));
    }
    EXPECT_LT(apart(steady[key - 1], steady[key]), 1.2 * most);
    EXPECT_LT(most, 0.6 * jumps);
}

TEST(Marks, AreKeptWithWhatAFrameFoundIfAPenHasSome) {
    const auto found = Frame(job_at(0, 4)).found_lines();
    ASSERT_TRUE(found->lines.marked);
    EXPECT_GT(found->bytes(), found->lines.marked->lines->bytes());
    EXPECT_FALSE(Frame(job_at(0, 0)).found_lines()->lines.marked);
    Job on_screen = job_at(0, 4);
    on_screen.style.line_sets[0].pen.texture_anchor = style::Anchor::screen;
    EXPECT_FALSE(Frame(std::move(on_screen)).found_lines()->lines.marked);
}

TEST(Marks, AreAsLongAsThoseOfTheFirstPenThatFixesThem) {
    Job job = job_at(0, 4);
    style::LineSet& set = job.style.line_sets[0];
    set.pen.texture_anchor = style::Anchor::screen;
    style::Hidden hidden;
    hidden.pen = set.pen;
    hidden.pen.texture_anchor = style::Anchor::path;
    set.hidden.push_back(hidden);
    const auto found = Frame(std::move(job)).found_lines();
    ASSERT_TRUE(found->lines.marked);
    EXPECT_NE(found->lines.marked->content(), 0u);
}
