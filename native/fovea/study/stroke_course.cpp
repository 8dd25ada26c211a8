// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/stroke_course.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <vector>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>
#include <fovea/study/darkness.h>

namespace fovea::study {
namespace {

constexpr float step = 0.25f;                        // [px] across strokes
constexpr float is_ink = 0.4f;                       // of the darkness of strokes
constexpr float is_paper = 0.1f;                     // of it
constexpr double to_each_side = 3.0;                 // [px] to each side along a line, of its direction
constexpr double straight = 0.9;                     // cosine of the angle between both: at corners nothing is told
constexpr float apart = 2.5f;                        // [px] from a line, from which on another one is another one
constexpr float met_beside = 2.0f;                   // [px] beyond the reach, where strokes of other lines may be met
constexpr double inside = 20.0;                      // [px] before the end of a line, where a stroke is followed from
constexpr float ahead[] = {3.0f, 4.0f, 6.0f, 8.0f};  // [px] beyond an end where another line may go on
constexpr float lateral = 0.75f;                     // [px] that the middle of a stroke is off to a side there
constexpr double shortest = 15.0;                    // [px] of lines whose ends are told
constexpr float turned = 0.05f;                      // [rad] that its direction there is off
constexpr double of_end = 8.0;                       // [px] before an end, of its direction
constexpr float ending_gap = 1.5f;                   // [px] without ink that end a stroke
constexpr double farthest = 0.1;                     // of the diagonal, beyond an end

struct Place {
    vec2 at, along;  // along: (0, 0) at a corner

    vec2 across() const { return {-along.y, along.x}; }
};

/// A line by its arc length.
class Arc {
   public:
    Arc(In<vec2> px, std::size_t begin, std::size_t end) : px_(px.subspan(begin, end - begin)), lengths_{0.0} {
        for (std::size_t i = 1; i < px_.size(); ++i)
            lengths_.push_back(lengths_.back() + double(glm::distance(px_[i - 1], px_[i])));
    }
    double length() const { return lengths_.back(); }
    vec2 at(double s) const {
        const auto above = std::upper_bound(lengths_.begin(), lengths_.end() - 1, s);
        const auto i = std::size_t(std::max<std::ptrdiff_t>(above - lengths_.begin(), 1));
        const double part = lengths_[i] - lengths_[i - 1];
        return glm::mix(px_[i - 1], px_[i], part > 0.0 ? float((s - lengths_[i - 1]) / part) : 0.0f);
    }
    Place place(double s) const {
        const vec2 here = at(s), before = here - at(std::max(s - to_each_side, 0.0)),
                   after = at(std::min(s + to_each_side, length())) - here;
        const float a = glm::length(before), b = glm::length(after);
        const bool bends = a > 0.5f && b > 0.5f && glm::dot(before, after) < float(straight) * a * b;
        const vec2 along = before + after;
        return {here, bends || glm::length(along) <= 0.0f ? vec2(0.0f) : glm::normalize(along)};
    }

   private:
    In<vec2> px_;
    std::vector<double> lengths_;
};

struct Across {
    float away = NAN, ink = 0.0f;  // the ink of a stroke in pixels of full darkness
};

class Tracer {
   public:
    Tracer(const Darkness& dark, const Bitmap& every, const CourseOptions& options)
        : dark_(dark), every_(every), options_(options), reach_(float(options.reach)) {}

    float darkest(const Place& place) const {
        float most = 0.0f;
        for (float t = -reach_; t <= reach_; t += step) most = std::max(most, dark_.at(place.at + t * place.across()));
        return most;
    }
    void set_ink(float ink) { ink_ = ink; }

    /// The stroke across a line: the nearest ink, up to paper on both sides.
    Across across(const Place& place) const {
        if (place.along == vec2(0.0f) || is_beside_another(place)) return {};
        for (float t = 0.0f; t <= reach_; t += step)
            for (const float from : {t, -t})
                if (dark_.at(place.at + from * place.across()) >= is_ink * ink_) return middle(place, from);
        return {};
    }

    /// How far a stroke goes on from the end of a line, outwards along `out`, whose middle is `away` to its left near
    /// to the end.
    float beyond(const vec2& end, const vec2& out, float away, float width, double length) const {
        const vec2 left(-out.y, out.x);
        if (goes_on(end, out)) return NAN;
        const auto has_ink = [&](float u) {
            const float more = lateral + turned * std::abs(u);
            for (float t = std::min(0.0f, away) - more; t <= std::max(0.0f, away) + more; t += 2.0f * step)
                if (dark_.at(end + u * out + t * left) >= is_ink * ink_) return true;
            return false;
        };
        const float start = -float(std::min(inside, 0.5 * length));
        float last = NAN;
        for (float u = start; u <= float(farthest * every_.diagonal()); u += step) {
            if (has_ink(u))
                last = u;
            else if (std::isnan(last) || u - last > ending_gap)
                break;
        }
        return last - float(options_.cap) * width;
    }

   private:
    bool is_set(const vec2& p) const {
        const int x = int(std::floor(p.x)), y = int(std::floor(p.y));
        const bool is_inside = x >= 0 && y >= 0 && x < every_.width && y < every_.height;
        return is_inside && every_.set[std::size_t(y) * std::size_t(every_.width) + std::size_t(x)];
    }
    bool is_beside_another(const Place& place) const {
        for (float t = apart; t <= reach_ + met_beside; t += 0.5f)
            if (is_set(place.at + t * place.across()) || is_set(place.at - t * place.across())) return true;
        return false;
    }
    bool goes_on(const vec2& end, const vec2& out) const {
        const vec2 left(-out.y, out.x);
        for (const float u : ahead)
            for (float t = -apart; t <= apart; t += 0.5f)
                if (is_set(end + u * out + t * left)) return true;
        return false;
    }
    Across middle(const Place& place, float from) const {
        const float most = 2.0f * reach_;
        float sum = 0.0f, moment = 0.0f;
        const auto add = [&](float t) {
            const float value = dark_.at(place.at + t * place.across());
            if (value < is_paper * ink_) return false;
            sum += value, moment += t * value;
            return true;
        };
        float high = from, low = from - step;
        while (high <= most && add(high)) high += step;
        while (low >= -most && add(low)) low -= step;
        if (high > most || low < -most) return {};
        return {moment / sum, sum * step / ink_};
    }

    const Darkness& dark_;
    const Bitmap& every_;
    CourseOptions options_;
    float reach_, ink_ = 1.0f;
};

/// Of values that are then in another order.
float median(std::vector<float>& values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Lines, where their samples are in `found`, and room for what is found of each.
std::vector<Arc> arcs_of(In<vec2> px, In<std::int64_t> offsets, StrokeCourses& found) {
    std::vector<Arc> arcs;
    found.first.push_back(0);
    for (std::size_t i = 0; i + 1 < offsets.size(); ++i) {
        check(offsets[i] < offsets[i + 1] && std::size_t(offsets[i + 1]) <= px.size(), "offsets: rising, within px");
        arcs.emplace_back(px, std::size_t(offsets[i]), std::size_t(offsets[i + 1]));
        found.first.push_back(found.first.back() + std::int64_t(arcs.back().length()));
    }
    found.away.resize(std::size_t(found.first.back()));
    std::fill(found.away.begin(), found.away.end(), NAN);
    found.beyond.resize(arcs.size());
    std::fill(found.beyond.begin(), found.beyond.end(), vec2(NAN));
    return arcs;
}

/// How dark strokes near the lines are: a median; 0 where there are none.
float ink_of_strokes(const Tracer& tracer, const std::vector<Arc>& arcs, const StrokeCourses& found) {
    Array<float> darkest(found.away.size(), 0.0f);
    parallel_for(arcs.size(), 8, [&](std::size_t i) {
        for (std::int64_t k = found.first[i]; k < found.first[i + 1]; ++k)
            darkest[std::size_t(k)] = tracer.darkest(arcs[i].place(double(k - found.first[i]) + 0.5));
    });
    std::vector<float> drawn;
    std::copy_if(darkest.begin(), darkest.end(), std::back_inserter(drawn), [](float v) { return v > is_paper; });
    return drawn.empty() ? 0.0f : median(drawn);
}

/// Fills in where strokes are beside a line; their width, or 0 where there are none.
float trace(const Tracer& tracer, const Arc& arc, std::span<float> away) {
    std::vector<float> widths;
    for (std::size_t k = 0; k < away.size(); ++k) {
        const Across across = tracer.across(arc.place(double(k) + 0.5));
        away[k] = across.away;
        if (!std::isnan(across.away)) widths.push_back(across.ink);
    }
    return widths.empty() ? 0.0f : median(widths);
}

/// How far to the left of a line a stroke is near to its end; 0 where that cannot be told.
float away_at_end(std::span<const float> away, bool at_end) {
    for (std::size_t k = 0; k < std::min(away.size(), std::size_t(inside)); ++k) {
        const float value = away[at_end ? away.size() - 1 - k : k];
        if (!std::isnan(value)) return value;
    }
    return 0.0f;
}

float beyond_end(const Tracer& tracer, const Arc& arc, std::span<const float> away, bool at_end, float width) {
    const double length = arc.length(), near = std::min(of_end, length);
    const vec2 end = arc.at(at_end ? length : 0.0), back = arc.at(at_end ? length - near : near);
    if (glm::distance(end, back) <= 0.0f) return NAN;
    const float beside = away_at_end(away, at_end);  // seen along the line; from its start one looks back
    return tracer.beyond(end, glm::normalize(end - back), at_end ? beside : -beside, width, length);
}

}  // namespace

StrokeCourses courses_of(const color::GrayImage& picture, In<vec2> px, In<std::int64_t> offsets,
                         In<std::uint8_t> is_free, const Bitmap& every, const CourseOptions& options) {
    every.check_size_of({picture.width, picture.height});
    check(!offsets.empty() && is_free.size() == 2 * (offsets.size() - 1), "is_free: two values per line expected");
    check(options.reach > 0.0 && std::isfinite(options.reach + options.cap), "a stroke is within a reach above 0");
    StrokeCourses found;
    const std::vector<Arc> arcs = arcs_of(px, offsets, found);
    const Darkness dark = darkness_of(picture, false);
    Tracer tracer(dark, every, options);
    const float ink = ink_of_strokes(tracer, arcs, found);
    if (ink <= 0.0f) return found;
    tracer.set_ink(ink);
    parallel_for(arcs.size(), 8, [&](std::size_t i) {
        const std::span<float> away(found.away.data() + found.first[i], found.away.data() + found.first[i + 1]);
        const float width = trace(tracer, arcs[i], away);
        for (const bool at_end : {false, true})
            if (width > 0.0f && arcs[i].length() >= shortest && is_free[2 * i + std::size_t(at_end)])
                found.beyond[i][at_end] = beyond_end(tracer, arcs[i], away, at_end, width);
    });
    return found;
}

}  // namespace fovea::study
