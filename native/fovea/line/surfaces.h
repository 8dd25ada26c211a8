// SPDX-License-Identifier: GPL-3.0-or-later
// Which surfaces a line set draws its lines on, by what their polygons stand for.
#pragma once

#include <fovea/line/definition.h>

namespace fovea::line {

enum class Surfaces : std::uint8_t { all, suited, hard, rounded, smooth };

/// Whether a line set draws a definition on a surface of this shape (never automatic).
inline bool is_drawn_on(Surfaces chosen, const LineDefinition& definition, Shape shape) {
    switch (chosen) {
        case Surfaces::suited:
            return !definition.of_smooth || shape == Shape::smooth;
        case Surfaces::hard:
            return shape == Shape::hard;
        case Surfaces::rounded:
            return shape == Shape::rounded;
        case Surfaces::smooth:
            return shape == Shape::smooth;
        case Surfaces::all:
            break;
    }
    return true;
}

}  // namespace fovea::line
