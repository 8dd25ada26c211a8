// SPDX-License-Identifier: GPL-3.0-or-later
// Words for the enumerations of folders that come before style/; those after it have theirs beside them
// (style/field.h).
#pragma once

#include <fovea/line/definition.h>
#include <fovea/mesh/field_options.h>
#include <fovea/style/field.h>

namespace fovea::style {

template <>
inline constexpr Choice choices_of<Estimator>[] = {{"automatic"}, {"jets"}, {"one_ring"}};

template <>
inline constexpr Choice choices_of<line::Unit>[] = {{""}, {"degrees"}, {"pixels"}, {"bool"}};

/// For scripts lines depend on the surface alone, on the view too, or on the whole scene.
template <>
inline constexpr Choice choices_of<Scope>[] = {{"surface"}, {"scene"}, {"view"}, {"scene"}};

}  // namespace fovea::style
