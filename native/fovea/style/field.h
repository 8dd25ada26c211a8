// SPDX-License-Identifier: GPL-3.0-or-later
// Reflection of settings structures: each member is declared once, with its range, unit, label and tooltip. Files, the
// Python bindings, panels and range checks follow from the list.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <fovea/base/each_of.h>

namespace fovea::style {

using base::each_of;

/// Unit of a number.
enum class Unit : std::uint8_t {
    none,
    share,      ///< fraction, 0 to 1
    reference,  ///< pixels of an image 1080 pixels high
    degrees,
    scene,        ///< scene length
    millimeters,  ///< on paper
    light,        ///< color channel, scene-linear
    seed,         ///< integer random seed
};

/// What a string refers to.
enum class Names : std::uint8_t {
    anything,
    texture,    ///< shipped pen texture
    paper,      ///< shipped paper texture
    datablock,  ///< Blender object, collection or material
    attribute,  ///< mesh attribute in Blender
};

/// Maximum length of a name in Blender, in characters; 0: unlimited.
constexpr std::size_t most_letters(Names names) {
    return names == Names::attribute ? 63 : names == Names::datablock ? 255 : 0;
}

/// Allowed values of a member.
struct Domain {
    double least = -1e9, most = 1e9;  ///< of a number
    double soft_most = most;          ///< soft maximum of sliders
    Unit unit = Unit::none;
    Names names = Names::anything;  ///< of a string
};

inline constexpr double far_away = 1e9;  ///< upper limit of distances in a style
/// A distance from the camera.
inline constexpr Domain distances{.least = 0.0, .most = far_away, .soft_most = 1000.0, .unit = Unit::scene};
inline constexpr Domain share{.least = 0.0, .most = 1.0, .unit = Unit::share};
inline constexpr Domain light{.least = 0.0, .most = 1000.0, .soft_most = 1.0, .unit = Unit::light};
/// A length in the image, in reference pixels.
constexpr Domain reference(double most, double soft_most, double least = 0.0) {
    return {.least = least, .most = most, .soft_most = soft_most, .unit = Unit::reference};
}
constexpr Domain number(double least, double most, double soft_most) {
    return {.least = least, .most = most, .soft_most = soft_most};
}
constexpr Domain naming(Names names) { return {.names = names}; }

/// Declaration of a member of structure S. S::fields is each_of all of them, in the order in which they are written to
/// files. Label and description are shown by Blender: a title, and a sentence without its full stop; for a length in
/// the image its unit is appended.
template <typename S, typename V>
struct Field {
    const char* name;
    V S::* member;
    const char* label = "";
    const char* description = "";
    Domain domain = {};
    const char* group = "";     ///< panels show members of one group together
    const char* in_files = "";  ///< key in files if not `name`; null: not in files

    constexpr bool is_in_files() const { return in_files != nullptr; }
    /// Null: not in files.
    constexpr const char* key() const { return in_files && !*in_files ? name : in_files; }
};
template <typename S, typename V>
Field(const char*, V S::*, const char* = "", const char* = "", Domain = {}, const char* = "", const char* = "")
    -> Field<S, V>;

template <typename S>
concept Record = requires { S::fields; };

/// Calls visit(field) for each field of S.
template <Record S, typename Visit>
void for_each_field(const Visit& visit) {
    S::fields(visit);
}

/// Copy of `record` with lengths in reference pixels and in millimeters converted to image pixels. `reference_scale`,
/// `mm_px`: image pixels per reference pixel and per millimeter of the page.
template <Record S>
S in_pixels(S record, double reference_scale, double mm_px) {
    for_each_field<S>([&]<typename V>(const Field<S, V>& field) {
        if constexpr (std::is_same_v<V, double>) {
            if (field.domain.unit == Unit::reference) record.*field.member *= reference_scale;
            if (field.domain.unit == Unit::millimeters) record.*field.member *= mm_px;
        }
    });
    return record;
}

/// A value of an enumeration: its name in files, label and tooltip.
struct Choice {
    const char* name;
    const char* label = "";
    const char* description = "";
};

/// Array of Choice indexed by the values of an enumeration; specialized next to each enumeration.
template <typename Enum>
inline constexpr int choices_of = 0;

template <>
inline constexpr Choice choices_of<Unit>[] = {
    {""}, {"share"}, {"reference pixels"}, {"degrees"}, {"scene"}, {"millimeters"}, {"light"}, {"seed"}};

template <>
inline constexpr Choice choices_of<Names>[] = {{""}, {"texture"}, {"paper"}, {"datablock"}, {"attribute"}};

}  // namespace fovea::style
