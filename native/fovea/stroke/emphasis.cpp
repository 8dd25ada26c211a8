// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/stroke/emphasis.h>

#include <algorithm>

#include <fovea/base/check.h>
#include <fovea/visibility/piece_samples.h>

namespace fovea::stroke {
namespace {

constexpr float tolerance = 0.02f;

/// Emphasis at an arc length of the line.
struct Place {
    double arc;
    vec4 mix;
    float shown, seen;
};

/// The cone of slopes from a place that pass all following places within the tolerance.
class Fan {
   public:
    explicit Fan(const Place& from) : from_(from) {}

    bool admits(const Place& to) const {
        const float length = float(to.arc - from_.arc);
        for (int k = 0; k < count; ++k) {
            const float slope = (value(to, k) - value(from_, k)) / length;
            if (slope < low_[k] || slope > high_[k]) return false;
        }
        return true;
    }
    void narrow(const Place& to) {
        const float length = float(to.arc - from_.arc);
        for (int k = 0; k < count; ++k) {
            const float rise = value(to, k) - value(from_, k);
            low_[k] = std::max(low_[k], (rise - tolerance) / length);
            high_[k] = std::min(high_[k], (rise + tolerance) / length);
        }
    }

   private:
    static constexpr int count = 6;
    static float value(const Place& place, int k) { return k < 4 ? place.mix[k] : k == 4 ? place.shown : place.seen; }

    Place from_;
    float low_[count] = {-1e30f, -1e30f, -1e30f, -1e30f, -1e30f, -1e30f};
    float high_[count] = {1e30f, 1e30f, 1e30f, 1e30f, 1e30f, 1e30f};
};

/// The samples in a run; for a run between two samples, the one nearest to its middle.
struct Own {
    std::ptrdiff_t first, last;
};

Own own_samples(const PieceSamples& samples, double start_px, double end_px) {
    const Own own{samples.after(start_px), samples.after(end_px) - 1};
    if (own.first <= own.last) return own;
    const double middle = 0.5 * (start_px + end_px);
    const std::ptrdiff_t next = std::min(own.first, samples.count() - 1),
                         before = std::max<std::ptrdiff_t>(next - 1, 0);
    const std::ptrdiff_t nearest = samples.arc(next) - middle < middle - samples.arc(before) ? next : before;
    return {nearest, nearest};
}

/// The knots at both sides of an arc length, and its share of the way from a to b.
struct Between {
    std::size_t a, b;
    float t;
};

Between between(const EmphasisAlong& emphasis, double at) {
    const auto& arc = emphasis.arc;
    const std::size_t k = std::upper_bound(arc.begin(), arc.end(), at) - arc.begin();
    const std::size_t a = k > 0 ? k - 1 : 0, b = std::min(k, arc.size() - 1);
    return {a, b, a < b ? float((at - arc[a]) / (arc[b] - arc[a])) : 0.0f};
}

}  // namespace

void check_emphasis(const ClippedPaths& clipped, const Emphasis& emphasis) {
    for (const In<float>& values : {emphasis.focus, emphasis.distance, emphasis.shown, emphasis.seen})
        check(values.empty() || values.size() == clipped.samples, "emphasis: one value per atlas sample expected");
}

void find_emphasis(const ClippedPaths& clipped, const Emphasis& e, Index piece, double start_px, double end_px,
                   EmphasisAlong& out) {
    out.arc.clear();
    out.mix.clear();
    out.shown.clear();
    out.seen.clear();
    if (e.focus.empty() && e.distance.empty() && e.shown.empty() && e.seen.empty()) return;
    const PieceSamples samples(clipped, piece);
    if (samples.count() == 0) return;
    // From the sample before the run to the one after it. What is shown and seen of these two is of other runs, or
    // of none.
    const std::ptrdiff_t first = std::max<std::ptrdiff_t>(samples.after(start_px) - 1, 0);
    const std::ptrdiff_t last = std::min(samples.after(end_px), samples.count() - 1);
    const Own own = own_samples(samples, start_px, end_px);
    const auto at = [&](std::ptrdiff_t s) {
        const std::size_t i = samples.in_atlas(s);
        const float f = e.focus.empty() ? 0.0f : e.focus[i], d = e.distance.empty() ? 0.0f : e.distance[i];
        const std::size_t own_at = samples.in_atlas(std::clamp(s, own.first, own.last));
        const auto left = [&](In<float> values) {
            const float share = values.empty() ? 1.0f : std::clamp(values[own_at], 0.0f, 1.0f);
            return share == share ? share : 1.0f;
        };
        const bool near = e.focus.empty(), flat = e.distance.empty();
        const auto by_focus = [&](const Transfer& transfer) { return near ? 0.0f : transfer(f); };
        const auto by_distance = [&](const Transfer& transfer) { return flat ? 0.0f : transfer(d); };
        const vec4 mix(by_focus(e.color), by_focus(e.texture), both(by_focus(e.width), by_distance(e.distance_width)),
                       both(by_focus(e.opacity), by_distance(e.distance_opacity)));
        return Place{samples.arc(s), mix, left(e.shown), left(e.seen)};
    };
    const auto keep = [&](const Place& place) {
        out.arc.push_back(place.arc);
        out.mix.push_back(place.mix);
        out.shown.push_back(place.shown);
        out.seen.push_back(place.seen);
    };
    Place before = at(first);
    keep(before);
    Fan fan(before);
    for (std::ptrdiff_t s = first + 1; s <= last; ++s) {
        const Place place = at(s);
        if (!fan.admits(place)) {
            keep(before);
            fan = Fan(before);
        }
        fan.narrow(place);
        before = place;
    }
    if (last > first) keep(before);
}

void emphasize(CenterLine& line, const EmphasisAlong& emphasis) {
    if (emphasis.arc.empty() || line.size() < 2) return;
    insert_points(line, emphasis.arc);
    for (CenterPoint& p : line) {
        const auto [a, b, t] = between(emphasis, p.arc);
        p.mix = glm::mix(emphasis.mix[a], emphasis.mix[b], t);
        p.shown = glm::mix(emphasis.shown[a], emphasis.shown[b], t);
        p.seen = glm::mix(emphasis.seen[a], emphasis.seen[b], t);
    }
}

}  // namespace fovea::stroke
