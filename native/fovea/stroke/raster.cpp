// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/stroke/raster.h>

#include <algorithm>

#include <fovea/base/check.h>
#include <fovea/stroke/fragments.h>

namespace fovea::stroke {

Array<vec4> rasterize(const Strokes& strokes, In<Pen> pens, In<PenTexture> textures, int width, int height,
                      const SpineTest* spine) {
    check(width > 0 && height > 0, "raster: the picture needs a positive width and height");
    const Fragments fragments(strokes, pens, textures, spine);
    Array<vec4> image(std::size_t(width) * height);
    const auto row = [&](int y) { return image.data() + std::size_t(y) * width; };
    for_each_tile(strokes.px, strokes.triangles, width, height, [&](const PixelBox& box, In<Index> triangles) {
        for (int y = box.y0; y < box.y1; ++y) std::fill_n(row(y) + box.x0, box.x1 - box.x0, vec4(0.0f));
        fragments.each(triangles, box, [&](int x, int y, const Fragment& fragment) {
            row(y)[x] = over(row(y)[x], fragment.color, fragment.alpha);
        });
    });
    return image;
}

}  // namespace fovea::stroke
