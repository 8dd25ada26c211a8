// SPDX-License-Identifier: GPL-3.0-or-later
// Intersections of a scene as curves in the world, and shapes whose intersections are known.
#pragma once

#include <glm/gtc/quaternion.hpp>

#include "drawing.h"

namespace fovea::intersections {
using namespace draw;

using namespace fovea::meshes;
using namespace fovea::drawing;

inline const View somewhere = perspective({9, -12, 7}, {0, 0, 0}, 30);

/// What the paths of a scene are, in the world.
struct Found {
    Index count = 0, closed = 0, points = 0;
    double length = 0.0;
    std::vector<double> lengths;  // per path, ascending
    std::vector<dvec3> at;

    explicit Found(std::vector<Placement> placements, const Values& values = {1, 1}) {
        const Drawing drawing(std::move(placements), somewhere, {line_set_with("intersection", values)});
        const Paths& paths = drawing.paths;
        count = paths.count();
        for (Index p = 0; p < count; ++p) {
            const dmat4& to_world = drawing.scene.placements[paths.placement[p]].object_to_world;
            double length_of_path = 0.0;
            for (Index i = paths.rows.begin(p); i < paths.rows.end(p); ++i) {
                at.push_back(dvec3(to_world * dvec4(dvec3(paths.points_obj[i]), 1.0)));
                if (i > paths.rows.begin(p)) length_of_path += glm::distance(at.back(), at[at.size() - 2]);
            }
            closed += paths.closed[p];
            lengths.push_back(length_of_path);
            length += length_of_path;
        }
        points = static_cast<Index>(at.size());
        std::sort(lengths.begin(), lengths.end());
    }
};

inline Placement put(const Mesh& mesh, dmat4 at, std::uint64_t id) { return place(mesh, at, id); }

inline dmat4 turned(double angle, dvec3 axis) { return glm::mat4_cast(glm::angleAxis(angle, glm::normalize(axis))); }

inline Mesh torus(double big, double small, int around, int across) {
    Mesh mesh("torus", {});
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) {
            const double a = 2 * std::numbers::pi * i / around, b = 2 * std::numbers::pi * j / across;
            const double r = big + small * std::cos(b);
            mesh.positions.push_back(vec3(dvec3(r * std::cos(a), r * std::sin(a), small * std::sin(b))));
        }
    const auto at = [&](int i, int j) { return (i % around) * across + j % across; };
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) mesh.add_polygon({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    return mesh;
}

/// Meshes as one object.
inline Mesh joined(const std::vector<std::pair<Mesh, dmat4>>& parts) {
    Mesh mesh("joined", {});
    for (const auto& [part, at] : parts) {
        const int base = static_cast<int>(mesh.positions.size());
        for (const vec3& p : part.positions) mesh.positions.push_back(vec3(at * dvec4(dvec3(p), 1.0)));
        for (std::size_t f = 0; f + 1 < part.polygon_offsets.size(); ++f) {
            std::vector<int> verts;
            for (int c = part.polygon_offsets[f]; c < part.polygon_offsets[f + 1]; ++c)
                verts.push_back(base + part.corner_verts[c]);
            mesh.add_polygon(verts);
        }
    }
    return mesh;
}

/// A wall whose plan is a figure of eight: it crosses itself along the z axis.
inline Mesh eight(int n) {
    Mesh mesh("eight", {});
    for (int i = 0; i < n; ++i) {
        const double t = 2 * std::numbers::pi * (i + 0.5) / n;
        for (const float z : {-1.0f, 1.0f})
            mesh.positions.push_back({float(std::sin(2 * t)), float(2 * std::sin(t)), z});
    }
    for (int i = 0; i < n; ++i) {
        const int j = (i + 1) % n;
        mesh.add_polygon({2 * i, 2 * j, 2 * j + 1, 2 * i + 1});
    }
    return mesh;
}

/// Every triangle with corners of its own.
inline Mesh split(const Mesh& mesh) {
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

}  // namespace fovea::intersections
