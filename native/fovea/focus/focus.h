// SPDX-License-Identifier: GPL-3.0-or-later
// Focus: how far every place of the picture is from where the viewer shall look.
#pragma once

#include <memory>

#include <fovea/base/view.h>
#include <fovea/project/clipped_paths.h>
#include <fovea/scene/distance.h>

namespace fovea::focus {

/// A place to look at: in focus up to `near` from it, out of focus from `far` on.
struct FocusPoint {
    /// In the image: pixels in x and y. In the scene: view space.
    vec3 at{0.0f};
    /// Pixels, or units of the scene.
    float near = 0.0f, far = 1.0f;
    /// In the scene: surfaces to be near to, instead of `at`.
    std::shared_ptr<const SurfaceDistance> surface = nullptr;

    /// Infinite beyond `far` of surfaces.
    float distance(vec3 place) const { return surface ? (*surface)(place, far) : glm::distance(place, at); }
};

enum class FocusSpace : std::uint8_t { image, scene };

/// Focus f in [0,1] by distance from points or surfaces (Cole 2009, 5.3.1): 0 in focus, 1 out of it. Several points:
/// the nearest in its own radii counts; or what each leaves in focus adds up. Without points all is in focus.
struct Focus {
    FocusSpace space = FocusSpace::image;
    std::vector<FocusPoint> points;
    bool sum = false;

    /// Of a place in pixels of the image and in view space, whichever `space` asks for. What is no place is out of
    /// focus.
    float operator()(vec2 px, vec3 position_view) const;
    /// Whether it asks for distances from surfaces, which take long.
    bool of_surfaces() const;
    /// How much f changes at most over a unit of the scene; infinite where it has a step.
    float steepness() const;
};

/// Where focus falls off from surfaces, samples and pixels between two (or four) others over which f cannot change by
/// more than this have what lies between theirs; all others are exact.
inline constexpr float focus_tolerance = 1.0f / 32.0f;

/// f of each atlas sample.
Array<float> focus_of_samples(const ClippedPaths& clipped, const Focus& focus);

/// f of each pixel of the view, first row at the bottom. `distance`: along the view, of what the pixel shows; infinite
/// where it shows nothing, which is out of focus where focus lies in the scene.
Array<float> focus_of_pixels(const View& view, In<float> distance, const Focus& focus);

/// Values at the points of paths (see path/painted.h), at each atlas sample.
Array<float> values_of_samples(const ClippedPaths& clipped, In<float> values);

/// How far each atlas sample is from the camera, in [0,1] between the distances near and far along the view.
Array<float> distance_of_samples(const ClippedPaths& clipped, float near, float far);

}  // namespace fovea::focus
