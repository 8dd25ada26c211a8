// SPDX-License-Identifier: GPL-3.0-or-later
// A cube as files have it.
#pragma once

#include <string>
#include <tool/ply_header.h>
#include <vector>

namespace fovea::model_files {

/// Eight vertices, six quads, turned outwards; corners are written as `corner` says, with % for the vertex from 1.
std::string cube_obj(const std::string& corner = "%", const std::string& line_end = "\n");

/// How the values of a PLY cube are stored.
struct PlyKind {
    tool::PlyFormat format = tool::PlyFormat::ascii;
    const char *coordinate = "float", *count = "uchar", *index = "int";
    bool with_more = false;  ///< properties and elements that are not asked for, before, between and after
    std::string line_end = "\n";
};

std::string cube_ply(const PlyKind& kind = {});

}  // namespace fovea::model_files
