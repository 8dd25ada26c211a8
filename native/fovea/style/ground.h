// SPDX-License-Identifier: GPL-3.0-or-later
// Paper, color layer and the inside of sections, drawn under the lines.
#pragma once

#include <optional>
#include <string>

#include <fovea/base/types.h>
#include <fovea/base/view.h>
#include <fovea/style/field.h>

namespace fovea::style {

struct Paper {
    dvec3 color{1.0};
    bool transparent = false;
    std::string texture = "none";  ///< "none": smooth
    double scale = 1.0;            ///< of the texture; 1: its own size in millimeters
    double tooth = 0.0;
    double granulation = 0.0;
    double tint = 0.0;
    double height_mm = 210.0;  ///< default: A4 landscape

    bool operator==(const Paper&) const = default;
    /// `reference_scale`: image pixels per reference pixel.
    double px_per_mm(double reference_scale) const { return reference_height * reference_scale / height_mm; }

    static constexpr auto fields = each_of(
        Field{"color", &Paper::color, "Color", "Color of the paper", light},
        Field{"transparent", &Paper::transparent, "Transparent", "The picture has no paper, only what is drawn on it"},
        Field{"texture", &Paper::texture, "Surface", "Height of the paper, which ink and color heed",
              naming(Names::paper)},
        Field{"scale", &Paper::scale, "Grain Size",
              "Size of the paper's grain; 1: as large as on real paper, on a page of this height",
              number(0.1, 20.0, 5.0)},
        Field{"tooth", &Paper::tooth, "Tooth", "How far ink stays off the valleys of the paper", share},
        Field{"granulation", &Paper::granulation, "Granulation", "How far color settles in the valleys of the paper",
              share},
        Field{"tint", &Paper::tint, "Relief", "How far the paper's own relief shades the picture", share},
        Field{"height_mm",
              &Paper::height_mm,
              "Page Height",
              "Height of the page, for pens measured in millimeters and the size of the paper's grain",
              {10.0, 10000.0, 1000.0, Unit::millimeters}});
};

enum class Shading : std::uint8_t { plain, flat, smooth, toon };
template <>
inline constexpr Choice choices_of<Shading>[] = {
    {"plain", "Paper", "No colors: the paper alone lies under the lines"},
    {"flat", "Flat", "Base colors of the materials"},
    {"smooth", "Smooth", "Lit by the scene's lights, or by one at the camera"},
    {"toon", "Toon", "Lit in bands"},
};

struct Color {
    Shading shading = Shading::plain;
    int bands = 3;
    double opacity = 1.0;
    double desaturation = 0.0;  ///< in addition to that of focus
    double shadow = 0.0;
    double blacks = 0.0;
    dvec3 black_color{0.0};
    double edge_darkening = 0.0;
    double backruns = 0.0;
    std::optional<dvec3> background;  ///< color behind the layer; unset: the paper

    bool operator==(const Color&) const = default;

    static constexpr auto fields = each_of(
        Field{"shading", &Color::shading, "Shading", "What colors lie under the lines"},
        Field{"bands", &Color::bands, "Bands", "Number of tones of toon shading", number(2, 16, 16)},
        Field{"opacity", &Color::opacity, "Opacity", "How much of the paper the colors cover", share},
        Field{"desaturation", &Color::desaturation, "Desaturation", "How gray colors are everywhere", share},
        Field{"shadow", &Color::shadow, "Shadow",
              "How much of the light of those lights is gone that do not reach a place", share},
        Field{"blacks", &Color::blacks, "Blacks",
              "Tone below which colors are filled with black: 1 is full light, 0 is none, by lights and their shadows",
              share},
        Field{"black_color", &Color::black_color, "Black Color", "Color of what is filled with black", light},
        Field{"edge_darkening", &Color::edge_darkening, "Edge Darkening",
              "How much darker washes dry along their edges, where the water carries their pigment", share},
        Field{"backruns", &Color::backruns, "Backruns",
              "How unevenly washes dry, in flows and in blooms with dark rims", share},
        Field{"background", &Color::background, "Background", "Color behind everything, towards which colors fade",
              light});
};

/// The inside of what the scene's section plane cuts.
struct Section {
    bool filled = false;
    dvec3 color{0.0};

    bool operator==(const Section&) const = default;

    static constexpr auto fields = each_of(
        Field{"filled", &Section::filled, "Fill", "The inside of what the section plane cuts is filled (poche)"},
        Field{"color", &Section::color, "Fill Color", "Color of the inside of what the section plane cuts", light});
};

}  // namespace fovea::style
