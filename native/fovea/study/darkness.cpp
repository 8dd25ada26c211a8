// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/darkness.h>

#include <algorithm>
#include <array>

#include <fovea/base/parallel.h>
#include <fovea/color/srgb.h>
#include <fovea/study/scan.h>

namespace fovea::study {

Darkness darkness_of(const color::GrayImage& picture, bool of_light) {
    const auto light = [&](int value) {
        const float share = float(value) / 255.0f;
        return of_light ? color::from_srgb(share) : share;
    };
    const float paper = light(paper_of(picture)), most = paper_of(picture) < dark_paper ? 1.0f - paper : -paper;
    std::array<float, 256> table{};
    for (int value = 0; value < 256; ++value) table[std::size_t(value)] = std::max(0.0f, (light(value) - paper) / most);
    return {picture.width, picture.height,
            parallel_map<float>(picture.values.size(), [&](std::size_t i) { return table[picture.values[i]]; })};
}

}  // namespace fovea::study
