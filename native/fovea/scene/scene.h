// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes: placements of surfaces.
#pragma once

#include <memory>
#include <optional>

#include <fovea/base/types.h>
#include <fovea/base/view.h>
#include <fovea/mesh/surface.h>
#include <fovea/scene/light.h>

namespace fovea::scene {

/// Bits: roles of a placement in the drawing.
enum Usage : std::uint8_t {
    usage_draw = 1,     ///< its lines are drawn
    usage_occlude = 2,  ///< it occludes
    usage_holdout = 4,  ///< it cuts a hole (alpha 0) where it is visible
};

/// A surface with its transform.
struct Placement {
    std::shared_ptr<const Surface> surface;
    dmat4 object_to_world{1.0};
    /// Persistent id of the object, from which line ids are hashed.
    std::uint64_t id = 0;
    std::uint8_t usage = usage_draw | usage_occlude;
    /// Placements of the same group have one outline together; 0: of none.
    std::uint64_t group = 0;
};

struct Scene {
    std::vector<Placement> placements;
    /// First facet of each placement in the scene-wide numbering: facet f of placement i is facet_base[i] + f, modulo
    /// 2^32.
    Array<Index> facet_base;
    /// Section plane in world space, with a unit normal: where dot(section, (p, 1)) is positive, all is cut away
    /// (section.h). Unset: nothing is.
    std::optional<dvec4> section;
    std::vector<Light> lights;

    Scene() = default;
    /// Placements whose transform flattens their surface get a thickness (flattened.h).
    explicit Scene(std::vector<Placement> placed);

    /// Whether two placements are one, or two of a group.
    bool share_outline(Index a, Index b) const {
        return a == b || (placements[a].group != 0 && placements[a].group == placements[b].group);
    }
};

/// Bounding sphere of a placement, in view space.
struct Sphere {
    dvec3 center;
    double radius;
};
Sphere bounding_sphere(const Placement& placement, const View& view);

/// False if the placement's bounding sphere is outside the frame, widened by `margin` times its half size, or entirely
/// before the near plane. Without a frame, as from a light (light_view.h), all is in it.
bool in_frame(const Placement& placement, const View& view, double margin);

}  // namespace fovea::scene
