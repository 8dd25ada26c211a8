#include "stroke/pen_table.h"

#include <string>

#include "base/check.h"
#include "stroke/ink.h"

namespace fovea {

PenTable pen_table(In<Pen> pens, In<PenTexture> textures) {
    PenTable table;
    for (Index i = 0; i < pens.size(); ++i) {
        const Pen& pen = pens[i];
        check(pen.texture == none || pen.texture < textures.size(),
              "pen: there is no texture " + std::to_string(pen.texture));
        check(pen.away == none || pen.away < pens.size(),
              "pen: there is no pen " + std::to_string(pen.away) + " out of focus");
        PenTexture fitted;
        if (pen.texture != none) fitted = fit_texture(textures[pen.texture], pen.texture_length_px, pen.width_px);
        table.pens.push_back(vec4(pen.color, float(pen.away == none ? i : pen.away)));
        table.pens.push_back(
            vec4(pen.texture_length_px, pen.cap == Cap::round ? 1.0f : 0.0f, float(table.ink.size()),
                 pen.anchor == Anchor::path ? 1.0f : 0.0f));
        table.pens.push_back(vec4(fitted.width, fitted.height, 0.0f, 0.0f));
        table.ink.insert(table.ink.end(), fitted.ink.begin(), fitted.ink.end());
        table.ink.insert(table.ink.end(), fitted.row_mean.begin(), fitted.row_mean.end());
    }
    return table;
}

}  // namespace fovea
