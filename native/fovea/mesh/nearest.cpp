// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/mesh/nearest.h>

#include <algorithm>
#include <limits>

namespace fovea {

dvec3 nearest_in_triangle(const dvec3& p, const dvec3& a, const dvec3& b, const dvec3& c) {
    const dvec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
    if (d1 <= 0 && d2 <= 0) return a;
    const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
    if (d3 >= 0 && d4 <= d3) return b;
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return d1 == d3 ? a : a + d1 / (d1 - d3) * ab;
    const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
    if (d6 >= 0 && d5 <= d6) return c;
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return d2 == d6 ? a : a + d2 / (d2 - d6) * ac;
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        const double length = (d4 - d3) + (d5 - d6);
        return length > 0 ? b + (d4 - d3) / length * (c - b) : b;
    }
    const double sum = va + vb + vc;
    return a + vb / sum * ab + vc / sum * ac;
}

NearestPoint::NearestPoint(std::vector<dvec3> positions, std::vector<glm::uvec3> triangles, double cell)
    : positions_(std::move(positions)), triangles_(std::move(triangles)) {
    if (triangles_.empty()) return;
    dvec3 high(std::numeric_limits<double>::lowest());
    low_ = dvec3(std::numeric_limits<double>::max());
    for (const glm::uvec3& t : triangles_)
        for (int i = 0; i < 3; ++i) {
            low_ = glm::min(low_, positions_[t[i]]);
            high = glm::max(high, positions_[t[i]]);
        }
    const dvec3 extent = high - low_;
    const double longest = std::max({extent.x, extent.y, extent.z});
    cell_ = std::max({cell, longest / 200.0, std::numeric_limits<double>::min()});
    size_ = glm::ivec3(extent / cell_) + 1;
    for (Index t = 0; t < triangles_.size(); ++t) {
        const glm::uvec3& v = triangles_[t];
        const dvec3 &a = positions_[v.x], &b = positions_[v.y], &c = positions_[v.z];
        const glm::ivec3 first = cell_of(glm::min(a, glm::min(b, c))), last = cell_of(glm::max(a, glm::max(b, c)));
        for (int z = first.z; z <= last.z; ++z)
            for (int y = first.y; y <= last.y; ++y)
                for (int x = first.x; x <= last.x; ++x) cells_[x + size_.x * (y + size_.y * z)].push_back(t);
    }
}

glm::ivec3 NearestPoint::cell_of(const dvec3& p) const {
    const dvec3 inside = glm::clamp((p - low_) / cell_, dvec3(0.0), dvec3(size_ - 1));
    return glm::ivec3(inside);
}

dvec3 NearestPoint::to(const dvec3& p) const {
    dvec3 best = p;
    double least = std::numeric_limits<double>::max();
    const glm::ivec3 home = cell_of(p);
    const int longest = triangles_.empty() ? -1 : std::max({size_.x, size_.y, size_.z});
    // Shells of cells around the point's own, until no cell beyond can hold anything nearer.
    for (int r = 0; r <= longest && least > cell_ * (r - 1) * cell_ * std::max(r - 1, 0); ++r) {
        const glm::ivec3 first = glm::max(home - r, glm::ivec3(0)), last = glm::min(home + r, size_ - 1);
        for (int z = first.z; z <= last.z; ++z)
            for (int y = first.y; y <= last.y; ++y)
                for (int x = first.x; x <= last.x; ++x) {
                    const glm::ivec3 away = glm::abs(glm::ivec3(x, y, z) - home);
                    if (std::max({away.x, away.y, away.z}) != r) continue;
                    const auto found = cells_.find(x + size_.x * (y + size_.y * z));
                    if (found == cells_.end()) continue;
                    for (Index t : found->second) {
                        const glm::uvec3& v = triangles_[t];
                        const dvec3 q = nearest_in_triangle(p, positions_[v.x], positions_[v.y], positions_[v.z]);
                        const double distance2 = glm::dot(q - p, q - p);
                        if (distance2 < least) {
                            least = distance2;
                            best = q;
                        }
                    }
                }
    }
    return best;
}

}  // namespace fovea
