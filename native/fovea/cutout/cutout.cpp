// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/cutout/cutout.h>

#include <algorithm>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>

namespace fovea::cutout {

CutMesh::CutMesh(const std::string& name, const MeshArrays& mesh, const std::vector<Cut>& cuts,
                 const CutOptions& options)
    : name_(name), vertices_(mesh.positions.size()), corners_(mesh.corner_verts.size()) {
    check_mesh(name, mesh);
    const std::size_t polygon_total = mesh.polygon_offsets.empty() ? 0 : mesh.polygon_offsets.size() - 1;
    check(options.cut_of_polygon.size() == polygon_total, name + ": cut-out: one cut per polygon expected");
    for (const Cut& cut : cuts) {
        check(cut.uvs.size() == corners_, name + ": cut-out: texture coordinates per corner expected");
        check(cut.opacity && cut.opacity->width > 0 && cut.opacity->height > 0 &&
                  cut.opacity->texels.size() == std::size_t(cut.opacity->width) * cut.opacity->height,
              name + ": cut-out: width x height texels expected");
    }
    for (const int cut : options.cut_of_polygon)
        check(cut < int(cuts.size()), name + ": cut-out: each polygon must name a cut that is given, or none");
    build(mesh, cuts, options);
}

Array<vec3> CutMesh::moved(In<vec3> positions) const {
    check(positions.size() == vertices_, name_ + ": cut-out: " + std::to_string(positions.size()) + " positions for " +
                                             std::to_string(vertices_) + " vertices; give one for each");
    Array<vec3> all(vertices_ + new_vertices_.size());
    std::copy(positions.begin(), positions.end(), all.begin());
    parallel_for(new_vertices_.size(), [&](std::size_t i) {
        const Mean& mean = new_vertices_[i];
        dvec3 sum(0.0);
        for (int k = 0; k < 3; ++k)
            if (mean.of[k] != none) sum += mean.weight[k] * dvec3(positions[mean.of[k]]);
        all[vertices_ + i] = vec3(sum);
    });
    return all;
}

Array<float> CutMesh::mix_corners(In<float> values, int columns) const {
    check(columns > 0 && values.size() == corners_ * std::size_t(columns),
          name_ + ": cut-out: one row of values per corner expected");
    Array<float> mixed(corner_means_.size() * columns);
    parallel_for(corner_means_.size(), [&](std::size_t c) {
        const Mean& mean = corner_means_[c];
        for (int column = 0; column < columns; ++column) {
            double sum = 0.0;
            for (int k = 0; k < 3; ++k)
                if (mean.of[k] != none)
                    sum += mean.weight[k] * double(values[mean.of[k] * std::size_t(columns) + column]);
            mixed[c * columns + column] = static_cast<float>(sum);
        }
    });
    return mixed;
}

}  // namespace fovea::cutout
