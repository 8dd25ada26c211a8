// SPDX-License-Identifier: GPL-3.0-or-later
// Shadows and blacks of the color layer: where closed forms say that they are, soft where lights have a size, without
// leaks and specks.
#include <cmath>
#include <cstring>
#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <fovea/color/layer.h>
#include <fovea/color/spots.h>

#include "shadows.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::drawing;
using namespace fovea::meshes;
using namespace fovea::shadows;

namespace {

constexpr int width = 240, height = 180;
constexpr double across = 12.0;

/// The picture of a floor at z = 0 and what is on it, straight from above, 12 wide.
struct Above {
    Scene scene;
    View view = orthographic({0, 0, 50}, {0, 0, 0}, across, width, height);
    Array<vec4> pixels;

    Above(std::vector<Placement> placements, const std::vector<Light>& lights, const style::Color& color)
        : scene(std::move(placements)) {
        const Tracer tracer(scene, view);
        pixels = color_layer(tracer, SceneColor(scene.placements.size()), lights, vec3(0.0f), color, Cancel());
    }
    static dvec2 floor(std::size_t pixel) {
        const double px = across / width;
        return {(double(pixel % width) + 0.5 - 0.5 * width) * px, (double(pixel / width) + 0.5 - 0.5 * height) * px};
    }
};

style::Color with(Shading shading, double shadow, double blacks = 0.0) {
    style::Color color;
    color.shading = shading;
    color.shadow = shadow;
    color.blacks = blacks;
    return color;
}

Placement floor_at(double z) { return place(grid(1, 20.0f), moved({0, 0, z}), 9); }

Placement smooth_ball(int n, const dmat4& to_world, int usage = usage_draw | usage_occlude) {
    Mesh mesh = sphere(n);
    mesh.shape = Shape::smooth;
    return place(mesh, to_world, 1, usage);
}

}  // namespace

TEST(ColorShadows, BlacksUnderALampAreInTheConeThatTouchesABall) {
    const dvec3 lamp_at(1.0, 0.5, 6.0), c(0.5, -0.25, 2.5);
    const Above seen({smooth_ball(64, moved(c)), floor_at(0.0)}, {lamp(lamp_at, 50.0f)},
                     with(Shading::flat, 0.0, 0.02));
    int black = 0, wrong = 0;
    for (std::size_t i = 0; i < seen.pixels.size(); ++i) {
        const dvec3 at(Above::floor(i), 0.0), way = at - lamp_at, to_ball = c - lamp_at;
        if (glm::length(dvec2(at - c)) < 1.1) continue;  // the ball itself
        const double squared = glm::dot(to_ball, to_ball), along = glm::dot(way, to_ball);
        const double inside = along / (glm::length(way) * std::sqrt(squared)) - std::sqrt(1.0 - 1.0 / squared);
        if (std::abs(inside) < 0.012) continue;
        const bool is_black = seen.pixels[i] == vec4(0, 0, 0, 1);
        wrong += is_black != (inside > 0.0);
        black += is_black;
    }
    EXPECT_EQ(wrong, 0);
    EXPECT_GT(black, 500);
}

TEST(ColorShadows, TheEdgeOfBlacksIsOnePixelWide) {
    const Above seen({place(box(vec3(-20, -20, 3), vec3(0.013, 20, 4)), dmat4(1.0), 1, usage_occlude), floor_at(0.0)},
                     {sun({0.7, 0.1, 1.0})}, with(Shading::flat, 0.0, 0.1));
    int between = 0;
    for (int y = 20; y < height - 20; ++y)
        for (int x = width / 2 + 4; x < width; ++x) {
            const vec4& pixel = seen.pixels[std::size_t(y) * width + x];
            between += pixel.r > 0.0f && pixel.r < 0.79f;
        }
    EXPECT_LE(between, height - 40);
}

TEST(ColorShadows, OfASunBehindAnEdgeIsTheShareOfItsDiskThatIsSeen) {
    Light light = sun({0, 0, 1});
    light.radius = 0.5;
    const double z = 5.0;  // of the upper edge of a plate above all that is left of the middle
    const Above seen({place(box(vec3(-60, -60, 4), vec3(0, 60, 5)), dmat4(1.0), 1, 0), floor_at(0.0)}, {light},
                     with(Shading::flat, 1.0));
    EXPECT_EQ(seen.pixels[width * height / 2 + 3], seen.pixels[width * height / 2 - 3]) << "it hides nothing";
    const Above hidden({place(box(vec3(-60, -60, 4), vec3(0, 60, 5)), dmat4(1.0), 1, usage_occlude), floor_at(0.0)},
                       {light}, with(Shading::flat, 1.0));
    double worst = 0.0;
    int soft = 0;
    for (int x = width / 2 + 2; x < width; ++x) {
        const std::size_t i = std::size_t(height / 2) * width + x;
        const double d = Above::floor(i).x / (z * light.radius);  // of the disk, from its middle
        const double hides = d >= 1.0 ? 0.0 : (std::acos(d) - d * std::sqrt(1.0 - d * d)) / glm::pi<double>();
        soft += d < 1.0;
        worst = std::max(worst, std::abs(hidden.pixels[i].r / 0.8 - (1.0 - hides)));
    }
    EXPECT_GT(soft, 30);
    EXPECT_LT(worst, 0.04);
}

TEST(ColorShadows, DarkenInProportionToTheirStrength) {
    Light light = sun({0.4, 0.2, 1.0});
    light.radius = 0.1;
    for (const Shading shading : {Shading::flat, Shading::smooth}) {
        const auto drawn = [&](double shadow) {
            return Above({smooth_ball(32, moved({0, 0, 2})), floor_at(0.0)}, {light}, with(shading, shadow)).pixels;
        };
        const Array<vec4> half = drawn(0.5), full = drawn(1.0), none = drawn(1e-9);
        int darker = 0, off = 0;
        for (std::size_t i = 0; i < half.size(); ++i) {
            off += std::abs(half[i].r - 0.5f * (full[i].r + none[i].r)) > 0.03f;  // where some have more samples
            darker += full[i].r < none[i].r - 0.1f;
        }
        EXPECT_GT(darker, 500);
        EXPECT_LT(off, 30);
    }
}

TEST(ColorShadows, ABallThatNothingHidesFromTheLightHasNone) {
    const Light light = lamp({9, -4, 12}, 100.0f);
    for (const int n : {8, 16, 48}) {
        const Above bare({smooth_ball(n, scaled(dvec3(4.0)))}, {light}, with(Shading::smooth, 0.0));
        const Above shaded({smooth_ball(n, scaled(dvec3(4.0)))}, {light}, with(Shading::smooth, 1.0));
        float worst = 0.0f;
        for (std::size_t i = 0; i < bare.pixels.size(); ++i)
            worst = std::max(worst, std::abs(bare.pixels[i].r - shaded.pixels[i].r));
        EXPECT_LT(worst, 0.03f) << n;
    }
}

TEST(ColorShadows, ALightInAClosedBoxLightsNothingOutside) {
    Light light = lamp({0.2, 0.1, 2.0}, 80.0f);
    light.radius = 0.3;
    const Above seen({place(box(vec3(-1, -1, 1), vec3(1, 1, 3))), floor_at(0.0)}, {light}, with(Shading::flat, 1.0));
    for (const vec4& pixel : seen.pixels) ASSERT_EQ(pixel, vec4(0, 0, 0, 1));
}

TEST(ColorShadows, AreOfLightsThatCastThemAlone) {
    const auto drawn = [](bool casts, double shadow, double blacks) {
        Light light = sun({0.4, 0.2, 1.0});
        light.casts = casts;
        return Above({smooth_ball(32, moved({0, 0, 2})), floor_at(0.0)}, {light}, with(Shading::smooth, shadow, blacks))
            .pixels;
    };
    const Array<vec4> none = drawn(false, 0.0, 0.0);
    EXPECT_EQ(drawn(false, 1.0, 0.0), none);
    EXPECT_NE(drawn(true, 1.0, 0.0), none);
    EXPECT_EQ(drawn(true, 0.0, 0.0), none);
}

TEST(ColorShadows, AreTheSameForAnyNumberOfThreads) {
    Light light{.kind = Light::area, .position = {2, 1, 6}, .direction = {-0.3, -0.1, -1}, .color = vec3(60.0f)};
    light.half_side[0] = {1, 0, 0};
    light.half_side[1] = {0, 0.5, 0};
    const auto drawn = [&] {
        return Above({smooth_ball(24, moved({0, 0, 2})), floor_at(0.0)}, {light, lamp({-3, 2, 5}, 20.0f)},
                     with(Shading::toon, 0.8, 0.1))
            .pixels;
    };
    const Array<vec4> many = drawn();
    tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(std::memcmp(many.data(), drawn().data(), many.size() * sizeof(vec4)), 0);
}

TEST(ColorShadows, SmallSpotsAreOpenAndSmallHolesAreFilled) {
    constexpr int side = 20;
    Array<std::uint8_t> black(side * side, 0);
    const auto fill = [&](int x0, int y0, int x1, int y1, std::uint8_t value) {
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x) black[y * side + x] = value;
    };
    fill(2, 2, 4, 4, 1);      // 4 pixels of black
    fill(8, 2, 16, 10, 1);    // 64
    fill(11, 5, 13, 7, 0);    // a hole of 4 in them
    fill(18, 18, 20, 20, 1);  // 4 at the border, of what may be larger
    const Array<color::Spot> spots = color::small_spots(black, side, 6.0);
    const auto at = [&](int x, int y) { return spots[y * side + x]; };
    EXPECT_EQ(at(2, 3), color::Spot::open);
    EXPECT_EQ(at(1, 1), color::Spot::open) << "beside it";
    EXPECT_EQ(at(12, 6), color::Spot::filled);
    EXPECT_EQ(at(10, 4), color::Spot::filled) << "beside it";
    EXPECT_EQ(at(6, 15), color::Spot::open) << "far from all black";
    for (const auto& [x, y] : {std::pair(8, 2), std::pair(7, 6), std::pair(19, 19), std::pair(17, 17)})
        EXPECT_EQ(at(x, y), color::Spot::as_is) << x << " " << y;
}

TEST(ColorShadows, BlacksOnABallOfFacetsEndWhereThoseOfTheSmoothOneDo) {
    const dvec3 towards = glm::normalize(dvec3(1.0, 0.3, 0.4));
    const Above seen({smooth_ball(32, scaled(dvec3(4.0)))}, {sun(towards)}, with(Shading::flat, 0.0, 0.2));
    const auto full = float(glm::length(towards));  // of the light of a typical place
    int wrong = 0;
    for (std::size_t i = 0; i < seen.pixels.size(); ++i) {
        const dvec2 at = Above::floor(i) / 4.0;
        const double squared = glm::dot(at, at);
        if (squared > 0.9) continue;
        const double tone = glm::dot(dvec3(at, std::sqrt(1.0 - squared)), towards) / full;
        if (std::abs(tone - 0.2) < 0.02) continue;
        wrong += (seen.pixels[i] == vec4(0, 0, 0, 1)) != (tone < 0.2);
    }
    EXPECT_EQ(wrong, 0);
}
