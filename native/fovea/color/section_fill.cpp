// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/color/section_fill.h>

#include <algorithm>

#include <fovea/image/spans.h>

namespace fovea::color {
namespace {

/// Lines per row of pixels. Along a line, coverage is exact.
constexpr int lines_per_row = 16;
static_assert(image::spans_block % lines_per_row == 0, "pixels of a row are added up by one thread");

/// Adds the share of each pixel of a row that is in [begin, end).
void add_coverage(double begin, double end, float weight, std::span<float> row) {
    begin = std::clamp(begin, 0.0, double(row.size()));
    end = std::clamp(end, 0.0, double(row.size()));
    for (auto x = static_cast<std::size_t>(begin); x < end; ++x)
        row[x] += weight * static_cast<float>(std::min(end, x + 1.0) - std::max(begin, double(x)));
}

}  // namespace

void fill_section(In<SectionSide> sides, const View& view, const vec3& color, std::span<vec4> lines) {
    const auto polygon =
        parallel_map<image::Side>(sides.size(), [&](std::size_t i) { return image::Side{sides[i].from, sides[i].to}; });
    Array<float> covered(lines.size(), 0.0f);
    const image::ScanLines scan{0.5 / lines_per_row, 1.0 / lines_per_row, view.height * lines_per_row};
    image::each_span(polygon, scan, [&](int line, double begin, double end) {
        float* const row = &covered[std::size_t(line / lines_per_row) * view.width];
        add_coverage(begin, end, 1.0f / lines_per_row, {row, std::size_t(view.width)});
    });
    parallel_for(lines.size(), [&](std::size_t i) {
        const float share = std::min(covered[i], 1.0f) * (1.0f - lines[i].a);
        lines[i] += vec4(share * color, share);
    });
}

}  // namespace fovea::color
