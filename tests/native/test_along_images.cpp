// SPDX-License-Identifier: GPL-3.0-or-later
// Images along lines, and images as files.
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

#include <fovea/color/map.h>
#include <fovea/color/png.h>
#include <fovea/focus/focus.h>

#include "drawing.h"
#include "system_files.h"

namespace fovea {
using namespace draw;

using namespace drawing;

TEST(MapOfSamples, LiesOverTheFrameAndGoesOnBeyondIt) {
    View view = perspective({0, -12, 3}, dvec3(0), 36, 96, 64);
    view.frame = {0, 0, view.width, view.height};
    const Drawing drawn({place(meshes::box(), moved({-2, 0, 0}), 1), place(meshes::box(), moved({2, 0, 0}), 2)}, view,
                        {line_set({"crease"})});
    const ColorTexture halves(std::vector<float>{0.0f, 1.0f}, 2, 1, 1, false);  // black on the left, white on the right
    const ClippedPaths& clipped = drawn.clipped;
    const Array<float> found = map_of_samples(clipped, drawn.view, halves);
    ASSERT_EQ(found.size(), clipped.samples);
    ASSERT_GT(found.size(), 100u);
    for (std::size_t i = 0; i < clipped.px.size(); ++i)
        for (Index j = 0; j < clipped.sample_count[i]; ++j) {
            const float share = (float(j) + 0.5f) / float(clipped.sample_count[i]);
            const float x = glm::mix(clipped.px[i].x, clipped.px[i + 1].x, share);
            EXPECT_NEAR(found[clipped.sample_start[i] + j], glm::clamp(2.0f * x / 96.0f - 0.5f, 0.0f, 1.0f), 5e-3f);
        }
}

TEST(ValuesOfSamples, ThereIsOneForEachPointOfThePaths) {
    const Drawing drawn({place(meshes::box())}, perspective({4, -5, 3}, dvec3(0)), {line_set({"crease"})});
    EXPECT_THROW((void)values_of_samples(drawn.clipped, std::vector<float>{1, 2, 3}), std::invalid_argument);
}

TEST(Png, APictureComesBackAsATextureThatBeginsWithTheTopRow) {
    constexpr int width = 7, height = 5;
    std::vector<std::uint8_t> rgb;
    for (int i = 0; i < width * height; ++i) rgb.insert(rgb.end(), 3, std::uint8_t(7 * i));
    const auto path = own_path("png");
    std::ofstream(path, std::ios::binary) << png_bytes(rgb, width, height);
    const PenTexture read = read_texture(path);
    std::filesystem::remove(path);
    ASSERT_EQ(read.width, width);
    ASSERT_EQ(read.height, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            EXPECT_NEAR(255.0f * read.ink[y * width + x], 7.0f * float((height - 1 - y) * width + x), 1.01f);
}

}  // namespace fovea
