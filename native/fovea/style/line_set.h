// SPDX-License-Identifier: GPL-3.0-or-later
// Which lines are drawn, and with which pens.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fovea/line/surfaces.h>
#include <fovea/style/pen.h>

namespace fovea::style {

inline constexpr int most_surfaces = 100;  ///< limit of ranges of quantitative invisibility

/// Pens for the parts of lines whose quantitative invisibility lies in [first, last]; `last` unset: no upper limit.
struct Hidden {
    int first = 1;
    std::optional<int> last;
    Pen pen;
    std::optional<Pen> pen_away;  ///< out of focus; unset: `pen`

    bool operator==(const Hidden&) const = default;

    static constexpr Domain surfaces = number(1, most_surfaces, 8);
    static constexpr auto fields = each_of(
        Field{"first", &Hidden::first, "From", "Draw lines that at least so many surfaces hide", surfaces, "", "from"},
        Field{"last", &Hidden::last, "To", "Draw lines that at most so many surfaces hide; 0: any number", surfaces, "",
              "to"},
        Field{"pen", &Hidden::pen, "", "How they are drawn"},
        Field{"pen_away", &Hidden::pen_away, "", "And out of focus: what differs from the pen"});
};

/// (name, value) of a line definition's parameters, in the definition's units, and of its file.
using Parameters = std::vector<std::pair<std::string, line::ParameterValue>>;

/// (name, parameters) of line definitions; names are unique.
using Definitions = std::vector<std::pair<std::string, Parameters>>;

template <>
inline constexpr Choice choices_of<line::Surfaces>[] = {
    {"all", "All", "Surfaces of any shape have the lines of this set"},
    {"suited", "As Suits Them",
     "Smooth surfaces have lines of smooth shapes, and smooth contours instead of those of the mesh"},
    {"hard", "Hard", "Only surfaces whose faces are meant as they are"},
    {"rounded", "Rounded", "Only surfaces whose faces approximate a rounded shape coarsely"},
    {"smooth", "Smooth", "Only surfaces whose faces approximate a smooth shape well"},
};

/// Parts of lines by what the scene's lights do to the surface there (scene/shade.h).
enum class LightFilter : std::uint8_t { any, lit, shaded, attached, cast };

template <>
inline constexpr Choice choices_of<LightFilter>[] = {
    {"any", "Any", "Lines of this set are drawn in light and in shade"},
    {"lit", "Lit", "Only the parts of lines that a light of the scene shines on"},
    {"shaded", "In Shade", "Only the parts of lines that no light of the scene shines on"},
    {"attached", "Attached Shadow", "Only the parts of lines where surfaces turn away from all lights"},
    {"cast", "Cast Shadow", "Only the parts of lines in shade that a light would shine on if nothing were between"},
};

/// Line definitions with common filters and pens. An edge belongs to the first line set of the style that draws it.
struct LineSet {
    std::string name = "lines";
    Definitions kinds;
    std::string collection;
    bool outside = false;
    std::string object;
    bool other_objects = false;
    std::string material;
    bool other_materials = false;
    line::Surfaces surfaces = line::Surfaces::all;
    LightFilter light = LightFilter::any;
    double corner_angle = 60.0;  ///< turning angle above which a path is split
    double least_length = 30.0;
    double overshoot = 0.0;
    double halo = 0.0;
    std::optional<double> overshoot_away;  ///< unset: `overshoot`
    Pen pen;                               ///< for visible parts
    std::optional<Pen> pen_away;           ///< for visible parts out of focus; unset: `pen`
    std::vector<Hidden> hidden;            ///< ascending ranges; parts in none of them are not drawn

    bool operator==(const LineSet&) const = default;

    static constexpr auto fields = each_of(
        Field{"name", &LineSet::name, "", "For people"},
        Field{"kinds", &LineSet::kinds, "",
              "Its line definitions, each with the parameters that differ from their defaults"},
        Field{"collection", &LineSet::collection, "Collection",
              "Only objects of this collection have the lines of this set; none: all", naming(Names::datablock)},
        Field{"outside", &LineSet::outside, "Outside",
              "Only objects that are not in the collection have the lines of this set"},
        Field{"object", &LineSet::object, "Object",
              "Only this object, what it instances and what is instanced of it have the lines of this set; none: all",
              naming(Names::datablock)},
        Field{"other_objects", &LineSet::other_objects, "Other Objects",
              "Only other objects have the lines of this set"},
        Field{"material", &LineSet::material, "Material",
              "Only lines on faces of this material are of this set, those where another one meets it included; none: "
              "all",
              naming(Names::datablock)},
        Field{"other_materials", &LineSet::other_materials, "Other Materials",
              "Only lines on faces of other materials are of this set"},
        Field{"surfaces", &LineSet::surfaces, "Surfaces", "Which surfaces have the lines of this set, by their shape"},
        Field{"light", &LineSet::light, "Light",
              "Which parts of lines are of this set, by whether lights that cast shadows shine on them"},
        Field{"corner_angle",
              &LineSet::corner_angle,
              "Corner Angle",
              "Strokes end where a line turns by more than this",
              {0.0, 180.0, 180.0, Unit::degrees}},
        Field{"least_length", &LineSet::least_length, "Min Length",
              "Shorter lines that end without touching another are left out", reference(10000.0, 200.0)},
        Field{"overshoot", &LineSet::overshoot, "Overshoot",
              "How far lines go on beyond their ends, but not behind what hides them", reference(200.0, 60.0)},
        Field{"halo", &LineSet::halo, "Halo", "Gap that is left in lines where they pass behind others",
              reference(100.0, 30.0)},
        Field{"overshoot_away", &LineSet::overshoot_away, "Overshoot",
              "How far lines out of focus go on beyond their ends", reference(200.0, 60.0)},
        Field{"pen", &LineSet::pen, "", "How visible lines are drawn"},
        Field{"pen_away", &LineSet::pen_away, "", "And out of focus: what differs from the pen"},
        Field{"hidden", &LineSet::hidden, "", "List of pens for hidden lines"});
};

}  // namespace fovea::style
