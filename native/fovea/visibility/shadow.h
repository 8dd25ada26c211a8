// SPDX-License-Identifier: GPL-3.0-or-later
// Shadow volumes: what a polygon, or the triangle that a ray met, hides from the eye.
#pragma once

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

#include <fovea/visibility/segment.h>

namespace fovea::visibility {

/// Interval of a segment's parameter; empty when begin > end.
struct Interval {
    double begin = 1.0, end = 0.0;
    bool holds(double t) const { return begin <= t && t <= end; }
};

/// Bounded by the planes through the eye (view-space origin; along z for an orthographic camera) and the sides of a
/// flat convex polygon of three or four corners, and by the polygon's own plane. Convex, so it cuts an interval out of
/// a segment.
class Shadow {
   public:
    Shadow() = default;
    /// Corners in view space. `margin`: share of the distance by which a point must lie behind to be hidden.
    Shadow(In<dvec3> corners, bool orthographic, double near_clip, double margin);

    /// False when the polygon is seen edge-on or reaches in front of the near plane: it then hides nothing for sure.
    bool usable() const { return usable_; }

    /// Part of the segment from a to b that is hidden, as fractions of its length in space.
    Interval hides(const dvec3& a, const dvec3& b) const;

   private:
    dvec4 planes_[5];  // inside where positive; its own first
    int count_ = 0;
    bool usable_ = false;
};

/// The shadow of a hit's outline (Tracer::outline), and of which surface it is.
class Occluding {
   public:
    Occluding() = default;
    Occluding(const Tracer& tracer, const Hit& hit);

    /// The part of a segment that it surely hides, in screen fractions; empty where the segment ignores it.
    Interval hides(const Tracer& tracer, const Segment& segment) const;

   private:
    Shadow shadow_;
    Index placement_ = none, triangle_ = none, other_ = none;
};

/// So many of what hid segments before, and which part of the one that is looked at now each of them hides.
template <typename Hider, std::size_t count>
class Remembered {
   public:
    struct Entry {
        Hider by;
        std::optional<Interval> interval;  ///< none: not asked for yet
    };

    Remembered() { std::iota(order_.begin(), order_.end(), std::size_t(0)); }

    /// Another segment is looked at.
    void next_segment() {
        for (Entry& entry : entries_) entry.interval.reset();
    }

    /// The interval around s that one of them hides; null where none does. interval_of(hider): on this segment.
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

    /// Keeps another one instead of that which did not hide for longest.
    void remember(Entry entry) {
        std::rotate(order_.begin(), order_.end() - 1, order_.end());
        entries_[order_[0]] = std::move(entry);
    }

   private:
    std::array<Entry, count> entries_;
    std::array<std::size_t, count> order_;  // of entries_, those that hid last before the others
};

}  // namespace fovea::visibility
