// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/line/shadow_of_segment.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/steps.h>

namespace fovea::line {
namespace {

/// Shares of the scene's radius: the shortest step, and the gap up to which a shadow goes on over one surface.
constexpr double finest = 0x1p-20, nearest = 0x1p-14;
/// Shortest step of an endless segment, as a share of it, that numbers tell from none.
constexpr double least_share = 0x1p-50;
/// How often it is looked where what was met ends, before steps are halved: there may be many small triangles.
constexpr int most_end_looks = 8;

class Shadow {
   public:
    Shadow(const LightEye& eye, DarkParts& dark, const CastingSegment& segment, std::size_t& rays,
           Array<ShadowPiece>& out)
        : eye_(eye),
          dark_(dark),
          segment_(segment),
          rays_(rays),
          out_(out),
          length_(glm::distance(segment.from, segment.to)),
          shortest_(std::max(finest * eye.radius / length_, least_share)) {}

    void trace() {
        const double wanted = length_ / eye_.step;
        if (!std::isfinite(wanted)) return;
        dark_.next_segment(segment_.from, segment_.to, segment_.ignore);
        const int steps = steps_of(wanted, most_steps);
        At before = at(0.0);
        for (int i = 1; i <= steps; ++i) {
            const At next = at(double(i) / steps);
            trace(before, next, most_end_looks);
            before = next;
        }
    }

   private:
    /// Where the ray through the segment at parameter t falls; placement `none`: nowhere.
    struct At {
        double t;
        Index placement = none, triangle = none;
        dvec3 point{0.0};
        Interval dark = {};  // a part around t that is known to be dark

        bool falls() const { return placement != none; }
    };

    At at(double t) {
        if (const Interval dark = dark_.known(t); !dark.is_empty()) return {.t = t, .dark = dark};
        if (rays_ == 0) return {t};
        --rays_;
        const dvec3 passed = t == 1.0 ? segment_.to : glm::mix(segment_.from, segment_.to, t);
        const LightEye::Passing way = eye_.pass(passed, segment_.ignore);
        const auto& hit = way.hit;
        if (!hit) return {t};
        if (!way.lit) return {.t = t, .dark = dark_.hidden_by(*hit, t)};
        const dvec3 point = eye_.on_ray(passed, hit->t);
        if (!std::isfinite(point.x + point.y + point.z)) return {t};
        if (glm::distance(point, passed) < segment_.reach && eye_.is_one_body(*hit, segment_.ignore)) return {t};
        return {t, hit->placement, hit->triangle, point};
    }

    const Surface& surface(Index placement) const { return *eye_.tracer.scene().placements[placement].surface; }
    Index facet(Index placement, Index triangle) const { return surface(placement).triangle_facet[triangle]; }

    /// Appends the shadow between two places if it is on one facet, or on two whose triangles share a side.
    bool join(const At& a, const At& b) {
        if (!a.falls() || a.placement != b.placement) return false;
        if (facet(a.placement, a.triangle) == facet(b.placement, b.triangle)) {
            append(a, a.point, b.point, a.t, b.t);
            return true;
        }
        dvec3 crossing;
        if (!cross(a, b, crossing)) return false;
        append(a, a.point, crossing, a.t, -1.0);
        append(b, crossing, b.point, -1.0, b.t);
        return true;
    }

    /// `looks`: how often to look where something ends.
    void trace(At a, At b, int looks) {
        if ((!a.falls() && !b.falls()) || join(a, b)) return;
        if (!a.falls()) a.t = std::clamp(a.dark.end, a.t, b.t);
        if (!b.falls()) b.t = std::clamp(b.dark.begin, a.t, b.t);
        if (b.t - a.t <= shortest_ || rays_ == 0) {
            if (a.falls() && a.placement == b.placement && glm::distance(a.point, b.point) <= nearest * eye_.radius)
                append(a, a.point, b.point, a.t, b.t);
            else
                open_ = false;
            return;
        }
        if (looks > 0 && look_at_end(a, b, looks - 1)) return;
        const At middle = at(0.5 * (a.t + b.t));
        trace(a, middle, looks - 1);
        trace(middle, b, looks - 1);
    }

    /// As trace(a, b), beginning right beside where what was met at one of them ends; false if that is not between.
    bool look_at_end(const At& a, const At& b, int looks) {
        const double aside = 0.25 * shortest_;
        const auto inside = [&](double t) { return a.t < t - aside && t + aside < b.t; };
        // What is dark ends right there.
        if (const bool first = !a.falls() && !a.dark.is_empty(); first || (!b.falls() && !b.dark.is_empty())) {
            const At beside = at(first ? a.t + aside : b.t - aside);
            trace(a, beside, first ? 0 : looks);
            trace(beside, b, first ? looks : 0);
            return true;
        }
        // The shadow leaves the triangles that it falls on.
        const double end = a.falls() ? covered_by(a).end : infinity, begin = b.falls() ? covered_by(b).begin : infinity;
        if (inside(end)) {
            const At beyond = at(end + aside);
            if (!join(a, beyond)) {
                const At within = at(end - aside);
                trace(a, within, 0);
                trace(within, beyond, 0);
            }
            trace(beyond, b, looks);
            return true;
        }
        if (!inside(begin)) return false;
        const At beyond = at(begin - aside);
        trace(a, beyond, looks);
        if (!join(beyond, b)) {
            const At within = at(begin + aside);
            trace(beyond, within, 0);
            trace(within, b, 0);
        }
        return true;
    }

    /// The part of the segment whose rays pass the triangles that its shadow falls on at a place.
    Interval covered_by(const At& place) const {
        const Occluding by(eye_.tracer, {.placement = place.placement, .triangle = place.triangle, .t = 1.0});
        const Interval part = by.covers(segment_.from, segment_.to);
        return part.is_empty() ? Interval{place.t, place.t} : part;
    }

    /// Where the shadow between two points crosses the side that their triangles share.
    bool cross(const At& a, const At& b, dvec3& crossing) const {
        const Surface& own = surface(a.placement);
        const Triangle &s = own.triangles[a.triangle], &t = own.triangles[b.triangle];
        Index shared[3];
        int count = 0;
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k)
                if (s[i] == t[k]) shared[count++] = s[i];
        if (count != 2) return false;
        const dmat4 to_light = eye_.from_object(a.placement);
        dvec3 end[2];
        for (int i = 0; i < 2; ++i) end[i] = dvec3(to_light * dvec4(dvec3(own.positions[shared[i]]), 1.0));
        // The plane of all rays through the segment: through a.point, and the light or along its rays.
        const bool of_sun = eye_.tracer.view().orthographic;
        const dvec3 ray = of_sun ? dvec3(0, 0, 1) : segment_.from;
        const dvec3 normal = glm::cross(ray, segment_.to - segment_.from), base = of_sun ? segment_.from : dvec3(0.0);
        const double x = glm::dot(normal, end[0] - base), y = glm::dot(normal, end[1] - base);
        if ((x < 0.0) == (y < 0.0)) return false;
        crossing = glm::mix(end[0], end[1], x / (x - y));
        // It must lie between both, as the light sees it.
        const auto seen = [&](const dvec3& p) { return of_sun ? dvec3(p.x, p.y, 0.0) : glm::normalize(p); };
        const dvec3 from = seen(a.point), way = seen(b.point) - from;
        const double share = glm::dot(seen(crossing) - from, way);
        return share >= 0.0 && share <= glm::dot(way, way);
    }

    /// A piece on the facet of `on`, or the last one, longer. `t`: at its ends; -1: inside the segment.
    void append(const At& on, const dvec3& from, const dvec3& to, double from_t, double to_t) {
        const bool longer = open_ && out_.back().placement == on.placement &&
                            facet(on.placement, out_.back().triangle) == facet(on.placement, on.triangle);
        if (longer) {
            out_.back().point[1] = to;
        } else {
            if (open_) out_.back().goes_on = true;
            out_.push_back({on.placement, on.triangle, {from, to}});
            out_.back().starts = from_t == 0.0;
        }
        out_.back().ends = to_t == 1.0;
        open_ = true;
    }

    const LightEye& eye_;
    DarkParts& dark_;
    const CastingSegment& segment_;
    std::size_t& rays_;
    Array<ShadowPiece>& out_;
    const double length_, shortest_;  // of the segment; the shortest step, in shares of it
    bool open_ = false;               // the last piece ends where the next part of the segment begins
};

}  // namespace

void append_shadow(const LightEye& eye, DarkParts& dark, const CastingSegment& segment, std::size_t& rays,
                   Array<ShadowPiece>& out) {
    Shadow(eye, dark, segment, rays, out).trace();
}

}  // namespace fovea::line
