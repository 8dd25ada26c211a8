// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/stroke/ink.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include <fovea/base/check.h>
#include <fovea/stroke/octaves.h>

namespace fovea::stroke {

namespace {

constexpr float no_ink = 0.1f, full_ink = 0.9f;
constexpr double most_between = 0.15;  // of the columns of dashes that have neither none nor full ink
constexpr double least_gap = 0.05;     // of the columns

/// Box filter from `from` to `to` <= from values: each is the mean over its interval of the line. Value i of line j
/// lies at in[i * step_in + j * line_in].
void shrink(const float* in, int from, float* out, int to, int lines, std::ptrdiff_t step_in, std::ptrdiff_t line_in,
            std::ptrdiff_t step_out, std::ptrdiff_t line_out) {
    const double share = double(from) / to;
    for (int k = 0; k < to; ++k) {
        const double begin = k * share, end = (k + 1) * share;
        for (int line = 0; line < lines; ++line) {
            double sum = 0.0;
            for (int i = int(begin); i < std::min(from, int(std::ceil(end))); ++i)
                sum += in[i * step_in + line * line_in] * (std::min(end, i + 1.0) - std::max(begin, double(i)));
            out[k * step_out + line * line_out] = float(sum / share);
        }
    }
}

int fitted(int size, float px) { return std::isfinite(px) ? int(std::clamp(std::ceil(px), 1.0f, float(size))) : size; }

}  // namespace

std::array<float, 17> ink_levels(const PenTexture& texture) {
    std::array<float, 17> levels{};
    Array<float> ink = texture.ink;
    if (ink.empty()) return levels;
    std::ranges::sort(ink);
    for (std::size_t k = 0; k < levels.size(); ++k) levels[k] = ink[(ink.size() - 1) * k / (levels.size() - 1)];
    return levels;
}

double mean_ink(In<float> ink) { return std::accumulate(ink.begin(), ink.end(), 0.0) / double(ink.size()); }

bool is_dashed(const PenTexture& texture) {
    const In<float> middle = texture.row(texture.height / 2);
    const auto share = [&](const auto& holds) {
        return double(std::ranges::count_if(middle, holds)) / double(middle.size());
    };
    return share([](float v) { return v >= no_ink && v <= full_ink; }) < most_between &&
           share([](float v) { return v < no_ink; }) > least_gap;
}

PenTexture fit_texture(const PenTexture& texture, float length_px, float width_px) {
    check(texture.width > 0 && texture.height > 0 &&
              texture.ink.size() == std::size_t(texture.width) * std::size_t(texture.height),
          "pen texture: expected rows x columns of ink, at least one of each");
    PenTexture narrow{fitted(texture.width, length_px), texture.height, {}};
    narrow.ink.resize(std::size_t(narrow.width) * narrow.height);
    shrink(texture.ink.data(), texture.width, narrow.ink.data(), narrow.width, texture.height, 1, texture.width, 1,
           narrow.width);
    PenTexture result{narrow.width, fitted(texture.height, width_px), {}};
    result.ink.resize(std::size_t(result.width) * result.height);
    shrink(narrow.ink.data(), narrow.height, result.ink.data(), result.height, narrow.width, narrow.width, 1,
           result.width, 1);
    result.dashed = is_dashed(texture);
    return result;
}

std::vector<PenTexture> fit_textures(In<Pen> pens, In<PenTexture> textures) {
    std::vector<PenTexture> fitted;
    for (const Pen& pen : pens) {
        check(pen.texture == none || pen.texture < textures.size(),
              "pen: there is no texture " + std::to_string(pen.texture));
        check(pen.away == none || pen.away < pens.size(),
              "pen: there is no pen " + std::to_string(pen.away) + " out of focus");
        PenTexture& made = fitted.emplace_back();
        if (pen.texture == none) continue;
        made = fit_texture(textures[pen.texture], pen.texture_length_px, pen.width_px);
        if (is_anchored(pen)) made.octaves = octaves_of(made);
    }
    return fitted;
}

PenTable pen_table(In<Pen> pens, In<PenTexture> textures) {
    PenTable table;
    const std::vector<PenTexture> inks = fit_textures(pens, textures);
    for (Index i = 0; i < pens.size(); ++i) {
        const Pen& pen = pens[i];
        const PenTexture& fitted = inks[i];
        table.pens.push_back(vec4(vec3(pen.look.color), float(pen.away == none ? i : pen.away)));
        table.pens.push_back(vec4(pen.texture_length_px, pen.look.cap == Cap::round ? 1.0f : 0.0f,
                                  float(table.ink.size()), is_anchored(pen) ? 1.0f : 0.0f));
        table.pens.push_back(vec4(fitted.width, fitted.height, fitted.dashed ? 1.0f : 0.0f, 0.0f));
        table.pens.push_back(vec4(vec3(pen.look.second_color), 0.0f));
        table.ink.insert(table.ink.end(), fitted.ink.begin(), fitted.ink.end());
        table.ink.insert(table.ink.end(), fitted.octaves.begin(), fitted.octaves.end());
    }
    return table;
}

}  // namespace fovea::stroke
