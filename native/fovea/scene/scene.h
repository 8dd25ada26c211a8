// SPDX-License-Identifier: GPL-3.0-or-later
// Placements of surfaces: what one frame sees.
#pragma once

#include <memory>

#include <fovea/base/types.h>
#include <fovea/base/view.h>
#include <fovea/mesh/surface.h>

namespace fovea::scene {

/// What a placement does in the drawing.
enum Usage : std::uint8_t {
    usage_draw = 1,     ///< its lines are drawn
    usage_occlude = 2,  ///< it hides what lies behind
    usage_holdout = 4,  ///< it cuts a hole (alpha 0) where it is seen
};

/// A surface put into the world.
struct Placement {
    std::shared_ptr<const Surface> surface;
    dmat4 object_to_world{1.0};
    /// The object's persistent id; line ids are made from it.
    std::uint64_t id = 0;
    std::uint8_t usage = usage_draw | usage_occlude;
};

struct Scene {
    std::vector<Placement> placements;
    /// Facets are numbered over the whole scene: facet f of placement i is facet_base[i] + f. Ids wrap at 2^32.
    Array<Index> facet_base;

    Scene() = default;
    explicit Scene(std::vector<Placement> placed) : placements(std::move(placed)) {
        Index base = 0;
        for (const Placement& placement : placements) {
            facet_base.push_back(base);
            base += placement.surface->facet_count();
        }
    }
};

/// A sphere in view space that holds the placement.
struct Sphere {
    dvec3 center;
    double radius;
};
Sphere bounding_sphere(const Placement& placement, const View& view);

/// True unless the placement's bounding sphere lies outside the frame (widened by `margin` of its half size).
bool in_frame(const Placement& placement, const View& view, double margin);

}  // namespace fovea::scene
