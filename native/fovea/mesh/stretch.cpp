// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/mesh/stretch.h>

#include <cmath>

#include <fovea/base/hash.h>

namespace fovea::mesh {
namespace {

/// Deviation (Frobenius norm) from the identity below which the stretch is taken as the identity; and the rounding
/// step.
constexpr double same_angles = 1e-4, step = 1.0 / (1 << 18);
/// Determinant (after normalization) at or below which a map counts as singular.
constexpr double flat = 1e-3;

double squares(const dmat3& m) { return glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]); }

}  // namespace

dmat3 stretch_of(const dmat3& linear) {
    const dmat3 identity(1.0), even = linear * std::sqrt(3.0 / squares(linear));
    if (!(std::abs(glm::determinant(even)) > flat)) return identity;
    // Nearest orthogonal matrix (rotation or reflection), by Newton's iteration.
    dmat3 motion = even;
    for (int i = 0; i < 40; ++i) {
        const dmat3 next = 0.5 * (motion + glm::transpose(glm::inverse(motion)));
        const double change = squares(next - motion);
        motion = next;
        if (change < 1e-28) break;
    }
    dmat3 stretch = glm::transpose(motion) * even;
    stretch = 0.5 * (stretch + glm::transpose(stretch));
    if (squares(stretch - identity) < same_angles * same_angles) return identity;
    for (int i = 0; i < 3; ++i) stretch[i] = glm::round(stretch[i] / step) * step;
    return stretch;
}

std::shared_ptr<const Surface> as_placed(const std::shared_ptr<const Surface>& surface, const dmat4& object_to_world) {
    const dmat3 stretch = stretch_of(dmat3(object_to_world));
    if (stretch == dmat3(1.0)) return surface;
    return *surface->cache().get<std::shared_ptr<const Surface>>(
        hash_bytes(&stretch, sizeof stretch), [&] { return std::make_shared<const Surface>(*surface, stretch); });
}

}  // namespace fovea::mesh
