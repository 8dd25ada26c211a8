// SPDX-License-Identifier: GPL-3.0-or-later
// Light contour: the contour of surfaces as a light sees it, where their lit side ends.
// In   the lights of the scene that cast shadows; contours as each of them sees them, of smooth surfaces across their
//      triangles (line/smooth_contour.cpp), of others along edges
// Out  the parts that the light reaches, on all placements that are drawn. Independent of the view.
#include <algorithm>
#include <cmath>

#include <fovea/base/hash.h>
#include <fovea/base/steps.h>
#include <fovea/field/shape.h>
#include <fovea/line/dark_parts.h>
#include <fovea/line/look_at.h>
#include <fovea/mesh/stretch.h>

namespace fovea::line {

extern const LineDefinition smooth_contour;

namespace {

struct LightContour {
    int lights;
};

const Parameters<LightContour> light_contour_parameters{
    {&LightContour::lights, "lights", "Lights", 4, 0, 64,
     "How many lights have lines, those that are strongest amid the scene first"}};

constexpr float seen_strength = 0.5f;  // smooth contours below it are hidden behind cusps

/// To which share of a step changes of light are found; where what is known to be dark ends, it is looked so often
/// before that is halved.
constexpr double shortest = 0x1p-20;
constexpr int most_looks = 2;

/// Calls part(from, to) for the intervals of [0, 1] that are lit. dark_at(t): a dark interval around t, or at t alone;
/// empty where it is lit.
template <typename DarkAt, typename Part>
void each_lit_part(int steps, const DarkAt& dark_at, const Part& part) {
    const auto change = [&](double lit, double dark, Interval known) {
        const double way = lit < dark ? -1.0 : 1.0;
        for (int looks = most_looks;; --looks) {
            dark = way < 0.0 ? std::clamp(known.begin, lit, dark) : std::clamp(known.end, dark, lit);
            if (std::abs(lit - dark) <= shortest) return lit;
            const double t = looks > 0 ? dark + 0.5 * way * shortest : 0.5 * (lit + dark);
            if (const Interval at = dark_at(t); !at.is_empty())
                dark = t, known = at;
            else
                lit = t, known = {dark, dark};
        }
    };
    double from = 0.0;
    Interval was = dark_at(0.0);
    for (int i = 1; i <= steps; ++i) {
        const double before = double(i - 1) / steps, here = double(i) / steps;
        const Interval dark = dark_at(here);
        if (dark.is_empty() && !was.is_empty()) from = change(here, before, was);
        if (!dark.is_empty() && was.is_empty()) part(from, change(before, here, dark));
        was = dark;
    }
    if (was.is_empty()) part(from, 1.0);
}

/// Contours across the triangles of a smooth surface, in object space.
Curves across_triangles(const LightEye& eye, const std::shared_ptr<const Surface>& own, Index placement) {
    const auto surface = mesh::as_placed(own, eye.tracer.scene().placements[placement].object_to_world);
    const SurfaceView seen = look_at(*surface, placement, eye.tracer);
    Curves pieces = std::get<CurveRule>(smooth_contour.rule).find(seen, default_values(smooth_contour));
    std::erase_if(
        pieces, [](const CurvePiece& piece) { return std::max(piece.strength[0], piece.strength[1]) < seen_strength; });
    const dmat3 to_object = glm::inverse(surface->stretch());
    for (CurvePiece& piece : pieces) {
        for (vec3& point : piece.point) point = vec3(to_object * dvec3(point));
        piece.other = piece.triangle;
        piece.key = hash_numbers(eye.light.id, piece.triangle);
    }
    return pieces;
}

/// Per facet: one of its triangles.
struct FacetTriangles {
    Array<Index> of;

    explicit FacetTriangles(const Surface& surface) : of(surface.facet_count(), none) {
        for (Index t = 0; t < surface.triangles.size(); ++t) of[surface.triangle_facet[t]] = t;
    }
};

/// Contours along edges: on two facets, of which each is one of its triangles.
Curves along_edges(const LightEye& eye, const Surface& surface, Index placement) {
    const auto triangle_of = surface.cache().get<FacetTriangles>(0, [&] { return FacetTriangles(surface); });
    Curves pieces;
    for (const Index e : outline_edges(look_at(surface, placement, eye.tracer))) {
        const In<EdgeSide> sides = surface.sides(e);
        if (sides.size() < 2) continue;
        const Edge& edge = surface.edges[e];
        pieces.push_back({.triangle = triangle_of->of[sides[0].facet()],
                          .side = {edge.x, edge.y},
                          .point = {surface.positions[edge.x], surface.positions[edge.y]},
                          .strength = {1.0f, 1.0f},
                          .other = triangle_of->of[sides[1].facet()],
                          .key = hash_numbers(eye.light.id, surface.place_count() + e)});
    }
    return pieces;
}

/// The parts of pieces that the light reaches.
Curves in_light(const LightEye& eye, const Curves& pieces, Index placement, bool is_smooth) {
    const Scene& scene = eye.tracer.scene();
    const Surface& surface = *scene.placements[placement].surface;
    const dmat4 to_light = eye.from_object(placement);
    return parallel_collect<CurvePiece>(pieces.size(), 64, [&](std::size_t begin, std::size_t end, auto& out) {
        DarkParts dark(eye);
        for (const CurvePiece& piece : In<CurvePiece>(pieces).subspan(begin, end - begin)) {
            const Index other_facet = scene.facet_base[placement] + surface.triangle_facet[piece.other],
                        place = surface.place_of_triangle(piece.triangle);
            const Ignore ignore = eye.tracer.ignore_at(placement, place, is_smooth ? none : other_facet, is_smooth);
            const dvec3 a(to_light * dvec4(dvec3(piece.point[0]), 1.0)),
                b(to_light * dvec4(dvec3(piece.point[1]), 1.0));
            const dvec3 above = is_smooth ? dvec3(ignore.above) : dvec3(0.0);
            dark.next_segment(a + above, b + above, ignore);
            const auto dark_at = [&](double t) -> Interval {
                if (const Interval known = dark.known(t); !known.is_empty()) return known;
                const dvec3 point = glm::mix(a, b, t);
                if (!eye.shines_at(point)) return {t, t};
                if (is_smooth) {
                    const auto by = eye.tracer.occluder(vec3(point) + ignore.above, ignore);
                    return by ? dark.hidden_by(*by, t) : Interval{};
                }
                const LightEye::Passing way = eye.pass(point, ignore);
                return way.lit ? Interval{} : way.hit ? dark.hidden_by(*way.hit, t) : Interval{t, t};
            };
            const double steps = glm::distance(a, b) / eye.step;
            if (!std::isfinite(steps)) continue;
            Index number = 0;
            each_lit_part(steps_of(steps, most_steps), dark_at, [&](double from, double to) {
                CurvePiece part = piece;
                for (const int i : {0, 1}) {
                    const double t = i ? to : from;
                    if (t == double(i)) continue;
                    part.point[i] = vec3(glm::mix(dvec3(piece.point[0]), dvec3(piece.point[1]), t));
                    part.side[i] = none;
                }
                part.key = hash_numbers(piece.key, number++);
                out.push_back(part);
            });
        }
    });
}

std::vector<SceneCurves> find_light_contour(const Scene& scene, In<Index> drawn, const LightContour& values,
                                            const Cancel& cancel) {
    std::vector<SceneCurves> found;
    for (const Light& light : casting_lights(scene, std::size_t(values.lights), false)) {
        const LightEye eye(scene, light);
        std::vector<std::shared_ptr<KeptCurves>> curves(drawn.size());
        parallel_for(drawn.size(), 1, [&](std::size_t i) {
            cancel.poll();
            const auto& surface = scene.placements[drawn[i]].surface;
            const bool is_smooth = field::shape_of(*surface) == Shape::smooth;
            const Curves all =
                is_smooth ? across_triangles(eye, surface, drawn[i]) : along_edges(eye, *surface, drawn[i]);
            curves[i] = std::make_shared<KeptCurves>();
            curves[i]->pieces = in_light(eye, all, drawn[i], is_smooth);
        });
        for (std::size_t i = 0; i < drawn.size(); ++i)
            if (!curves[i]->pieces.empty()) found.push_back({drawn[i], drawn[i], std::move(curves[i])});
    }
    return found;
}

}  // namespace

extern const LineDefinition light_contour = {
    .name = "light_contour",
    .label = "Light Contour",
    .source = "Blender's Line Art; Hertzmann & Zorin 2000, section 4",
    .description = "Where the lit side of surfaces ends: their contours as the lights of the scene see them",
    .scope = Scope::placements,
    .importance = 0.4,
    .parameters = light_contour_parameters,
    .rule =
        SceneRule{light_contour_parameters.of(find_light_contour), [](const Surface&, const Values&, const Cancel&) {}},
    .usual = true,
    .shade = Shade::attached,
};

}  // namespace fovea::line
