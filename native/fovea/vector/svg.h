// SPDX-License-Identifier: GPL-3.0-or-later
// Documents as SVG files.
#pragma once

#include <string>

#include <fovea/vector/document.h>

namespace fovea::vector {

/// The bytes of an SVG file (1.1, with layers as Inkscape has them): a millimeter is a unit of it, or a pixel.
std::string svg_bytes(const Document& document);

}  // namespace fovea::vector
