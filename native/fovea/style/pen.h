// SPDX-License-Identifier: GPL-3.0-or-later
// Pens: appearance of strokes.
#pragma once

#include <string>

#include <fovea/base/types.h>
#include <fovea/style/field.h>

namespace fovea::style {

enum class Cap : std::uint8_t { round, butt };
template <>
inline constexpr Choice choices_of<Cap>[] = {
    {"round", "Round", "Half a disc beyond each end"},
    {"butt", "Butt", "Cut off straight at each end"},
};

enum class WidthUnit : std::uint8_t { reference, pixels, millimetres };
template <>
inline constexpr Choice choices_of<WidthUnit>[] = {
    {"reference", "Reference Pixels", "Pixels of an image 1080 pixels high: alike at any resolution"},
    {"pixels", "Pixels", "Pixels of the image, however large it is"},
    {"millimetres", "Millimeters", "Millimeters on a page as high as the paper says"},
};

/// What a pen's texture is fixed to when a stroke's size in the image changes. screen: one repetition keeps its length
/// in the image. path: the texture keeps its places on the path and repeats by octaves (powers of two); dashes turn
/// gray while octaves blend.
enum class Anchor : std::uint8_t { screen, path };
template <>
inline constexpr Choice choices_of<Anchor>[] = {
    {"screen", "Screen", "One repetition is always as long in the image, and slides along lines that grow"},
    {"path", "Path", "It stays where it is along lines, and divides as they grow: for grain, not for dashes"},
};

struct Pen {
    dvec3 color{0.0};
    double opacity = 1.0;
    double width = 2.0;
    std::string texture = "solid";
    double length_scale = 1.0;
    Cap cap = Cap::round;
    double taper = 0.0;
    double strength_width = 0.0;
    double wobble = 0.0;
    double wobble_length = 60.0;
    double seed = 0.0;
    double pressure = 0.0;
    double spacing = 6.0;
    WidthUnit width_unit = WidthUnit::reference;
    Anchor texture_anchor = Anchor::screen;

    bool operator==(const Pen&) const = default;

    static constexpr const char *ink = "ink", *breadth = "breadth", *grain = "grain", *ends = "ends", *hand = "hand";
    static constexpr std::tuple fields{
        Field{"color", &Pen::color, "Color", "Color of the strokes", light, ink},
        Field{"opacity", &Pen::opacity, "Opacity", "How much of what lies below the strokes cover", share, ink},
        Field{"width", &Pen::width, "Width", "Width of the strokes, by default in pixels of an image 1080 pixels high",
              number(0.01, 1000.0, 20.0), breadth},
        Field{"texture", &Pen::texture, "Texture", "Ink of the strokes, repeated along them", naming(Names::texture),
              grain},
        Field{"length_scale", &Pen::length_scale, "Texture Scale", "Stretches the texture along the strokes",
              number(0.01, 100.0, 10.0), grain},
        Field{"cap", &Pen::cap, "Caps", "Shape of the ends of the strokes", {}, ends},
        Field{"taper", &Pen::taper, "Taper", "Length of the thinning ends of the strokes", reference(10000.0, 200.0),
              ends},
        Field{"strength_width", &Pen::strength_width, "Fade by Thinning", "How far weak lines are thin instead of pale",
              share, breadth},
        Field{"wobble", &Pen::wobble, "Wobble", "How far the strokes stray from their lines", reference(100.0, 10.0),
              hand},
        Field{"wobble_length", &Pen::wobble_length, "Wavelength", "Length of the waves in which strokes stray",
              reference(2000.0, 300.0, 2.0), hand},
        Field{"seed", &Pen::seed, "Seed", "Another number is another hand", {0.0, 1e6, 100.0, Unit::seed}, hand},
        Field{"pressure", &Pen::pressure, "Pressure", "How much thinner strokes are at their ends than in the middle",
              share, breadth},
        Field{"spacing", &Pen::spacing, "Min Distance", "How near to each other lines may be where Line Thinning is on",
              reference(200.0, 60.0)},
        Field{"width_unit", &Pen::width_unit, "Unit", "What the width of the strokes is measured in", {}, breadth},
        Field{"texture_anchor",
              &Pen::texture_anchor,
              "Texture Fixed To",
              "What the texture is fixed to when strokes grow in the image",
              {},
              grain}};
};

}  // namespace fovea::style
