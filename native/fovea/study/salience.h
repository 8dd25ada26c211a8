// SPDX-License-Identifier: GPL-3.0-or-later
// Salience: how far a place of a picture stands out of the rest. It predicts where eyes go first by what is there to be
// seen alone; people look at faces and read, too.
#pragma once

#include <fovea/color/png.h>
#include <fovea/study/plane.h>

namespace fovea::study {

/// Diagonal in pixels of pictures as they are looked at: of 640 x 480. Larger and smaller ones are resized.
inline constexpr double usual_diagonal = 800.0;

/// What salience is found in: intensity and two color opponencies, as displayed; in cells whose size follows from that
/// of the picture.
struct Channels {
    Plane intensity;    ///< in [0, 1]
    Plane red_green;    ///< in [-1, 1]; 0 where it is dark
    Plane blue_yellow;  ///< the same
};

/// Opponencies are those of Walther & Koch, "Modeling Attention to Salient Proto-Objects", 2006.
Channels channels_of(const color::RgbImage& picture, int width, int height);

/// Itti, Koch & Niebur, "A Model of Saliency-Based Visual Attention for Rapid Scene Analysis", 1998: differences of
/// intensity, color and orientation between centers and surrounds in pyramids of the picture. Cells are 16 pixels wide
/// in a picture of 640 x 480. All 0 where nothing stands out.
Plane itti_koch(const color::RgbImage& picture);

/// A second opinion: what is rare in the spectrum of the picture. Hou & Zhang, "Saliency Detection: A Spectral Residual
/// Approach", 2007. 64 cells high.
Plane spectral_residual(const color::RgbImage& picture);

}  // namespace fovea::study
