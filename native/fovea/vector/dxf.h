// SPDX-License-Identifier: GPL-3.0-or-later
// Documents as DXF files.
#pragma once

#include <string>

#include <fovea/vector/document.h>

namespace fovea::vector {

/// The bytes of a DXF file of AutoCAD 2000 (AC1015), in millimeters, or without a unit where that is the pixel: a
/// polyline for each curve of lines, else a spline, on layers "SET_VISIBLE" and "SET_HIDDEN", of plotters
/// "1_SET_HIDDEN" and "2_SET", with the nearest of the line weights that there are. Colors, opacities and fills are
/// left out.
std::string dxf_bytes(const Document& document);

}  // namespace fovea::vector
