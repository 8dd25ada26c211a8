// SPDX-License-Identifier: GPL-3.0-or-later
// Structures that name their members once, with what each may be and what people are told of it: files, Python, panels
// and checks follow from the list.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <tuple>
#include <type_traits>

namespace fovea::style {

/// What a number is measured in, or counts.
enum class Unit : std::uint8_t {
    none,
    share,      ///< of a whole, 0 to 1
    reference,  ///< pixels of an image 1080 pixels high
    degrees,
    scene,        ///< lengths of the scene
    millimeters,  ///< on paper
    light,        ///< of a color's channels, scene-linear
    seed,         ///< a whole number that stands for nothing but itself
};

/// What a text names.
enum class Names : std::uint8_t {
    anything,
    texture,    ///< a pen's, that ships
    paper,      ///< that ships
    datablock,  ///< an object, collection or material in Blender
    attribute,  ///< of meshes in Blender
};

/// The most letters of a name in Blender; 0: any number.
constexpr std::size_t most_letters(Names names) {
    return names == Names::attribute ? 63 : names == Names::datablock ? 255 : 0;
}

/// What a member may be.
struct Domain {
    double least = -1e9, most = 1e9;  ///< of a number
    double soft_most = most;          ///< where sliders end
    Unit unit = Unit::none;
    Names names = Names::anything;  ///< of a text
};

inline constexpr double far_away = 1e9;  ///< the farthest place that a style names
inline constexpr Domain share{.least = 0.0, .most = 1.0, .unit = Unit::share};
inline constexpr Domain light{.least = 0.0, .most = 1000.0, .soft_most = 1.0, .unit = Unit::light};
/// A length in the image.
constexpr Domain reference(double most, double soft_most, double least = 0.0) {
    return {.least = least, .most = most, .soft_most = soft_most, .unit = Unit::reference};
}
constexpr Domain number(double least, double most, double soft_most) {
    return {.least = least, .most = most, .soft_most = soft_most};
}
constexpr Domain naming(Names names) { return {.names = names}; }

/// A member of a structure S by its name. S::fields is a tuple of all of them, in the order in which they are
/// written. Label and description are Blender's: the first a title, the second a sentence without its full stop; of a
/// length in the image it is followed by what that is measured in.
template <typename S, typename V>
struct Field {
    const char* name;
    V S::* member;
    const char* label = "";
    const char* description = "";
    Domain domain = {};
    const char* group = "";     ///< members of the same group stand together in panels
    const char* in_files = "";  ///< its name in files, where that is another; null: it is not in files

    constexpr bool is_in_files() const { return in_files != nullptr; }
    constexpr const char* key() const { return *in_files ? in_files : name; }
};
template <typename S, typename V>
Field(const char*, V S::*, const char* = "", const char* = "", Domain = {}, const char* = "", const char* = "")
    -> Field<S, V>;

template <typename S>
concept Record = requires { S::fields; };

/// visit(field) for each.
template <Record S, typename Visit>
void for_each_field(const Visit& visit) {
    std::apply([&](const auto&... field) { (visit(field), ...); }, S::fields);
}

/// A record with its lengths in the image in pixels of a picture, so many of which are a reference pixel.
template <Record S>
S in_pixels(S record, double reference_scale) {
    for_each_field<S>([&]<typename V>(const Field<S, V>& field) {
        if constexpr (std::is_same_v<V, double>)
            if (field.domain.unit == Unit::reference) record.*field.member *= reference_scale;
    });
    return record;
}

/// A value of an enumeration: its name in files, and what people are told of it.
struct Choice {
    const char* name;
    const char* label = "";
    const char* description = "";
};

/// An array of Choice, by the values of an enumeration: specialized where the enumeration is.
template <typename Enum>
inline constexpr int choices_of = 0;

}  // namespace fovea::style
