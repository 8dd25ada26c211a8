// SPDX-License-Identifier: GPL-3.0-or-later
// Lines by lights, as segments in the world.
#pragma once

#include <fovea/scene/light_view.h>

#include "drawing.h"

namespace fovea::shadows {
using namespace draw;

inline Light sun(const dvec3& towards) { return {.kind = Light::sun, .direction = -towards}; }
inline Light lamp(const dvec3& at, float strength = 1.0f, std::uint64_t id = 0) {
    return {.kind = Light::point, .position = at, .color = vec3(strength), .id = id};
}

struct Segment {
    dvec3 a, b;
    Index placement;
    double length() const { return glm::distance(a, b); }
    dvec3 middle() const { return 0.5 * (a + b); }
};

inline double length(const std::vector<Segment>& segments) {
    double sum = 0.0;
    for (const Segment& s : segments) sum += s.length();
    return sum;
}

/// Lines of a definition in a scene with lights, from a camera that sees all of it.
struct Lines {
    Scene scene;
    std::vector<Segment> segments;
    std::vector<std::uint64_t> ids;
    Index closed = 0;

    Lines(std::vector<Placement> placements, std::vector<Light> lights, const LineSet& set,
          const std::optional<dvec4>& section = {})
        : scene(drawing::cut_open(std::move(placements), section)) {
        scene.lights = std::move(lights);
        const View view = drawing::perspective({31, -17, 400}, {0, 0, 0}, 20.0);
        const Tracer tracer(scene, view);
        const Paths paths = extract_paths(scene, view, {set}, tracer, Cancel());
        for (Index p = 0; p < paths.count(); ++p) {
            const Index placement = paths.placement[p];
            const dmat4& to_world = scene.placements[placement].object_to_world;
            const auto at = [&](Index i) { return dvec3(to_world * dvec4(dvec3(paths.points_obj[i]), 1.0)); };
            for (Index i = paths.rows.begin(p); i + 1 < paths.rows.end(p); ++i)
                segments.push_back({at(i), at(i + 1), placement});
            ids.push_back(paths.id[p]);
            closed += paths.closed[p];
        }
    }
    /// Those on one placement.
    std::vector<Segment> on(Index placement) const {
        std::vector<Segment> found;
        for (const Segment& s : segments)
            if (s.placement == placement) found.push_back(s);
        return found;
    }
};

/// Lengths weigh: `median` and `most` (nine tenths) of distance(middle) over segments; the share with more than `far`.
struct Errors {
    double median = 0.0, most = 0.0, beyond = 0.0;

    template <typename Distance>
    Errors(const std::vector<Segment>& segments, double far, const Distance& distance) {
        std::vector<std::pair<double, double>> all;
        for (const Segment& s : segments) all.emplace_back(distance(s.middle()), s.length());
        std::ranges::sort(all);
        const double sum = length(segments);
        double before = 0.0;
        for (const auto& [d, l] : all) {
            if (before <= 0.5 * sum) median = d;
            if (before <= 0.9 * sum) most = d;
            if (d > far) beyond += l / sum;
            before += l;
        }
    }
};

/// Whether a triangle is between a point and a light, by trying all: shares nothing with the tracer.
inline bool is_lit(const Scene& scene, const Light& light, const dvec3& point, Index but) {
    const dvec3 way = light.kind == Light::sun ? -1e3 * glm::normalize(light.direction) : light.position - point;
    for (Index i = 0; i < scene.placements.size(); ++i) {
        if (i == but) continue;
        const Surface& surface = *scene.placements[i].surface;
        const auto place = [&](Index v) {
            return dvec3(scene.placements[i].object_to_world * dvec4(dvec3(surface.positions[v]), 1.0));
        };
        for (const Triangle& t : surface.triangles) {
            // Moeller & Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997.
            const dvec3 a = place(t.x), e = place(t.y) - a, f = place(t.z) - a, p = glm::cross(way, f);
            const double det = glm::dot(e, p);
            if (det == 0.0) continue;
            const dvec3 s = point - a, q = glm::cross(s, e);
            const double u = glm::dot(s, p) / det, v = glm::dot(way, q) / det, along = glm::dot(f, q) / det;
            if (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && along > 0.0 && along < 1.0) return false;
        }
    }
    return true;
}

}  // namespace fovea::shadows
