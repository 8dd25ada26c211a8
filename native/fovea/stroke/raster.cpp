// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/stroke/raster.h>

#include <algorithm>
#include <string>

#include <fovea/base/check.h>
#include <fovea/raster/tiles.h>
#include <fovea/stroke/fragment.h>
#include <fovea/stroke/ink.h>

namespace fovea::stroke {

namespace {

/// Pixels of a depth buffer's core, whose bounds lie between pixels, or beyond the image.
PixelBox pixels_of(const vec4& core) { return {int(core.x), int(core.y), int(core.z), int(core.w)}; }

class Painter {
   public:
    Painter(const Strokes& strokes, In<Pen> pens, In<PenTexture> textures, int width, int height, Array<vec4>& image,
            const SpineTest* spine)
        : strokes_(strokes),
          pens_(pens),
          picture_{0, 0, width, height},
          decided_(spine ? intersect(picture_, pixels_of(spine->core())) : picture_),
          image_(image),
          spine_(spine),
          inks_(fit_textures(pens, textures)) {}

    void tile(const PixelBox& box, In<Index> triangles) const {
        for (int y = box.y0; y < box.y1; ++y) std::fill_n(row(y) + box.x0, box.x1 - box.x0, vec4(0.0f));
        const PixelBox drawn = intersect(box, decided_);
        if (drawn.empty()) return;
        for (const Index t : triangles) triangle(strokes_.triangles[t], drawn);
    }

   private:
    vec4* row(int y) const { return image_.data() + std::size_t(y) * picture_.x1; }

    void triangle(glm::uvec3 c, const PixelBox& tile) const {
        const FixedTriangle shape(strokes_.px[c[0]], strokes_.px[c[1]], strokes_.px[c[2]]);
        const PixelBox box = intersect(shape.box(), tile);
        const OverTriangle<4> values(shape, corner(c[0]), corner(c[1]), corner(c[2]));
        const OverTriangle<3> mixes(shape, dvec3(strokes_.mix[c[0]]), dvec3(strokes_.mix[c[1]]),
                                    dvec3(strokes_.mix[c[2]]));
        const float start = strokes_.arc[c[0]].z, end = strokes_.arc[c[0]].w, path_px = strokes_.path_px[c[0]];
        const Pen& pen = pens_[strokes_.pen[c[0]]];
        const Index away = pen.away;
        const Pen& other = away == none ? pen : pens_[away];
        const bool tinted = strokes_.mix[c[0]].z + strokes_.mix[c[1]].z + strokes_.mix[c[2]].z > 0.0f;
        for (int y = box.y0; y < box.y1; ++y) {
            int x0 = box.x0, x1 = box.x1;
            shape.span(y, x0, x1);
            for (int x = x0; x < x1; ++x) {
                const vec4 f = values.at(x, y);
                float alpha = coverage(f[0], f[1], start, end, f[2], pen.look.cap);
                if (alpha <= 0.0f) continue;
                const vec3 mix = away == none && !tinted ? vec3(0.0f) : mixes.at(x, y);
                vec3 color(pen.look.color);
                if (away != none) color = glm::mix(color, vec3(other.look.color), mix.x);
                if (tinted) {
                    const vec3 second(pen.look.second_color), second_away(other.look.second_color);
                    color = glm::mix(color, glm::mix(second, second_away, mix.x), mix.z);
                }
                const float ink = ink_of(strokes_.pen[c[0]], f, path_px);
                alpha *= away == none ? ink : glm::mix(ink, ink_of(away, f, path_px), mix.y);
                if (spine_) alpha *= spine_->visibility(strokes_.piece[c[0]], std::clamp(f[0], start, end));
                row(y)[x] = over(row(y)[x], color, alpha * f[3]);
            }
        }
    }

    float ink_of(Index number, const vec4& f, float path_px) const {
        const Pen& pen = pens_[number];
        if (pen.texture == none) return 1.0f;
        if (pen.look.texture_anchor == Anchor::path)
            return anchored_ink(inks_[number], f[0], f[1], f[2], path_px, pen.texture_length_px);
        return ink(inks_[number], f[0] / pen.texture_length_px, f[1], f[2]);
    }

    dvec4 corner(Index i) const {
        return {strokes_.arc[i].x, strokes_.arc[i].y, strokes_.half_width[i], strokes_.opacity[i]};
    }

    const Strokes& strokes_;
    In<Pen> pens_;
    PixelBox picture_, decided_;
    Array<vec4>& image_;
    const SpineTest* spine_;
    std::vector<PenTexture> inks_;
};

void check_pieces(const Strokes& strokes, const SpineTest& spine) {
    check(strokes.piece.size() == strokes.px.size(), "strokes: the spine test needs a piece per vertex");
    const auto missing = std::ranges::find_if(strokes.piece, [&](Index q) { return !spine.has(q); });
    check(missing == strokes.piece.end(), "strokes: a vertex belongs to a piece that is not there or has no segments");
}

void check_input(const Strokes& strokes, In<Pen> pens) {
    const std::size_t count = strokes.px.size();
    check(strokes.arc.size() == count && strokes.half_width.size() == count && strokes.opacity.size() == count &&
              strokes.mix.size() == count && strokes.path_px.size() == count && strokes.pen.size() == count,
          "strokes: px, arc, half_width, opacity, mix, path_px and pen must have the same length");
    Index corner = 0, pen = 0;
    for (const glm::uvec3 t : strokes.triangles) corner = std::max({corner, t.x, t.y, t.z});
    for (const Index p : strokes.pen) pen = std::max(pen, p);
    check(strokes.triangles.empty() || corner < count, "strokes: there is no vertex " + std::to_string(corner));
    check(strokes.pen.empty() || pen < pens.size(), "strokes: there is no pen " + std::to_string(pen));
}

}  // namespace

Array<vec4> rasterize(const Strokes& strokes, In<Pen> pens, In<PenTexture> textures, int width, int height,
                      const SpineTest* spine) {
    check(width > 0 && height > 0, "raster: the picture needs a positive width and height");
    check_input(strokes, pens);
    if (spine) check_pieces(strokes, *spine);
    Array<vec4> image(std::size_t(width) * height);
    const Painter painter(strokes, pens, textures, width, height, image, spine);
    for_each_tile(strokes.px, strokes.triangles, width, height,
                  [&](const PixelBox& tile, In<Index> triangles) { painter.tile(tile, triangles); });
    return image;
}

}  // namespace fovea::stroke
