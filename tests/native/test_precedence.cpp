// SPDX-License-Identifier: GPL-3.0-or-later
// Lines whose kind changes pass others steadily: what goes by behind a contour makes a silhouette of it.
#include <gtest/gtest.h>
#include <map>

#include <fovea/draw/frame.h>
#include <fovea/elision/outer_shares.h>
#include <fovea/style/json.h>

#include "drawing.h"
#include "elision_fixture.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::drawing;

namespace {
namespace formulas {
using namespace glm;
struct Precedence {
#include <shared/precedence.glsl>
};
}  // namespace formulas

float precedence(vec3 line, vec3 other) { return formulas::Precedence{}.precedence(line, other); }

/// What is left of two lines 3 px apart and of one between them that is less important. The first is below the second
/// before it changes, and above it after. `on_top`: which of these two is above now.
std::vector<Array<float>> of_three_lines(float share, bool first_on_top) {
    Sheet sheet;
    const std::vector<vec2> first = Sheet::through({100.2f, 81.5f}, 0.02, 90.0),
                            second = Sheet::through({100.2f, 78.5f}, 0.02, 90.0);
    sheet.line(first_on_top ? first : second);
    sheet.line(first_on_top ? second : first);
    sheet.line(Sheet::through({100.2f, 80.0f}, 0.02, 90.0));
    OwnBands own = sheet.own();
    const vec3 changing(2, 4, share), other(3, 3, 0);
    own.precedence_of_rank = {vec3(0), vec3(1, 1, 0), first_on_top ? other : changing, first_on_top ? changing : other};
    const PriorityBuffer buffer = draw_priorities(draw_bands(sheet.clipped, sheet.runs, sheet.ranks(), own),
                                                  sheet.width, sheet.height, own.precedence_of_rank);
    const Array<float> all =
        elision_opacities(sheet.clipped, own, elision_scores(own, crowding(own, buffer)), ElisionOptions());
    std::vector<Array<float>> lines;
    for (const Index piece : {first_on_top ? 0u : 1u, first_on_top ? 1u : 0u, 2u}) {
        const std::vector<float> of = sheet.of(piece, all);
        lines.emplace_back(of.begin(), of.end());
    }
    return lines;
}

float most_apart(const std::vector<Array<float>>& a, const std::vector<Array<float>>& b) {
    float most = 0.0f;
    for (std::size_t line = 0; line < a.size(); ++line)
        for (std::size_t s = 0; s < a[line].size(); ++s) most = std::max(most, std::abs(a[line][s] - b[line][s]));
    return most;
}

/// A pole and, behind it, a panel of the same object from the left to `edge`; before the pole's right edge a thinner
/// pole of another object.
std::shared_ptr<const Scene> poles_before_a_panel(float edge) {
    const std::vector<meshes::Mesh> parts{meshes::box({-0.4f, -1.0f, -1.0f}, {0.1f, -0.9f, 1.0f}),
                                          meshes::box({-3.0f, 3.0f, -2.0f}, {edge, 3.1f, 2.0f})};
    std::vector<vec3> positions;
    meshes::Polygons polygons;
    for (const meshes::Mesh& part : parts) {
        for (std::size_t f = 0; f + 1 < part.polygon_offsets.size(); ++f) {
            polygons.emplace_back();
            for (int c = part.polygon_offsets[f]; c < part.polygon_offsets[f + 1]; ++c)
                polygons.back().push_back(part.corner_verts[c] + int(positions.size()));
        }
        positions.insert(positions.end(), part.positions.begin(), part.positions.end());
    }
    return std::make_shared<Scene>(
        Scene({place(meshes::of_polygons("pole", positions, polygons), dmat4(1.0), 1),
               place(meshes::box({0.045f, -1.3f, -0.9f}, {0.055f, -1.29f, 0.9f}), dmat4(1.0), 2)}));
}

View turned(double degrees) {
    const double angle = glm::radians(degrees);
    return orthographic({10.0 * std::sin(angle), -10.0 * std::cos(angle), 0.5}, {0, 0, 0}, 4.0);
}

/// Shares of the pole's vertical edges, by the edge's place from the left.
std::map<float, float> shares_of_pole(const Scene& scene, const View& view) {
    const Tracer tracer(scene, view);
    const Paths paths =
        extract_paths(scene, view, {line_set({"silhouette"}), line_set({"contour", "crease"})}, tracer, Cancel());
    const std::vector<std::uint8_t> asked(paths.count(), 1);
    const Array<OuterShare> shares = outer_shares(paths, tracer, asked, Cancel());
    std::map<float, float> found;
    for (Index p = 0; p < paths.count(); ++p)
        for (Index i = paths.rows.begin(p); i + 1 < paths.rows.end(p); ++i) {
            const vec3 from = paths.points_obj[i], to = paths.points_obj[i + 1];
            if (paths.placement[p] == 0 && from.y < 0.0f && std::abs(from.z - to.z) > 1.0f && shares[i].share >= 0.0f)
                found[from.x] = shares[i].share;
        }
    return found;
}

/// Mean opacity of each visible line of the thinner pole, by its id.
std::map<std::uint64_t, double> shown_of_thin_pole(const View& view, float edge) {
    Frame frame({.scene = poles_before_a_panel(edge),
                 .view = view,
                 .style = style::read_style(R"({"schema": 1, "elision": {"enabled": true}, "line_sets": [
                     {"kinds": {"silhouette": {}}, "pen": {"spacing": 30}},
                     {"kinds": {"contour": {}, "crease": {}}, "pen": {"spacing": 30}}]})"),
                 .assets = std::make_shared<Assets>("."),
                 .backend = std::make_shared<CpuBackend>()});
    frame.thin();
    std::map<std::uint64_t, double> sum, count;
    for (std::size_t r = 0; r < frame.runs->size(); ++r) {
        const Index piece = frame.runs->piece[r], path = frame.clipped->path[piece];
        if (frame.paths->placement[path] != 1 || frame.runs->invisibility[r] != 0) continue;
        for (Index i = frame.clipped->pieces.begin(piece); i + 1 < frame.clipped->pieces.end(piece); ++i)
            for (Index j = 0; j < frame.clipped->sample_count[i]; ++j) {
                sum[frame.paths->id[path]] += frame.shown[frame.clipped->sample_start[i] + j];
                ++count[frame.paths->id[path]];
            }
    }
    for (auto& [id, shown] : sum) shown /= count[id];
    return sum;
}

}  // namespace

TEST(Precedence, OfLinesThatDoNotChangeTheHigherTakesAll) {
    EXPECT_EQ(precedence({1, 1, 0}, {2, 2, 0}), 1.0f);
    EXPECT_EQ(precedence({2, 2, 0}, {1, 1, 0}), 0.0f);
    EXPECT_EQ(precedence({1, 3, 0.5f}, {4, 4, 0}), 1.0f);  // changes below the other
    EXPECT_EQ(precedence({1, 3, 0.5f}, {5, 7, 0.5f}), 1.0f);
    EXPECT_EQ(precedence({5, 7, 0.5f}, {1, 3, 0.5f}), 0.0f);
}

TEST(Precedence, APassingLineTakesMoreAndMore) {
    for (int k = 0; k <= 10; ++k) {
        const float share = float(k) / 10.0f;
        EXPECT_FLOAT_EQ(precedence({2, 2, 0}, {1, 3, share}), share * share);
        EXPECT_FLOAT_EQ(precedence({1, 3, share}, {2, 2, 0}), (1.0f - share) * (1.0f - share));
    }
    // Of two that change, each has passed the other in one of four ways.
    EXPECT_FLOAT_EQ(precedence({1, 3, 0.5f}, {2, 4, 0.5f}), 0.75f * 0.75f);
}

TEST(Precedence, ItIsTheSameWhicheverLineIsDrawnOnTop) {
    for (int k = 0; k <= 8; ++k) {
        const float share = float(k) / 8.0f;
        EXPECT_LT(most_apart(of_three_lines(share, true), of_three_lines(share, false)), 1e-5f) << share;
    }
}

TEST(Precedence, OpacityFollowsTheShareSteadily) {
    constexpr int steps = 64;
    // The steepest: scores by the square of the share, opacity by the score from fade_from on.
    const float bound = 2.0f / (1.0f - ElisionOptions().fade_from) / float(steps) + 1e-4f;
    std::vector<Array<float>> before = of_three_lines(0.0f, false);
    for (int k = 1; k <= steps; ++k) {
        const std::vector<Array<float>> now = of_three_lines(float(k) / steps, 2 * k > steps);
        EXPECT_LE(most_apart(before, now), bound) << k;
        before = now;
    }
}

TEST(Precedence, BeforeAndAfterItsChangeALineIsLikeOthers) {
    const std::vector<Array<float>> before = of_three_lines(0.0f, false), after = of_three_lines(1.0f, true);
    for (const float left : before[1]) EXPECT_EQ(left, 1.0f);
    for (const float left : after[0]) EXPECT_EQ(left, 1.0f);
    for (const auto& lines : {before, after})
        EXPECT_LT(std::ranges::max(lines[2]), 0.2f);  // the one between them loses to either
}

TEST(OuterShares, AreThatOfTheStripNextToAnEdgeInWhichItsObjectEnds) {
    const View view = turned(0.0);
    const auto at = [&](float panel) {
        const auto scene = poles_before_a_panel(panel);
        return shares_of_pole(*scene, view).at(0.1f);
    };
    EXPECT_EQ(at(0.09f), 1.0f);  // the panel ends behind the pole
    EXPECT_EQ(at(2.0f), 0.0f);   // and far beyond its edge
    const double strip = 12.0 * view.reference_scale * 4.0 / 640.0;
    for (const double share : {0.25, 0.5, 0.75})
        EXPECT_NEAR(at(float(0.1 + strip * (1.0 - share))), share, 0.15) << share;
}

TEST(OuterShares, AreNotAskedForWhereNothingChanges) {
    const View view = turned(0.0);
    const auto scene = poles_before_a_panel(0.0f);
    const Tracer tracer(*scene, view);
    const Paths paths = extract_paths(*scene, view, {line_set({"silhouette", "contour", "crease"})}, tracer, Cancel());
    const std::vector<std::uint8_t> none_asked(paths.count(), 0), too_few(1, 1);
    for (const OuterShare& of : outer_shares(paths, tracer, none_asked, Cancel())) EXPECT_LT(of.share, 0.0f);
    const std::vector<std::uint8_t> all(paths.count(), 1);
    const Array<OuterShare> shares = outer_shares(paths, tracer, all, Cancel());
    const Kinds contours = bit_of("silhouette") | bit_of("contour");
    for (Index i = 0; i < shares.size(); ++i)
        if (!(paths.kinds[i] & contours)) {
            EXPECT_LT(shares[i].share, 0.0f);
        }
    EXPECT_THROW(outer_shares(paths, tracer, too_few, Cancel()), std::invalid_argument);
}

TEST(OuterShares, OnlyAContourThatIsPartlyASilhouetteHasTwoPriorities) {
    const View view = turned(0.0);
    const double strip = 12.0 * view.reference_scale * 4.0 / 640.0;
    for (const double covered : {-0.5, 0.5, 9.0}) {
        const auto scene = poles_before_a_panel(float(0.1 + strip * covered));
        const Tracer tracer(*scene, view);
        const Paths paths =
            extract_paths(*scene, view, {line_set({"silhouette"}), line_set({"contour", "crease"})}, tracer, Cancel());
        const std::vector<std::uint8_t> asked(paths.count(), 1);
        const Array<Priority> priorities = path_priorities(paths, *scene, view, style::Elision(), {}, {},
                                                           outer_shares(paths, tracer, asked, Cancel()));
        int changing = 0;
        for (Index p = 0; p < paths.count(); ++p) {
            const Priority& of = priorities[p];
            EXPECT_LE(of.before, of.value);
            EXPECT_LE(of.value, of.after);
            if (!of.is_changing()) continue;
            EXPECT_NEAR(of.value, glm::mix(of.before, of.after, of.share), 1e-6);
            const vec3 from = paths.points_obj[paths.rows.begin(p)], to = paths.points_obj[paths.rows.begin(p) + 1];
            changing += from.x == 0.1f && to.x == 0.1f && from.z != to.z;
        }
        EXPECT_EQ(changing > 0, covered == 0.5) << covered;
    }
}

TEST(OuterShares, AsTheViewTurnsLinesBesideAContourFadeSteadily) {
    // The panel's edge goes by behind the pole's, which becomes a silhouette, and then goes before the thin pole.
    constexpr double step = 0.02;
    std::map<std::uint64_t, double> before = shown_of_thin_pole(turned(0.2), 0.16f), most = before, least = before;
    for (double angle = 0.2 + step; angle < 1.6; angle += step) {
        const std::map<std::uint64_t, double> now = shown_of_thin_pole(turned(angle), 0.16f);
        for (const auto& [id, shown] : now) {
            if (!before.contains(id)) continue;
            EXPECT_LT(std::abs(shown - before[id]), 0.3) << angle;
            most[id] = std::max(most[id], shown);
            least[id] = std::min(least[id], shown);
        }
        before = now;
    }
    double widest = 0.0;
    for (const auto& [id, shown] : most) widest = std::max(widest, shown - least[id]);
    EXPECT_GT(widest, 0.4);
}
