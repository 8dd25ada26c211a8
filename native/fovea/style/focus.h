// SPDX-License-Identifier: GPL-3.0-or-later
// Stylized focus as data (Cole 2009, 5.3): focus points, and a transfer function per effect. Focus is 0 in focus and 1
// far out of focus (focus/focus.h, focus/transfer.h).
#pragma once

#include <string>
#include <vector>

#include <fovea/style/transfer.h>

namespace fovea::style {

/// How lines or colors respond to focus: to its value at each place, to one constant value, or not drawn at all.
enum class Mode : std::uint8_t { emphasized, uniform, none };
template <>
inline constexpr Choice choices_of<Mode>[] = {
    {"emphasized", "By Focus", "As focus says at each place"},
    {"uniform", "Constant", "The same all over the image"},
    {"none", "Off", "Not drawn"},
};

/// Effects driven by focus, one transfer function each.
struct Effects {
    Transfer color, texture, width, opacity, density, overshoot;  ///< lines: mix towards the out-of-focus pen
    Transfer desaturation = off(), fade = off(), blur = off();    ///< color layer: amount
    Mode lines = Mode::emphasized, colors = Mode::emphasized;
    double emphasis = 1.0;
    double uniform = 0.5;
    double blur_radius = 12.0;

    static constexpr Domain some_emphasis{0.1, 10.0, 4.0};

    bool operator==(const Effects&) const = default;

    static constexpr const char *of_lines = "lines", *of_colors = "colors";
    static constexpr auto fields = each_of(
        Field{"color", &Effects::color, "Line Color", "", {}, of_lines},
        Field{"texture", &Effects::texture, "Line Texture", "", {}, of_lines},
        Field{"width", &Effects::width, "Line Width", "", {}, of_lines},
        Field{"opacity", &Effects::opacity, "Line Opacity", "", {}, of_lines},
        Field{"density", &Effects::density, "Line Density", "", {}, of_lines},
        Field{"overshoot", &Effects::overshoot, "Overshoot", "", {}, of_lines},
        Field{"desaturation", &Effects::desaturation, "Desaturation", "", {}, of_colors},
        Field{"fade", &Effects::fade, "Fade to Paper", "", {}, of_colors},
        Field{"blur", &Effects::blur, "Blur", "", {}, of_colors},
        Field{"lines", &Effects::lines, "Lines", "Whether lines answer to focus"},
        Field{"colors", &Effects::colors, "Colors", "Whether colors answer to focus"},
        Field{
            "emphasis", &Effects::emphasis, "Emphasis",
            "How much effects set off what is in focus: all are multiplied by this, up to their whole, but those that "
            "are strongest in focus are divided by it",
            some_emphasis},
        Field{"uniform", &Effects::uniform, "Constant Focus",
              "Focus everywhere, of what is constant: 0 in focus, 1 out of it", share},
        Field{"blur_radius", &Effects::blur_radius, "Blur Radius", "Radius of the full blur", reference(200.0, 60.0)});
};

/// Line effects driven by distance from the camera, combined with those of focus.
struct Distance {
    double near = 0.0, far = 100.0;  ///< along the view axis, scene units
    Transfer width = off(), opacity = off(), density = off();

    bool operator==(const Distance&) const = default;

    static constexpr auto fields =
        each_of(Field{"near", &Distance::near, "Near", "Distance from the camera at which effects begin", distances},
                Field{"far", &Distance::far, "Far", "Distance from the camera at which effects are whole", distances},
                Field{"width", &Distance::width, "Line Width"}, Field{"opacity", &Distance::opacity, "Line Opacity"},
                Field{"density", &Distance::density, "Line Density"});
};

/// A focus point.
struct FocusPlace {
    /// In the image: 0 .. 1 from the left and from the top, of the whole frame. In the scene: world coordinates.
    dvec3 at{0.5, 0.5, 0.0};
    double near = 0.1;   ///< in focus up to this distance: frame heights in the image, scene units in the scene
    double far = 0.5;    ///< out of focus from this distance on
    std::string object;  ///< model `object`: distance is measured from its surface; from `at` if it has none

    bool operator==(const FocusPlace&) const = default;

    static constexpr Domain radius = number(0.0, far_away, far_away);
    static constexpr auto fields = each_of(
        Field{"at", &FocusPlace::at, "",
              "In the image two numbers from its left and top, 0 to 1; in the scene three, in world space"},
        Field{"near", &FocusPlace::near, "",
              "In focus up to this distance: in heights of the frame in the image, else in units of the scene", radius},
        Field{"far", &FocusPlace::far, "", "Out of focus from this distance on", radius},
        Field{"object", &FocusPlace::object, "", "Of the model object: from whose surfaces distances are",
              naming(Names::datablock)});
};

/// How the places in focus are specified.
enum class FocusModel : std::uint8_t { none, image, scene, object, painted };
template <>
inline constexpr Choice choices_of<FocusModel>[] = {{"none"}, {"image"}, {"scene"}, {"object"}, {"painted"}};

/// What focus is a function of.
enum class FocusBasis : std::uint8_t {
    nothing,
    image,     ///< position in the image
    scene,     ///< position in space of the visible point
    surfaces,  ///< distance of that point from surfaces of the scene
    attribute  ///< per-corner mesh attribute
};
inline constexpr FocusBasis basis_of[] = {FocusBasis::nothing, FocusBasis::image, FocusBasis::scene,
                                          FocusBasis::surfaces, FocusBasis::attribute};

/// How several focus points are combined.
enum class Combine : std::uint8_t { nearest, sum };
template <>
inline constexpr Choice choices_of<Combine>[] = {{"nearest"}, {"sum"}};

/// Focus model and focus points. In Blender they belong to the scene, not to its style.
struct Focus {
    FocusModel model = FocusModel::none;
    std::vector<FocusPlace> points{FocusPlace()};
    Combine combine = Combine::nearest;
    std::string attribute;  ///< mesh attribute, for the basis `attribute`

    static constexpr std::size_t most_places = 16;

    bool operator==(const Focus&) const = default;
    FocusBasis basis() const { return basis_of[int(model)]; }
    bool is_painted() const { return basis() == FocusBasis::attribute; }
    bool active() const { return is_painted() ? !attribute.empty() : model != FocusModel::none && !points.empty(); }

    static constexpr auto fields = each_of(
        Field{"model", &Focus::model, "", "How it is said what is in focus"},
        Field{"points", &Focus::points, "", "List of up to 16 places to look at"},
        Field{"combine", &Focus::combine, "", "Of several places the nearest counts, or how near they are adds up"},
        Field{"attribute", &Focus::attribute, "", "Of the model painted: an attribute of meshes, white in focus",
              naming(Names::attribute)});
};

}  // namespace fovea::style
