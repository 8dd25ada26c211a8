// SPDX-License-Identifier: GPL-3.0-or-later
// Rasterization of strokes into fragments, for pictures and for passes.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include <fovea/raster/tiles.h>
#include <fovea/stroke/fragment.h>
#include <fovea/stroke/octaves.h>
#include <fovea/stroke/strokes.h>
#include <fovea/visibility/spine.h>

namespace fovea::stroke {

struct Fragment {
    Index vertex;  ///< one of its triangle's: for what is the same all over a stroke
    float arc;     ///< u [px of arc along the whole path], also beyond the ends of the run
    vec3 color;    ///< scene-linear
    float alpha;   ///< in [0, 1]
};

/// The fragments of strokes. Borrows its arguments.
class Fragments {
   public:
    /// With `spine` the opacity of each fragment is multiplied by the spine test at its u, and there are none outside
    /// of the depth buffer's core. Throws where a stroke's pen, a pen's texture, a triangle's corner or (with `spine`)
    /// a vertex's piece does not exist.
    Fragments(const Strokes& strokes, In<Pen> pens, In<PenTexture> textures, const SpineTest* spine);

    /// Calls each(x, y, fragment) for all fragments of these triangles in a box, in the order of the triangles.
    template <typename Each>
    void each(In<Index> triangles, const PixelBox& box, const Each& each) const {
        const PixelBox drawn = spine_ ? intersect(box, core()) : box;
        if (drawn.empty()) return;
        for (const Index t : triangles) of_triangle(strokes_.triangles[t], drawn, each);
    }

   private:
    template <typename Each>
    void of_triangle(glm::uvec3 c, const PixelBox& within, const Each& each) const {
        const FixedTriangle shape(strokes_.px[c[0]], strokes_.px[c[1]], strokes_.px[c[2]]);
        const PixelBox box = intersect(shape.box(), within);
        if (box.empty()) return;
        const OverTriangle<4> values(shape, corner(c[0]), corner(c[1]), corner(c[2]));
        const float start = strokes_.arc[c[0]].z, end = strokes_.arc[c[0]].w;
        const Pen& pen = pens_[strokes_.pen[c[0]]];
        const Index away = pen.away;
        const Pen& other = away == none ? pen : pens_[away];
        const bool fixed = is_anchored(pen) || is_anchored(other);
        const bool tinted = strokes_.mix[c[0]].z + strokes_.mix[c[1]].z + strokes_.mix[c[2]].z > 0.0f;
        const bool breaks = strokes_.mix[c[0]].w + strokes_.mix[c[1]].w + strokes_.mix[c[2]].w > 0.0f;
        const auto mixes = over(away != none || tinted || breaks, shape, strokes_.mix, c);
        const auto colors = over(!strokes_.color.empty(), shape, strokes_.color, c);
        const auto anchors = over(fixed, shape, strokes_.anchor, c);
        for (int y = box.y0; y < box.y1; ++y) {
            int x0 = box.x0, x1 = box.x1;
            shape.span(y, x0, x1);
            for (int x = x0; x < x1; ++x) {
                const vec4 f = values.at(x, y);
                float alpha = coverage(f[0], f[1], start, end, f[2], pen.look.cap);
                if (alpha <= 0.0f) continue;
                const vec4 mix = mixes ? mixes->at(x, y) : vec4(0.0f);
                vec3 color(pen.look.color);
                if (colors)
                    color = colors->at(x, y);
                else if (away != none)
                    color = glm::mix(color, vec3(other.look.color), mix.x);
                if (tinted) {
                    const vec3 second(pen.look.second_color), second_away(other.look.second_color);
                    color = glm::mix(color, glm::mix(second, second_away, mix.x), mix.z);
                }
                const vec2 anchor = anchors ? anchors->at(x, y) : vec2(0.0f);
                float ink = ink_of(strokes_.pen[c[0]], f, anchor);
                if (away != none) ink = glm::mix(ink, ink_of(away, f, anchor), mix.y);
                alpha *= breaks ? ink_left(ink, mix.w) : ink;
                if (spine_) alpha *= spine_->visibility(strokes_.piece[c[0]], std::clamp(f[0], start, end));
                each(x, y, Fragment{c[0], f[0], color, alpha * f[3]});
            }
        }
    }

    float ink_of(Index number, const vec4& f, const vec2& anchor) const {
        const Pen& pen = pens_[number];
        if (pen.texture == none) return 1.0f;
        if (is_anchored(pen)) return anchored_ink(inks_[number], anchor.x, f[1], f[2], anchor.y, pen.texture_length_px);
        return ink(inks_[number], f[0] / pen.texture_length_px, f[1], f[2]);
    }

    dvec4 corner(Index i) const {
        return {strokes_.arc[i].x, strokes_.arc[i].y, strokes_.half_width[i], strokes_.opacity[i]};
    }

    /// A column of the vertices over a triangle, where it is wanted.
    template <int N>
    static std::optional<OverTriangle<N>> over(bool wanted, const FixedTriangle& shape,
                                               const Array<glm::vec<N, float>>& column, glm::uvec3 c) {
        using Value = glm::vec<N, double>;
        if (!wanted) return {};
        return OverTriangle<N>(shape, Value(column[c[0]]), Value(column[c[1]]), Value(column[c[2]]));
    }

    /// Pixels of the depth buffer's core, whose bounds lie between pixels, or beyond the image.
    PixelBox core() const {
        const vec4& core = spine_->core();
        return {int(core.x), int(core.y), int(core.z), int(core.w)};
    }

    const Strokes& strokes_;
    In<Pen> pens_;
    const SpineTest* spine_;
    std::vector<PenTexture> inks_;
};

}  // namespace fovea::stroke
