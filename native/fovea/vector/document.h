// SPDX-License-Identifier: GPL-3.0-or-later
// A drawing as a document of layers and paths, which every format of files is written from.
#pragma once

#include <optional>
#include <string>

#include <fovea/vector/curve.h>

namespace fovea::vector {

/// How a path is drawn. Lengths in the document's unit.
struct Look {
    dvec3 color{0.0};  ///< as displayed (sRGB), each in [0,1]
    double opacity = 1.0;
    double width = 0.0;               ///< of its line; 0: its curves are outlines that are filled (nonzero winding)
    bool round_caps = true;           ///< of lines: else they are cut off straight
    bool round_joins = false;         ///< of lines: else mitred
    std::vector<double> dashes = {};  ///< lengths drawn and left out in turn; empty: all is drawn
    double dash_start = 0.0;          ///< how far into them the line begins

    bool operator==(const Look&) const = default;
};

/// A stroke, or a part of one.
struct Path {
    std::string id;      ///< unique in the document, and the same for the same line of the same scene
    std::string kind;    ///< its line definition
    std::string object;  ///< the object that it lies on; empty: none
    int invisibility = 0;
    Look look;
    std::vector<Curve> curves;
};

/// A line of text.
struct Caption {
    std::string id;     ///< unique in the document
    std::string text;   ///< UTF-8
    dvec2 place{0.0};   ///< where its base line begins
    double size = 0.0;  ///< of its font
    dvec3 color{0.0};   ///< as displayed
};

inline constexpr double capitals = 0.716;  ///< height of capital letters, of the size of fonts like Helvetica

struct Layer {
    std::string id, label;
    std::string line_set;  ///< its name; empty: of none, or inside its layer
    std::vector<Path> paths;
    std::vector<Layer> layers;           ///< above its own paths, from below
    std::vector<Caption> captions = {};  ///< above its own paths
};

/// A picture over a rectangle.
struct Image {
    Array<std::uint8_t> values;  ///< per pixel as displayed, bottom row first: color, and alpha where there are four
    int width = 0, height = 0, channels = 3;
    dvec2 lower{0.0}, size{0.0};
};

/// The origin is the lower left corner, y goes up.
struct Document {
    dvec2 size{0.0};
    bool in_pixels = false;      ///< whether the unit is the pixel, else it is the millimeter
    std::optional<dvec3> paper;  ///< its color as displayed; none: transparent
    std::optional<Image> image;  ///< below all layers
    std::vector<Layer> layers;   ///< from below
};

/// Calls visit(path) for each path of a layer or document, from below.
template <typename Layers, typename Visit>
void for_each_path(Layers& layers, const Visit& visit) {
    for (auto& layer : layers) {
        for (auto& path : layer.paths) visit(path);
        for_each_path(layer.layers, visit);
    }
}

}  // namespace fovea::vector
