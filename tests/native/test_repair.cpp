// SPDX-License-Identifier: GPL-3.0-or-later
// Orientation and resampling: what they change, and what they must leave.
#include <gtest/gtest.h>
#include <random>

#include <fovea/repair/repair.h>

#include "analytic.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::meshes;

namespace {

RepairedMesh repaired(const Mesh& mesh, const Repair& repair) {
    return fovea::repair::repaired(mesh.name, mesh.arrays(), repair);
}

Surface surface_of(const RepairedMesh& mesh) { return Surface("repaired", mesh.arrays()); }

double volume(const Surface& surface) {
    double sum = 0.0;
    for (const Triangle& t : surface.triangles) {
        const auto p = [&](int i) { return dvec3(surface.positions[t[i]]); };
        sum += glm::dot(p(0), glm::cross(p(1), p(2))) / 6.0;
    }
    return sum;
}

struct Quality {
    double mean = 0.0, slivers = 0.0;  ///< slivers: the share of triangles with an angle under 15
};

/// Angles of triangles in degrees; the mean is of each triangle's smallest.
Quality quality_of(const RepairedMesh& mesh) {
    Quality q;
    const std::size_t triangles = mesh.corner_verts.size() / 3;
    for (std::size_t t = 0; t < triangles; ++t) {
        double smallest = 180.0;
        for (int i = 0; i < 3; ++i) {
            const auto p = [&](int k) { return dvec3(mesh.positions[mesh.corner_verts[3 * t + (i + k) % 3]]); };
            const dvec3 a = glm::normalize(p(1) - p(0)), b = glm::normalize(p(2) - p(0));
            smallest = std::min(smallest, glm::degrees(std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0))));
        }
        q.slivers += (smallest < 15.0) / double(triangles);
        q.mean += smallest / double(triangles);
    }
    return q;
}

}  // namespace

TEST(Repair, APolygonWhoseTrianglesNameOthersVerticesIsKeptAsItIs) {
    Mesh mesh = grid(8);
    const int first = static_cast<int>(mesh.positions.size());
    for (const vec3& p : l_shape().positions) mesh.positions.push_back(p + vec3(0, 0, 5));
    mesh.add_polygon({first, first + 1, first + 2, first + 3, first + 4, first + 5});
    const int polygon = static_cast<int>(mesh.polygon_offsets.size()) - 2, inside = 40;
    for (const glm::ivec3& t : {glm::ivec3(0, 1, 2), {0, 2, 3}, {0, 3, 5}}) mesh.ngon_triangles.push_back(first + t);
    mesh.ngon_triangles.push_back({first + 3, first + 4, inside});
    mesh.ngon_polygon.assign(4, polygon);
    const RepairedMesh made = repaired(mesh, {.resample = 5, .edge_length = 1.0});
    EXPECT_TRUE(made.ngon_triangles.empty());
    const std::size_t last = made.polygon_offsets.size() - 1;
    EXPECT_EQ(made.polygon_offsets[last] - made.polygon_offsets[last - 1], 6) << "its own corners";
    EXPECT_EQ(surface_of(made).report().degenerate_polygons, 0u);
}

TEST(Repair, ClosedPartsFaceOutwards) {
    std::mt19937 random(5);
    for (int turned = 0; turned < 8; ++turned) {
        const Mesh mesh = flipped(box(), [&](int) { return random() % 2; });
        const Surface surface = surface_of(repaired(mesh, {.orient = true}));
        EXPECT_EQ(surface.report().inconsistent_edges, 0u);
        EXPECT_NEAR(volume(surface), 8.0, 1e-5);
    }
    const RepairedMesh inside_out = repaired(flipped(box(), [](int) { return true; }), {.orient = true});
    EXPECT_EQ(inside_out.report.turned_polygons, 6u);
}

TEST(Repair, OpenPartsFollowTheirMajority) {
    const RepairedMesh mesh = repaired(flipped(grid(4), [](int f) { return f % 5 == 0; }), {.orient = true});
    EXPECT_EQ(mesh.report.turned_polygons, 4u);
    const Surface surface = surface_of(mesh);
    for (const vec4& plane : surface.facet_plane) EXPECT_GT(plane.z, 0.99f);
    // A one-sided strip cannot agree everywhere, but nothing is lost of it.
    EXPECT_EQ(surface_of(repaired(moebius(8), {.orient = true})).report().inconsistent_edges, 1u);
}

TEST(Repair, ResamplingKeepsFeatures) {
    const Surface finer = surface_of(repaired(box(), {.resample = 6, .edge_length = 0.25}));
    EXPECT_GT(finer.triangles.size(), 500u);
    EXPECT_NEAR(volume(finer), 8.0, 1e-5);
    for (Index v = 0; v < finer.vertex_count(); ++v) {
        const vec3 p = glm::abs(finer.positions[v]);
        EXPECT_NEAR(std::max({p.x, p.y, p.z}), 1.0f, 1e-6f);
    }
}

TEST(Repair, ResamplingMakesEvenTriangles) {
    const analytic::Sample bad = analytic::torus({.n = 48, .irregular = true});
    const RepairedMesh mesh = repaired(bad.mesh, {.resample = 10});
    const Surface surface = surface_of(mesh);
    EXPECT_EQ(surface.report().inconsistent_edges + surface.report().non_manifold_edges, 0u);
    const RepairedMesh before = repaired(bad.mesh, {});
    EXPECT_LT(quality_of(before).mean, 40.0);
    EXPECT_GT(quality_of(mesh).mean, 48.0);
    EXPECT_GT(quality_of(before).slivers, 0.02);
    EXPECT_LT(quality_of(mesh).slivers, 0.003);
    // Still a torus of V - E + F = 0, on the old triangles.
    EXPECT_EQ(int(mesh.positions.size()) - int(mesh.edge_verts.size()) + int(surface.triangles.size()), 0);
    for (const vec3& p : mesh.positions) {
        const double off = std::hypot(std::hypot(p.x, p.y) - 1.0, double(p.z)) - 0.4;
        EXPECT_LT(std::abs(off), 0.012);
    }
}

TEST(Repair, MarksAndMaterialsSurviveResampling) {
    Mesh mesh = grid(4);
    for (int f = 0; f < 16; ++f) mesh.material.push_back(f % 4 < 2 ? 0 : 1);
    mesh.edge_mark = mesh.edge_flags({mesh.edge(6, 7), mesh.edge(7, 8)});
    const RepairedMesh out = repaired(mesh, {.resample = 5, .edge_length = 0.2});
    double area[2] = {0, 0}, marked = 0.0;
    for (std::size_t f = 0; f < out.material.size(); ++f) {
        const auto p = [&](int i) { return dvec3(out.positions[out.corner_verts[3 * f + i]]); };
        const double a = 0.5 * glm::cross(p(1) - p(0), p(2) - p(0)).z;
        EXPECT_GT(a, 0.0);
        area[out.material[f]] += a;
    }
    EXPECT_NEAR(area[0], 2.0, 1e-5);
    EXPECT_NEAR(area[1], 2.0, 1e-5);
    for (std::size_t e = 0; e < out.edge_verts.size(); ++e)
        if (out.edge_mark[e])
            marked += glm::distance(out.positions[out.edge_verts[e].x], out.positions[out.edge_verts[e].y]);
    EXPECT_NEAR(marked, 1.0, 1e-5);
}

TEST(Repair, NonManifoldPartsStayAsTheyAre) {
    const Mesh mesh = two_boxes_at_an_edge();
    const RepairedMesh out = repaired(mesh, {.resample = 3, .edge_length = 0.5});
    EXPECT_GT(out.report.refused_polygons, 0u);
    EXPECT_LT(out.report.refused_polygons, 12u);
    const Surface surface = surface_of(out);
    EXPECT_NEAR(volume(surface), 16.0, 1e-4);
    EXPECT_EQ(surface.report().degenerate_polygons, 0u);
    // No gap: every edge has at least two sides.
    for (Index e = 0; e < surface.mesh_edges; ++e) EXPECT_GE(surface.edge_rows.size(e), 2u);
}

TEST(Repair, PolygonsWithoutCornersHaveNoOrientation) {
    for (const Polygons& polygons :
         {Polygons{{}}, Polygons{{}, {}, {0, 1, 2}}, Polygons{{0, 1, 2}, {}, {0, 1, 3}, {}}}) {
        const Mesh mesh = of_polygons("empty", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}}, polygons);
        const RepairedMesh out = repaired(mesh, {.orient = true, .resample = 0});
        EXPECT_EQ(out.polygon_offsets.size(), polygons.size() + 1);
        EXPECT_EQ(out.report.turned_polygons, polygons.size() == 4 ? 1u : 0u);
    }
}

TEST(Repair, BrokenPolygonsAreRefusedNotFatal) {
    Mesh mesh = grid(3);
    mesh.positions[5].z = std::nanf("");
    const RepairedMesh out = repaired(mesh, {.orient = true, .resample = 2});
    EXPECT_EQ(out.report.refused_polygons, 4u);
    EXPECT_EQ(surface_of(out).report().degenerate_polygons, 4u);
    EXPECT_THROW(repaired(grid(1), {.edge_length = -1.0}), std::invalid_argument);
    EXPECT_THROW(repaired(grid(1), {.resample = -1}), std::invalid_argument);
    const Repair all{.orient = true, .resample = 1};
    EXPECT_EQ(repaired(Mesh("nothing", {}), all).positions.size(), 0u);
}

TEST(Repair, WhatWouldBeTooManyTrianglesIsLeftAsItIs) {
    const Mesh mesh = box();
    const RepairedMesh refused = repaired(mesh, {.resample = 50, .edge_length = 1e-4, .most_triangles = 1'000'000});
    EXPECT_NEAR(double(refused.report.too_many_triangles), 24.0 / (std::sqrt(0.75) / 2.0 * 1e-8), 1e7);
    EXPECT_EQ(refused.positions.size(), 8u);
    EXPECT_EQ(refused.polygon_offsets.size(), 7u);
    const RepairedMesh few_steps = repaired(mesh, {.resample = 2, .edge_length = 1e-4, .most_triangles = 1'000'000});
    EXPECT_EQ(few_steps.report.too_many_triangles, 0u) << "at most 12 x 4 x 4";
    EXPECT_GT(few_steps.positions.size(), 8u);
    const RepairedMesh endless = repaired(mesh, {.resample = 100, .edge_length = 1e-300, .most_triangles = 100});
    EXPECT_GT(endless.report.too_many_triangles, 1'000'000'000u);
    EXPECT_EQ(endless.positions.size(), 8u);
}
