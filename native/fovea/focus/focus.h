// SPDX-License-Identifier: GPL-3.0-or-later
// The focus field of a picture.
#pragma once

#include <memory>

#include <fovea/base/view.h>
#include <fovea/project/clipped_paths.h>
#include <fovea/scene/distance.h>

namespace fovea::focus {

/// A focus point: in focus up to distance `near` from it, out of focus from `far` on.
struct FocusPoint {
    /// In the image: pixels in x and y. In the scene: view space.
    vec3 at{0.0f};
    /// Pixels, or scene units.
    float near = 0.0f, far = 1.0f;
    /// In the scene: surfaces from which distance is measured, instead of `at`.
    std::shared_ptr<const SurfaceDistance> surface = nullptr;

    /// Distance of a place; infinite beyond `far` of surfaces.
    float distance(vec3 place) const { return surface ? (*surface)(place, far) : glm::distance(place, at); }
};

enum class FocusSpace : std::uint8_t { image, scene };

/// Focus f in [0,1] by distance from points or surfaces (Cole 2009, 5.3.1): 0 in focus, 1 out of focus. Several points:
/// the minimum of their f; or, with `sum`, 1 - f of the points adds up to at most 1. Without points all is in focus.
struct Focus {
    FocusSpace space = FocusSpace::image;
    std::vector<FocusPoint> points;
    bool sum = false;

    /// f of a place, given by its pixel and its view-space position; `space` selects which is used. NaN is out of
    /// focus.
    float operator()(vec2 px, vec3 position_view) const;
    /// Whether it needs distances from surfaces, which are slow.
    bool of_surfaces() const;
    /// Lipschitz constant of f per scene unit; infinite if f has a step.
    float steepness() const;
};

/// Focus by distance from surfaces is interpolated at samples and pixels between two (or four) others over which f
/// cannot change by more than this; all others are exact.
inline constexpr float focus_tolerance = 1.0f / 32.0f;

/// f of each atlas sample.
Array<float> focus_of_samples(const ClippedPaths& clipped, const Focus& focus);

/// f of each pixel of the view, bottom row first. `distance`: along the view axis, of the surface that the pixel shows;
/// infinite for background, which is out of focus if focus lies in the scene.
Array<float> focus_of_pixels(const View& view, In<float> distance, const Focus& focus);

/// Per-point values of paths (path/painted.h), interpolated at each atlas sample.
Array<float> values_of_samples(const ClippedPaths& clipped, In<float> values);

/// Distance of each atlas sample along the view axis, mapped from [near, far] to [0,1].
Array<float> distance_of_samples(const ClippedPaths& clipped, float near, float far);

}  // namespace fovea::focus
