// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of each pixel of a scene's picture alone, by which people decide whether to draw a line there. Cole
// 2009, section 3.2.4.
#pragma once

#include <array>

#include <fovea/base/cancel.h>
#include <fovea/image/shaded_buffer.h>
#include <fovea/scene/tracer.h>
#include <fovea/study/bitmap.h>

namespace fovea::study {

/// In the order of Property, as model files and tables name them.
struct PropertyName {
    const char* name;
    const char* label;
};
inline constexpr std::array property_names{
    PropertyName{"luminance", "Luminance"},
    PropertyName{"image_gradient", "Image Gradient"},
    PropertyName{"image_least_curvature", "Image Least Curvature"},
    PropertyName{"image_most_curvature", "Image Most Curvature"},
    PropertyName{"first_curvature", "First Principal Curvature"},
    PropertyName{"second_curvature", "Second Principal Curvature"},
    PropertyName{"mean_curvature", "Mean Curvature"},
    PropertyName{"gaussian_curvature", "Gaussian Curvature"},
    PropertyName{"first_curvature_change", "Change of the First Curvature"},
    PropertyName{"facing", "Facing the Viewer"},
    PropertyName{"view_curvature", "Curvature as Seen"},
    PropertyName{"view_curvature_change", "Change of Curvature as Seen"},
    PropertyName{"radial_curvature", "Radial Curvature"},
    PropertyName{"radial_curvature_change", "Change of Radial Curvature"},
    PropertyName{"radial_torsion", "Radial Torsion"},
};
inline constexpr std::size_t property_count = property_names.size();

/// Numbers without units, so that models know other scenes and other sizes of pictures.
///
/// Of the image: the scene in the light of a lamp at the eye on white, its luminance in [0, 1]; of it blurred by 2
/// pixels of a picture with a diagonal of 1280, the length of the gradient and both eigenvalues of the Hessian, times
/// that width and its square. Of the surface, with its feature size as the unit of length (field/fields.h): curvatures,
/// |first| >= |second|, positive where it is convex, and how fast the first one changes along its direction. Of the
/// view: n . v; the greatest curvature as it appears in the image, and its change along its direction there; radial
/// curvature, its derivative times the sine of the angle between n and v, and radial torsion (field/view_curvature.h).
/// Changes along directions without a sign are absolute. Surfaces are seen from their outside: where one is seen from
/// its back, its normal is turned around.
enum class Property : std::uint8_t {
    luminance,
    image_gradient,
    image_least_curvature,
    image_most_curvature,
    first_curvature,
    second_curvature,
    mean_curvature,
    gaussian_curvature,
    first_curvature_change,
    facing,
    view_curvature,
    view_curvature_change,
    radial_curvature,
    radial_curvature_change,
    radial_torsion,
};
static_assert(std::size_t(Property::radial_torsion) + 1 == property_count);

/// One per property.
using PropertyRow = std::array<float, property_count>;

/// Pixels or nodes, bottom row first. `known`: where a surface is seen whose lines are drawn, or is so near that lines
/// of its outline may lie there; these have its nearest one's properties of the surface and the view. Others are 0.
struct LocalProperties {
    Bitmap known;
    Array<PropertyRow> rows;
};

/// Of the middles of the pixels of the tracer's view.
LocalProperties local_properties(const Tracer& tracer, const Cancel& cancel);

/// Of the nodes of the lattice of its scene, shaded by a lamp at the eye, but of `border` nodes at each side, at least
/// image::fit_reach.
LocalProperties local_properties(const Tracer& tracer, const image::ShadedBuffer& shaded, int border,
                                 const Cancel& cancel);

}  // namespace fovea::study
