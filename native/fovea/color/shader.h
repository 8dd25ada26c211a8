// SPDX-License-Identifier: GPL-3.0-or-later
// Shaded color of a visible point of a triangle.
#pragma once

#include <fovea/color/light.h>
#include <fovea/color/screen_triangle.h>
#include <fovea/color/source.h>
#include <fovea/field/corner_normals.h>
#include <fovea/scene/scene.h>

namespace fovea::color {

/// A potentially visible triangle, prepared for shading.
struct SeenTriangle {
    ScreenTriangle screen;
    Index placement = none;
    std::array<Index, 3> corner{};
    const ColorSlot* slot = nullptr;
    Index triangle = none;
};

class ColorShader {
   public:
    /// Borrows its arguments. Throws as check_color, and unless there is one entry of `colors` per placement.
    /// `with_normals`: also of flat shading, as for tones.
    ColorShader(const Scene& scene, const View& view, const SceneColor& colors, const Lighting& lighting,
                bool with_normals = false);

    SeenTriangle triangle(Index placement, Index triangle) const;
    /// Scene-linear; `share` as SeenTriangle::screen.at(px) gives it. `reach`: null without shadows.
    vec3 color(const SeenTriangle& triangle, const dvec2& px, const dvec3& share, const Reach* reach = nullptr) const;
    /// Light that arrives there (light.h); of what light does not change, 1.
    float tone(const SeenTriangle& triangle, const dvec2& px, const dvec3& share, const Reach& reach) const;
    /// In view space.
    dvec3 point(const SeenTriangle& triangle, const dvec2& px, const dvec3& share) const;
    /// Number of the band of toon shading there; of other shading, and what light does not change, 0.
    int band(const SeenTriangle& triangle, const dvec2& px, const dvec3& share) const;
    Shading shading() const { return lighting_.shading(); }
    bool holdout(Index placement) const { return scene_.placements[placement].usage & usage_holdout; }

   private:
    struct Placed {
        dmat4 object_to_view;
        glm::mat3 normal_to_view;
        std::shared_ptr<const CornerNormals> normals;  // if the mesh has none of its own
    };
    /// Calls use(point, normal, direction to the eye) there, in view space.
    template <typename Use>
    auto lit(const SeenTriangle& triangle, const dvec2& px, const dvec3& share, const Use& use) const;
    vec3 base(const SeenTriangle& triangle, const dvec2& px, const vec3& share) const;
    vec3 normal(const SeenTriangle& triangle, const vec3& share, const vec3& to_eye) const;

    const Scene& scene_;
    const View& view_;
    const SceneColor& colors_;
    const Lighting& lighting_;
    dmat3 pixel_to_ray_;
    std::vector<Placed> placed_;
};

}  // namespace fovea::color
