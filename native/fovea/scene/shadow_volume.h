// SPDX-License-Identifier: GPL-3.0-or-later
// Shadow volumes: the space that a polygon, or the triangle that a ray hit, hides from the eye.
#pragma once

#include <array>
#include <numeric>
#include <optional>

#include <fovea/base/interval.h>
#include <fovea/scene/tracer.h>

namespace fovea::scene {

/// The shadow volume of a flat convex polygon of three to five corners, with the eye as the light: bounded by the
/// planes through the eye (view-space origin; along z for an orthographic view) and the polygon's sides, and by the
/// polygon's own plane. Convex, so its intersection with a segment is one interval.
class ShadowVolume {
   public:
    ShadowVolume() = default;
    /// Corners in view space. `margin`: how far a point must lie behind the polygon to be hidden, as a fraction of the
    /// distance.
    ShadowVolume(In<dvec3> corners, const View& view, double margin);

    /// False when the polygon is seen edge-on or reaches in front of the near plane: then nothing is certain to be
    /// hidden.
    bool usable() const { return usable_; }

    /// Part of the segment from a to b that is hidden, as fractions of its length in space.
    Interval hides(const dvec3& a, const dvec3& b) const { return inside(a, b, 0); }
    /// Part of it that is before or behind the polygon.
    Interval covers(const dvec3& a, const dvec3& b) const { return inside(a, b, 1); }

   private:
    Interval inside(const dvec3& a, const dvec3& b, int first_plane) const;

    dvec4 planes_[6];  // positive inside; the polygon's own plane first
    int count_ = 0;
    bool usable_ = false;
};

/// Shadow volume of a hit's outline (Tracer::outline), with the surface that was hit.
class Occluding {
   public:
    Occluding() = default;
    /// `margin`: of the shadow volume; at least that of the rays that the answers shall agree with.
    Occluding(const Tracer& tracer, const Hit& hit, double margin = ray_margin);

    /// The part of the segment from a to b (view space) that is certain to be hidden, as fractions of its length in
    /// space; empty if what rays along it ignore is of this surface.
    Interval hides(const Tracer& tracer, const dvec3& a, const dvec3& b, const Ignore& ignore) const;
    /// The part whose rays pass the outline.
    Interval covers(const dvec3& a, const dvec3& b) const { return volume_.covers(a, b); }

   private:
    ShadowVolume volume_;
    Index placement_ = none, triangle_ = none, other_ = none;
};

/// Fixed-size cache of occluders of earlier segments, with the interval of the current segment that each of them hides.
template <typename Hider, std::size_t count>
class Remembered {
   public:
    struct Entry {
        Hider by;
        std::optional<Interval> interval;  ///< unset: not computed yet
    };

    Remembered() { std::iota(order_.begin(), order_.end(), std::size_t(0)); }

    /// Starts a new segment: clears the intervals.
    void next_segment() {
        for (Entry& entry : entries_) entry.interval.reset();
    }

    /// The interval around s that a cached occluder hides; null if none does. interval_of(hider) computes it for this
    /// segment. A hit moves up one place in the search order.
    template <typename IntervalOf>
    const Interval* around(double s, const IntervalOf& interval_of) {
        for (std::size_t i = 0; i < count; ++i) {
            Entry& entry = entries_[order_[i]];
            if (!entry.interval) entry.interval = interval_of(entry.by);
            if (!entry.interval->holds(s)) continue;
            if (i > 0) std::swap(order_[i], order_[i - 1]);
            return &*entry.interval;
        }
        return nullptr;
    }

    /// Inserts an occluder first in the search order, replacing the last.
    void remember(Entry entry) {
        std::rotate(order_.begin(), order_.end() - 1, order_.end());
        entries_[order_[0]] = std::move(entry);
    }

   private:
    std::array<Entry, count> entries_;
    std::array<std::size_t, count> order_;  // search order: indices into entries_, those with recent hits first
};

}  // namespace fovea::scene
