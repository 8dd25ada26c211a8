// SPDX-License-Identifier: GPL-3.0-or-later
// Names (style/field.h) for the enumerations of folders that style/ depends on; later folders declare theirs next to
// the enumeration.
#pragma once

#include <fovea/cutout/opacity.h>
#include <fovea/line/definition.h>
#include <fovea/mesh/field_options.h>
#include <fovea/style/field.h>

namespace fovea::style {

template <>
inline constexpr Choice choices_of<Estimator>[] = {{"automatic"}, {"jets"}, {"one_ring"}};

template <>
inline constexpr Choice choices_of<Shape>[] = {{"automatic"}, {"hard"}, {"rounded"}, {"smooth"}};

template <>
inline constexpr Choice choices_of<Extension>[] = {{"repeat"}, {"extend"}, {"clip"}, {"mirror"}};

template <>
inline constexpr Choice choices_of<line::Unit>[] = {{""}, {"degrees"}, {"pixels"}, {"millimeters"}, {"bool"}};

/// In scripts a line's scope is "surface", "view" or "scene".
template <>
inline constexpr Choice choices_of<Scope>[] = {{"surface"}, {"scene"}, {"view"}, {"scene"}};

}  // namespace fovea::style
