// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/stroke/fragments.h>

#include <string>

#include <fovea/base/check.h>
#include <fovea/stroke/ink.h>

namespace fovea::stroke {
namespace {

void check_pieces(const Strokes& strokes, const SpineTest& spine) {
    check(strokes.piece.size() == strokes.px.size(), "strokes: the spine test needs a piece per vertex");
    const auto missing = std::ranges::find_if(strokes.piece, [&](Index q) { return !spine.has(q); });
    check(missing == strokes.piece.end(), "strokes: a vertex belongs to a piece that is not there or has no segments");
}

void check_input(const Strokes& strokes, In<Pen> pens) {
    const std::size_t count = strokes.px.size();
    check(strokes.arc.size() == count && strokes.half_width.size() == count && strokes.opacity.size() == count &&
              strokes.mix.size() == count && strokes.anchor.size() == count && strokes.pen.size() == count &&
              (strokes.color.empty() || strokes.color.size() == count),
          "strokes: px, arc, half_width, opacity, mix, anchor, pen and color must have the same length");
    Index corner = 0, pen = 0;
    for (const glm::uvec3 t : strokes.triangles) corner = std::max({corner, t.x, t.y, t.z});
    for (const Index p : strokes.pen) pen = std::max(pen, p);
    check(strokes.triangles.empty() || corner < count, "strokes: there is no vertex " + std::to_string(corner));
    check(strokes.pen.empty() || pen < pens.size(), "strokes: there is no pen " + std::to_string(pen));
}

}  // namespace

Fragments::Fragments(const Strokes& strokes, In<Pen> pens, In<PenTexture> textures, const SpineTest* spine)
    : strokes_(strokes), pens_(pens), spine_(spine) {
    check_input(strokes, pens);
    if (spine) check_pieces(strokes, *spine);
    inks_ = fit_textures(pens, textures);
}

}  // namespace fovea::stroke
