// SPDX-License-Identifier: GPL-3.0-or-later
// A style: the paper, the layers under the lines, and an ordered list of line sets with their pens. Lengths are in
// reference pixels (image height / 1080), colors scene-linear.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fovea/base/types.h>
#include <fovea/style/field.h>

namespace fovea::style {

/// Where a pen's texture stays in zooms. On the screen: one repetition is as long as the pen says, and slides along the
/// path; on the path: it keeps its places there, in octaves: for grain; dashes turn gray while they divide.
enum class Anchor : std::uint8_t { screen, path };
template <>
inline constexpr const char* names_of<Anchor>[] = {"screen", "path", nullptr};

enum class Cap : std::uint8_t { butt, round };
template <>
inline constexpr const char* names_of<Cap>[] = {"butt", "round", nullptr};

/// What the width of a pen is measured in: reference pixels, pixels of the image, or millimeters on the style's paper.
enum class WidthUnit : std::uint8_t { reference, pixels, millimetres };
template <>
inline constexpr const char* names_of<WidthUnit>[] = {"reference", "pixels", "millimetres", nullptr};

/// Whether lines or colors answer to focus: as it says, as at one value of it everywhere, or not drawn at all.
enum class Mode : std::uint8_t { emphasized, uniform, none };
template <>
inline constexpr const char* names_of<Mode>[] = {"emphasized", "uniform", "none", nullptr};

/// What the colors under the lines are: none, base colors, lit, lit in bands.
enum class Shading : std::uint8_t { plain, flat, smooth, toon };
template <>
inline constexpr const char* names_of<Shading>[] = {"plain", "flat", "smooth", "toon", nullptr};

/// Where the places to look at lie.
enum class FocusModel : std::uint8_t { none, image, scene, object, painted };
template <>
inline constexpr const char* names_of<FocusModel>[] = {"none", "image", "scene", "object", "painted", nullptr};

/// What several places make together: the nearest counts, or they add up.
enum class Combine : std::uint8_t { nearest, sum };
template <>
inline constexpr const char* names_of<Combine>[] = {"nearest", "sum", nullptr};

/// How a stroke looks.
struct Pen {
    dvec3 color{0.0};
    double opacity = 1.0;
    double width = 2.0;
    std::string texture = "solid";  ///< the name of one that ships
    double length_scale = 1.0;      ///< stretches the texture along the stroke
    Cap cap = Cap::round;
    double taper = 0.0;           ///< length of the thinning ends
    double strength_width = 0.0;  ///< how far weak lines are thin instead of pale
    double wobble = 0.0;          ///< how far the pen strays from its line,
    double wobble_length = 60.0;  ///< in waves of this length,
    double seed = 0.0;            ///< and the number of that hand
    double pressure = 0.0;        ///< how much thinner strokes are at their ends than in the middle
    double spacing = 6.0;         ///< how near two lines that go alongside may be where elision thins them
    WidthUnit width_unit = WidthUnit::reference;
    Anchor texture_anchor = Anchor::screen;

    static constexpr std::tuple fields{Field{"color", &Pen::color},
                                       Field{"opacity", &Pen::opacity},
                                       Field{"width", &Pen::width},
                                       Field{"texture", &Pen::texture},
                                       Field{"length_scale", &Pen::length_scale},
                                       Field{"cap", &Pen::cap},
                                       Field{"taper", &Pen::taper},
                                       Field{"strength_width", &Pen::strength_width},
                                       Field{"wobble", &Pen::wobble},
                                       Field{"wobble_length", &Pen::wobble_length},
                                       Field{"seed", &Pen::seed},
                                       Field{"pressure", &Pen::pressure},
                                       Field{"spacing", &Pen::spacing},
                                       Field{"width_unit", &Pen::width_unit},
                                       Field{"texture_anchor", &Pen::texture_anchor}};
};

/// How the parts of lines are drawn that at least `first` and at most `last` surfaces hide (none: any number).
struct Hidden {
    int first = 1;
    std::optional<int> last;
    Pen pen;
    std::optional<Pen> pen_away;  ///< out of focus; none: as in focus

    static constexpr std::tuple fields{Field{"from", &Hidden::first}, Field{"to", &Hidden::last},
                                       Field{"pen", &Hidden::pen}, Field{"pen_away", &Hidden::pen_away}};
};

/// Parameters of a line definition by their names.
using Parameters = std::map<std::string, double>;

/// Lines drawn alike. An edge goes to the first set of the style that has a line for it.
struct LineSet {
    std::string name = "lines";
    std::vector<std::pair<std::string, Parameters>> kinds;  ///< by the names of the definitions, in order
    std::string collection;                                 ///< of Blender: only its objects; none: all
    bool outside = false;                                   ///< only what is not in it
    std::string object;                                     ///< of Blender: only it and its instances; none: all
    bool other_objects = false;                             ///< only what is not it
    std::string material;                                   ///< of Blender: only faces of it; none: all
    bool other_materials = false;                           ///< only faces of others
    double corner_angle = 60.0;                             ///< degrees of turn at which a path is split
    double least_length = 30.0;            ///< shorter lines with an end that touches no other are left out
    double overshoot = 0.0;                ///< lines go on so far beyond their ends, where nothing hides these
    double halo = 0.0;                     ///< gap where visible parts pass behind others
    std::optional<double> overshoot_away;  ///< the same as overshoot, out of focus; none: as in focus
    Pen pen;                               ///< of visible parts
    std::optional<Pen> pen_away;           ///< of visible parts out of focus; none: as in focus
    std::vector<Hidden> hidden;            ///< ranges that do not overlap; parts in none of them are not drawn

    static constexpr std::tuple fields{Field{"name", &LineSet::name},
                                       Field{"kinds", &LineSet::kinds},
                                       Field{"collection", &LineSet::collection},
                                       Field{"outside", &LineSet::outside},
                                       Field{"object", &LineSet::object},
                                       Field{"other_objects", &LineSet::other_objects},
                                       Field{"material", &LineSet::material},
                                       Field{"other_materials", &LineSet::other_materials},
                                       Field{"corner_angle", &LineSet::corner_angle},
                                       Field{"least_length", &LineSet::least_length},
                                       Field{"overshoot", &LineSet::overshoot},
                                       Field{"halo", &LineSet::halo},
                                       Field{"overshoot_away", &LineSet::overshoot_away},
                                       Field{"pen", &LineSet::pen},
                                       Field{"pen_away", &LineSet::pen_away},
                                       Field{"hidden", &LineSet::hidden}};
};

struct Paper {
    dvec3 color{1.0};
    bool transparent = false;
    std::string texture = "none";  ///< the name of one that ships; none: smooth
    double scale = 1.0;            ///< reference pixels that a texel of the texture covers
    double tooth = 0.0;            ///< how far thin ink stays on the heights of the paper
    double granulation = 0.0;      ///< how much more pigment of the color layer its valleys take
    double tint = 0.0;             ///< how much its relief shades the whole picture
    double height_mm = 210.0;      ///< of the page, for pens measured in millimeters

    static constexpr std::tuple fields{Field{"color", &Paper::color},     Field{"transparent", &Paper::transparent},
                                       Field{"texture", &Paper::texture}, Field{"scale", &Paper::scale},
                                       Field{"tooth", &Paper::tooth},     Field{"granulation", &Paper::granulation},
                                       Field{"tint", &Paper::tint},       Field{"height_mm", &Paper::height_mm}};
};

/// The scene's surfaces in color, under the lines.
struct Color {
    Shading shading = Shading::plain;
    int bands = 3;  ///< of toon shading
    double opacity = 1.0;
    double desaturation = 0.0;        ///< everywhere, besides what focus does
    std::optional<dvec3> background;  ///< painted under the layer; none: the paper shows

    static constexpr std::tuple fields{Field{"shading", &Color::shading}, Field{"bands", &Color::bands},
                                       Field{"opacity", &Color::opacity}, Field{"desaturation", &Color::desaturation},
                                       Field{"background", &Color::background}};
};

/// Lines that go alongside each other nearer than their pens' spacing are thinned, by priority.
struct Elision {
    bool enabled = false;
    double fade_from = 0.35;  ///< share of its room that a line must have to show at all
    double cut = 0.0;         ///< opacity below which a line is left out altogether
    int frames = 0;           ///< before and after each, over which renders smooth what stays of a line
    double length = 1.0, kind = 0.5, strength = 0.25, depth = 0.25, object = 1.0, painted = 1.0;  ///< what counts
    std::string priority_attribute;  ///< what is painted; none: that does not count
    std::string density_attribute;   ///< painted: 0 for lines a quarter as dense as their pens say, 1 four times

    static constexpr std::tuple fields{Field{"enabled", &Elision::enabled},
                                       Field{"fade_from", &Elision::fade_from},
                                       Field{"cut", &Elision::cut},
                                       Field{"frames", &Elision::frames},
                                       Field{"length", &Elision::length},
                                       Field{"kind", &Elision::kind},
                                       Field{"strength", &Elision::strength},
                                       Field{"depth", &Elision::depth},
                                       Field{"object", &Elision::object},
                                       Field{"painted", &Elision::painted},
                                       Field{"priority_attribute", &Elision::priority_attribute},
                                       Field{"density_attribute", &Elision::density_attribute}};
};

/// A transfer function as data (focus/transfer.h): 0 up to `start`, `strength` from `end` on, a curve between.
struct Transfer {
    double start = 0.0, end = 1.0, strength = 1.0;
    std::vector<dvec2> curve;  ///< (x, y) in [0, 1], x ascending; none: straight

    static constexpr std::tuple fields{Field{"start", &Transfer::start}, Field{"end", &Transfer::end},
                                       Field{"strength", &Transfer::strength}, Field{"curve", &Transfer::curve}};
};

inline Transfer off() { return {0.0, 1.0, 0.0, {}}; }

/// What answers to focus, one transfer function each.
struct Effects {
    Transfer color, texture, width, opacity, density, overshoot;  ///< of lines: to the pen out of focus
    Transfer desaturation = off(), fade = off(), blur = off();    ///< of the colors under the lines: amount
    Mode lines = Mode::emphasized, colors = Mode::emphasized;
    double uniform = 0.5;       ///< focus of what is uniform
    double blur_radius = 12.0;  ///< at full blur

    static constexpr std::tuple fields{Field{"color", &Effects::color},
                                       Field{"texture", &Effects::texture},
                                       Field{"width", &Effects::width},
                                       Field{"opacity", &Effects::opacity},
                                       Field{"density", &Effects::density},
                                       Field{"overshoot", &Effects::overshoot},
                                       Field{"desaturation", &Effects::desaturation},
                                       Field{"fade", &Effects::fade},
                                       Field{"blur", &Effects::blur},
                                       Field{"lines", &Effects::lines},
                                       Field{"colors", &Effects::colors},
                                       Field{"uniform", &Effects::uniform},
                                       Field{"blur_radius", &Effects::blur_radius}};
};

/// Distance from the camera drives width, opacity and density as focus does, and together with it.
struct Distance {
    double near = 0.0, far = 100.0;  ///< along the view, in units of the scene
    Transfer width = off(), opacity = off(), density = off();

    static constexpr std::tuple fields{Field{"near", &Distance::near}, Field{"far", &Distance::far},
                                       Field{"width", &Distance::width}, Field{"opacity", &Distance::opacity},
                                       Field{"density", &Distance::density}};
};

/// A place to look at.
struct FocusPlace {
    /// In the image: 0 .. 1 from the left and from the top, of the whole frame. In the scene: world coordinates.
    dvec3 at{0.5, 0.5, 0.0};
    double near = 0.1;   ///< in focus up to here; in the image in heights of the frame, in the scene in its units
    double far = 0.5;    ///< out of focus from here on
    std::string object;  ///< of the model `object`: whose surface is the place

    static constexpr std::tuple fields{Field{"at", &FocusPlace::at}, Field{"near", &FocusPlace::near},
                                       Field{"far", &FocusPlace::far}, Field{"object", &FocusPlace::object}};
};

/// Where the viewer shall look.
struct Focus {
    FocusModel model = FocusModel::none;
    std::vector<FocusPlace> points{FocusPlace()};
    Combine combine = Combine::nearest;
    std::string attribute;  ///< of the model `painted`: 1 is in focus, 0 out of it

    bool active() const {
        return model == FocusModel::painted ? !attribute.empty() : model != FocusModel::none && !points.empty();
    }

    static constexpr std::tuple fields{Field{"model", &Focus::model}, Field{"points", &Focus::points},
                                       Field{"combine", &Focus::combine}, Field{"attribute", &Focus::attribute}};
};

/// A pen, and the one that it becomes out of focus.
struct PenPair {
    const Pen* pen;
    const Pen* away;  ///< null: it stays as it is
};

struct Style {
    Paper paper;
    std::vector<LineSet> line_sets{LineSet()};
    Focus focus;
    Effects effects;
    Distance distance;
    Color color;
    Elision elision;

    static constexpr std::tuple fields{Field{"paper", &Style::paper},       Field{"line_sets", &Style::line_sets},
                                       Field{"focus", &Style::focus},       Field{"effects", &Style::effects},
                                       Field{"distance", &Style::distance}, Field{"color", &Style::color},
                                       Field{"elision", &Style::elision}};

    /// Whether there is a color layer.
    bool has_color() const { return color.shading != Shading::plain && effects.colors != Mode::none; }
    /// Those of visible parts by line set, then those of hidden parts. Borrowed.
    std::vector<PenPair> pen_pairs() const;
    /// Whether lines out of focus are other than those in focus.
    bool has_away() const;
    /// How many surfaces that hide a line must be told apart; 0: hidden lines are not drawn.
    Index counted() const;
};

}  // namespace fovea::style
