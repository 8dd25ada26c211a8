// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/mesh/strands.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include <fovea/base/check.h>
#include <fovea/base/elementary.h>
#include <fovea/base/parallel.h>

namespace fovea::mesh {
namespace {

constexpr int sides = 3;
constexpr float least_share = 0.02f;  // of a strand's greatest radius: a tip of none would have no area
constexpr std::size_t grain = 64;     // strands per block

/// Circumradius of a regular prism per radius of a cylinder of the same mean width, which is the perimeter over pi.
const double wide = glm::pi<double>() / (sides * sine(glm::pi<double>() / sides));

void check_strands(const std::string& name, const Strands& strands) {
    const In<int> offsets = strands.offsets;
    check(strands.radii.size() == strands.points.size(), name + ": one radius per point of a strand expected");
    check(strands.points.size() < none / 16,
          name + ": more than a hundred million points of strands; lower their number");
    check(!offsets.empty() && offsets.front() == 0 && std::size_t(offsets.back()) == strands.points.size(),
          name + ": offsets of strands must go from 0 to the number of points");
    for (std::size_t s = 1; s < offsets.size(); ++s)
        check(offsets[s] - offsets[s - 1] >= 2, name + ": each strand must have at least two points");
}

template <typename T>
T catmull_rom(const T& before, const T& a, const T& b, const T& after, float t) {
    const T linear = b - before, square = 2.0f * before - 5.0f * a + 4.0f * b - after;
    const T cube = 3.0f * (a - b) + after - before;
    return a + 0.5f * t * (linear + t * (square + t * cube));
}

/// Calls body(strand, first point, end) for each strand.
template <typename Body>
void each_strand(In<int> offsets, const Body& body) {
    parallel_for(offsets.size() - 1, grain, [&](std::size_t s) { body(int(s), offsets[s], offsets[s + 1]); });
}

/// A direction perpendicular to a unit vector, by the axis that it is farthest from.
dvec3 any_normal(const dvec3& along) {
    const dvec3 size = glm::abs(along);
    const dvec3 axis = size.x <= size.y && size.x <= size.z ? dvec3(1, 0, 0)
                       : size.y <= size.z                   ? dvec3(0, 1, 0)
                                                            : dvec3(0, 0, 1);
    return glm::normalize(axis - glm::dot(axis, along) * along);
}

/// Fills the vertices of one strand's prism, whose cross section is carried along without twist.
void place_prism(In<vec3> points, In<float> radii, vec3* out) {
    const std::size_t last = points.size() - 1;
    const auto direction = [&](std::size_t from) {
        const dvec3 d = dvec3(points[from + 1]) - dvec3(points[from]);
        const double length = glm::length(d);
        return length > 0.0 ? d / length : dvec3(0.0);
    };
    const float least = least_share * *std::max_element(radii.begin(), radii.end());
    dvec3 along(0.0, 0.0, 1.0), normal(1.0, 0.0, 0.0);
    bool started = false;
    for (std::size_t i = 0; i <= last; ++i) {
        const dvec3 mean = (i > 0 ? direction(i - 1) : dvec3(0.0)) + (i < last ? direction(i) : dvec3(0.0));
        if (glm::dot(mean, mean) > 1e-12) along = glm::normalize(mean);
        const dvec3 carried = normal - glm::dot(normal, along) * along;
        const bool turned = started && glm::dot(carried, carried) > 1e-12;
        normal = turned ? glm::normalize(carried) : any_normal(along);
        started = true;
        const dvec3 across = glm::cross(along, normal);
        const double radius = wide * std::max(radii[i], least);
        for (int k = 0; k < sides; ++k) {
            const double angle = glm::two_pi<double>() * k / sides;
            out[sides * i + k] = vec3(dvec3(points[i]) + radius * (cosine(angle) * normal + sine(angle) * across));
        }
    }
}

/// Fills the faces of the prism of strand `s`, with the points begin .. end: first the rings' edges, then those along;
/// quadrilaterals of all strands, then two triangles for each.
void join_prism(int s, int begin, int end, int points, int segments, OwnedMesh& mesh) {
    const auto ring = [](int i, int k) { return sides * i + k % sides; };
    const auto along = [&](int i, int k) { return sides * points + sides * (i - s) + k % sides; };
    for (int i = begin; i < end; ++i)
        for (int k = 0; k < sides; ++k) {
            mesh.edge_verts[ring(i, k)] = {ring(i, k), ring(i, k + 1)};
            if (i + 1 == end) continue;
            mesh.edge_verts[along(i, k)] = {ring(i, k), ring(i + 1, k)};
            const int face = sides * (i - s) + k, corner = 4 * face;
            const int verts[] = {ring(i, k), ring(i, k + 1), ring(i + 1, k + 1), ring(i + 1, k)};
            const int edges[] = {ring(i, k), along(i, k + 1), ring(i + 1, k), along(i, k)};
            std::copy_n(verts, 4, mesh.corner_verts.begin() + corner);
            std::copy_n(edges, 4, mesh.corner_edges.begin() + corner);
            mesh.polygon_offsets[face] = corner;
        }
    for (int cap = 0; cap < 2; ++cap) {
        const int face = sides * segments + 2 * s + cap, corner = 4 * sides * segments + sides * (2 * s + cap);
        const int at = cap ? end - 1 : begin;
        for (int j = 0; j < sides; ++j) {  // the root winds the other way
            mesh.corner_verts[corner + j] = ring(at, cap ? j : sides - j);
            mesh.corner_edges[corner + j] = ring(at, cap ? j : sides - 1 - j);
        }
        mesh.polygon_offsets[face] = corner;
    }
}

}  // namespace

OwnedStrands rounded_strands(const std::string& name, const Strands& strands, int steps) {
    check_strands(name, strands);
    check(steps >= 1 && steps <= 64, name + ": 1 to 64 steps for each segment of a strand expected");
    const In<int> offsets = strands.offsets;
    OwnedStrands result;
    result.offsets = parallel_map<int>(offsets.size(), [&](std::size_t s) {
        return steps * (offsets[s] - int(s)) + int(s);  // every strand keeps its first point
    });
    result.points.resize(result.offsets.back());
    result.radii.resize(result.offsets.back());
    each_strand(offsets, [&](int s, int begin, int end) {
        for (int j = result.offsets[s]; j < result.offsets[s + 1]; ++j) {
            const int step = j - result.offsets[s], i = std::min(begin + step / steps, end - 2);
            const float t = float(step - steps * (i - begin)) / float(steps);
            const int before = std::max(i - 1, begin), after = std::min(i + 2, end - 1);
            const auto at = [&](const auto& values) {
                return catmull_rom(values[before], values[i], values[i + 1], values[after], t);
            };
            result.points[j] = at(strands.points);
            result.radii[j] = std::max(at(strands.radii), 0.0f);
        }
    });
    return result;
}

OwnedMesh strand_prisms(const std::string& name, const Strands& strands, bool occludes) {
    check_strands(name, strands);
    const int points = int(strands.points.size()), count = int(strands.offsets.size()) - 1, segments = points - count;
    const int polygons = sides * segments + 2 * count;
    OwnedMesh mesh;
    mesh.positions.resize(std::size_t(sides) * points);
    mesh.edge_verts.resize(std::size_t(sides) * (points + segments));
    mesh.corner_verts.resize(std::size_t(sides) * (4 * segments + 2 * count));
    mesh.corner_edges.resize(mesh.corner_verts.size());
    mesh.polygon_offsets.resize(std::size_t(polygons) + 1);
    mesh.polygon_offsets.back() = int(mesh.corner_verts.size());
    if (!occludes) mesh.occluding.assign(polygons, 0);
    each_strand(strands.offsets, [&](int s, int begin, int end) {
        const std::size_t size = end - begin;
        place_prism(strands.points.subspan(begin, size), strands.radii.subspan(begin, size),
                    mesh.positions.data() + sides * begin);
        join_prism(s, begin, end, points, segments, mesh);
    });
    return mesh;
}

OwnedMesh strand_wires(const std::string& name, const Strands& strands) {
    check_strands(name, strands);
    OwnedMesh mesh;
    mesh.positions.assign(strands.points.begin(), strands.points.end());
    mesh.edge_verts.resize(strands.points.size() - (strands.offsets.size() - 1));
    mesh.polygon_offsets = {0};
    each_strand(strands.offsets, [&](int s, int begin, int end) {
        for (int i = begin; i + 1 < end; ++i) mesh.edge_verts[i - s] = {i, i + 1};
    });
    return mesh;
}

}  // namespace fovea::mesh
