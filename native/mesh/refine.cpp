#include "mesh/refine.h"

#include "mesh/refine_limit.h"

namespace fovea {

struct RefinedSurface::Limit {
    std::unique_ptr<LimitPatches> patches;
    RefinedMesh mesh;  // until there is a Surface of it
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
    return limit;
}

RefinedSurface::RefinedSurface(const std::string& name, const MeshArrays& cage, const Refinement& refinement)
    : RefinedSurface(name, limit_of(name, cage, refinement)) {}

RefinedSurface::RefinedSurface(const std::string& name, std::unique_ptr<Limit> limit)
    : Surface(name, limit->mesh.arrays(limit->patches->positions)), limit_(std::move(limit)) {
    limit_->mesh = {};
    jets = std::move(limit_->patches->jets);
}

RefinedSurface::~RefinedSurface() = default;

void RefinedSurface::move_cage(In<vec3> cage_positions) {
    limit_->patches->evaluate(name(), cage_positions);
    set_positions(limit_->patches->positions);
    jets = std::move(limit_->patches->jets);
}

}  // namespace fovea
