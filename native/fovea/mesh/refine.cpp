// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/mesh/refine.h>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>
#include <fovea/mesh/refine_limit.h>

namespace fovea::mesh {

struct RefinedSurface::Limit {
    std::unique_ptr<LimitPatches> patches;
    OwnedMesh mesh;  // moved out of here once the Surface is built
    std::vector<Cell> cells;

    MeshArrays arrays() const {
        MeshArrays at_limit = mesh.arrays();
        at_limit.positions = patches->positions;
        return at_limit;
    }
};

namespace {

std::unique_ptr<Far::TopologyRefiner> uniform_refiner(const Cage& cage, int level) {
    auto uniform = shared(cage);
    Far::TopologyRefiner::UniformOptions options(level);
    options.fullTopologyInLastLevel = true;
    uniform->RefineUniform(options);
    return uniform;
}

}  // namespace

std::unique_ptr<RefinedSurface::Limit> RefinedSurface::limit_of(const std::string& name, const MeshArrays& mesh,
                                                                const Refinement& refinement) {
    Cage cage = cage_of(name, mesh, refinement);
    const auto uniform = uniform_refiner(cage, refinement.level);
    const std::vector<Cell> cells = cells_of(*uniform);
    auto limit = std::make_unique<Limit>();
    limit->mesh = refined_mesh(*uniform, cells, cage, mesh);
    limit->patches = std::make_unique<LimitPatches>(std::move(cage), *uniform, cells);
    limit->patches->evaluate(name, mesh.positions);
    limit->cells = cells;
    return limit;
}

RefinedSurface::RefinedSurface(const std::string& name, const MeshArrays& cage, const Refinement& refinement)
    : RefinedSurface(name, limit_of(name, cage, refinement)) {}

RefinedSurface::RefinedSurface(const std::string& name, std::unique_ptr<Limit> limit)
    : Surface(name, limit->arrays()), limit_(std::move(limit)) {
    limit_->mesh = {};
    jets = std::move(limit_->patches->jets);
}

RefinedSurface::~RefinedSurface() = default;

void RefinedSurface::move_cage(In<vec3> cage_positions, bool refit) {
    limit_->patches->evaluate(name(), cage_positions);
    set_positions(limit_->patches->positions, refit);
    jets = std::move(limit_->patches->jets);
}

void RefinedSurface::set_cage_rest(In<vec3> positions) {
    if (positions.empty()) return set_rest({});
    limit_->patches->evaluate(name(), positions);
    set_rest(limit_->patches->positions);
    limit_->patches->jets = {};
}

Array<float> RefinedSurface::mix_corners(In<float> values, int columns, In<int> polygon_offsets) const {
    const std::vector<Cell>& cells = limit_->cells;
    const std::size_t cage_polygons = polygon_offsets.empty() ? 0 : polygon_offsets.size() - 1;
    check(columns > 0 && cage_polygons > 0 && values.size() == std::size_t(polygon_offsets.back()) * columns,
          name() + ": one value per corner of the cage expected");
    // Catmull-Clark splits a non-quad into one face per corner.
    Array<int> first_face(cage_polygons);
    int faces = 0;
    for (std::size_t f = 0; f < cage_polygons; ++f) {
        const int corners = polygon_offsets[f + 1] - polygon_offsets[f];
        check(corners >= 0 && polygon_offsets[f] >= 0, name() + ": polygon_offsets must ascend");
        first_face[f] = faces;
        faces += corners == 4 ? 1 : corners;
    }
    for (const Cell& cell : cells)
        check(std::size_t(cell.polygon) < cage_polygons &&
                  polygon_offsets[cell.polygon + 1] - polygon_offsets[cell.polygon] >= 3,
              name() + ": these are not the polygons of its cage; give those that it was made of");
    Array<float> mixed(4 * cells.size() * columns);
    parallel_for(cells.size(), [&](std::size_t q) {
        const Cell& cell = cells[q];
        const int begin = polygon_offsets[cell.polygon], corners = polygon_offsets[cell.polygon + 1] - begin;
        const int part = (cell.face - first_face[cell.polygon]) % std::max(corners, 1);
        for (int c = 0; c < columns; ++c) {
            const auto at = [&](int i) { return values[std::size_t(begin + i % corners) * columns + c]; };
            float face[4];
            if (corners == 4) {
                for (int i = 0; i < 4; ++i) face[i] = at(i);
            } else {
                double sum = 0.0;
                for (int i = 0; i < corners; ++i) sum += at(i);
                face[0] = at(part);
                face[1] = 0.5f * (at(part) + at(part + 1));
                face[2] = static_cast<float>(sum / corners);
                face[3] = 0.5f * (at(part) + at(part + corners - 1));
            }
            for (int i = 0; i < 4; ++i) {
                const vec2 uv(cell.corner(i));
                mixed[(4 * q + i) * columns + c] =
                    glm::mix(glm::mix(face[0], face[1], uv.x), glm::mix(face[3], face[2], uv.x), uv.y);
            }
        }
    });
    return mixed;
}

}  // namespace fovea::mesh
