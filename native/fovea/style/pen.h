// SPDX-License-Identifier: GPL-3.0-or-later
// Pens: appearance of strokes.
#pragma once

#include <string>

#include <fovea/style/paint.h>
#include <fovea/style/transfer.h>

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
/// in the image. path: the texture keeps its places on the path and repeats by octaves (powers of two).
enum class Anchor : std::uint8_t { screen, path };
template <>
inline constexpr Choice choices_of<Anchor>[] = {
    {"screen", "Screen", "One repetition is always as long in the image, and slides along lines that grow"},
    {"path", "Path", "It stays where it is along lines, and divides as they grow"},
};

struct Pen {
    dvec3 color{0.0};
    double opacity = 1.0;
    double width = 2.0;
    std::string texture = "solid";
    double length_scale = 1.0;
    Cap cap = Cap::round;
    double taper = 0.0;
    double written = 1.0;
    double strength_width = 0.0;
    double wobble = 0.0;
    double wobble_length = 60.0;
    double seed = 0.0;
    double pressure = 0.0;
    double spacing = 6.0;
    WidthUnit width_unit = WidthUnit::reference;
    Anchor texture_anchor = Anchor::screen;
    /// Modifiers along a stroke (stroke/along.h): how far each cause takes away width and opacity, and how far it mixes
    /// the color with the second one.
    dvec3 second_color{0.5};
    Transfer along_width = off(), along_opacity = off(), along_color = off();
    double nib_angle = 45.0;
    double nib_width = 0.0, nib_opacity = 0.0, nib_color = 0.0;
    double distance_near = 0.0, distance_far = 100.0;
    double distance_width = 0.0, distance_opacity = 0.0, distance_color = 0.0;
    double noise_length = 10.0;
    double noise_width = 0.0, noise_opacity = 0.0, noise_color = 0.0;
    /// What is painted on surfaces: width and opacity are multiplied by it, the color is replaced.
    PaintSource paint_width = PaintSource::constant, paint_opacity = PaintSource::constant,
                paint_color = PaintSource::constant;
    std::string paint_width_name, paint_opacity_name, paint_color_name;

    bool operator==(const Pen&) const = default;

    static constexpr const char *ink = "ink", *breadth = "breadth", *grain = "grain", *ends = "ends", *hand = "hand",
                                *along = "along", *nib = "nib", *distance = "distance", *noise = "noise",
                                *paint = "paint";
    static constexpr auto fields = each_of(
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
        Field{"written", &Pen::written, "Written", "How much of each line is drawn, from its start", share, ends},
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
              "What the texture, the hand's wobble and noise are fixed to when strokes grow in the image",
              {},
              grain},
        Field{"second_color", &Pen::second_color, "Second Color",
              "Color that strokes change to along their length, by their direction, by distance and by noise", light,
              along},
        Field{"along_width", &Pen::along_width, "Width", "", {}, along},
        Field{"along_opacity", &Pen::along_opacity, "Opacity", "", {}, along},
        Field{"along_color", &Pen::along_color, "Color", "", {}, along},
        Field{"nib_angle",
              &Pen::nib_angle,
              "Orientation",
              "Angle of a broad nib, counterclockwise from the horizontal: strokes in its direction are its thin ones",
              {0.0, 180.0, 180.0, Unit::degrees},
              nib},
        Field{"nib_width", &Pen::nib_width, "Width",
              "How much thinner strokes are in the direction of the nib than across it", share, nib},
        Field{"nib_opacity", &Pen::nib_opacity, "Opacity",
              "How much fainter strokes are in the direction of the nib than across it", share, nib},
        Field{"nib_color", &Pen::nib_color, "Color",
              "How much of the second color strokes have in the direction of the nib", share, nib},
        Field{"distance_near", &Pen::distance_near, "Near", "Distance from the camera at which strokes begin to change",
              distances, distance},
        Field{"distance_far", &Pen::distance_far, "Far",
              "Distance from the camera at which strokes have changed; less than near turns it around", distances,
              distance},
        Field{"distance_width", &Pen::distance_width, "Width", "How much thinner strokes are there", share, distance},
        Field{"distance_opacity", &Pen::distance_opacity, "Opacity", "How much fainter strokes are there", share,
              distance},
        Field{"distance_color", &Pen::distance_color, "Color", "How much of the second color strokes have there", share,
              distance},
        Field{"noise_length",
              &Pen::noise_length,
              "Scale",
              "Length of the waves of the noise along strokes, on a page as high as the paper says",
              {0.1, 1000.0, 100.0, Unit::millimeters},
              noise},
        Field{"noise_width", &Pen::noise_width, "Width", "How much thinner noise makes strokes at most", share, noise},
        Field{"noise_opacity", &Pen::noise_opacity, "Opacity", "How much fainter noise makes strokes at most", share,
              noise},
        Field{"noise_color", &Pen::noise_color, "Color", "How much of the second color noise gives strokes at most",
              share, noise},
        Field{"paint_width",
              &Pen::paint_width,
              "Width",
              "Where on surfaces it is read how wide strokes are: 1 or white as the pen says, 0 or black not at all",
              {},
              paint},
        Field{"paint_width_name", &Pen::paint_width_name, "Name", "Name of the vertex group or attribute",
              naming(Names::attribute), paint},
        Field{"paint_opacity",
              &Pen::paint_opacity,
              "Opacity",
              "Where on surfaces it is read how opaque strokes are: 1 or white as the pen says, 0 or black not at all",
              {},
              paint},
        Field{"paint_opacity_name", &Pen::paint_opacity_name, "Name", "Name of the vertex group or attribute",
              naming(Names::attribute), paint},
        Field{"paint_color",
              &Pen::paint_color,
              "Color",
              "Where on surfaces the color of strokes is read, in place of the pen's",
              {},
              paint},
        Field{"paint_color_name", &Pen::paint_color_name, "Name", "Name of the vertex group or attribute",
              naming(Names::attribute), paint});
};

}  // namespace fovea::style
