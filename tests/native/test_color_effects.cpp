// SPDX-License-Identifier: GPL-3.0-or-later
// The color effects against plain formulas, and what focus asks of them: nothing bleeds, nothing is lost.
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <random>

#include <fovea/color/effects.h>

namespace fovea {
using namespace draw;
namespace {

constexpr int width = 37, height = 23;
constexpr vec3 luminance(0.2126f, 0.7152f, 0.0722f);

struct ColorEffects : testing::Test {
    Array<vec4> image;     ///< premultiplied
    Array<float> amounts;  ///< a seventh of them 0, another 1

    ColorEffects() {
        std::mt19937 random(3);
        std::uniform_real_distribution<float> share(0.0f, 1.0f);
        for (int i = 0; i < width * height; ++i) {
            const float alpha = share(random);
            image.push_back(vec4(alpha * vec3(share(random), share(random), share(random)), alpha));
            amounts.push_back(glm::clamp(1.4f * share(random) - 0.2f, 0.0f, 1.0f));
        }
    }

    Array<float> scaled(float by) const {
        Array<float> result = amounts;
        for (float& amount : result) amount *= by;
        return result;
    }
    static Array<vec4> desaturated(Array<vec4> image, In<float> amount) { return desaturate(image, amount), image; }
    static Array<vec4> faded(Array<vec4> image, In<float> amount, std::optional<vec3> color = {}) {
        return fade(image, amount, color), image;
    }
    static Array<vec4> blurred(Array<vec4> image, In<float> radius, int columns = width) {
        return blur(image, columns, radius), image;
    }
};

bool same(const vec4& a, const vec4& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

/// Solves n equations by elimination; `matrix` row by row.
std::vector<double> solved(std::vector<double> matrix, std::vector<double> right) {
    const std::size_t n = right.size();
    for (std::size_t k = 0; k < n; ++k)
        for (std::size_t i = k + 1; i < n; ++i) {
            const double factor = matrix[i * n + k] / matrix[k * n + k];
            for (std::size_t j = k; j < n; ++j) matrix[i * n + j] -= factor * matrix[k * n + j];
            right[i] -= factor * right[k];
        }
    for (std::size_t k = n; k-- > 0;) {
        for (std::size_t j = k + 1; j < n; ++j) right[k] -= matrix[k * n + j] * right[j];
        right[k] /= matrix[k * n + k];
    }
    return right;
}

/// One step of implicit diffusion of a channel along a row or a column of `count` pixels, `stride` apart.
void diffuse(std::vector<double>& channel, In<float> radius, std::size_t first, std::size_t stride, std::size_t count) {
    std::vector<double> matrix(count * count, 0.0), values(count);
    const auto strength = [&](std::size_t i) { return std::pow(double(radius[first + i * stride]), 2.0) / 16.0; };
    for (std::size_t i = 0; i < count; ++i) {
        values[i] = channel[first + i * stride];
        matrix[i * count + i] += 1.0;
        if (i + 1 == count) break;
        const double flow = std::min(strength(i), strength(i + 1));
        matrix[i * count + i] += flow;
        matrix[(i + 1) * count + i + 1] += flow;
        matrix[i * count + i + 1] = matrix[(i + 1) * count + i] = -flow;
    }
    values = solved(std::move(matrix), std::move(values));
    for (std::size_t i = 0; i < count; ++i) channel[first + i * stride] = values[i];
}

/// Rows, then columns, twice.
std::vector<double> diffused(std::vector<double> channel, In<float> radius) {
    for (int round = 0; round < 2; ++round) {
        for (std::size_t y = 0; y < height; ++y) diffuse(channel, radius, y * width, 1, width);
        for (std::size_t x = 0; x < width; ++x) diffuse(channel, radius, x, width, height);
    }
    return channel;
}

TEST_F(ColorEffects, DesaturatingLeadsToTheGrayOfTheSameLuminance) {
    const Array<vec4> result = desaturated(image, amounts);
    for (std::size_t i = 0; i < image.size(); ++i) {
        const vec3 color(image[i]), gray(glm::dot(color, luminance));
        EXPECT_LT(glm::length(vec3(result[i]) - glm::mix(color, gray, amounts[i])), 2e-6f);
        EXPECT_NEAR(glm::dot(vec3(result[i]), luminance), gray.x, 1e-6f);
        EXPECT_EQ(result[i].a, image[i].a);
    }
}

TEST_F(ColorEffects, FadingLeadsToNothingOrToAColorUnderTheSameAlpha) {
    const vec3 color(0.9f, 0.5f, 0.1f);
    const Array<vec4> nothing = faded(image, amounts), towards = faded(image, amounts, color);
    for (std::size_t i = 0; i < image.size(); ++i) {
        EXPECT_LT(glm::length(nothing[i] - image[i] * (1.0f - amounts[i])), 2e-6f);
        const vec3 expected = glm::mix(vec3(image[i]), color * image[i].a, amounts[i]);
        EXPECT_LT(glm::length(vec3(towards[i]) - expected), 2e-6f);
        EXPECT_EQ(towards[i].a, image[i].a);
    }
}

TEST_F(ColorEffects, BlurIsImplicitDiffusion) {
    for (const float most : {1.5f, 6.0f, 40.0f}) {
        const Array<float> radius = scaled(most);
        const Array<vec4> result = blurred(image, radius);
        for (int c = 0; c < 4; ++c) {
            std::vector<double> channel;
            for (const vec4& pixel : image) channel.push_back(pixel[c]);
            const std::vector<double> expected = diffused(std::move(channel), radius);
            for (std::size_t i = 0; i < result.size(); ++i) ASSERT_NEAR(result[i][c], expected[i], 3e-5) << most;
        }
    }
}

TEST_F(ColorEffects, WhereTheAmountIsNothingPixelsStayBitForBit) {
    const Array<float> none(image.size(), 0.0f);
    Array<float> some = amounts, radius = scaled(9.0f);
    for (std::size_t i = 0; i < some.size(); ++i)
        if (some[i] <= 0.5f) some[i] = radius[i] = 0.0f;
    const std::pair<Array<vec4>, Array<vec4>> effects[] = {{desaturated(image, none), desaturated(image, some)},
                                                           {faded(image, none), faded(image, some)},
                                                           {faded(image, none, vec3(1, 0, 0)), faded(image, some)},
                                                           {blurred(image, none), blurred(image, radius)}};
    for (const auto& [unchanged, partly] : effects) {
        std::size_t changed = 0;
        for (std::size_t i = 0; i < image.size(); ++i) {
            ASSERT_TRUE(same(unchanged[i], image[i]));
            if (some[i] == 0.0f)
                ASSERT_TRUE(same(partly[i], image[i]));
            else
                changed += !same(partly[i], image[i]);
        }
        EXPECT_GT(changed, 100u);
    }
}

TEST_F(ColorEffects, BlurKeepsTheSumAndWhatIsEven) {
    const Array<vec4> result = blurred(image, scaled(12.0f));
    glm::dvec4 before(0.0), after(0.0);
    for (std::size_t i = 0; i < image.size(); ++i) {
        before += image[i];
        after += result[i];
        for (int c = 0; c < 4; ++c) EXPECT_TRUE(result[i][c] >= 0.0f && result[i][c] <= 1.0f + 1e-6f);
    }
    EXPECT_LT(glm::length(after - before), 1e-5 * glm::length(before));
    for (const vec4& pixel : blurred(Array<vec4>(image.size(), vec4(0.4f)), scaled(30.0f)))
        EXPECT_LT(glm::length(pixel - vec4(0.4f)), 2e-5f);
}

TEST_F(ColorEffects, WhatIsInFocusBleedsNowhere) {
    constexpr int side = 64;
    const auto sharp = [](int i) { return i % side >= 20 && i % side < 40 && i / side >= 20 && i / side < 40; };
    Array<vec4> red_on_blue(side * side, vec4(0, 0, 0.2f, 1));
    Array<float> radius(side * side, 10.0f);
    for (int i = 0; i < side * side; ++i)
        if (sharp(i)) {
            red_on_blue[i] = vec4(1, 0, 0, 1);
            radius[i] = 0.0f;
        }
    const Array<vec4> result = blurred(red_on_blue, radius, side);
    for (int i = 0; i < side * side; ++i) {
        EXPECT_TRUE(!sharp(i) || same(result[i], red_on_blue[i]));
        EXPECT_EQ(result[i].r > 0.0f, sharp(i));
        EXPECT_NEAR(result[i].b, sharp(i) ? 0.0f : 0.2f, 1e-6f);
    }
}

TEST_F(ColorEffects, APointSpreadsAsWideAsItsDiscAndEvenly) {
    constexpr int side = 129, middle = side / 2;
    for (const double radius : {4.0, 12.0}) {
        Array<vec4> point(side * side, vec4(0.0f));
        point[middle * side + middle] = vec4(1.0f);
        const Array<vec4> spread = blurred(point, Array<float>(side * side, float(radius)), side);
        double sum = 0.0, across = 0.0, up = 0.0;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const double here = spread[y * side + x].r;
                sum += here;
                across += here * (x - middle) * (x - middle);
                up += here * (y - middle) * (y - middle);
                EXPECT_NEAR(here, spread[x * side + y].r, 1e-6);
                EXPECT_NEAR(here, spread[(side - 1 - y) * side + side - 1 - x].r, 1e-6);
            }
        EXPECT_NEAR(sum, 1.0, 1e-4);
        // The variance of a disc along an axis.
        EXPECT_NEAR(across, radius * radius / 4.0, 0.02 * radius * radius / 4.0);
        EXPECT_NEAR(up, radius * radius / 4.0, 0.02 * radius * radius / 4.0);
    }
}

TEST_F(ColorEffects, WhatIsNoNumberStaysAlone) {
    const std::size_t bad_pixel = 11 * width + 17, bad_amount = 3 * width + 4;
    const Array<float> radius(image.size(), 8.0f);
    const Array<vec4> clean = blurred(image, radius);
    amounts[bad_amount] = std::numeric_limits<float>::quiet_NaN();
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        Array<vec4> broken = image;
        broken[bad_pixel] = vec4(bad);
        const Array<vec4> result = blurred(broken, radius);
        for (std::size_t i = 0; i < result.size(); ++i)
            ASSERT_TRUE(i == bad_pixel || std::isfinite(result[i].r + result[i].g + result[i].b + result[i].a));
        EXPECT_LT(glm::length(result[0] - clean[0]), 0.05f);
        for (const auto& each : {desaturated(broken, amounts), faded(broken, amounts), blurred(broken, amounts)})
            EXPECT_TRUE(same(each[bad_amount], broken[bad_amount]));
    }
}

TEST_F(ColorEffects, SizesThatDoNotFitAreRefused) {
    const Array<float> few(image.size() - 1, 0.5f);
    EXPECT_THROW(desaturated(image, few), std::invalid_argument);
    EXPECT_THROW(faded(image, few), std::invalid_argument);
    EXPECT_THROW(blurred(image, few), std::invalid_argument);
}

}  // namespace
}  // namespace fovea
