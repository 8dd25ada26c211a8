// SPDX-License-Identifier: GPL-3.0-or-later
// Focus and what answers to it, as data: where the viewer shall look, and a transfer function per effect. Focus is 0
// where the viewer shall look and 1 far from there (focus/focus.h, focus/transfer.h).
#pragma once

#include <string>
#include <vector>

#include <fovea/base/types.h>
#include <fovea/style/field.h>

namespace fovea::style {

/// Mix of an effect: 0 where focus is at most `start`, `strength` from `end` on, a curve between; a start beyond the
/// end turns it round.
struct Transfer {
    double start = 0.0, end = 1.0, strength = 1.0;
    std::vector<dvec2> curve;  ///< (x, y) in [0, 1], x ascending; none: straight

    static constexpr std::size_t most_points = 32;  ///< of a curve

    bool operator==(const Transfer&) const = default;

    static constexpr std::tuple fields{
        Field{"start", &Transfer::start, "Start", "Value (focus: 0 in, 1 out of it) at which the effect begins", share},
        Field{"end", &Transfer::end, "End", "Value at which the effect is whole; less than the start turns it around",
              share},
        Field{"strength", &Transfer::strength, "Strength",
              "How strong the effect is where it is whole; 0 switches it off", share},
        Field{"curve", &Transfer::curve, "", "", share}};
};

inline Transfer off() { return {0.0, 1.0, 0.0, {}}; }

/// Whether lines or colors answer to focus: as it says, as at one value of it everywhere, or not drawn at all.
enum class Mode : std::uint8_t { emphasized, uniform, none };
template <>
inline constexpr Choice choices_of<Mode>[] = {
    {"emphasized", "Emphasized", "As focus says"},
    {"uniform", "Uniform", "The same all over the image"},
    {"none", "None", "Not drawn"},
};

/// What answers to focus, one transfer function each.
struct Effects {
    Transfer color, texture, width, opacity, density, overshoot;  ///< of lines: to the pen out of focus
    Transfer desaturation = off(), fade = off(), blur = off();    ///< of the colors under the lines: amount
    Mode lines = Mode::emphasized, colors = Mode::emphasized;
    double uniform = 0.5;
    double blur_radius = 12.0;

    bool operator==(const Effects&) const = default;

    static constexpr const char *of_lines = "lines", *of_colors = "colors";
    static constexpr std::tuple fields{
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
        Field{"uniform", &Effects::uniform, "Uniform Focus",
              "Focus everywhere, of what is uniform: 0 in focus, 1 out of it", share},
        Field{"blur_radius", &Effects::blur_radius, "Blur Radius", "Radius of the full blur", reference(200.0, 60.0)}};
};

/// Distance from the camera drives width, opacity and density as focus does, and together with it.
struct Distance {
    double near = 0.0, far = 100.0;  ///< along the view
    Transfer width = off(), opacity = off(), density = off();

    bool operator==(const Distance&) const = default;

    static constexpr Domain length{0.0, far_away, 1000.0, Unit::scene};
    static constexpr std::tuple fields{
        Field{"near", &Distance::near, "Near", "Distance from the camera at which effects begin", length},
        Field{"far", &Distance::far, "Far", "Distance from the camera at which effects are whole", length},
        Field{"width", &Distance::width, "Line Width"}, Field{"opacity", &Distance::opacity, "Line Opacity"},
        Field{"density", &Distance::density, "Line Density"}};
};

/// A place to look at.
struct FocusPlace {
    /// In the image: 0 .. 1 from the left and from the top, of the whole frame. In the scene: world coordinates.
    dvec3 at{0.5, 0.5, 0.0};
    double near = 0.1;   ///< in focus up to here; in the image in heights of the frame, in the scene in its units
    double far = 0.5;    ///< out of focus from here on
    std::string object;  ///< of the model `object`: whose surface is the place; `at` where it has none

    bool operator==(const FocusPlace&) const = default;

    static constexpr Domain radius = number(0.0, far_away, far_away);
    static constexpr std::tuple fields{Field{"at", &FocusPlace::at}, Field{"near", &FocusPlace::near, "", "", radius},
                                       Field{"far", &FocusPlace::far, "", "", radius},
                                       Field{"object", &FocusPlace::object, "", "", naming(Names::datablock)}};
};

/// What says where to look.
enum class FocusModel : std::uint8_t { none, image, scene, object, painted };
template <>
inline constexpr Choice choices_of<FocusModel>[] = {{"none"}, {"image"}, {"scene"}, {"object"}, {"painted"}};

/// What focus depends on in a picture.
enum class FocusBasis : std::uint8_t {
    nothing,
    image,     ///< where a pixel lies
    scene,     ///< where in space what it shows lies
    surfaces,  ///< how near that is to surfaces of the scene
    attribute  ///< values at the corners of meshes
};
inline constexpr FocusBasis basis_of[] = {FocusBasis::nothing, FocusBasis::image, FocusBasis::scene,
                                          FocusBasis::surfaces, FocusBasis::attribute};

/// What several places make together.
enum class Combine : std::uint8_t { nearest, sum };
template <>
inline constexpr Choice choices_of<Combine>[] = {{"nearest"}, {"sum"}};

/// Where the viewer shall look: in Blender a scene says it, not its style.
struct Focus {
    FocusModel model = FocusModel::none;
    std::vector<FocusPlace> points{FocusPlace()};
    Combine combine = Combine::nearest;
    std::string attribute;  ///< of the basis `attribute`

    static constexpr std::size_t most_places = 16;

    bool operator==(const Focus&) const = default;
    FocusBasis basis() const { return basis_of[int(model)]; }
    bool is_painted() const { return basis() == FocusBasis::attribute; }
    bool active() const { return is_painted() ? !attribute.empty() : model != FocusModel::none && !points.empty(); }

    static constexpr std::tuple fields{Field{"model", &Focus::model}, Field{"points", &Focus::points},
                                       Field{"combine", &Focus::combine},
                                       Field{"attribute", &Focus::attribute, "", "", naming(Names::attribute)}};
};

}  // namespace fovea::style
