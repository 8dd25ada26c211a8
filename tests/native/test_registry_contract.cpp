// SPDX-License-Identifier: GPL-3.0-or-later
// What every definition of the registry must do, whichever it is: over whole scenes, through extract_paths.
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <tbb/global_control.h>

#include <fovea/mesh/triangle_sides.h>

#include "analytic.h"
#include "drawing.h"
#include "rules.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::meshes;
using namespace fovea::drawing;

namespace {

constexpr float nan_value = std::numeric_limits<float>::quiet_NaN();

/// Words of small letters, one underscore between them.
bool is_snake_case(const std::string& name) {
    bool word = false;
    for (const char c : name) {
        if (!(c >= 'a' && c <= 'z') && !(c == '_' && word)) return false;
        word = c != '_';
    }
    return word;
}

LineSet every(const Values& values, Index definition) {
    LineSet set;
    set.corner_angle_rad = 1.0;
    set.kinds.push_back({definition, values});
    return set;
}

/// Marks, materials and borders, smooth parts and hard edges, two surfaces that cut each other, and one far below.
std::vector<Placement> small_scene() {
    Mesh cube = box();
    cube.material = {0, 1, 0, 1, 0, 1};
    cube.edge_mark = cube.edge_flags({0, 3});
    const Mesh hills = analytic::waves({.n = 40, .irregular = true}).mesh;
    const Mesh ring = analytic::torus({.n = 48}).mesh;
    return {place(hills, scaled(dvec3(2)), 1), place(ring, moved({0.3, 0, 0.4}), 2),
            place(cube, moved({-1, 1, 0.2}), 3), place(grid(4, 4.0f), moved({0, 0, -1}), 4)};
}

Scene lit(Scene scene) {
    scene.lights = {{.kind = Light::sun, .direction = {-0.4, 0.5, -0.3}, .id = 1},
                    {.kind = Light::point, .position = {2, -1, 0.8}, .id = 2}};
    return scene;
}

/// Paths of one definition in a scene that has lights and is cut open, and the camera they were found for.
struct Found {
    Scene scene;
    View view;
    Tracer tracer;
    Paths paths;

    Found(std::vector<Placement> placements, const View& seen, const LineSet& set)
        : scene(lit(cut_open(std::move(placements), dvec4(0.0, 0.0, 1.0, -0.9)))),
          view(seen),
          tracer(scene, view),
          paths(extract_paths(scene, view, {set}, tracer, Cancel())) {}
    Found(const Found&) = delete;
};

template <typename T>
void expect_same_bytes(const Array<T>& a, const Array<T>& b, const std::string& what) {
    ASSERT_EQ(a.size(), b.size()) << what;
    EXPECT_TRUE(a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0) << what;
}

void expect_same(const Paths& a, const Paths& b, const std::string& name) {
    expect_same_bytes(a.rows.offsets, b.rows.offsets, name + ": rows");
    const auto compare = [&](const auto& column) {
        expect_same_bytes(a.*column.array, b.*column.array, name + ": " + column.name);
    };
    for_each_column(Paths::path_columns, compare);
    for_each_column(Paths::point_columns, compare);
}

/// Corners of the edge or triangle that a segment lies on.
std::vector<vec3> corners_of(const Surface& surface, Index place) {
    const auto& p = surface.positions;
    if (surface.is_edge(place)) return {p[surface.edges[place].x], p[surface.edges[place].y]};
    const Triangle& t = surface.triangles[surface.triangle_at(place)];
    return {p[t.x], p[t.y], p[t.z]};
}

/// Edges have a place in common, triangles a side; vertices in the same place count as one.
bool touch(const Surface& surface, Index a, Index b) {
    int common = 0;
    for (const vec3& p : corners_of(surface, a))
        for (const vec3& q : corners_of(surface, b)) common += p == q;
    return common >= (surface.is_edge(a) ? 1 : 2);
}

void expect_sound(const Found& found, const std::string& name) {
    const Paths& paths = found.paths;
    for (Index p = 0; p < paths.count(); ++p) {
        const Index begin = paths.rows.begin(p), end = paths.rows.end(p);
        ASSERT_GE(end - begin, 2u) << name << ": a path has two points";
        const Index placement = paths.placement[p];
        const Surface* surface =
            placement < found.scene.placements.size() ? found.scene.placements[placement].surface.get() : nullptr;
        for (Index i = begin; i < end; ++i) {
            const vec3 point = paths.points_obj[i];
            ASSERT_TRUE(std::isfinite(point.x + point.y + point.z)) << name;
            ASSERT_TRUE(paths.strength[i] >= 0.0f && paths.strength[i] <= 1.0f) << name << " " << paths.strength[i];
            ASSERT_TRUE(std::isfinite(paths.arc_obj[i]) && (i == begin || paths.arc_obj[i] >= paths.arc_obj[i - 1]))
                << name;
            ASSERT_EQ(paths.kinds[i] & ~bit_of(name.c_str()), 0u) << name << ": kinds that were not asked for";
            if (!surface) continue;
            ASSERT_LE(glm::distance(point, surface->center), surface->radius * 1.0001f)
                << name << ": outside of the mesh";
        }
        EXPECT_TRUE(!paths.closed[p] || paths.points_obj[begin] == paths.points_obj[end - 1]) << name;
        // Lines of the scene need not lie on one surface.
        if (!surface || definition_called(name).scope == Scope::scene) continue;
        // Pieces of no length, in slivers, are left out of lines on two surfaces.
        const bool with_gaps = has_rule<SceneRule>(definition_called(name));
        for (Index i = begin; i + 1 < end; ++i) {
            ASSERT_LT(paths.place[i], surface->place_count()) << name;
            ASSERT_TRUE(i + 2 >= end || with_gaps || touch(*surface, paths.place[i], paths.place[i + 1])) << name;
        }
    }
    std::set<std::uint64_t> ids(paths.id.begin(), paths.id.end());
    EXPECT_EQ(ids.size(), paths.count()) << name << ": ids differ";
}

std::vector<Mesh> degenerate_meshes() {
    Mesh broken = analytic::waves({.n = 12}).mesh;
    broken.name = "NaN";
    broken.positions[30] = broken.positions[77] = vec3(nan_value);
    broken.positions[100].z = std::numeric_limits<float>::infinity();
    Mesh slivers = analytic::waves({.n = 12}).mesh;
    slivers.name = "slivers";
    for (std::size_t v = 0; v + 1 < slivers.positions.size(); v += 3)
        slivers.positions[v] = slivers.positions[v + 1] + vec3(1e-7f, 0, 0);
    Mesh line = grid(4);
    line.name = "line";
    for (vec3& p : line.positions) p.y = p.z = 0.0f;
    Mesh huge = sphere(6);
    huge.name = "huge";
    for (vec3& p : huge.positions) p *= 1e18f;
    Mesh tiny = sphere(6);
    tiny.name = "tiny";
    for (vec3& p : tiny.positions) p *= 1e-18f;
    return {broken,
            slivers,
            line,
            huge,
            tiny,
            Mesh("nothing", {}),
            sphere(8),
            grid(6),
            box(),
            cylinder(5),
            moebius(9),
            of_polygons("triangle", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}),
            of_polygons("three faces at an edge", {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 1}, {-1, 0, -1}},
                        {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}),
            two_boxes_at_an_edge(),
            bent_quad(),
            analytic::ellipsoid(2, true).mesh};
}

const View view_from_corner = perspective({6, -5, 4}, {0, 0, 0});

}  // namespace

class Definition : public testing::TestWithParam<Index> {
   protected:
    const Index index = GetParam();
    const LineDefinition& definition = *line_definitions()[index];
    const std::string name = definition.name;
};

TEST_P(Definition, SaysWhatItIs) {
    EXPECT_TRUE(is_snake_case(name)) << name;
    EXPECT_GT(std::string(definition.label).size(), 2u);
    EXPECT_GT(std::string(definition.source).size(), 5u);
    EXPECT_GT(std::string(definition.description).size(), 10u);
    EXPECT_LT(index, 8 * sizeof(Kinds));
    std::set<std::string> names;
    for (const Parameter& p : definition.parameters) {
        EXPECT_TRUE(is_snake_case(p.name)) << p.name;
        EXPECT_TRUE(names.insert(p.name).second) << p.name << " twice";
        EXPECT_TRUE(p.low < p.high && p.low <= p.value && p.value <= p.high) << p.name;
        EXPECT_GT(std::string(p.label).size(), 1u);
        EXPECT_GT(std::string(p.meaning).size(), 10u);
    }
    EXPECT_TRUE(definition.importance > 0.0 && definition.importance <= 1.0) << definition.importance;
    for (Index other = 0; other < line_definitions().size(); ++other)
        EXPECT_TRUE(other == index || line_definitions()[other]->name != name);
    // What surfaces keep is there in every view (path/find_edges.h).
    EXPECT_FALSE(definition.smooth_twin && definition.scope == draw::Scope::surface);
}

TEST_P(Definition, IsSoundAndTheSameForAnyNumberOfThreads) {
    for (const View& view :
         {view_from_corner, orthographic({6, -5, 4}, {0, 0, 0}, 8), perspective({0, 0, 7}, {0, 0, 0})}) {
        const Found all(small_scene(), view, every(quick_values(definition), index));
        expect_sound(all, name);
        const Found again(small_scene(), view, every(quick_values(definition), index));
        expect_same(all.paths, again.paths, name);
        tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
        const Found alone(small_scene(), view, every(quick_values(definition), index));
        expect_same(all.paths, alone.paths, name);
    }
}

TEST_P(Definition, FindsSomethingWhenItsParametersAllowIt) {
    Index count = 0;
    for (const bool least : {false, true}) {
        Values values = quick_values(definition);
        for (std::size_t p = 0; least && p < values.size(); ++p) values[p] = definition.parameters[p].low;
        count += Found(small_scene(), view_from_corner, every(values, index)).paths.count();
    }
    EXPECT_GT(count, 0u) << "give the scene of this test what the definition finds";
}

TEST_P(Definition, EndsPiecesOnTheSidesThatTheyName) {
    const auto* rule = std::get_if<CurveRule>(&definition.rule);
    if (!rule || definition.scope == Scope::scene) return;  // not pieces of curves on a surface
    const auto surface = analytic::waves({.n = 40, .irregular = true}).mesh.surface();
    const auto sides = triangle_sides(*surface);
    SurfaceView seen{.surface = *surface};
    seen.eye_obj = dvec3(5, -4, 4);
    Values values = default_values(definition);
    if (!values.empty()) values[0] = definition.parameters[0].low;
    std::map<std::pair<Index, Index>, std::vector<vec3>> at_side;
    for (const CurvePiece& piece : rule->find(seen, values))
        for (int k = 0; k < 2; ++k) {
            if (piece.side[k] == none) continue;
            const glm::uvec3& own = sides->of_triangle[piece.triangle];
            ASSERT_TRUE(own.x == piece.side[k] || own.y == piece.side[k] || own.z == piece.side[k]);
            const Edge e = sides->vertices[piece.side[k]];
            const dvec3 a(surface->positions[e.x]), b(surface->positions[e.y]), p(piece.point[k]);
            EXPECT_NEAR(glm::distance(a, p) + glm::distance(p, b), glm::distance(a, b), 1e-6);
            at_side[{piece.side[k], piece.level}].push_back(piece.point[k]);
        }
    for (const auto& [side, points] : at_side) {
        ASSERT_LE(points.size(), 2u) << "one piece of a level in a triangle";
        if (points.size() < 2) continue;
        const Edge e = sides->vertices[side.first];
        const float length = glm::distance(surface->positions[e.x], surface->positions[e.y]);
        EXPECT_LE(glm::distance(points[0], points[1]), 0.1f * length) << "a curve goes on where it left";
    }
}

TEST(Registry, AllDefinitionsAtOnce) {
    // Several that ask the same new surface for the same fields, on many threads.
    LineSet all;
    for (Index d = 0; d < line_definitions().size(); ++d)
        if (!has_rule<ImageRule>(*line_definitions()[d]))
            all.kinds.push_back({d, default_values(*line_definitions()[d])});
    Paths first;
    for (int run = 0; run < 20; ++run) {
        const Found found(small_scene(), view_from_corner, {all});
        if (run == 0) first = found.paths;
        expect_same(found.paths, first, "run " + std::to_string(run));
    }
    EXPECT_GT(first.count(), 0u);
}

TEST_P(Definition, TakesExtremesOfItsParameters) {
    static const std::vector<Placement> scene = small_scene();  // whose surfaces keep their fields
    View view = view_from_corner;
    if (has_rule<ImageRule>(definition)) {  // which costs by the pixel
        view.width /= 2;
        view.height /= 2;
    }
    for (std::size_t p = 0; p < definition.parameters.size(); ++p)
        for (const double extreme : {definition.parameters[p].low, definition.parameters[p].high}) {
            Values values = quick_values(definition);
            values[p] = extreme;
            expect_sound(Found(scene, view, every(values, index)), name);
        }
}

TEST_P(Definition, TakesDegenerateMeshes) {
    Values least = quick_values(definition);
    for (std::size_t p = 0; p < least.size(); ++p) least[p] = definition.parameters[p].low;
    for (const Mesh& mesh : degenerate_meshes()) {
        const Placement placed = place(mesh);
        for (const Values& values : {quick_values(definition), least})
            // The last looks along a face, from a vertex.
            for (View view :
                 {view_from_corner, orthographic({0, 0, 5}, {0, 0, 0}, 4), perspective({0, 1, 0}, {0, 0, 0})}) {
                SCOPED_TRACE(mesh.name);
                // Lines of the image cost by the pixel; what is degenerate is so in few of them, too.
                view.width /= 4;
                view.height /= 4;
                expect_sound(Found({placed}, view, every(values, index)), name);
            }
    }
    // Two of a kind in one place, and a scene of nothing.
    expect_sound(
        Found({place(box()), place(box(), dmat4(1.0), 2)}, view_from_corner, every(quick_values(definition), index)),
        name);
    EXPECT_EQ(Found({}, view_from_corner, every(quick_values(definition), index)).paths.count(), 0u);
}

INSTANTIATE_TEST_SUITE_P(Registry, Definition, testing::Range(Index(0), Index(line_definitions().size())),
                         [](const auto& info) { return std::string(line_definitions()[info.param]->name); });
