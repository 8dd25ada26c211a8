// SPDX-License-Identifier: GPL-3.0-or-later
// Hatching: curves on surfaces where families of parallel planes cut them, over what is darker than a tone.
// In   planes of the camera, the world or each object; tone (line/tone.h), interpolated normals
// Out  on each triangle the planes at multiples of a power of two of units, namely that which is nearest to the spacing
//      on paper there: so lines stay where they are while a camera approaches, and others fade in between. Each is cut
//      to where its power is called for, and to where the tone is below that of its family
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

#include <fovea/base/elementary.h>
#include <fovea/base/hash.h>
#include <fovea/field/corner_normals.h>
#include <fovea/field/shape.h>
#include <fovea/line/tone.h>
#include <fovea/mesh/triangle_sides.h>

namespace fovea::line {
namespace {

enum Planes { of_camera, of_world, of_object };

struct Hatching {
    int planes, families;
    double spacing, light, middle, dark, angle, turn, tilt, swell;
    int lights;
    bool shadows;

    double tone(int family) const { return family == 0 ? light : family == 1 ? middle : dark; }
};

const Parameters<Hatching> parameters{
    {&Hatching::spacing, "spacing", "Spacing", 7.0, 1.0, 200.0, Unit::pixels,
     "Distance between the lines on paper, within a factor of 1.41"},
    {&Hatching::families, "families", "Families", 2, 1, 3,
     "How many directions lines have: cross-hatching from two on"},
    {&Hatching::light, "light", "Light Tone", 0.6, 0.0, 1.0, Unit::none,
     "Brightness below which there are lines of the first direction"},
    {&Hatching::middle, "middle", "Middle Tone", 0.3, 0.0, 1.0, Unit::none,
     "Brightness below which lines of the second direction cross them"},
    {&Hatching::dark, "dark", "Dark Tone", 0.1, 0.0, 1.0, Unit::none,
     "Brightness below which there are lines of the third direction"},
    {&Hatching::angle, "angle", "Angle", 45.0, -90.0, 90.0, Unit::degrees,
     "Direction of the lines on a surface that faces the viewer, from the horizontal"},
    {&Hatching::turn, "turn", "Turn", 60.0, 10.0, 90.0, Unit::degrees,
     "Angle from the first direction to the second; the third halves what is left"},
    {&Hatching::tilt, "tilt", "Tilt", 30.0, 0.0, 80.0, Unit::degrees,
     "How far the planes lean towards the viewer: at 0 lines are straight, beyond it they follow the form"},
    {&Hatching::planes, "planes", "Planes", 0, 0, 2,
     "What the planes belong to: 0 the camera, 1 the world, 2 each object"},
    {&Hatching::swell, "swell", "Swell", 0.0, 0.0, 1.0, Unit::none,
     "How much fainter lines are where they end in the light than in the dark"},
    {&Hatching::lights, "lights", "Lights", 4, 0, 64,
     "How many lights count, those that are strongest amid the scene first; without any there is one at the eye"},
    {&Hatching::shadows, "shadows", "Cast Shadows", true, "What lies in the shadow of something else is dark"}};

/// Of the spacing between lines where the surface faces the viewer, that where it is almost parallel to the planes is
/// not more than this many times as dense in space: there lines would turn with every ripple.
constexpr double most_turned = 8.0;

/// Steps along lines at which light is looked for [reference px], at most so many, and the precision of ends [px].
constexpr double step_reference_px = 4.0, end_px = 1.0 / 64.0;
constexpr int most_steps = 512;
/// Where the light changes amid a line, its strength does within so much [px].
constexpr double ramp_px = 1.0;

/// Lines that come in between others reach their strength where they are so many times as far apart as where they begin:
/// while a camera approaches, none appears at once.
constexpr double fade_in = 1.25;

/// Lines of a family on one triangle, at most; more are left out in coarser powers of two.
constexpr double most_levels = 4096.0;

/// Margin of the frame beyond which there are no lines, as a share of its half size: that of project/clip.h and more.
constexpr double frame_margin = 0.15;

/// Planes dot(along, p) + offset = any number, p in view space.
struct Family {
    dvec3 along;
    double offset;
    double tone;
    Index number;
    double at(const dvec3& p) const { return glm::dot(along, p) + offset; }
};

struct Middle {
    dvec3 of{0.0};

    explicit Middle(const Surface& surface) {
        double count = 0.0;
        for (Index v = 0; v < surface.vertex_count(); ++v) {
            const dvec3 p(surface.positions[v]);
            if (!std::isfinite(p.x + p.y + p.z)) continue;
            of += p;
            ++count;
        }
        if (count > 0.0) of /= count;
    }
};

/// Normal of the planes of a family in their frame: right, up, towards the viewer.
dvec3 normal_of(const Hatching& values, int family) {
    const double turned[3] = {0.0, values.turn, 0.5 * values.turn + 90.0};
    const double angle = glm::radians(values.angle + turned[family]), tilt = glm::radians(values.tilt);
    return {-sine(angle) * cosine(tilt), cosine(angle) * cosine(tilt), sine(tilt)};
}

/// Planes of the camera go through the middle of the surface, so that they move along with it. Others are a share of a
/// unit away from the origin: planes through it are those of faces.
Family family_of(const SurfaceView& seen, const Hatching& values, int number) {
    constexpr double away = 0.381966;
    const dvec3 n = normal_of(values, number);
    if (values.planes == of_camera) {
        const dvec3 middle = seen.surface.cache().get<Middle>(0, [&] { return Middle(seen.surface); })->of;
        return {n, -glm::dot(n, dvec3(seen.object_to_view * dvec4(middle, 1.0))), values.tone(number), Index(number)};
    }
    const dmat4 to_view = values.planes == of_world ? seen.tracer->view().world_to_view
                                                    : seen.object_to_view * dmat4(seen.surface.stretch());
    const dvec3 along = glm::transpose(glm::inverse(dmat3(to_view))) * dvec3(n.x, -n.z, n.y);
    return {along, away - glm::dot(along, dvec3(to_view[3])), values.tone(number), Index(number)};
}

/// Point of a triangle or of a chord across it.
struct Spot {
    dvec3 at;      ///< view space
    dvec3 normal;  ///< of unit length, to the viewer's side of the facet
};

Spot mix(const Spot& a, const Spot& b, double t) {
    const dvec3 normal = glm::mix(a.normal, b.normal, t);
    const double length = glm::length(normal);
    return {glm::mix(a.at, b.at, t), length > 0.0 ? normal / length : a.normal};
}

/// End of a chord on a side of its triangle.
struct End {
    Spot spot;
    dvec3 in_surface;
    Index side;
};

/// A level of a family: a multiple of 2^power, and of no higher one.
struct Level {
    double value;
    int power;
};

/// What is drawn at a place of a chord, and by which lights.
struct Drawn {
    bool drawn;
    Tone::Lit lit;
    bool operator==(const Drawn&) const = default;
};

/// The eye of a view in the world, homogeneous.
dvec4 viewer(const View& view) {
    return glm::inverse(view.world_to_view) * (view.orthographic ? dvec4(0, 0, 1, 0) : dvec4(0, 0, 0, 1));
}

class Hatcher {
   public:
    Hatcher(const SurfaceView& seen, const Hatching& values, const Tone& tone)
        : seen_(seen),
          values_(values),
          tone_(tone),
          view_(seen.tracer->view()),
          normals_(corner_normals(seen.surface)),
          sides_(triangle_sides(seen.surface)),
          normal_to_view_(glm::transpose(glm::inverse(dmat3(seen.object_to_view)))),
          is_smooth_(field::shape_of(seen.surface) == Shape::smooth),
          shaded_(seen.tracer->scene(), seen.placement, viewer(view_)),
          per_px_{2.0 / (std::abs(view_.view_to_clip[0][0]) * view_.width),
                  2.0 / (std::abs(view_.view_to_clip[1][1]) * view_.height)},
          spacing_(values.spacing * view_.reference_scale),
          step_px_(step_reference_px * view_.reference_scale) {
        for (int f = 0; f < values.families; ++f) families_.push_back(family_of(seen, values, f));
        const Surface& surface = seen.surface;
        place_ = parallel_map<dvec3>(surface.vertex_count(), [&](std::size_t v) {
            return dvec3(seen.object_to_view * dvec4(dvec3(surface.positions[v]), 1.0));
        });
        const dvec3 center(seen.object_to_view * dvec4(dvec3(surface.center), 1.0));
        const double radius = glm::length(seen.object_to_view[0]) * surface.radius * 1.001;
        // A body is seen from outside, whole: the backs of its facets are not seen.
        if (!seen.tracer->scene().section && -center.z - radius > view_.near_clip)
            bodies_ = bodies_of(*seen.tracer->scene().placements[seen.placement].surface);
    }

    /// Whether all of the surface is no larger in the image than the spacing.
    bool is_dot() const {
        const dvec3 center(seen_.object_to_view * dvec4(dvec3(seen_.surface.center), 1.0));
        const double radius = glm::length(seen_.object_to_view[0]) * seen_.surface.radius;
        return -center.z - radius > view_.near_clip && 2.0 * radius < spacing_ * px_at(center) * least_turn;
    }

    void append(Index triangle, Curves& out) const {
        const Triangle& t = seen_.surface.triangles[triangle];
        const std::array<dvec3, 3> p{place_[t.x], place_[t.y], place_[t.z]};
        const dvec3 sum = p[0] + p[1] + p[2];
        if (!std::isfinite(sum.x + sum.y + sum.z)) return;
        int outside[3];
        for (int i = 0; i < 3; ++i) outside[i] = outcode(p[i]);
        if (outside[0] & outside[1] & outside[2]) return;
        const Index facet = seen_.surface.triangle_facet[triangle];
        const dvec3 across = normal_to_view_ * dvec3(seen_.surface.facet_plane[facet]);
        const double facing = glm::dot(across, view_.orthographic ? dvec3(0, 0, 1) : -p[0]);
        if (facing == 0.0 || !std::isfinite(facing) || (facing < 0.0 && hides_back(facet))) return;
        Corners corners;
        for (int i = 0; i < 3; ++i) {
            const dvec3 n = normal_to_view_ * dvec3(normals_->at(t, triangle, i));
            const double length = glm::length(n);
            if (!(length > 0.0) || !std::isfinite(length)) return;
            corners[i] = {p[i], (facing < 0.0 ? -1.0 : 1.0) / length * n};
        }
        const bool whole = !(outside[0] | outside[1] | outside[2]);
        for (const Family& family : families_)
            for (const Level& level : levels(family, corners, whole)) {
                std::array<End, 2> ends;
                if (chord(family, triangle, corners, level.value, ends))
                    append_chord({family, triangle, level, ends}, out);
            }
    }

   private:
    using Corners = std::array<Spot, 3>;
    using Polygon = std::vector<Spot>;
    static constexpr double least_turn = 0.5;

    /// A chord of a level across a triangle.
    struct Across {
        const Family& family;
        Index triangle;
        Level level;
        const std::array<End, 2>& ends;
        Spot at(double t) const { return mix(ends[0].spot, ends[1].spot, t); }
    };

    double distance_to(int plane, const dvec3& p) const {
        if (plane == 0) return -p.z - view_.near_clip;
        const dvec4 clip = view_.view_to_clip * dvec4(p, 1.0);
        const double w = clip.w * (1.0 + frame_margin), along = plane < 3 ? clip.x : clip.y;
        return w + (plane & 1 ? along : -along);
    }
    static constexpr int planes = 5;

    int outcode(const dvec3& p) const {
        int bits = 0;
        for (int plane = 0; plane < planes; ++plane) bits |= (distance_to(plane, p) < 0.0) << plane;
        return bits;
    }

    bool hides_back(Index facet) const {
        const Surface& surface = *seen_.tracer->scene().placements[seen_.placement].surface;
        if (!surface.polygon_one_sided.empty() && surface.polygon_one_sided[surface.facet_polygon[facet]]) return true;
        return bodies_ && bodies_->of_facet[facet] != none && bodies_->outward[bodies_->of_facet[facet]];
    }

    /// Length in space of a pixel at a point, along the axes of the image.
    dvec2 sides_of_px(const dvec3& p) const { return per_px_ * (view_.orthographic ? 1.0 : -p.z); }
    double px_at(const dvec3& p) const {
        const dvec2 sides = sides_of_px(p);
        return std::max(sides.x, sides.y);
    }

    /// Pixels between levels that are 1 apart, as they lie on the surface there; negative beyond its contour.
    double apart_px(const Family& family, const Spot& spot) const {
        const dvec3 way = view_.orthographic ? dvec3(0, 0, -1) : spot.at;
        const double facing = glm::dot(spot.normal, way);
        const dvec3 slope = family.along * facing - spot.normal * glm::dot(family.along, way);
        const dvec2 px = sides_of_px(spot.at);
        const double steep = glm::length(dvec2(slope) * px);
        const double most = most_turned / (glm::length(family.along) * std::max(px.x, px.y));
        return steep * most > -facing ? -facing / steep : most;
    }

    /// The lowest power of two whose multiples are as far apart as the spacing, or nearly so, where multiples of 1 are
    /// `apart` pixels apart.
    int power_for(double apart) const {
        int power = 0;
        const double share = std::frexp(spacing_ * std::numbers::sqrt2 * 0.5 / apart, &power);
        return share == 0.5 ? power - 1 : power;
    }

    /// Upper bound of apart_px over a polygon in a plane with a normal. The gradient of a family in the image is, at
    /// any distance, the distance times what depends on the value of the family alone.
    double most_apart(const Family& family, const Polygon& polygon, const dvec3& normal, double low,
                      double high) const {
        double apart = 0.0, near = HUGE_VAL;
        for (const Spot& corner : polygon) {
            apart = std::max(apart, apart_px(family, corner));
            near = std::min(near, -corner.at.z);
        }
        if (view_.orthographic) return apart;
        const double offset = glm::dot(normal, polygon[0].at);
        const dvec2 along = dvec2(family.along) * per_px_, turned = dvec2(normal) * per_px_;
        const double first = (low - family.offset) / offset, last = (high - family.offset) / offset,
                     flat = glm::dot(turned, turned), least = flat > 0.0 ? glm::dot(along, turned) / flat : 0.0;
        if (!std::isfinite(first + last)) return apart;
        const double at = std::clamp(least, std::min(first, last), std::max(first, last));
        const double most = most_turned / (glm::length(family.along) * std::max(per_px_.x, per_px_.y) * near);
        return std::max(apart, std::min(most, 1.0 / (near * glm::length(along - at * turned))));
    }

    /// Appends the multiples of a power of two between the values at a polygon's corners that may have a line there.
    void append_levels(const Family& family, const Polygon& polygon, const dvec3& normal,
                       std::vector<Level>& found) const {
        constexpr double slack = 1.25;  // where normals are interpolated
        double low = HUGE_VAL, high = -HUGE_VAL;
        for (const Spot& corner : polygon) {
            low = std::min(low, family.at(corner.at));
            high = std::max(high, family.at(corner.at));
        }
        if (!(low < high)) return;
        const double apart = most_apart(family, polygon, normal, low, high);
        if (!(apart > 0.0)) return;
        int power = power_for(apart * slack);
        if (power < -900 || power > 900) return;
        while ((high - low) > std::ldexp(most_levels, power)) ++power;
        const double step = std::ldexp(1.0, power), first = std::ceil(low / step), last = std::floor(high / step);
        if (!(std::abs(first) < 0x1p52 && std::abs(last) < 0x1p52)) return;
        for (double m = first; m <= last; ++m) {
            const auto number = static_cast<std::uint64_t>(std::abs(m));
            found.push_back({m * step, number == 0 ? 1000 : power + std::countr_zero(number)});
        }
    }

    Polygon clipped(const Polygon& polygon, const auto& distance) const {
        Polygon kept;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Spot &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
            const double da = distance(a.at), db = distance(b.at);
            if (da >= 0.0) kept.push_back(a);
            if ((da >= 0.0) != (db >= 0.0)) kept.push_back(mix(a, b, da / (da - db)));
        }
        return kept;
    }

    /// Levels that may have a line on a triangle, ascending. `whole`: all of it is in the frame.
    std::vector<Level> levels(const Family& family, const Corners& corners, bool whole) const {
        std::vector<Level> found;
        const dvec3 normal = glm::cross(corners[1].at - corners[0].at, corners[2].at - corners[0].at);
        Polygon polygon(corners.begin(), corners.end());
        double near = HUGE_VAL, far = 0.0;
        const auto measure = [&] {
            near = HUGE_VAL, far = 0.0;
            for (const Spot& corner : polygon) near = std::min(near, -corner.at.z), far = std::max(far, -corner.at.z);
        };
        measure();
        if (whole && (view_.orthographic || far < 1.5 * near)) {
            append_levels(family, polygon, normal, found);
            return found;
        }
        for (int plane = 0; plane < planes && !polygon.empty(); ++plane)
            polygon = clipped(polygon, [&](const dvec3& p) { return distance_to(plane, p); });
        measure();
        // Slabs of twice the distance each, in which spacing differs little. Of huge triangles clipping is not exact.
        const double first = view_.orthographic ? HUGE_VAL : 2.0 * std::max(near, view_.near_clip);
        for (double split = first; polygon.size() >= 3; split *= 2.0) {
            append_levels(family, clipped(polygon, [&](const dvec3& p) { return p.z + split; }), normal, found);
            if (!(split < far)) break;
            polygon = clipped(polygon, [&](const dvec3& p) { return -split - p.z; });
        }
        std::ranges::sort(found, {}, &Level::value);
        const auto rest = std::ranges::unique(found, {}, &Level::value);
        found.erase(rest.begin(), rest.end());
        return found;
    }

    /// Where a level crosses a triangle. Zero counts as positive, so that each side is crossed in both of its triangles
    /// or in neither, and points are the same from both.
    bool chord(const Family& family, Index triangle, const Corners& corners, double level,
               std::array<End, 2>& ends) const {
        const Triangle& t = seen_.surface.triangles[triangle];
        double above[3];
        for (int i = 0; i < 3; ++i) above[i] = family.at(corners[i].at) - level;
        const bool positive[3] = {above[0] >= 0.0, above[1] >= 0.0, above[2] >= 0.0};
        if (positive[0] == positive[1] && positive[1] == positive[2]) return false;
        const int alone = positive[0] == positive[1] ? 2 : positive[0] == positive[2] ? 1 : 0;
        for (const int k : {0, 1}) {
            const int from = k == 0 ? alone : (alone + 2) % 3, to = (from + 1) % 3;
            const bool ascends = t[from] < t[to];
            const int a = ascends ? from : to, b = ascends ? to : from;
            const double share = std::clamp(above[a] / (above[a] - above[b]), 0.0, 1.0);
            const auto& positions = seen_.surface.positions;
            ends[k] = {mix(corners[a], corners[b], share),
                       glm::mix(dvec3(positions[t[a]]), dvec3(positions[t[b]]), share),
                       sides_->of_triangle[triangle][from]};
        }
        return true;
    }

    /// Clips an interval to where a linear quantity with these values at 0 and 1 is positive.
    static void clip(double at_0, double at_1, double& from, double& to) {
        if (at_0 >= 0.0 && at_1 >= 0.0) return;
        if (!(at_0 > 0.0) && !(at_1 > 0.0)) {
            to = -1.0;
            return;
        }
        const double zero = at_0 / (at_0 - at_1);
        if (at_0 < at_1)
            from = std::max(from, zero);
        else
            to = std::min(to, zero);
    }

    /// Pixels between multiples of 1 from which on a level has lines: its power is that of the spacing, or higher.
    double least_apart(const Level& level) const {
        return level.power > 900 ? 0.0 : spacing_ / (std::ldexp(1.0, level.power) * std::numbers::sqrt2);
    }

    /// Clips to where multiples of 1 are at least so many pixels apart. Across a flat triangle they are closer in
    /// proportion to distance, across others the distance between them is interpolated.
    void clip_to_apart(const Across& of, double least, double& from, double& to) const {
        if (least == 0.0) return;
        const Spot a = of.at(from), b = of.at(to);
        const double first = apart_px(of.family, a), last = apart_px(of.family, b);
        const bool is_flat = glm::distance(a.normal, b.normal) < 1e-6 && first > 0.0 && last > 0.0;
        double begin = 0.0, end = 1.0;
        if (is_flat)
            clip(1.0 / least - 1.0 / first, 1.0 / least - 1.0 / last, begin, end);
        else
            clip(first - least, last - least, begin, end);
        const double start = from, way = to - from;
        if (begin > 0.0) from = start + begin * way;
        if (end < 1.0) to = start + end * way;
    }

    Drawn drawn_at(const Across& of, double t) const {
        const Spot spot = of.at(t);
        if (values_.swell > 0.0) {
            const Tone::Lit lit = tone_.lit_at(shaded_, of.triangle, spot.at);
            return {tone_.at(spot.at, spot.normal, lit) < of.family.tone, lit};
        }
        // Shadows only darken: rays are needed where it is bright without them.
        const auto is_dark = [&](Tone::Lit lit) { return tone_.at(spot.at, spot.normal, lit) < of.family.tone; };
        const bool dark =
            is_dark(Tone::all) || (tone_.has_shadows() && is_dark(tone_.lit_at(shaded_, of.triangle, spot.at)));
        return {dark, Tone::all};
    }

    float strength(const Across& of, double t, Tone::Lit lit) const {
        const Spot spot = of.at(t);
        double found = 1.0;
        if (const double least = least_apart(of.level); least > 0.0)
            found = std::clamp((apart_px(of.family, spot) / least - 1.0) / (fade_in - 1.0), 0.0, 1.0);
        if (values_.swell > 0.0) {
            const double share = tone_.at(spot.at, spot.normal, lit) / of.family.tone;
            found *= 1.0 - values_.swell * std::clamp(share, 0.0, 1.0);
        }
        return static_cast<float>(found);
    }

    /// A point of a line, and how strong the line is there.
    struct Node {
        double t;
        float strength;
    };

    void append_chord(const Across& of, Curves& out) const {
        double from = 0.0, to = 1.0;
        for (int plane = 0; plane < planes; ++plane)
            clip(distance_to(plane, of.ends[0].spot.at), distance_to(plane, of.ends[1].spot.at), from, to);
        if (!(from < to)) return;
        clip_to_apart(of, least_apart(of.level), from, to);
        if (!(from < to)) return;
        double full_from = from, full_to = to;  // where it has faded in
        clip_to_apart(of, fade_in * least_apart(of.level), full_from, full_to);
        const auto px = [&](double t) { return to_pixels(view_, view_.view_to_clip * dvec4(of.at(t).at, 1.0)); };
        const double length = glm::distance(px(from), px(to));
        if (!std::isfinite(length)) return;
        // Light is looked for at even steps in the image: x is a share of the way there.
        const double near = -of.at(from).at.z, far = -of.at(to).at.z;
        const auto in_space = [&](double x) {
            if (x == 0.0 || x == 1.0) return x == 0.0 ? from : to;
            return glm::mix(from, to, view_.orthographic ? x : share_in_space(x, near, far));
        };
        const int steps = std::clamp(int(std::ceil(std::min(length / step_px_, 1e6))), 1, most_steps);
        const double ramp = ramp_px / std::max(length, ramp_px), precision = end_px / std::max(length, end_px);

        std::vector<Node> line;
        Index number = 0;
        const auto add_at = [&](double t, Tone::Lit lit) {
            if (line.empty() || t > line.back().t) line.push_back({t, strength(of, t, lit)});
        };
        const auto add = [&](double x, Tone::Lit lit) { add_at(in_space(x), lit); };
        const auto add_bends_between = [&](double x0, double x1, Tone::Lit lit) {
            if (!(full_from < full_to)) return;
            for (const double t : {full_from, full_to})
                if (t > in_space(x0) && t < in_space(x1)) add_at(t, lit);
        };
        const auto finish = [&] {
            if (line.size() > 1) append_line(of, line, number, out);
            line.clear();
        };
        Drawn before = drawn_at(of, from);
        double since = 0.0;  // the last change
        if (before.drawn) add(0.0, before.lit);
        for (int i = 1; i <= steps; ++i) {
            const double last = double(i - 1) / steps, here = i == steps ? 1.0 : double(i) / steps;
            const Drawn now = drawn_at(of, in_space(here));
            if (now != before) {
                double own = last, other = here;
                while (other - own > precision) {
                    const double middle = 0.5 * (own + other);
                    (drawn_at(of, in_space(middle)) == before ? own : other) = middle;
                }
                if (before.drawn) add_bends_between(last, own, before.lit);
                if (before.drawn && now.drawn) {
                    // Light that changes right at an end, as beside what stands on a floor, does not count.
                    if (i == steps && 1.0 - own < ramp) {
                        add(1.0 - ramp, before.lit);
                        add(1.0, before.lit);
                        break;
                    }
                    if (own - since < ramp) line.back().strength = strength(of, line.back().t, now.lit);
                    add(std::max(own - ramp, ramp), own - since < ramp ? now.lit : before.lit);
                } else if (before.drawn) {
                    add(own, before.lit);
                    finish();
                }
                if (now.drawn) {
                    add(other, now.lit);
                    add_bends_between(other, here, now.lit);
                }
                since = other;
            } else if (now.drawn) {
                add_bends_between(last, here, now.lit);
            }
            if (now.drawn && (i == steps || values_.swell > 0.0)) add(here, now.lit);
            before = now;
        }
        finish();
    }

    /// Appends the pieces of a line between its nodes.
    void append_line(const Across& of, In<Node> line, Index& number, Curves& out) const {
        const std::uint64_t level = hash_numbers(of.family.number, std::bit_cast<std::uint64_t>(of.level.value + 0.0));
        const auto point = [&](double t) { return vec3(glm::mix(of.ends[0].in_surface, of.ends[1].in_surface, t)); };
        // Inner joints have numbers unlike those of sides.
        const auto joint = [&](Index n) { return Index(hash_numbers(of.triangle, n)) | 0x80000000u; };
        const auto side = [&](double t, bool inner, Index n) {
            return inner ? joint(n) : t == 0.0 ? of.ends[0].side : t == 1.0 ? of.ends[1].side : none;
        };
        for (std::size_t i = 0; i + 1 < line.size(); ++i, ++number) {
            const Node &a = line[i], &b = line[i + 1];
            const bool goes_on = i + 2 < line.size();
            out.push_back({.triangle = of.triangle,
                           .side = {side(a.t, i > 0, number), side(b.t, goes_on, number + 1)},
                           .point = {point(a.t), point(b.t)},
                           .strength = {a.strength, b.strength},
                           .level = Index(level),
                           .other = is_smooth_ ? none : of.triangle,
                           .key = hash_numbers(level, of.triangle, number)});
        }
        ++number;
    }

    const SurfaceView& seen_;
    const Hatching& values_;
    const Tone& tone_;
    const View& view_;
    const std::shared_ptr<const CornerNormals> normals_;
    const std::shared_ptr<const TriangleSides> sides_;
    const dmat3 normal_to_view_;
    const bool is_smooth_;
    const ShadedSurface shaded_;
    const dvec2 per_px_;
    const double spacing_, step_px_;
    std::vector<Family> families_;
    Array<dvec3> place_;  // of the vertices, in view space
    std::shared_ptr<const Bodies> bodies_;
};

Curves find(const SurfaceView& seen, const Hatching& values) {
    const auto make = [&] { return Tone(*seen.tracer, values.lights, values.shadows); };
    const auto tone = seen.shared ? seen.shared->get<Tone>(hash_numbers(values.lights, values.shadows), make)
                                  : std::make_shared<const Tone>(make());
    const Hatcher hatcher(seen, values, *tone);
    if (hatcher.is_dot()) return {};
    return parallel_collect<CurvePiece>(seen.surface.triangles.size(), 1024,
                                        [&](std::size_t begin, std::size_t end, auto& out) {
                                            for (std::size_t t = begin; t < end; ++t)
                                                hatcher.append(static_cast<Index>(t), out);
                                        });
}

}  // namespace

extern const LineDefinition hatching = {
    .name = "hatching",
    .label = "Hatching",
    .source = "Winkenbach & Salesin 1994; Hertzmann & Zorin 2000, section 5",
    .description = "Parallel curves over what lies in the dark, crossed where it is darker",
    .scope = Scope::scene,
    .importance = 0.05,
    .parameters = parameters,
    .rule = CurveRule{CurveType::tone, parameters.of(find)},
};

}  // namespace fovea::line
