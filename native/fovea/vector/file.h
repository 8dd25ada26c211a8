// SPDX-License-Identifier: GPL-3.0-or-later
// Files of vectors by their kinds.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <fovea/vector/document.h>
#include <fovea/vector/options.h>

namespace fovea::vector {

enum class Kind : std::uint8_t { svg, pdf, dxf };

/// The kind of file that a suffix without its dot names.
std::optional<Kind> kind_of(std::string_view suffix);

/// The options with what a kind of file has no words for taken out: DXF has lines alone, without dashes and ground.
Options fitting(Kind kind, Options options);

/// The bytes of a file; equal ones for equal documents.
std::string bytes_of(const Document& document, Kind kind);

}  // namespace fovea::vector

namespace fovea::style {
template <>
inline constexpr Choice choices_of<vector::Kind>[] = {
    {"svg", "SVG", "For Inkscape, browsers and plotters, with layers"},
    {"pdf", "PDF", "For printers, with layers"},
    {"dxf", "DXF", "For CAD: center lines on layers, with line weights"},
};
}  // namespace fovea::style
