// SPDX-License-Identifier: GPL-3.0-or-later
// The command line.
#pragma once

#include <filesystem>
#include <string>
#include <tool/camera.h>
#include <vector>

#include <fovea/vector/options.h>

namespace fovea::tool {

struct Options {
    std::filesystem::path model;
    std::vector<std::string> lines;  ///< names of line definitions
    Camera camera;
    std::filesystem::path style;   ///< a style file; empty: a style made of `lines`
    std::filesystem::path assets;  ///< a folder with textures and papers
    std::filesystem::path output;  ///< a PNG, SVG, PDF or DXF file; empty: nothing is drawn
    vector::Options vectors;
    int threads = 0;  ///< 0: as many as the machine has
};

/// Parses the command line. Exits the program on a request for help and on invalid arguments.
Options parse(int count, char** words);

}  // namespace fovea::tool
