// SPDX-License-Identifier: GPL-3.0-or-later
// Cast shadow: outlines of shadows. Where light that passes the outline of something next meets a surface.
// In   the lights of the scene that cast shadows; edges that are outlines of what hides, as each of them sees it
// Out  pieces on facets of all placements that are drawn, of the meshes as they are: rays decide of any point of a
//      surface whether it lies in shadow, and these lines are where that changes. None where a body touches another:
//      there its own edges bound the shadow. Independent of the view.
#include <map>
#include <tuple>
#include <unordered_map>

#include <fovea/base/disjoint_sets.h>
#include <fovea/base/hash.h>
#include <fovea/field/turn.h>
#include <fovea/line/look_at.h>
#include <fovea/line/shadow_of_segment.h>

namespace fovea::line {
namespace {

struct CastShadow {
    int lights;
    bool corners;
};

const Parameters<CastShadow> cast_shadow_parameters{
    {&CastShadow::lights, "lights", "Lights", 4, 0, 64,
     "How many lights have lines, those that are strongest amid the scene first"},
    {&CastShadow::corners, "corners", "Corners of Areas", false,
     "Shadows by the corners of area lights, too: between them and those by the center is half-shadow"}};

/// Where a mesh bends by less at an edge, it stands for a round surface, whose outline the edges only approximate: what
/// they would cast right behind themselves, within so many of their lengths, is of their corners, not of the surface.
constexpr double round_turn = 0.8, round_reach = 4.0;

/// Rays that are asked for the shadow of a surface and of each of its edges, at most, by each light: three times what
/// any but a tangle takes. Edges one after the other share what some of them do not need.
constexpr std::size_t rays_of_surface = 1 << 16, rays_of_edge = 32, edges_at_once = 64;

/// A piece, and the edge that casts it.
struct Cast {
    ShadowPiece piece;              // placement `none`: an edge without length, which makes one point of its vertices
    Index placement, edge, number;  // of the edge's pieces
};

/// The shadows of one light, in the order of placements and their edges.
Array<Cast> shadows_of(const LightEye& eye, const Cancel& cancel) {
    const Scene& scene = eye.tracer.scene();
    return parallel_collect<Cast>(scene.placements.size(), 1, [&](std::size_t i, std::size_t, auto& out) {
        const auto placement = static_cast<Index>(i);
        const Placement& caster = scene.placements[placement];
        if (!(caster.usage & (scene::usage_occlude | scene::usage_holdout))) return;
        cancel.poll();
        const Surface& surface = *caster.surface;
        const Array<Index> edges = outline_edges(look_at(surface, placement, eye.tracer));
        const dmat4 to_light = eye.from_object(placement);
        const auto place = [&](Index v) { return dvec3(to_light * dvec4(dvec3(surface.positions[v]), 1.0)); };
        out = parallel_collect<Cast>(edges.size(), edges_at_once, [&](std::size_t begin, std::size_t end, auto& part) {
            Array<ShadowPiece> pieces;
            std::size_t rays = rays_of_surface * (end - begin) / edges.size();
            DarkParts dark(eye);
            for (const Index e : In<Index>(edges).subspan(begin, end - begin)) {
                pieces.clear();
                const Edge& edge = surface.edges[e];
                const dvec3 from = place(edge.x), to = place(edge.y);
                if (from == to) {
                    part.push_back({{}, placement, e, 0});
                    continue;
                }
                const bool is_round = surface.sides(e).size() == 2 && field::turn_at(surface, e) < round_turn;
                const double reach = is_round ? round_reach * glm::distance(from, to) : 0.0;
                rays += rays_of_edge;
                append_shadow(eye, dark, {from, to, eye.tracer.ignore_at(placement, e), reach}, rays, pieces);
                for (Index n = 0; n < pieces.size(); ++n) part.push_back({pieces[n], placement, e, n});
            }
        });
    });
}

/// Numbers of the ends of pieces; equal where they go on.
class Joints {
   public:
    Index next() { return count_++; }
    /// Two vertices of a placement, of so many, are one point.
    void join(Index placement, const Edge& vertices, std::size_t count) {
        points_.try_emplace(placement, count).first->second.join(vertices.x, vertices.y);
    }
    /// At the shadow of a vertex on a facet.
    Index at_vertex(const Cast& cast, Index vertex, Index facet) {
        const auto points = points_.find(cast.placement);
        const Index point = points == points_.end() ? vertex : points->second.name(vertex);
        const auto [it, is_new] = of_vertex_.try_emplace({cast.placement, point, cast.piece.placement, facet}, count_);
        count_ += is_new;
        return it->second;
    }

   private:
    Index count_ = 0;
    std::map<Index, DisjointSets> points_;  // vertices per placement; of those alone of which some are one
    std::map<std::tuple<Index, Index, Index, Index>, Index> of_vertex_;
};

/// Sorts pieces by the placement that they fall on, and appends its curves.
void append_curves(const LightEye& eye, In<Cast> shadows, In<std::uint8_t> drawn, std::vector<SceneCurves>& found) {
    const Scene& scene = eye.tracer.scene();
    std::map<Index, std::shared_ptr<KeptCurves>> of_placement;
    std::unordered_map<Index, dmat4> to_object;
    Joints joints;
    const auto caster = [&](const Cast& cast) -> const Surface& { return *scene.placements[cast.placement].surface; };
    for (const Cast& cast : shadows)
        if (cast.piece.placement == none)
            joints.join(cast.placement, caster(cast).edges[cast.edge], caster(cast).vertex_count());
    Index from = none;  // where the piece before goes on
    for (const Cast& cast : shadows) {
        const auto& [placement, triangle, point, goes_on, starts, ends] = cast.piece;
        if (placement == none) continue;
        const Edge& edge = caster(cast).edges[cast.edge];
        const Index facet = scene.placements[placement].surface->triangle_facet[triangle];
        const Index start = from != none ? from : starts ? joints.at_vertex(cast, edge.x, facet) : none;
        const Index end = goes_on ? joints.next() : ends ? joints.at_vertex(cast, edge.y, facet) : none;
        from = goes_on ? end : none;
        if (!drawn[placement]) continue;
        auto& curves = of_placement[placement];
        if (!curves) {
            curves = std::make_shared<KeptCurves>();
            to_object.emplace(placement, glm::inverse(eye.from_object(placement)));
        }
        const auto in_object = [&](const dvec3& p) { return vec3(to_object.at(placement) * dvec4(p, 1.0)); };
        curves->pieces.push_back(
            {.triangle = triangle,
             .side = {start, end},
             .point = {in_object(point[0]), in_object(point[1])},
             .strength = {1.0f, 1.0f},
             .other = triangle,
             .key = hash_numbers(eye.light.id, scene.placements[cast.placement].id, cast.edge, cast.number)});
    }
    for (auto& [placement, curves] : of_placement) found.push_back({placement, placement, std::move(curves)});
}

std::vector<SceneCurves> find_cast_shadow(const Scene& scene, In<Index> drawn, const CastShadow& values,
                                          const Cancel& cancel) {
    std::vector<SceneCurves> found;
    Array<std::uint8_t> is_drawn(scene.placements.size(), 0);
    for (const Index placement : drawn) is_drawn[placement] = 1;
    for (const Light& light : casting_lights(scene, std::size_t(values.lights), values.corners)) {
        const LightEye eye(scene, light);
        append_curves(eye, shadows_of(eye, cancel), is_drawn, found);
    }
    return found;
}

}  // namespace

extern const LineDefinition cast_shadow = {
    .name = "cast_shadow",
    .label = "Cast Shadow",
    .source = "Crow 1977, Shadow Algorithms for Computer Graphics; Blender's Line Art",
    .description = "Outlines of the shadows that things cast on others and on themselves, by the lights of the scene",
    .scope = Scope::placements,
    .importance = 0.4,
    .parameters = cast_shadow_parameters,
    .rule = SceneRule{cast_shadow_parameters.of(find_cast_shadow), [](const Surface&, const Values&, const Cancel&) {}},
    .ends_at_lines = true,
    .usual = true,
    .shade = Shade::cast,
};

}  // namespace fovea::line
