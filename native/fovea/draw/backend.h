// SPDX-License-Identifier: GPL-3.0-or-later
// Backends: sampled visibility, elision and drawing of strokes.
#pragma once

#include <string>

#include <fovea/elision/bands.h>
#include <fovea/elision/own_band.h>

namespace fovea::draw {

class Frame;

/// Input of the elision test: bands to rasterize and samples to test, for both backends.
struct Elision : OwnBands, Bands {};

/// Three operations on a Frame whose earlier steps are done. `CpuBackend` is the reference and draws the same picture
/// on every machine; others may need a graphics context, and are called on the thread that draws the frame.
class Backend {
   public:
    virtual ~Backend() = default;
    virtual std::string name() const = 0;

    /// Visibility of each atlas sample, in [0, 1], by the frame's sampled method: Visibility::atlas or item_buffer.
    virtual Array<float> visibility(const Frame& frame) = 0;

    /// Result of the elision test at each sample of `elision`: crowding() of elision/elide.h.
    virtual Array<vec2> elide(const Frame& frame, const Elision& elision) = 0;

    /// The frame's strokes alone: scene-linear, premultiplied, bottom row first; with Visibility::spine their hidden
    /// parts are removed here.
    virtual Array<vec4> draw(const Frame& frame) = 0;
};

/// Software implementation, in tiles that bound the use of memory.
class CpuBackend : public Backend {
   public:
    explicit CpuBackend(int side = 6144) : most_side(side) {}

    std::string name() const override { return "cpu"; }
    Array<float> visibility(const Frame& frame) override;
    Array<vec2> elide(const Frame& frame, const Elision& elision) override;
    Array<vec4> draw(const Frame& frame) override;

    int most_side;  ///< maximum side of a depth buffer tile [texels]; 0.9 GB at 6144
};

}  // namespace fovea::draw
