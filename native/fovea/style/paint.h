// SPDX-License-Identifier: GPL-3.0-or-later
// What is painted on surfaces, by its name.
#pragma once

#include <string>

#include <fovea/style/field.h>

namespace fovea::style {

/// What says values on surfaces.
enum class PaintSource : std::uint8_t { constant, vertex_group, attribute, material, object };
template <>
inline constexpr Choice choices_of<PaintSource>[] = {
    {"constant", "Constant", "The pen's own value everywhere"},
    {"vertex_group", "Vertex Group", "Weights of the vertex group of that name"},
    {"attribute", "Attribute", "A float or color attribute of that name"},
    {"material", "Material", "Color of the material of the faces, its viewport color where nodes make it"},
    {"object", "Object", "Viewport color of the object"},
};

/// A source and, of vertex groups and attributes, the name of one.
struct Paint {
    PaintSource source = PaintSource::constant;
    std::string name = {};

    auto operator<=>(const Paint&) const = default;

    /// Whether the source is one of those with names.
    bool is_named() const { return source == PaintSource::vertex_group || source == PaintSource::attribute; }
    /// Whether anything is painted: a source without the name that it needs says nothing.
    bool any() const { return source != PaintSource::constant && (!is_named() || !name.empty()); }
};

}  // namespace fovea::style
