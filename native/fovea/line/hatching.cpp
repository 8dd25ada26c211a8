// SPDX-License-Identifier: GPL-3.0-or-later
// Hatching: curves on surfaces where families of parallel planes cut them, over what is darker than a tone.
// In   planes of the camera, the world or each object, or curves that follow the form; tone (line/tone.h), interpolated
// normals Out  on each triangle the levels of line/hatch_levels.h: so lines stay where they are while a camera
// approaches, and
//      others fade in between. Each is cut to where its power is called for, and to where the tone is below that of its
//      family
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include <fovea/base/elementary.h>
#include <fovea/base/hash.h>
#include <fovea/base/steps.h>
#include <fovea/field/bend_directions.h>
#include <fovea/field/corner_normals.h>
#include <fovea/field/shape.h>
#include <fovea/line/hatch_levels.h>
#include <fovea/line/streamlines.h>
#include <fovea/line/tone.h>
#include <fovea/mesh/triangle_sides.h>

namespace fovea::line {
namespace {

/// What lines follow: planes of these, or the form itself.
enum Planes { of_camera, of_world, of_object, of_form };

struct Hatching {
    int planes, families;
    double spacing, light, middle, dark, angle, turn, tilt, swell;
    int lights;
    bool shadows;

    double tone(int family) const { return family == 0 ? light : family == 1 ? middle : dark; }
};

const Parameters<Hatching> hatching_parameters{
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
     "Direction of the lines on a surface that faces the viewer, from the horizontal; along the form, from where it "
     "bends "
     "most"},
    {&Hatching::turn, "turn", "Turn", 60.0, 10.0, 90.0, Unit::degrees,
     "Angle from the first direction to the second; the third halves what is left"},
    {&Hatching::tilt, "tilt", "Tilt", 30.0, 0.0, 80.0, Unit::degrees,
     "How far the planes lean towards the viewer: at 0 lines are straight, beyond it they follow the form"},
    {&Hatching::planes, "planes", "Planes", 0, 0, 3,
     "What the planes belong to: 0 the camera, 1 the world, 2 each object; 3 none: lines follow the form as it bends"},
    {&Hatching::swell, "swell", "Swell", 0.0, 0.0, 1.0, Unit::none,
     "How much fainter lines are where they end in the light than in the dark"},
    {&Hatching::lights, "lights", "Lights", 4, 0, 64,
     "How many lights count, those that are strongest amid the scene first; without any there is one at the eye"},
    {&Hatching::shadows, "shadows", "Cast Shadows", true, "What lies in the shadow of something else is dark"}};

/// Steps along lines at which light is looked for [reference px], at most so many, and the precision of ends [px].
constexpr double step_reference_px = 4.0, end_px = 1.0 / 64.0;
constexpr int most_light_steps = 512;
/// Where the light changes amid a line, its strength does within so much [px].
constexpr double ramp_px = 1.0;

/// Lines that come in between others reach their strength where they are so many times as far apart as where they
/// begin: while a camera approaches, none appears at once.
constexpr double fade_in = 1.25;

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

/// Direction of a family's lines [radians].
double angle_of_family(const Hatching& values, int family) {
    const double turned[3] = {0.0, values.turn, 0.5 * values.turn + 90.0};
    return glm::radians(values.angle + turned[family]);
}

/// Normal of the planes of a family in their frame: right, up, towards the viewer.
dvec3 normal_of(const Hatching& values, int family) {
    const double angle = angle_of_family(values, family), tilt = glm::radians(values.tilt);
    return {-sine(angle) * cosine(tilt), cosine(angle) * cosine(tilt), sine(tilt)};
}

/// Planes of the camera go through the middle of the surface, so that they move along with it. Others are a share of a
/// unit away from the origin: planes through it are those of faces.
HatchFamily family_of(const SurfaceView& seen, const Hatching& values, int number) {
    constexpr double away = 0.381966;
    const dvec3 n = normal_of(values, number);
    if (values.planes == of_camera) {
        const dvec3 middle = seen.surface.cache().get<Middle>(0, [&] { return Middle(seen.surface); })->of;
        return {n, -glm::dot(n, dvec3(seen.object_to_view * dvec4(middle, 1.0))), values.tone(number), Index(number)};
    }
    // Also of objects that have no form to follow.
    const dmat4 to_view = values.planes == of_world ? seen.tracer->view().world_to_view
                                                    : seen.object_to_view * dmat4(seen.surface.stretch());
    const dvec3 along = glm::transpose(glm::inverse(dmat3(to_view))) * dvec3(n.x, -n.z, n.y);
    return {along, away - glm::dot(along, dvec3(to_view[3])), values.tone(number), Index(number)};
}

/// End of a chord on a side of its triangle.
struct End {
    HatchSpot spot;
    dvec3 in_surface;
    Index side;
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
          spacing_(values.spacing * view_.reference_scale),
          levels_(view_, spacing_),
          step_px_(step_reference_px * view_.reference_scale) {
        const Surface& surface = seen.surface;
        place_ = parallel_map<dvec3>(surface.vertex_count(), [&](std::size_t v) {
            return dvec3(seen.object_to_view * dvec4(dvec3(surface.positions[v]), 1.0));
        });
        const dvec3 center(seen.object_to_view * dvec4(dvec3(surface.center), 1.0));
        const double radius = glm::length(seen.object_to_view[0]) * surface.radius * 1.001;
        // A body is seen from outside, whole: the backs of its facets are not seen.
        if (!seen.tracer->scene().section && -center.z - radius > view_.near_clip)
            bodies_ = bodies_of(*seen.tracer->scene().placements[seen.placement].surface);
        if (values.planes == of_form && field::bend_directions(seen.surface)->any) {
            std::vector<double> angles;
            for (int f = 0; f < values.families; ++f) angles.push_back(angle_of_family(values, f));
            streams_ = streamlines(seen.surface, angles, finest_power());
            return;
        }
        for (int f = 0; f < values.families; ++f) families_.push_back(family_of(seen, values, f));
    }

    /// Whether all of the surface is no larger in the image than the spacing.
    bool is_dot() const {
        const dvec3 center(seen_.object_to_view * dvec4(dvec3(seen_.surface.center), 1.0));
        const double radius = glm::length(seen_.object_to_view[0]) * seen_.surface.radius;
        return -center.z - radius > view_.near_clip && 2.0 * radius < spacing_ * levels_.px_at(center) * least_turn;
    }

    void append(Index triangle, Curves& out) const {
        const Triangle& t = seen_.surface.triangles[triangle];
        const std::array<dvec3, 3> p{place_[t.x], place_[t.y], place_[t.z]};
        const dvec3 sum = p[0] + p[1] + p[2];
        if (!std::isfinite(sum.x + sum.y + sum.z)) return;
        int outside[3];
        for (int i = 0; i < 3; ++i) outside[i] = levels_.outcode(p[i]);
        if (outside[0] & outside[1] & outside[2]) return;
        const Index facet = seen_.surface.triangle_facet[triangle];
        const dvec3 across = normal_to_view_ * dvec3(seen_.surface.facet_plane[facet]);
        const double facing = glm::dot(across, view_.orthographic ? dvec3(0, 0, 1) : -p[0]);
        if (facing == 0.0 || !std::isfinite(facing) || (facing < 0.0 && hides_back(facet))) return;
        HatchLevels::Corners corners;
        for (int i = 0; i < 3; ++i) {
            const dvec3 n = normal_to_view_ * dvec3(normals_->at(t, triangle, i));
            const double length = glm::length(n);
            if (!(length > 0.0) || !std::isfinite(length)) return;
            corners[i] = {p[i], (facing < 0.0 ? -1.0 : 1.0) / length * n};
        }
        const bool whole = !(outside[0] | outside[1] | outside[2]);
        for (const HatchFamily& family : families_)
            for (const HatchLevel& level : levels_.on(family, corners, whole)) {
                std::array<End, 2> ends;
                if (chord(family, triangle, corners, level.value, ends))
                    append_chord({family, triangle, level, ends}, out);
            }
        for (std::size_t f = 0; f < streams_.size(); ++f)
            for (const StreamChord& across : (*streams_[f])[triangle])
                append_stream(Index(f), across, triangle, corners, out);
    }

   private:
    static constexpr double least_turn = 0.5;

    /// A chord of a level across a triangle.
    struct Across {
        const HatchFamily& family;
        Index triangle;
        HatchLevel level;
        const std::array<End, 2>& ends;
        HatchSpot at(double t) const { return mix(ends[0].spot, ends[1].spot, t); }
    };

    /// The power of two in units of the surface's space that is nearest to the spacing where a unit is largest.
    int finest_power() const {
        const double unit = glm::length(seen_.object_to_view[0]);
        const auto& triangles = seen_.surface.triangles;
        const auto parts =
            parallel_parts<double>(triangles.size(), 4096, [&](double& least, std::size_t begin, std::size_t end) {
                least = HUGE_VAL;
                for (std::size_t i = begin; i < end; ++i) {
                    int outside = ~0;
                    for (int k = 0; k < 3; ++k) outside &= levels_.outcode(place_[triangles[i][k]]);
                    for (int k = 0; k < 3 && !outside; ++k) {
                        const dvec3& p = place_[triangles[i][k]];
                        const double px = levels_.px_at({p.x, p.y, std::min(p.z, -view_.near_clip)});
                        if (px < least) least = px;
                    }
                }
            });
        const double least = parts.empty() ? HUGE_VAL : *std::ranges::min_element(parts);
        return std::isfinite(least) && unit > 0.0 ? levels_.power_for(unit / least) : 1000;
    }

    /// Appends a chord of a curve that follows the form. Across it lines of its family are as far apart as curves are.
    void append_stream(Index family, const StreamChord& across, Index triangle, const HatchLevels::Corners& corners,
                       Curves& out) const {
        const Triangle& t = seen_.surface.triangles[triangle];
        const auto& positions = seen_.surface.positions;
        std::array<End, 2> ends;
        for (const int k : {0, 1}) {
            const dvec3 w(across.weight[k]);
            if (across.side[k] < 0) {
                const HatchSpot first = mix(corners[0], corners[1], w.y / std::max(w.x + w.y, 1e-30));
                ends[k] = {mix(first, corners[2], w.z),
                           w.x * dvec3(positions[t.x]) + w.y * dvec3(positions[t.y]) + w.z * dvec3(positions[t.z]),
                           none};
                continue;
            }
            const auto [a, b] = ascending(t, across.side[k]);
            ends[k] = on_side(triangle, corners, across.side[k], w[b]);
        }
        const dvec3 along = ends[1].in_surface - ends[0].in_surface,
                    away = glm::cross(mesh::area_vector(positions, t), along);
        const double length = glm::length(away);
        if (!(length > 0.0) || !std::isfinite(length)) return;
        const HatchFamily as_planes{normal_to_view_ * (away / length), 0.0, values_.tone(int(family)), family};
        append_chord({as_planes, triangle, {double(across.curve), across.power}, ends}, out);
    }

    /// The corners of a side, that of the lower vertex first.
    static std::pair<int, int> ascending(const Triangle& t, int side) {
        const int next = (side + 1) % 3;
        return t[side] < t[next] ? std::pair(side, next) : std::pair(next, side);
    }

    /// The same point from both triangles at a side: a share of the way from its lower vertex.
    End on_side(Index triangle, const HatchLevels::Corners& corners, int side, double share) const {
        const Triangle& t = seen_.surface.triangles[triangle];
        const auto& positions = seen_.surface.positions;
        const auto [a, b] = ascending(t, side);
        return {mix(corners[a], corners[b], share), glm::mix(dvec3(positions[t[a]]), dvec3(positions[t[b]]), share),
                sides_->of_triangle[triangle][side]};
    }

    bool hides_back(Index facet) const {
        const Surface& surface = *seen_.tracer->scene().placements[seen_.placement].surface;
        if (!surface.polygon_one_sided.empty() && surface.polygon_one_sided[surface.facet_polygon[facet]]) return true;
        return bodies_ && bodies_->of_facet[facet] != none && bodies_->outward[bodies_->of_facet[facet]];
    }

    /// Where a level crosses a triangle. Zero counts as positive, so that each side is crossed in both of its triangles
    /// or in neither, and points are the same from both.
    bool chord(const HatchFamily& family, Index triangle, const HatchLevels::Corners& corners, double level,
               std::array<End, 2>& ends) const {
        const Triangle& t = seen_.surface.triangles[triangle];
        double above[3];
        for (int i = 0; i < 3; ++i) above[i] = family.at(corners[i].at) - level;
        const bool positive[3] = {above[0] >= 0.0, above[1] >= 0.0, above[2] >= 0.0};
        if (positive[0] == positive[1] && positive[1] == positive[2]) return false;
        const int alone = positive[0] == positive[1] ? 2 : positive[0] == positive[2] ? 1 : 0;
        for (const int k : {0, 1}) {
            const int side = k == 0 ? alone : (alone + 2) % 3;
            const auto [a, b] = ascending(t, side);
            ends[k] = on_side(triangle, corners, side, std::clamp(above[a] / (above[a] - above[b]), 0.0, 1.0));
        }
        return true;
    }

    Drawn drawn_at(const Across& of, double t) const {
        const HatchSpot spot = of.at(t);
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
        const HatchSpot spot = of.at(t);
        double found = 1.0;
        if (const double least = levels_.least_apart(of.level); least > 0.0)
            found = std::clamp((levels_.apart_px(of.family, spot) / least - 1.0) / (fade_in - 1.0), 0.0, 1.0);
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
        const HatchSpot &begin = of.ends[0].spot, &end = of.ends[1].spot;
        const ChordPart framed = levels_.in_frame(begin.at, end.at);
        if (framed.empty()) return;
        const double least = levels_.least_apart(of.level);
        const ChordPart part = levels_.where_apart(of.family, begin, end, least, framed);
        if (part.empty()) return;
        const ChordPart full = levels_.where_apart(of.family, begin, end, fade_in * least, part);  // faded in
        const double from = part.from, to = part.to;
        const auto px = [&](double t) { return to_pixels(view_, view_.view_to_clip * dvec4(of.at(t).at, 1.0)); };
        const double length = glm::distance(px(from), px(to));
        if (!std::isfinite(length)) return;
        // Light is looked for at even steps in the image: x is a share of the way there.
        const double near = -of.at(from).at.z, far = -of.at(to).at.z;
        const auto in_space = [&](double x) {
            if (x == 0.0 || x == 1.0) return x == 0.0 ? from : to;
            return glm::mix(from, to, view_.orthographic ? x : share_in_space(x, near, far));
        };
        const int steps = steps_of(length / step_px_, most_light_steps);
        const double ramp = ramp_px / std::max(length, ramp_px), precision = end_px / std::max(length, end_px);

        std::vector<Node> line;
        Index number = 0;
        const auto add_at = [&](double t, Tone::Lit lit) {
            if (line.empty() || t > line.back().t) line.push_back({t, strength(of, t, lit)});
        };
        const auto add = [&](double x, Tone::Lit lit) { add_at(in_space(x), lit); };
        const auto add_bends_between = [&](double x0, double x1, Tone::Lit lit) {
            if (full.empty()) return;
            for (const double t : {full.from, full.to})
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
    const double spacing_;
    const HatchLevels levels_;
    const double step_px_;
    std::vector<HatchFamily> families_;
    std::vector<std::shared_ptr<const Streamlines>> streams_;  // per family, instead
    Array<dvec3> place_;                                       // of the vertices, in view space
    std::shared_ptr<const Bodies> bodies_;
};

Curves find_hatching(const SurfaceView& seen, const Hatching& values) {
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
    .source = "Winkenbach & Salesin 1994; Hertzmann & Zorin 2000, section 5; Jobard & Lefer 1997",
    .description = "Parallel curves over what lies in the dark, crossed where it is darker",
    .scope = Scope::scene,
    .importance = 0.05,
    .parameters = hatching_parameters,
    .rule = CurveRule{CurveType::tone, hatching_parameters.of(find_hatching)},
};

}  // namespace fovea::line
