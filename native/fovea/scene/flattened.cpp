// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/scene/flattened.h>

#include <cmath>

namespace fovea::scene {
namespace {

/// Ratio of the smallest to the largest scale up to which single precision cannot invert a transform; and the ratio
/// that it gets. Below 1/2000 a surface counts as one without curvature (mesh/stretch.h).
constexpr double flat = 1e-6, thickness = 1.0 / 2048.0;

double size(const dmat3& m) { return std::sqrt(glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2])); }

/// The cross products of two columns each; their size is about the product of the two largest scales.
dmat3 areas(const dmat3& m) { return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])}; }

dvec3 longest(const dmat3& m) {
    const dvec3& of_two = glm::dot(m[0], m[0]) >= glm::dot(m[1], m[1]) ? m[0] : m[1];
    return glm::dot(of_two, of_two) >= glm::dot(m[2], m[2]) ? of_two : m[2];
}

/// Unit vector across the columns of a flat map: across their plane, or across their line.
dvec3 across(const dmat3& m, bool is_line) {
    if (!is_line) return glm::normalize(longest(areas(m)));
    const dvec3 along = longest(m), size = glm::abs(along);
    const bool is_x = size.x <= size.y && size.x <= size.z;
    const dvec3 least = is_x ? dvec3(1, 0, 0) : size.y <= size.z ? dvec3(0, 1, 0) : dvec3(0, 0, 1);
    return glm::normalize(glm::cross(along, least));
}

/// The direction or its opposite: upwards, or where it is level along positive y or x.
dvec3 upwards(const dvec3& way) {
    constexpr double level = 1e-6;
    const double rise = std::abs(way.z) > level ? way.z : std::abs(way.y) > level ? way.y : way.x;
    return rise < 0.0 ? -way : way;
}

}  // namespace

dmat4 with_thickness(const dmat4& object_to_world, const dvec3& center, const dvec3& half) {
    dmat3 linear(object_to_world);
    const double largest = size(linear);
    if (!(largest > 0.0) || !std::isfinite(largest)) return object_to_world;
    linear /= largest;
    dvec3 middle(object_to_world * dvec4(center, 1.0));
    bool changed = false;
    for (int axes = 0; axes < 2; ++axes) {
        const double two = size(areas(linear));
        const bool is_line = !(two > flat);
        if (!is_line && std::abs(glm::determinant(linear)) > flat * two) break;
        const dvec3 out = upwards(across(linear, is_line)), in = across(glm::transpose(linear), is_line);
        const dmat3 more = thickness * glm::outerProduct(out, in);
        linear += glm::determinant(linear + more) < 0.0 ? -more : more;
        middle += thickness * largest * glm::dot(glm::abs(in), half) * out;
        changed = true;
    }
    if (!changed) return object_to_world;
    linear *= largest;
    dmat4 thick(linear);
    thick[3] = dvec4(middle - linear * center, 1.0);
    return thick;
}

}  // namespace fovea::scene
