// SPDX-License-Identifier: GPL-3.0-or-later
// A model read from a file, and its builder for the readers.
#pragma once

#include <fovea/mesh/surface.h>

namespace fovea::tool {

using namespace draw;

/// Number of invalid elements, and the error of the first one.
struct Broken {
    Index count = 0;
    std::string first;
};

/// Polygons of all objects and groups of a file together, with any number of corners from 3.
struct Model {
    std::string name;
    std::vector<vec3> positions;  ///< as in the file; NaN for a broken vertex
    std::vector<int> corner_verts, polygon_offsets{0};
    std::vector<int> material;  ///< per polygon: number of its name in the file, 0 for none
    Broken vertices, polygons;  ///< broken vertices keep their number, broken polygons are left out
    bool y_up = false;          ///< up axis by the format's convention: y, else z

    Index polygon_count() const { return Index(polygon_offsets.size()) - 1; }
    std::shared_ptr<Surface> surface() const;
    /// Positions of the vertices that polygons without broken vertices have: what a picture frames.
    std::vector<vec3> drawn_positions() const;
};

/// Throws std::invalid_argument with one sentence that names the file and `place`; `unit` is "line" or "byte".
[[noreturn]] void refuse(const std::string& file, const char* unit, std::size_t place, const std::string& what);

/// Builds a model from a file's elements in order; `place`: their position in the file. Polygons may refer to later
/// vertices.
class ModelBuilder {
   public:
    ModelBuilder(const std::string& file, const char* unit);

    std::int64_t vertex_count() const { return std::int64_t(model_.positions.size()); }
    void add_vertex(const dvec3& position) { model_.positions.emplace_back(position); }
    void add_broken_vertex(std::size_t place, const std::string& what);
    /// Vertex numbers from 0; an invalid number counts as a missing vertex.
    void add_polygon(In<std::int64_t> vertices, int material, std::size_t place);

    Model finish();

   private:
    void note(Broken& broken, std::size_t place, const std::string& what) const;

    std::string file_;
    const char* unit_;
    Model model_;
    std::vector<std::size_t> places_;  // per polygon
};

}  // namespace fovea::tool
