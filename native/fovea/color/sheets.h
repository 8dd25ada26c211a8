// SPDX-License-Identifier: GPL-3.0-or-later
// See-through surfaces: those that hide no lines, but whose material has some color of its own.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/color/shader.h>

namespace fovea::color {

/// Triangles of see-through surfaces, by the pixels whose centers they cover. Facets that do not occlude, of placements
/// that do, whose slot has an opacity.
class Sheets {
   public:
    /// Borrows its arguments.
    Sheets(const Scene& scene, const View& view, const SceneColor& colors, const Cancel& cancel);

    bool empty() const { return sheets_.empty(); }

    struct Fragment {
        int x;
        Index sheet, triangle;
        float depth;  ///< as the depth buffer has it (base/view.h): the nearest is the greatest
        bool operator==(const Fragment& other) const { return sheet == other.sheet && triangle == other.triangle; }
    };
    /// Those of a pixel, the nearest first.
    In<Fragment> at(int x, int y) const;
    SeenTriangle triangle(const Fragment& fragment, const ColorShader& shader) const;

   private:
    struct Sheet {
        Index placement;
        Array<Triangle> triangles;  // two-sided ones first
        Array<Index> number;        // of the surface's triangle
        Index two_sided;
    };
    void draw(const Scene& scene, const View& view, const Cancel& cancel);

    std::vector<Sheet> sheets_;
    struct Row {
        std::vector<Fragment> fragments;  // by x, then from the viewer on
        std::vector<Index> first;         // of each x, and their number; empty without any
    };
    std::vector<Row> rows_;
};

}  // namespace fovea::color
