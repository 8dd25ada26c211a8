// SPDX-License-Identifier: GPL-3.0-or-later
// See-through surfaces in the color layer: composited in front of what hides, in the order of their distance.
#include <cstring>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <fovea/color/layer.h>

#include "drawing.h"

namespace fovea {
using namespace draw;
namespace {

using namespace drawing;

/// A square pane at a height, seen from above; `opacity` below 0: it occludes.
struct Pane {
    double height, half = 1.0;
    vec3 color{1.0f};
    float opacity = -1.0f;
    bool one_sided = false, turned = false;
};

struct Panes {
    std::vector<Placement> placements;
    SceneColor colors;

    explicit Panes(const std::vector<Pane>& panes) {
        for (const Pane& pane : panes) {
            const float a = float(pane.half), z = float(pane.height);
            meshes::Mesh mesh("pane", {vec3(-a, -a, z), vec3(a, -a, z), vec3(a, a, z), vec3(-a, a, z)});
            mesh.add_polygon(pane.turned ? std::vector{3, 2, 1, 0} : std::vector{0, 1, 2, 3});
            mesh.occluding = {std::uint8_t(pane.opacity < 0.0f)};
            mesh.one_sided = {std::uint8_t(pane.one_sided)};
            placements.push_back(place(mesh, dmat4(1.0), placements.size() + 1));
            auto color = std::make_shared<SurfaceColor>();
            ColorSlot slot;
            slot.color = pane.color;
            slot.opacity = std::max(pane.opacity, 0.0f);
            color->slots.push_back(slot);
            colors.push_back(color);
        }
    }

    Array<vec4> layer(const View& view) const {
        const Scene scene(placements);
        const Tracer tracer(scene, view);
        style::Color flat;
        flat.shading = Shading::flat;
        return color_layer(tracer, colors, {}, vec3(0.0f), flat, Cancel());
    }
};

constexpr int columns = 60, rows = 40;

View from_above() { return orthographic({0, 0, 10}, {0, 0, 0}, 6.0, columns, rows); }
vec4 amid(const Array<vec4>& layer) { return layer[std::size_t(rows / 2) * columns + columns / 2]; }
bool same(const Array<vec4>& a, const Array<vec4>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(vec4)) == 0;
}
void expect_near(const vec4& a, const vec4& b) {
    for (int c = 0; c < 4; ++c) EXPECT_NEAR(a[c], b[c], 1e-6f) << c;
}

const vec3 red(1, 0, 0), green(0, 1, 0), blue(0, 0, 1);

TEST(Sheets, AreCompositedOverWhatHidesByTheirOpacity) {
    const Array<vec4> found =
        Panes({{2.0, 1.0, red, 0.25f}, {1.0, 1.0, green, 0.5f}, {0.0, 2.0, blue}}).layer(from_above());
    expect_near(amid(found), {0.25f, 0.375f, 0.375f, 1.0f});
}

TEST(Sheets, OverNothingHaveTheirOpacityAsAlpha) {
    expect_near(amid(Panes({{1.0, 1.0, green, 0.5f}, {2.0, 1.0, red, 0.25f}}).layer(from_above())),
                {0.25f, 0.375f, 0.0f, 0.625f});
}

TEST(Sheets, ArePaintedByDistanceWhateverTheirOrderInTheScene) {
    const Pane near{2.0, 1.0, red, 0.25f}, middle{1.0, 1.3, green, 0.5f}, wall{0.0, 2.0, blue};
    EXPECT_TRUE(same(Panes({near, middle, wall}).layer(from_above()), Panes({wall, middle, near}).layer(from_above())));
}

TEST(Sheets, BehindWhatHidesAreNotSeen) {
    const Pane wall{1.0, 1.2, blue};
    EXPECT_TRUE(same(Panes({wall}).layer(from_above()), Panes({wall, {0.5, 1.0, red, 0.5f}}).layer(from_above())));
}

TEST(Sheets, WithoutOpacityAreNotThere) {
    const Pane wall{0.0, 2.0, blue};
    EXPECT_TRUE(same(Panes({wall}).layer(from_above()), Panes({wall, {1.0, 1.0, red, 0.0f}}).layer(from_above())));
}

TEST(Sheets, HaveSmoothEdges) {
    // Seen askew, so that its sides cross pixels at all places.
    View view = perspective({1.0, -0.7, 10}, {0.1, 0, 0}, 50.0, 200, 150);
    const auto area = [&](float opacity) {
        double sum = 0.0;
        for (const vec4& color : Panes({{0.0, 1.0, vec3(1.0f), opacity}}).layer(view)) sum += color.a;
        return sum;
    };
    const double whole = area(-1.0f);
    EXPECT_GT(whole, 1000.0);
    EXPECT_NEAR(area(0.5f), 0.5 * whole, 1e-4 * whole);
}

TEST(Sheets, OfCulledBacksAreNotThere) {
    const Pane front{1.0, 1.0, red, 0.5f, true, false}, back{1.0, 1.0, red, 0.5f, true, true};
    EXPECT_EQ(amid(Panes({front}).layer(from_above())).a, 0.5f);
    EXPECT_EQ(amid(Panes({back}).layer(from_above())).a, 0.0f);
}

TEST(Sheets, AreTheSameForAnyNumberOfThreads) {
    const Panes panes({{2.0, 1.0, red, 0.25f}, {1.0, 1.3, green, 0.5f}, {0.0, 2.0, blue}});
    const View view = perspective({5, -4, 3}, {0, 0, 0}, 50.0, 200, 150);
    const Array<vec4> many = panes.layer(view);
    tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_TRUE(same(many, panes.layer(view)));
}

}  // namespace
}  // namespace fovea
