// SPDX-License-Identifier: GPL-3.0-or-later
// Which lights reach what is seen of a scene, by rays: the shadows of the color layer.
#pragma once

#include <memory>
#include <vector>

#include <fovea/color/light.h>
#include <fovea/scene/shade.h>
#include <fovea/scene/tracer.h>

namespace fovea::color {

/// Of each light two bits: the lower ones for a part of it, the upper ones for its middle.
using LightBits = std::uint16_t;

/// Which lights shine on places, and which do not. Both are 0 where there is none.
struct KnownLights {
    LightBits lit = 0, dark = 0;

    LightBits differ() const { return lit & dark; }
    void operator|=(const KnownLights& other) {
        lit |= other.lit;
        dark |= other.dark;
    }
};

/// How far known_around looks: the pixels of any square of as many on each side take all parts of the lights.
inline constexpr int parts_side = 8, all_parts = parts_side * parts_side;

class Shadows {
   public:
    /// `casters`: of casting_lights, at most most_casters. The tracer must outlive it.
    Shadows(const Tracer& tracer, std::vector<Light> casters, const style::Color& style);

    /// A visible place; `point` in view space.
    ShadedPlace place(Index placement, Index triangle, const dvec3& point) const;
    /// What reaches the place at the center of a pixel, of each light a part that depends on the pixel.
    KnownLights sampled(const ShadedPlace& place, int x, int y) const;
    /// What reaches a place: of lights that differ around it by rays to so many parts of each (a power of 4), of others
    /// as is known.
    Reach reach(const ShadedPlace& place, const KnownLights& around, int parts) const;

   private:
    float share(std::size_t light, const ShadedPlace& place, int parts) const;

    dmat4 view_to_world_;
    dmat3 world_to_view_;
    float strength_;
    bool blacks_;
    scene::Shades shades_;
    std::vector<std::unique_ptr<const scene::ShadedSurface>> surfaces_;  // per placement; null: outside of the frame
};

/// What is known around each pixel, of what is known at all (width * height).
Array<KnownLights> known_around(const Array<KnownLights>& known, int width);

}  // namespace fovea::color
