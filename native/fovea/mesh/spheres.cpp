// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/mesh/spheres.h>

#include <glm/gtc/constants.hpp>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>
#include <fovea/mesh/polygon_surface.h>

namespace fovea::mesh {
namespace {

constexpr int octahedron = -1;
constexpr int finest = 4;
constexpr std::size_t most_faces = 2'000'000;  // of all spheres of a mesh, before they become octahedra

/// A unit sphere of triangles.
struct Ball {
    std::vector<dvec3> points;
    std::vector<int> corners;
    PolygonEdges edges;
    std::vector<int> offsets;
};

/// The convex hull's triangles of points that each have their neighbors at the least distance; outward by winding.
Ball regular(std::vector<dvec3> points) {
    Ball ball;
    double side = 4.0;
    for (dvec3& p : points) p = glm::normalize(p);
    for (const dvec3& p : points)
        if (&p != points.data()) side = std::min(side, glm::distance(p, points[0]));
    const int count = int(points.size());
    const auto joined = [&](int a, int b) { return glm::distance(points[a], points[b]) < 1.1 * side; };
    for (int a = 0; a < count; ++a)
        for (int b = a + 1; b < count; ++b)
            for (int c = b + 1; c < count; ++c) {
                if (!joined(a, b) || !joined(b, c) || !joined(a, c)) continue;
                const bool out = glm::determinant(dmat3(points[a], points[b], points[c])) > 0.0;
                ball.corners.insert(ball.corners.end(), {a, out ? b : c, out ? c : b});
            }
    ball.points = std::move(points);
    return ball;
}

Ball platonic(int level) {
    if (level == octahedron) return regular({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
    const double g = glm::golden_ratio<double>();
    std::vector<dvec3> points;
    for (const double a : {-1.0, 1.0})
        for (const double b : {-g, g}) points.insert(points.end(), {{0, a, b}, {a, b, 0}, {b, 0, a}});
    return regular(std::move(points));
}

std::vector<int> offsets_of(const Ball& ball) {
    std::vector<int> offsets;
    for (std::size_t c = 0; c <= ball.corners.size(); c += 3) offsets.push_back(int(c));
    return offsets;
}

/// Each triangle in four, the new points on the sphere.
Ball divided(const Ball& ball) {
    const PolygonEdges edges = polygon_edges(offsets_of(ball), ball.corners);
    const int first = int(ball.points.size());
    Ball fine{ball.points, {}, {}, {}};
    for (const glm::ivec2 e : edges.edge_verts)
        fine.points.push_back(glm::normalize(ball.points[e.x] + ball.points[e.y]));
    for (std::size_t c = 0; c < ball.corners.size(); c += 3) {
        const int* v = ball.corners.data() + c;
        const int ab = first + edges.corner_edges[c], bc = first + edges.corner_edges[c + 1],
                  ca = first + edges.corner_edges[c + 2];
        fine.corners.insert(fine.corners.end(), {v[0], ab, ca, ab, v[1], bc, ca, bc, v[2], ab, bc, ca});
    }
    return fine;
}

/// The mean area of a convex body's silhouettes is a fourth of its surface (Cauchy).
Ball ball_of(int level) {
    Ball ball = platonic(level);
    for (int i = 0; i < level; ++i) ball = divided(ball);
    double area = 0.0;
    for (std::size_t c = 0; c < ball.corners.size(); c += 3) {
        const auto at = [&](int i) { return ball.points[ball.corners[c + i]]; };
        area += 0.5 * glm::length(glm::cross(at(1) - at(0), at(2) - at(0)));
    }
    const double scale = std::sqrt(4.0 * glm::pi<double>() / area);
    for (dvec3& p : ball.points) p *= scale;
    ball.offsets = offsets_of(ball);
    ball.edges = polygon_edges(ball.offsets, ball.corners);
    return ball;
}

}  // namespace

int sphere_level(std::size_t count) {
    int level = finest;
    while (level > octahedron && (count * 20) << (2 * level) > most_faces) --level;
    return level;
}

OwnedMesh spheres(const std::string& name, In<vec3> centers, In<float> radii, bool occludes) {
    check(radii.size() == centers.size(), name + ": one radius per point expected");
    const Ball ball = ball_of(sphere_level(centers.size()));
    const std::size_t points = ball.points.size(), corners = ball.corners.size(), edges = ball.edges.edge_verts.size(),
                      faces = corners / 3, count = centers.size();
    check(count * corners < none / 4, name + ": more than a billion corners of spheres");
    OwnedMesh mesh;
    mesh.positions.resize(count * points);
    mesh.edge_verts.resize(count * edges);
    mesh.corner_verts.resize(count * corners);
    mesh.corner_edges.resize(count * corners);
    mesh.polygon_offsets.resize(count * faces + 1);
    mesh.polygon_offsets.back() = int(count * corners);
    if (!occludes) mesh.occluding.assign(count * faces, 0);
    parallel_for(count, 64, [&](std::size_t i) {
        for (std::size_t p = 0; p < points; ++p)
            mesh.positions[i * points + p] = vec3(dvec3(centers[i]) + double(radii[i]) * ball.points[p]);
        for (std::size_t e = 0; e < edges; ++e)
            mesh.edge_verts[i * edges + e] = ball.edges.edge_verts[e] + int(i * points);
        for (std::size_t c = 0; c < corners; ++c) {
            mesh.corner_verts[i * corners + c] = ball.corners[c] + int(i * points);
            mesh.corner_edges[i * corners + c] = ball.edges.corner_edges[c] + int(i * edges);
        }
        for (std::size_t f = 0; f < faces; ++f) mesh.polygon_offsets[i * faces + f] = int(i * corners + 3 * f);
    });
    return mesh;
}

}  // namespace fovea::mesh
