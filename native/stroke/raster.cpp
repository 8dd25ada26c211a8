#include "stroke/raster.h"

#include <algorithm>
#include <string>

#include "base/check.h"
#include "base/parallel.h"
#include "stroke/fragment.h"
#include "stroke/ink.h"
#include "stroke/tiles.h"

namespace fovea {

namespace {

/// A vertex value over the triangle; exact at the corners as drawn.
struct Plane {
    dvec2 origin;
    double value;
    dvec2 slope;

    double at(double x, double y) const {
        return value + slope.x * (x - origin.x) + slope.y * (y - origin.y);
    }
};

class Painter {
   public:
    Painter(const Strokes& strokes, In<Pen> pens, In<PenTexture> textures, int width, int height,
            Array<vec4>& image)
        : strokes_(strokes), pens_(pens), picture_{0, 0, width, height}, image_(image) {
        for (const Pen& pen : pens) {
            check(pen.texture == none || pen.texture < textures.size(),
                  "pen: there is no texture " + std::to_string(pen.texture));
            inks_.push_back(pen.texture == none ? PenTexture{}
                                                : fit_texture(textures[pen.texture],
                                                              pen.texture_length_px, pen.width_px));
        }
    }

    void tile(const Tiles& tiles, int i, int j) const {
        const int size = Tiles::size;
        const PixelBox box =
            intersect({i * size, j * size, (i + 1) * size, (j + 1) * size}, picture_);
        for (int y = box.y0; y < box.y1; ++y)
            std::fill_n(row(y) + box.x0, box.x1 - box.x0, vec4(0.0f));
        const std::size_t list = std::size_t(j) * tiles.across + i;
        for (std::size_t k = tiles.offsets[list]; k < tiles.offsets[list + 1]; ++k)
            triangle(strokes_.triangles[tiles.triangle[k]], box);
    }

   private:
    vec4* row(int y) const { return image_.data() + std::size_t(y) * picture_.x1; }

    void triangle(glm::uvec3 c, const PixelBox& tile) const {
        const FixedTriangle shape(strokes_.px[c[0]], strokes_.px[c[1]], strokes_.px[c[2]]);
        const PixelBox box = intersect(shape.box(), tile);
        const vec4* arc = strokes_.arc.data();
        const Plane u = plane(shape, arc[c[0]].x, arc[c[1]].x, arc[c[2]].x);
        const Plane v = plane(shape, arc[c[0]].y, arc[c[1]].y, arc[c[2]].y);
        const Plane half = plane(shape, c, strokes_.half_width),
                    opacity = plane(shape, c, strokes_.opacity);
        const float start = arc[c[0]].z, end = arc[c[0]].w;
        const Pen& pen = pens_[strokes_.pen[c[0]]];
        const PenTexture& texture = inks_[strokes_.pen[c[0]]];
        for (int y = box.y0; y < box.y1; ++y) {
            int x0 = box.x0, x1 = box.x1;
            shape.span(y, x0, x1);
            for (int x = x0; x < x1; ++x) {
                const double px = x + 0.5, py = y + 0.5;
                const float fu = float(u.at(px, py)), fv = float(v.at(px, py)),
                            fh = float(half.at(px, py));
                float alpha = coverage(fu, fv, start, end, fh, pen.cap);
                if (alpha <= 0.0f) continue;
                if (pen.texture != none) alpha *= ink(texture, fu, fv, fh, pen.texture_length_px);
                alpha *= float(opacity.at(px, py)) * pen.opacity;
                row(y)[x] = over(row(y)[x], pen.color, alpha);
            }
        }
    }

    Plane plane(const FixedTriangle& shape, glm::uvec3 c, const Array<float>& values) const {
        return plane(shape, values[c[0]], values[c[1]], values[c[2]]);
    }

    static Plane plane(const FixedTriangle& shape, double a, double b, double c) {
        const dvec2 p = shape.corner(0), e = shape.corner(1) - p, f = shape.corner(2) - p;
        const double area = e.x * f.y - e.y * f.x;
        return {p, a, dvec2((b - a) * f.y - (c - a) * e.y, (c - a) * e.x - (b - a) * f.x) / area};
    }

    const Strokes& strokes_;
    In<Pen> pens_;
    PixelBox picture_;
    Array<vec4>& image_;
    std::vector<PenTexture> inks_;
};

void check_input(const Strokes& strokes, In<Pen> pens) {
    const std::size_t count = strokes.px.size();
    check(strokes.arc.size() == count && strokes.half_width.size() == count &&
              strokes.opacity.size() == count && strokes.pen.size() == count,
          "strokes: px, arc, half_width, opacity and pen must have the same length");
    Index corner = 0, pen = 0;
    for (const glm::uvec3 t : strokes.triangles) corner = std::max({corner, t.x, t.y, t.z});
    for (const Index p : strokes.pen) pen = std::max(pen, p);
    check(strokes.triangles.empty() || corner < count,
          "strokes: there is no vertex " + std::to_string(corner));
    check(strokes.pen.empty() || pen < pens.size(),
          "strokes: there is no pen " + std::to_string(pen));
}

}  // namespace

void raster(const Strokes& strokes, In<Pen> pens, In<PenTexture> textures, int width, int height,
            Array<vec4>& image) {
    check(width > 0 && height > 0, "raster: the picture needs a positive width and height");
    check_input(strokes, pens);
    image.resize(std::size_t(width) * height);
    const Painter painter(strokes, pens, textures, width, height, image);
    const Tiles tiles = sort_into_tiles(strokes.px, strokes.triangles, width, height);
    parallel_for(
        std::size_t(tiles.across) * tiles.up,
        [&](std::size_t t) { painter.tile(tiles, int(t % tiles.across), int(t / tiles.across)); },
        1);
}

}  // namespace fovea
