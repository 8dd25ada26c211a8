// SPDX-License-Identifier: GPL-3.0-or-later
// Cut-outs of meshes by opacity images: their area, their borders, and what they hide.
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <random>

#include <fovea/cutout/cutout.h>

#include "wires.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::meshes;
using namespace fovea::drawing;
using namespace fovea::wires;

namespace {

constexpr double pi = std::numbers::pi;

template <typename Value>
std::shared_ptr<Opacity> opacity_of(int width, int height, const Value& value) {
    auto opacity = std::make_shared<Opacity>();
    opacity->width = width;
    opacity->height = height;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            opacity->texels.push_back(float(value(dvec2((x + 0.5) / width, (y + 0.5) / height))));
    return opacity;
}

/// Opaque within a radius of the middle, with an edge two texels wide; or outside of it.
std::shared_ptr<Opacity> disc(int size, double radius, bool hole = false) {
    const auto made = opacity_of(size, size, [&](dvec2 at) {
        const double inside = std::clamp(0.5 + 0.5 * size * (radius - glm::distance(at, dvec2(0.5))), 0.0, 1.0);
        return hole ? 1.0 - inside : inside;
    });
    made->extension = hole ? Extension::repeat : Extension::clip;
    return made;
}

/// Texture coordinates by the vertices of a mesh.
template <typename At>
Array<vec2> uvs_of(const Mesh& mesh, const At& at) {
    Array<vec2> uvs;
    for (const int v : mesh.corner_verts) uvs.push_back(at(mesh.positions[v]));
    return uvs;
}

/// The plane z = 0 over [-1, 1]^2 has the whole image.
vec2 plan(const vec3& p) { return 0.5f * vec2(p) + 0.5f; }

CutMesh cut(const Mesh& mesh, const Array<vec2>& uvs, std::shared_ptr<Opacity> opacity, double px_per_unit = 0.0) {
    const std::vector<int> first(mesh.polygon_offsets.size() - 1, 0);
    return CutMesh("cut", mesh.arrays(), {{uvs, std::move(opacity)}}, {first, px_per_unit});
}

CutMesh cut(const Mesh& mesh, std::shared_ptr<Opacity> opacity, double px_per_unit = 0.0) {
    return cut(mesh, uvs_of(mesh, plan), std::move(opacity), px_per_unit);
}

double area(const CutMesh& mesh) {
    const Surface surface("cut", mesh.arrays());
    double sum = 0.0;
    for (const Triangle& t : surface.triangles) {
        const dvec3 a(surface.positions[t.x]), b(surface.positions[t.y]), c(surface.positions[t.z]);
        const double z = glm::cross(b - a, c - a).z;
        EXPECT_GE(z, -1e-9) << "a triangle is turned around";
        sum += 0.5 * z;
    }
    return sum;
}

struct Borders {
    double length = 0.0, farthest = 0.0, nearest = HUGE_VAL;  ///< of the middles from the origin
};

/// Edges with one face.
Borders borders(const CutMesh& mesh) {
    const Surface surface("cut", mesh.arrays());
    EXPECT_EQ(surface.report().inconsistent_edges, 0u);
    EXPECT_EQ(surface.report().degenerate_polygons, 0u);
    Borders found;
    for (Index e = 0; e < surface.mesh_edges; ++e) {
        if (surface.edge_rows.size(e) != 1) continue;
        const vec3 a = surface.positions[surface.edges[e].x], b = surface.positions[surface.edges[e].y];
        found.length += glm::distance(a, b);
        found.farthest = std::max(found.farthest, double(glm::length(0.5f * (a + b))));
        found.nearest = std::min(found.nearest, double(glm::length(0.5f * (a + b))));
    }
    return found;
}

Mesh card() { return grid(1); }

}  // namespace

TEST(Cutout, ADiscHasTheAreaAndTheCircumferenceOfADisc) {
    for (const Mesh& mesh :
         {card(), grid(5), of_polygons("triangle", {{-1, -1, 0}, {3, -1, 0}, {-1, 3, 0}}, {{0, 1, 2}})}) {
        const CutMesh made = cut(mesh, disc(64, 0.3));
        const double texel = 2.0 / 64, radius = 0.6;
        const Borders edge = borders(made);
        EXPECT_NEAR(edge.length, 2 * pi * radius, 2 * pi * texel) << "no other border, none doubled";
        EXPECT_NEAR(edge.farthest, radius, 0.5 * texel);
        EXPECT_NEAR(edge.nearest, radius, 0.5 * texel);
        EXPECT_NEAR(area(made), pi * radius * radius, 0.5 * texel * 2 * pi * radius);
    }
}

TEST(Cutout, AHoleStaysOneAndTheRestOfTheCardWhatItWas) {
    for (const Mesh& mesh : {card(), grid(4)}) {
        const CutMesh made = cut(mesh, disc(64, 0.2, true));
        EXPECT_NEAR(area(made), 4.0 - pi * 0.16, 0.03);
        EXPECT_NEAR(borders(made).length, 8.0 + 2 * pi * 0.4, 0.06);
    }
}

TEST(Cutout, ManyHolesAreAllJoinedToWhatIsAroundThem) {
    const auto holes = opacity_of(96, 96, [](dvec2 at) {
        const dvec2 place = glm::fract(4.0 * at) - 0.5;
        return std::clamp(0.5 + 12.0 * (glm::length(place) - 0.25), 0.0, 1.0);
    });
    const CutMesh made = cut(card(), holes);
    EXPECT_NEAR(area(made), 4.0 - 16 * pi * 0.015625, 0.05);
    EXPECT_NEAR(borders(made).length, 8.0 + 16 * 2 * pi * 0.125, 0.2);
}

TEST(Cutout, WhatIsOpaqueStaysAsItIsAndWhatIsTransparentGoes) {
    const Mesh mesh = grid(3);
    const CutMesh whole = cut(mesh, opacity_of(8, 8, [](dvec2) { return 1.0; }));
    EXPECT_EQ(whole.corner_verts, mesh.corner_verts);
    EXPECT_EQ(whole.polygon_offsets, mesh.polygon_offsets);
    EXPECT_EQ(whole.positions, mesh.positions);
    EXPECT_TRUE(cut(mesh, opacity_of(8, 8, [](dvec2) { return 0.0; })).corner_verts.empty());
    const std::vector<int> no_cut(9, -1);
    EXPECT_EQ(CutMesh("cut", mesh.arrays(), {{uvs_of(mesh, plan), disc(8, 0.3)}}, {no_cut}).corner_verts,
              mesh.corner_verts);
}

TEST(Cutout, ImagesGoOnWhereTextureCoordinatesLeaveThem) {
    const auto thrice = [](const vec3& p) { return 3.0f * plan(p) - 1.0f; };
    const auto share = [&](Extension extension, const auto& value) {
        const auto opacity = opacity_of(32, 32, value);
        opacity->extension = extension;
        return area(cut(card(), uvs_of(card(), thrice), opacity)) / 4.0;
    };
    const auto left = [](dvec2 at) { return at.x < 0.25 ? 1.0 : 0.0; };
    EXPECT_NEAR(share(Extension::repeat, left), 0.25, 0.01);
    EXPECT_NEAR(share(Extension::mirror, left), 0.25, 0.01);
    EXPECT_NEAR(share(Extension::extend, left), 1.25 / 3.0, 0.01);
    EXPECT_NEAR(share(Extension::clip, left), 0.25 / 9.0, 0.01);
}

TEST(Cutout, SquareTexelsKeepTheirCorners) {
    const auto checker = opacity_of(2, 2, [](dvec2 at) { return (at.x < 0.5) == (at.y < 0.5) ? 1.0 : 0.0; });
    checker->closest = true;
    const CutMesh made = cut(card(), checker);
    EXPECT_NEAR(area(made), 2.0, 0.04);
    EXPECT_NEAR(borders(made).length, 8.0, 0.1);
}

TEST(Cutout, SeamsOfTextureCoordinatesOpenNoGap) {
    // Both squares are opaque along the edge between them, but for a notch that they have at different places.
    const Mesh mesh = of_polygons("two", {{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {-1, 1, 0}, {0, 1, 0}, {1, 1, 0}},
                                  {{0, 1, 4, 3}, {1, 2, 5, 4}});
    const auto notch = opacity_of(64, 64, [](dvec2 at) {
        return std::clamp(0.5 + 32.0 * (glm::distance(at, dvec2(0.0, 0.5)) - 0.125), 0.0, 1.0);
    });
    notch->extension = Extension::extend;
    Array<vec2> uvs;
    for (const int v : {0, 1, 4, 3}) uvs.push_back(vec2(-mesh.positions[v].x, mesh.positions[v].y));
    for (const int v : {1, 2, 5, 4}) uvs.push_back(vec2(mesh.positions[v].x, mesh.positions[v].y + 0.25f));
    const CutMesh made = cut(mesh, uvs, notch);
    // The rim, two half circles, and the parts of each half's diameter that the other half leaves open.
    EXPECT_NEAR(borders(made).length, 6.0 + 2 * pi * 0.125 + 2 * 0.25, 0.05);
}

TEST(Cutout, VerticesAndCornersFollowTheMeshThatWasCut) {
    const Mesh mesh = grid(3);
    const CutMesh made = cut(mesh, disc(32, 0.35));
    const auto moved = [](const vec3& p) { return vec3(2.0f * p.x + p.y, p.y - 1.0f, 3.0f * p.x); };
    std::vector<vec3> positions;
    for (const vec3& p : mesh.positions) positions.push_back(moved(p));
    const Array<vec3> all = made.moved(positions);
    ASSERT_EQ(all.size(), made.positions.size());
    for (std::size_t v = 0; v < all.size(); ++v) EXPECT_LT(glm::distance(all[v], moved(made.positions[v])), 1e-5f);
    const Array<vec2> uvs = uvs_of(mesh, plan);
    const Array<float> mixed = made.mix_corners({&uvs[0].x, 2 * uvs.size()}, 2);
    ASSERT_EQ(mixed.size(), 2 * made.corner_verts.size());
    for (std::size_t c = 0; c < made.corner_verts.size(); ++c) {
        const vec2 expected = plan(made.positions[made.corner_verts[c]]);
        EXPECT_NEAR(mixed[2 * c], expected.x, 1e-5);
        EXPECT_NEAR(mixed[2 * c + 1], expected.y, 1e-5);
    }
    EXPECT_THROW((void)made.moved(In<vec3>(positions).first(3)), std::invalid_argument);
    EXPECT_THROW((void)made.mix_corners({&uvs[0].x, 3}, 2), std::invalid_argument);
}

TEST(Cutout, MarksAndMaterialsStay) {
    Mesh mesh = grid(2);
    mesh.material = {0, 1, 2, 3};
    mesh.sharp = mesh.edge_flags({mesh.edge(3, 4), mesh.edge(4, 5)});
    const CutMesh made = cut(mesh, disc(64, 0.35));
    double marked = 0.0;
    for (std::size_t e = 0; e < made.edge_verts.size(); ++e)
        if (made.sharp[e])
            marked += glm::distance(made.positions[made.edge_verts[e].x], made.positions[made.edge_verts[e].y]);
    EXPECT_NEAR(marked, 2 * 0.7, 0.02) << "what is left of the sharp edges is sharp";
    for (std::size_t f = 0; f + 1 < made.polygon_offsets.size(); ++f)
        for (int c = made.polygon_offsets[f]; c < made.polygon_offsets[f + 1]; ++c) {
            const vec3 p = made.positions[made.corner_verts[c]];
            EXPECT_GE((made.material[f] & 1 ? 1 : -1) * p.x, -1e-6f);
            EXPECT_GE((made.material[f] & 2 ? 1 : -1) * p.y, -1e-6f);
        }
}

TEST(Cutout, FarAwayItIsCoarserButCoversAsMuch) {
    // Thin blades, which would be averaged away.
    const auto blades = opacity_of(256, 256, [](dvec2 at) { return glm::fract(8.0 * at.x) < 0.2 && at.y < 0.9; });
    const CutMesh near = cut(card(), blades), far = cut(card(), blades, 16.0);
    EXPECT_NEAR(area(near), 4.0 * 0.1875 * 0.9, 0.01);
    EXPECT_NEAR(area(far), area(near), 0.1 * area(near));
    const auto round = disc(256, 0.3);
    const std::size_t few = cut(card(), round, 8.0).corner_verts.size();
    EXPECT_LT(3 * few, cut(card(), round).corner_verts.size());
    EXPECT_GT(few, 6u);
    EXPECT_NEAR(area(cut(card(), round, 8.0)), pi * 0.36, 0.05);
}

TEST(Cutout, AnyImageOnAnyMeshHasNoBorderButThatOfItsOpaqueRegion) {
    std::mt19937 random(3);
    const auto number = [&](double low, double high) { return low + (high - low) * double(random()) / 4294967295.0; };
    for (int trial = 0; trial < 24; ++trial) {
        const int size = 8 + int(random() % 24), n = 1 + int(random() % 6);
        const auto noise = opacity_of(size, size, [&](dvec2) { return number(0.0, 1.0); });
        Mesh mesh = grid(n);
        for (vec3& p : mesh.positions)
            if (std::abs(p.x) < 0.99f && std::abs(p.y) < 0.99f)
                p += vec3(number(-0.3, 0.3) / n, number(-0.3, 0.3) / n, 0.0f);
        const CutMesh made = cut(mesh, noise), single = cut(card(), noise);
        EXPECT_NEAR(area(made), area(single), 0.002);
        EXPECT_NEAR(borders(made).length, borders(single).length, 0.01 * borders(single).length);
    }
}

TEST(Cutout, TexelsThatAreNoNumbersAreTransparentAndEndlessOnesOpaque) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    const auto halves = [](float left, float right) {
        return opacity_of(8, 8, [=](dvec2 at) { return at.x < 0.5 ? left : right; });
    };
    for (const double px_per_unit : {0.0, 1.0}) {  // as they are, and halved
        const double half = area(cut(card(), halves(1.0f, 0.0f), px_per_unit));
        EXPECT_NEAR(half, 2.0, 0.5);
        EXPECT_NEAR(area(cut(card(), halves(inf, -inf), px_per_unit)), half, 0.25);
        EXPECT_NEAR(area(cut(card(), halves(1.0f, nan), px_per_unit)), half, 1e-6);
    }
    for (const float threshold : {nan, inf}) {
        const auto image = halves(1.0f, 0.0f);
        image->threshold = threshold;
        EXPECT_EQ(area(cut(card(), image)), 0.0);
    }
}

TEST(Cutout, ACardHidesALineBehindItExactlyWhereItsDiscIs) {
    for (const bool ortho : {false, true}) {
        const View view = ortho ? orthographic({0, 0, 4}, {0, 0, 0}, 4) : perspective({0, 0, 4}, {0, 0, 0});
        const CutMesh made = cut(card(), disc(128, 0.3));
        const auto surface = std::make_shared<Surface>("card", made.arrays());
        const Wires wires({{dvec3(-1.5, 0.01, -1), dvec3(1.5, 0.01, -1)}}, dmat4(1.0), {{surface, dmat4(1.0), 7}});
        const ClippedPaths clipped = wires.project(view);
        const Runs runs = exact_visibility(clipped, wires.paths, Tracer(wires.scene, view), Cancel());
        ASSERT_EQ(runs.piece.size(), 2u);
        const double left = pixel_of(view, {-0.6, 0, 0}).x, right = pixel_of(view, {0.6, 0, 0}).x;
        const double texel = pixel_of(view, {2.0 / 128, 0, 0}).x - pixel_of(view, {0, 0, 0}).x;
        const double start = clipped.px[0].x - clipped.arc_px[0];
        EXPECT_NEAR(start + runs.end_px[0], left, 0.5 * texel);
        EXPECT_NEAR(start + runs.start_px[1], right, 0.5 * texel);
    }
}

TEST(Cutout, PolygonsWhoseTrianglesNameOthersVerticesAreCutAsIfTheyHadNone) {
    Mesh whole("l", l_shape().positions);
    for (vec3& p : whole.positions) p -= vec3(1, 1, 0);
    whole.positions.push_back({5, 5, 0});
    whole.add_polygon({0, 1, 2, 3, 4, 5});
    Mesh broken = whole;
    broken.ngon_triangles = {{0, 1, 3}, {1, 2, 3}, {0, 3, 6}, {3, 4, 6}};
    broken.ngon_polygon = {0, 0, 0, 0};
    for (const double px_per_unit : {0.0, 100.0}) {
        const CutMesh as_is = cut(whole, disc(16, 0.3), px_per_unit), told = cut(broken, disc(16, 0.3), px_per_unit);
        EXPECT_EQ(told.positions, as_is.positions);
        EXPECT_EQ(told.corner_verts, as_is.corner_verts);
        EXPECT_GT(told.corner_verts.size(), 10u);
    }
}

TEST(Cutout, BadInputIsRefusedByName) {
    const Mesh mesh = card();
    const std::vector<int> first{0}, missing{1};
    const Array<vec2> uvs = uvs_of(mesh, plan);
    const auto refused = [&](const std::vector<Cut>& cuts, const std::vector<int>& of) {
        EXPECT_THROW(CutMesh("leaf", mesh.arrays(), cuts, {of}), std::invalid_argument);
    };
    refused({{uvs, disc(8, 0.3)}}, missing);
    refused({{uvs, disc(8, 0.3)}}, {});
    refused({{{}, disc(8, 0.3)}}, first);
    refused({{uvs, nullptr}}, first);
    Array<vec2> broken = uvs;
    broken[0].x = NAN;
    EXPECT_EQ(CutMesh("leaf", mesh.arrays(), {{broken, disc(8, 0.3)}}, {first}).corner_verts, mesh.corner_verts);
    for (vec2& uv : broken) uv = 1e7f * uv;  // repeated too often to follow
    EXPECT_NO_THROW(CutMesh("leaf", mesh.arrays(), {{broken, disc(8, 0.3)}}, {first}));
}
