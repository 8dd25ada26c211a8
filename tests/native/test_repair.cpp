// SPDX-License-Identifier: GPL-3.0-or-later
// Welding, orientation, smoothing and resampling: what they change, and what they must leave.
#include <gtest/gtest.h>
#include <random>
#include <set>

#include <fovea/mesh/nearest.h>
#include <fovea/mesh/repair.h>

#include "analytic.h"

using namespace fovea;
using namespace fovea::meshes;

namespace {

RepairedMesh repaired(const Mesh& mesh, const Repair& repair) {
    return fovea::repaired(mesh.name, mesh.arrays(), repair);
}

Surface surface_of(const RepairedMesh& mesh) { return Surface("repaired", mesh.arrays()); }

/// Every polygon with vertices of its own.
Mesh torn(const Mesh& mesh) {
    Mesh result(mesh.name, {});
    for (std::size_t f = 0; f + 1 < mesh.polygon_offsets.size(); ++f) {
        std::vector<int> verts;
        for (int c = mesh.polygon_offsets[f]; c < mesh.polygon_offsets[f + 1]; ++c) {
            verts.push_back(static_cast<int>(result.positions.size()));
            result.positions.push_back(mesh.positions[mesh.corner_verts[c]]);
        }
        result.add_polygon(verts);
    }
    return result;
}

double volume(const Surface& surface) {
    double sum = 0.0;
    for (const Triangle& t : surface.triangles) {
        const auto p = [&](int i) { return dvec3(surface.positions[t[i]]); };
        sum += glm::dot(p(0), glm::cross(p(1), p(2))) / 6.0;
    }
    return sum;
}

std::size_t used_vertices(const RepairedMesh& mesh) {
    return std::set<int>(mesh.corner_verts.begin(), mesh.corner_verts.end()).size();
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

TEST(Repair, WeldingClosesATornBox) {
    Mesh mesh = torn(box());
    mesh.material = {0, 1, 2, 3, 4, 5};
    std::mt19937 random(3);
    std::uniform_real_distribution<float> jitter(-0.01f, 0.01f);
    for (vec3& p : mesh.positions) p += vec3(jitter(random), jitter(random), jitter(random));
    mesh.seam = mesh.edge_flags({0});
    const RepairedMesh welded = repaired(mesh, {.weld = 0.1});
    EXPECT_EQ(welded.report.welded_vertices, 16u);
    EXPECT_EQ(used_vertices(welded), 8u);
    EXPECT_EQ(welded.edge_verts.size(), 12u);
    EXPECT_EQ(welded.material, mesh.material);
    EXPECT_EQ(std::count(welded.seam.begin(), welded.seam.end(), 1), 1);
    EXPECT_EQ(surface_of(welded).report().inconsistent_edges, 0u);
    const RepairedMesh apart = repaired(mesh, {.weld = 1e-6});
    EXPECT_EQ(apart.report.welded_vertices, 0u);
    EXPECT_EQ(used_vertices(apart), 24u);
}

TEST(Repair, WeldingDropsWhatHasNoAreaLeft) {
    // The L's short side shrinks to a point: its triangles are left.
    Mesh mesh = l_shape();
    mesh.positions[2] = mesh.positions[1] + vec3(0, 1e-3f, 0);
    const RepairedMesh welded = repaired(mesh, {.weld = 1e-2});
    EXPECT_EQ(welded.polygon_offsets.size() - 1, 3u);
    EXPECT_EQ(surface_of(welded).report().degenerate_polygons, 0u);
    const Mesh sliver = of_polygons("sliver", {{0, 0, 0}, {1, 0, 0}, {1, 1e-3f, 0}, {0, 1e-3f, 0}}, {{0, 1, 2, 3}});
    EXPECT_EQ(repaired(sliver, {.weld = 1e-2}).corner_verts.size(), 0u);
}

TEST(Repair, NegativeAndPositiveZeroAreOnePlace) {
    const Mesh mesh =
        of_polygons("zeros", {{0.0f, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0f, -0.0f, -0.0f}, {-1, 0, 0}, {0, -1, 0}},
                    {{0, 1, 2}, {3, 4, 5}});
    EXPECT_EQ(repaired(mesh, {.weld = 1e-4}).report.welded_vertices, 1u);
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

TEST(Repair, SmoothingTakesNoiseAway) {
    Mesh mesh = sphere(20);
    std::mt19937 random(1);
    std::normal_distribution<float> noise(0.0f, 0.01f);
    for (vec3& p : mesh.positions) p *= 1.0f + noise(random);
    const auto roughness = [](const std::vector<vec3>& points) {
        double mean = 0.0, squares = 0.0;
        for (const vec3& p : points) mean += glm::length(p) / double(points.size());
        for (const vec3& p : points) squares += std::pow(glm::length(p) - mean, 2) / double(points.size());
        return std::pair(mean, std::sqrt(squares));
    };
    const RepairedMesh smoothed = repaired(mesh, {.smooth = 10});
    EXPECT_EQ(smoothed.corner_verts, mesh.corner_verts);
    const auto before = roughness(mesh.positions), after = roughness(smoothed.positions);
    EXPECT_LT(after.second, 0.7 * before.second);
    EXPECT_NEAR(after.first, before.first, 0.02);
}

TEST(Repair, SmoothingAndResamplingKeepFeatures) {
    const Mesh mesh = box();
    EXPECT_EQ(repaired(mesh, {.smooth = 5}).positions, mesh.positions);
    const Surface finer = surface_of(repaired(mesh, {.resample = 6, .edge_length = 0.25}));
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
    RepairedMesh before = repaired(bad.mesh, {.weld = 1e-12});
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
    const RepairedMesh out = repaired(mesh, {.smooth = 3, .resample = 3, .edge_length = 0.5});
    EXPECT_GT(out.report.refused_polygons, 0u);
    EXPECT_LT(out.report.refused_polygons, 12u);
    const Surface surface = surface_of(out);
    EXPECT_NEAR(volume(surface), 16.0, 1e-4);
    EXPECT_EQ(surface.report().degenerate_polygons, 0u);
    // No gap: every edge has at least two sides.
    for (Index e = 0; e < surface.mesh_edges; ++e) EXPECT_GE(surface.edge_rows.size(e), 2u);
}

TEST(Repair, BrokenPolygonsAreRefusedNotFatal) {
    Mesh mesh = grid(3);
    mesh.positions[5].z = std::nanf("");
    const RepairedMesh out = repaired(mesh, {.weld = 1e-3, .orient = true, .smooth = 2, .resample = 2});
    EXPECT_EQ(out.report.refused_polygons, 4u);
    EXPECT_EQ(surface_of(out).report().degenerate_polygons, 4u);
    EXPECT_THROW(repaired(grid(1), {.weld = -1.0}), std::invalid_argument);
    EXPECT_THROW(repaired(grid(1), {.smooth = -1}), std::invalid_argument);
    const Repair all{.weld = 1, .orient = true, .smooth = 1, .resample = 1};
    EXPECT_EQ(repaired(Mesh("nothing", {}), all).positions.size(), 0u);
}

TEST(Repair, NearestPointsOfATetrahedron) {
    const Mesh mesh = tetrahedron();
    std::vector<dvec3> p(mesh.positions.begin(), mesh.positions.end());
    std::vector<glm::uvec3> t;
    for (const int* v = mesh.corner_verts.data(); t.size() < 4; v += 3) t.push_back({v[0], v[1], v[2]});
    const NearestPoint nearest(p, t, 0.1);
    std::mt19937 random(2);
    std::uniform_real_distribution<double> at(-3.0, 3.0);
    for (int i = 0; i < 500; ++i) {
        const dvec3 q(at(random), at(random), at(random));
        double least = 1e30;
        for (const auto& v : t)
            least = std::min(least, glm::distance(q, nearest_in_triangle(q, p[v.x], p[v.y], p[v.z])));
        EXPECT_NEAR(glm::distance(q, nearest.to(q)), least, 1e-12);
    }
    EXPECT_EQ(NearestPoint({}, {}, 1.0).to(dvec3(3)), dvec3(3));
}
