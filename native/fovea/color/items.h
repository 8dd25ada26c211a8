// SPDX-License-Identifier: GPL-3.0-or-later
// Which triangle is seen at the center of each pixel.
#pragma once

#include <algorithm>

#include <fovea/base/parallel.h>
#include <fovea/color/shader.h>
#include <fovea/visibility/depth.h>

namespace fovea::color {

/// Item buffer of occluding triangles.
class Items {
   public:
    Items(const Scene& scene, const View& view, const Cancel& cancel) : width_(view.width) {
        const std::vector<RasterMesh> meshes = depth_meshes(scene, view, 0.0);
        Index total = 0;
        for (const RasterMesh& mesh : meshes) {
            first_.push_back(total);
            total += static_cast<Index>(mesh.triangles.size());
        }
        for (const Occluder& occluder : occluders(scene, view, 0.0)) placement_.push_back(occluder.placement);
        items_.assign(std::size_t(view.width) * view.height, none);
        depths_.resize(items_.size());
        const auto draw = [&](const RasterTriangle& triangle, int y0, int y1) {
            const Index item = first_[triangle.mesh] + triangle.triangle;
            const TriangleRows rows(triangle);
            for (int y = y0; y < y1; ++y) {
                Index* items = &items_[std::size_t(y) * width_];
                float* nearest = &depths_[std::size_t(y) * width_];
                const auto in_front = [&](int x, double exact) {
                    const float depth = static_cast<float>(exact);
                    return items[x] == none || depth > nearest[x] || (depth == nearest[x] && item < items[x]);
                };
                each_texel(rows, y, in_front, [&](int x, double depth) {
                    items[x] = item;
                    nearest[x] = static_cast<float>(depth);
                });
            }
        };
        draw_triangles(raster_target(view, depth_layout(view, {.scale = 1, .margin = 0.0})), meshes, &cancel, draw);
    }

    std::size_t size() const { return items_.size(); }
    Index at(int x, int y) const { return items_[std::size_t(y) * width_ + x]; }
    /// Of its triangle, as the depth buffer has it (base/view.h).
    float depth(int x, int y) const { return depths_[std::size_t(y) * width_ + x]; }
    SeenTriangle triangle(Index item, const ColorShader& shader) const {
        const auto mesh = std::upper_bound(first_.begin(), first_.end(), item) - first_.begin() - 1;
        return shader.triangle(placement_[mesh], item - first_[mesh]);
    }

   private:
    int width_;
    Array<Index> items_, first_, placement_;
    Array<float> depths_;
};

}  // namespace fovea::color
