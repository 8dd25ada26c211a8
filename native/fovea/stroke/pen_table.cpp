// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/stroke/pen_table.h>

#include <fovea/stroke/ink.h>

namespace fovea {

PenTable pen_table(In<Pen> pens, In<PenTexture> textures) {
    PenTable table;
    const std::vector<PenTexture> inks = fit_textures(pens, textures);
    for (Index i = 0; i < pens.size(); ++i) {
        const Pen& pen = pens[i];
        const PenTexture& fitted = inks[i];
        table.pens.push_back(vec4(vec3(pen.look.color), float(pen.away == none ? i : pen.away)));
        table.pens.push_back(vec4(pen.texture_length_px, pen.look.cap == Cap::round ? 1.0f : 0.0f,
                                  float(table.ink.size()), pen.look.texture_anchor == Anchor::path ? 1.0f : 0.0f));
        table.pens.push_back(vec4(fitted.width, fitted.height, 0.0f, 0.0f));
        table.ink.insert(table.ink.end(), fitted.ink.begin(), fitted.ink.end());
        table.ink.insert(table.ink.end(), fitted.row_mean.begin(), fitted.row_mean.end());
    }
    return table;
}

}  // namespace fovea
