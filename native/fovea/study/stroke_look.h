// SPDX-License-Identifier: GPL-3.0-or-later
// How wide and how dark strokes are in pictures of drawings.
#pragma once

#include <fovea/base/columns.h>
#include <fovea/color/png.h>
#include <fovea/study/bitmap.h>

namespace fovea::study {

/// Strokes across their middle lines, at those of the lines' pixels that have a direction.
struct StrokeLooks {
    Array<Index> pixel;
    Array<float> width, darkness;

    static constexpr auto columns = each_of(
        Column{"pixel", &StrokeLooks::pixel, "(N,) uint32 numbers of pixels, row by row from below"},
        Column{"width", &StrokeLooks::width, "(N,) float32 [px]"},
        Column{"darkness", &StrokeLooks::darkness,
               "(N,) float32 share of the paper's light that is missing in the stroke, [0, 1]; NaN on dark paper"});
};

/// `lines`: of one pixel's width, of the same size, in the middle of the strokes. A width is the ink across a stroke as
/// a share of how dark the stroke is at most nearby: borders of half a pixel's ink count half, so that strokes narrower
/// than two pixels are measured, too. Whether half a pixel's ink is half as much light (scans, renders) or half the
/// value (programs that paint) is told from the borders themselves, which have all shares of ink equally often; where
/// all lines lie alike on the pixels, it is taken for the latter.
StrokeLooks looks_of(const color::GrayImage& picture, const Bitmap& lines);

}  // namespace fovea::study
