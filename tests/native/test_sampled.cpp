// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <random>
#include <tbb/global_control.h>

#include <fovea/visibility/layout.h>
#include <fovea/visibility/sampled.h>

using namespace fovea;
using namespace fovea::draw;

namespace {

View test_view() {
    View view;
    view.width = 200;
    view.height = 150;
    view.near_clip = 0.1;
    view.view_to_clip = glm::perspective(0.8, 200.0 / 150.0, view.near_clip, 100.0);
    return view;
}

/// Appends a piece through view-space points, with samples of about 2 pixels.
void add_piece(const View& view, ClippedPaths& clipped, const std::vector<dvec3>& points, Index facet0 = none,
               Index facet1 = none) {
    const Index begin = Index(clipped.px.size()), end = begin + Index(points.size());
    for (const dvec3& point : points) {
        clipped.px.push_back(to_pixels(view, view.view_to_clip * dvec4(point, 1.0)));
        clipped.depth.push_back(float(screen_depth(view, point.z)));
        clipped.facet0.push_back(facet0);
        clipped.facet1.push_back(facet1);
        clipped.sample_count.push_back(0);
    }
    for (Index i = begin; i + 1 < end; ++i)
        clipped.sample_count[i] = Index(std::ceil(glm::length(clipped.px[i + 1] - clipped.px[i]) / 2.0f));
    for (Index i = begin; i < end; ++i) {
        clipped.sample_start.push_back(clipped.samples);
        clipped.samples += clipped.sample_count[i];
    }
    clipped.pieces.offsets.push_back(end);
}

/// A rectangle of two triangles, one facet.
struct Rectangle {
    std::vector<vec3> positions;
    std::vector<glm::uvec3> triangles{{0, 1, 2}, {0, 2, 3}};
    std::vector<Index> facets{0, 0};
    Index facet_base;
    Rectangle(vec3 a, vec3 b, vec3 c, vec3 d, Index facet) : positions{a, b, c, d}, facet_base(facet) {}
    operator RasterMesh() const { return {positions, triangles, facets, dmat4(1.0), facet_base}; }
};

Array<float> visibility_of(const View& view, const ClippedPaths& clipped, const OwnSides& sides,
                           const std::vector<RasterMesh>& meshes, int scale, int probes) {
    SampledOptions options;
    options.probes = probes;
    return sampled_visibility(clipped, sides, draw_depth(depth_layout(view, {.scale = scale}), view, meshes), options);
}

/// No scene to ask: lines of nothing steep.
OwnSides flat_sides(const ClippedPaths& clipped) {
    return {Array<float>(clipped.px.size(), 0.0f), Array<std::uint8_t>(clipped.px.size(), 0)};
}

Array<float> visibility_of(const View& view, const ClippedPaths& clipped, const std::vector<RasterMesh>& meshes,
                           int scale = 2, int probes = 1) {
    return visibility_of(view, clipped, flat_sides(clipped), meshes, scale, probes);
}

double mean(const Array<float>& values) {
    double sum = 0.0;
    for (float v : values) sum += v;
    return sum / double(values.size());
}

}  // namespace

TEST(Sampled, NothingHidesInAnEmptyScene) {
    const View view = test_view();
    ClippedPaths clipped;
    add_piece(view, clipped, {{-1, -1, -5}, {1, 1, -5}, {1, 0, -5}});
    EXPECT_EQ(mean(visibility_of(view, clipped, {})), 1.0);
    EXPECT_TRUE(visibility_of(view, ClippedPaths(), {}).empty());
}

TEST(Sampled, PiercingALeaningFaceChangesAtTheAnalyticPixel) {
    const View view = test_view();
    // Face z = -5 + .4 x; the line runs through it at x = .3.
    const auto on_face = [](float x, float y) { return vec3(x, y, -5.0f + 0.4f * x); };
    const Rectangle face(on_face(-1.5, -1.5), on_face(1.5, -1.5), on_face(1.5, 1.5), on_face(-1.5, 1.5), 0);
    const dvec3 hit(0.3, 0.2, -5.0 + 0.4 * 0.3), way(0.9, 0.15, -1.1);
    for (const int scale : {1, 2})
        for (const int probes : {1, 16}) {
            ClippedPaths clipped;
            add_piece(view, clipped, {hit - way, hit + way});
            const Array<float> values = visibility_of(view, clipped, {face}, scale, probes);
            const dvec2 hit_px = to_pixels(view, view.view_to_clip * dvec4(hit, 1.0));
            const double t = glm::length(hit_px - dvec2(clipped.px[0])) / glm::length(clipped.px[1] - clipped.px[0]);
            for (Index j = 0; j < clipped.sample_count[0]; ++j) {
                const double off = (j + 0.5) - t * clipped.sample_count[0];
                if (std::abs(off) > 1.0) {
                    EXPECT_EQ(values[clipped.sample_start[0] + j], off < 0 ? 1.0f : 0.0f) << j << " " << off;
                }
            }
        }
}

TEST(Sampled, BehindAnEdgeChangesAtTheAnalyticPixel) {
    const View view = test_view();
    const Rectangle face(vec3(-3, -3, -4), vec3(0.123f, -3, -4), vec3(0.123f, 3, -4), vec3(-3, 3, -4), 0);
    const double edge_px = to_pixels(view, view.view_to_clip * dvec4(0.123, 0, -4, 1)).x;
    ClippedPaths clipped;
    add_piece(view, clipped, {{-1, 0.1, -6}, {1, -0.2, -8}});
    const Array<float> values = visibility_of(view, clipped, {face});
    for (Index j = 0; j < clipped.sample_count[0]; ++j) {
        const double x = glm::mix(clipped.px[0], clipped.px[1], (j + 0.5f) / clipped.sample_count[0]).x;
        if (std::abs(x - edge_px) > 2.0) {
            EXPECT_EQ(values[clipped.sample_start[0] + j], x > edge_px ? 1.0f : 0.0f);
        }
    }
}

TEST(Sampled, LinesOfASurfaceAreSeenAndLinesJustBehindAreNot) {
    const View view = test_view();
    std::mt19937 random(1);
    std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
    // A floor seen at a low angle.
    const Rectangle face(vec3(-5, -0.5f, -1), vec3(5, -0.5f, -1), vec3(5, -0.5f, -30), vec3(-5, -0.5f, -30), 0);
    ClippedPaths on, behind;
    for (int i = 0; i < 200; ++i) {
        const dvec3 a{unit(random), -0.5, -3 - std::abs(unit(random))}, b{unit(random), -0.5, -4 + unit(random)};
        add_piece(view, on, {a, b});
        add_piece(view, behind, {a - dvec3(0, 2e-3, 0), b - dvec3(0, 2e-3, 0)});
    }
    EXPECT_EQ(mean(visibility_of(view, on, {face})), 1.0);
    EXPECT_EQ(mean(visibility_of(view, behind, {face})), 0.0);
}

TEST(Sampled, NeighborFacetsOfTheLineDoNotHideIt) {
    const View view = test_view();
    // The line lies a little behind the face, as rounding or a bulge may put it.
    const Rectangle face(vec3(-3, -3, -4), vec3(3, -3, -4), vec3(3, 3, -4), vec3(-3, 3, -4), 41);
    ClippedPaths own, other;
    add_piece(view, own, {{-1, 0, -4.01}, {1, 0.3, -4.01}}, 17, 41);
    add_piece(view, other, {{-1, 0, -4.01}, {1, 0.3, -4.01}}, 17, 18);
    EXPECT_EQ(mean(visibility_of(view, own, {face})), 1.0);
    EXPECT_EQ(mean(visibility_of(view, other, {face})), 0.0);
}

TEST(Sampled, SameWithOneAndManyThreads) {
    const View view = test_view();
    std::mt19937 random(2);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    std::vector<Rectangle> faces;
    ClippedPaths clipped;
    for (int i = 0; i < 300; ++i) {
        const dvec3 c{2 * unit(random), 1.5 * unit(random), -6 + 2 * unit(random)};
        faces.emplace_back(c, c + dvec3(.5, 0, .2), c + dvec3(.5, .5, -.2), c + dvec3(0, .5, 0), Index(i));
        add_piece(view, clipped, {c, c + dvec3{unit(random), unit(random), unit(random)}});
    }
    const std::vector<RasterMesh> meshes(faces.begin(), faces.end());
    const Array<float> many = visibility_of(view, clipped, meshes, 2, 4);
    tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(many, visibility_of(view, clipped, meshes, 2, 4));
}

TEST(Layout, BatchesHoldWholePiecesAndTablesFindTheOwner) {
    const View view = test_view();
    ClippedPaths clipped;
    for (int i = 0; i < 40; ++i)
        add_piece(view, clipped, {{-1, -1, -5}, {-.99 + .01 * i, -1, -5}, {1, 1, -4}, {1, .8, -4}}, i, i + 1);
    const Array<AtlasBatch> batches = atlas_batches(clipped, 1000);
    Index pieces = 0, samples = 0;
    for (const AtlasBatch& batch : batches) {
        EXPECT_EQ(batch.piece_begin, pieces);
        EXPECT_EQ(batch.sample_begin, samples);
        EXPECT_LE(batch.sample_end - batch.sample_begin, 1000u);
        pieces = batch.piece_end;
        samples = batch.sample_end;
        const AtlasTables tables = atlas_tables(clipped, flat_sides(clipped), batch);
        const Index segments = Index(tables.segments.size() / 3);
        for (Index s = 0; s < batch.sample_end - batch.sample_begin; ++s) {
            const Index from = Index(tables.owners[s / owner_stride]), to = Index(tables.owners[s / owner_stride + 1]);
            Index owner = none;
            for (Index k = from; k <= to; ++k)
                if (tables.segments[3 * k].w <= float(s)) owner = k;
            ASSERT_NE(owner, none) << s;
            EXPECT_TRUE(owner + 1 == segments || float(s) < tables.segments[3 * (owner + 1)].w);
        }
    }
    EXPECT_EQ(pieces, clipped.pieces.count());
    EXPECT_EQ(samples, clipped.samples);
    EXPECT_EQ(atlas_batches(clipped, 1).size(), 40u);  // a piece is never divided
    EXPECT_TRUE(atlas_batches(ClippedPaths(), 1).empty());
}

TEST(Layout, NoneOneAndTwoSegmentsAndABatchThatIsJustFull) {
    const View view = test_view();
    for (int segments = 0; segments < 3; ++segments) {
        ClippedPaths clipped;
        for (int i = 0; i < segments; ++i) add_piece(view, clipped, {{-1, -1, -5}, {1, 1, -4}});
        const Index each = segments ? clipped.samples / segments : 0;
        EXPECT_EQ(atlas_batches(clipped).size(), segments ? 1u : 0u);
        EXPECT_EQ(atlas_batches(clipped, std::max(clipped.samples, 1u)).size(), segments ? 1u : 0u);
        EXPECT_EQ(atlas_batches(clipped, std::max(each, 1u)).size(), Index(segments));
        EXPECT_EQ(visibility_of(view, clipped, {}), Array<float>(clipped.samples, 1.0f));
        for (const AtlasBatch& batch : atlas_batches(clipped, each)) {
            const AtlasTables tables = atlas_tables(clipped, flat_sides(clipped), batch);
            EXPECT_EQ(tables.segments.size(), 3u);
            for (const float owner : tables.owners) EXPECT_EQ(owner, 0.0f);
        }
    }
}

TEST(Sampled, AnEdgeHidesALineLessThanHalfATexelBelowIt) {
    const View view = test_view();
    // The edge of the face runs along the line, a fifth of a pixel above it; the texel there may show what is beyond.
    const auto y_of = [&](double px) { return px / (0.5 * view.height) * 4.0 * std::tan(0.4); };  // at distance 4
    for (double at_px = 0.0; at_px < 2.0; at_px += 0.13)
        for (const int scale : {1, 2}) {
            const float top = float(y_of(at_px + 0.2)), y = float(y_of(at_px) * 5.0 / 4.0);
            const Rectangle face(vec3(-3, -3, -4), vec3(3, -3, -4), vec3(3, top, -4), vec3(-3, top, -4), 0);
            ClippedPaths clipped;
            add_piece(view, clipped, {{-1, y, -5}, {1, y, -5}});
            EXPECT_EQ(mean(visibility_of(view, clipped, {face}, scale, 9)), 0.0) << at_px << " " << scale;
        }
}

TEST(Layout, BatchesOfOtherPathsAreRefused) {
    const View view = test_view();
    ClippedPaths clipped, other;
    for (int i = 0; i < 2; ++i) add_piece(view, clipped, {{-1, -1, -5}, {1, 1, -4}});
    add_piece(view, other, {{-1, -1, -5}, {1, 1, -4}, {1, 0, -4}});
    const AtlasBatch batch = atlas_batches(clipped)[0];
    EXPECT_THROW(atlas_tables(other, flat_sides(other), batch), std::invalid_argument);
    EXPECT_THROW(atlas_tables(clipped, flat_sides(other), batch), std::invalid_argument);
    EXPECT_THROW(sampled_visibility(clipped, flat_sides(other), draw_depth(depth_layout(view, {}), view, {}), {}),
                 std::invalid_argument);
}

TEST(Layout, FacetNumbersStayExactInFloats) {
    const View view = test_view();
    ClippedPaths clipped;
    add_piece(view, clipped, {{-1, -1, -5}, {1, 1, -4}}, none, facet_modulus * 3 + 12345677);
    const AtlasTables tables = atlas_tables(clipped, flat_sides(clipped), atlas_batches(clipped)[0]);
    EXPECT_EQ(tables.segments[2].x, -1.0f);
    EXPECT_EQ(tables.segments[2].y, 12345677.0f);
}
