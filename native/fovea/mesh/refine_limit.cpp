// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/mesh/refine_limit.h>

#include <algorithm>
#include <cmath>
#include <opensubdiv/far/patchTableFactory.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/stencilTable.h>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>

namespace fovea::mesh {
namespace {

/// Consecutive quads around a vertex, in their order around it, that are not separated by sharp edges. Edge i of a
/// vertex precedes face i.
struct Sector {
    int begin = 0, length = 0;
};

Sector widest_sector(const Far::TopologyLevel& fine, int v) {
    const auto edges = fine.GetVertexEdges(v);
    const int count = fine.GetVertexFaces(v).size();
    const auto sharp = [&](int i) { return fine.IsEdgeInfSharp(edges[i]); };
    Sector widest{0, 0};
    for (int i = 0; i < count; ++i) {
        if (!sharp(i)) continue;
        int n = 1;
        while (n < count && !sharp((i + n) % count)) ++n;
        if (n > widest.length) widest = {i, n};
    }
    return widest.length > 0 ? widest : Sector{0, count};
}

}  // namespace

LimitPatches::LimitPatches(Cage cage, const Far::TopologyRefiner& uniform, const std::vector<Cell>& cells)
    : cage_(std::move(cage)) {
    build_patches(uniform.GetMaxLevel());
    const Far::PatchMap map(*table_);
    const Far::TopologyLevel& fine = uniform.GetLevel(uniform.GetMaxLevel());
    const int vertices = fine.GetNumVertices();
    anchors_.resize(vertices);
    for (int v = 0; v < vertices; ++v) {
        add_places(map, fine, cells, v);
        shape_rows_.offsets.push_back(static_cast<Index>(shapes_.size()));
    }
    patch_number_ = {};
}

void LimitPatches::build_patches(int level) {
    bool semi_sharp = false;
    const Far::TopologyLevel& base = cage_.refiner->GetLevel(0);
    for (int e = 0; e < base.GetNumEdges() && !semi_sharp; ++e) semi_sharp = base.IsEdgeSemiSharp(e);
    for (int v = 0; v < base.GetNumVertices() && !semi_sharp; ++v) semi_sharp = base.IsVertexSemiSharp(v);

    const int isolation = level + (semi_sharp ? crease_isolation : smooth_isolation);
    Far::PatchTableFactory::Options options(isolation);
    options.useInfSharpPatch = true;
    options.generateLegacySharpCornerPatches = false;
    options.generateVaryingTables = false;
    options.SetEndCapType(Far::PatchTableFactory::Options::ENDCAP_GREGORY_BASIS);
    options.SetPatchPrecision<double>();
    auto adaptive = options.GetRefineAdaptiveOptions();
    adaptive.SetSecondaryLevel(level + smooth_isolation);
    cage_.refiner->RefineAdaptive(adaptive);
    table_.reset(Far::PatchTableFactory::Create(*cage_.refiner, options));
    patch_number_.assign(table_->GetNumPatchesTotal(), none);
}

/// The patch that contains the points slightly inside from `at` in the direction of `towards`, and the parameters of
/// `at` in it; patch `none` if there is none.
LimitPatches::Place LimitPatches::find(const Far::PatchMap& map, int face, const dvec2& at, const dvec2& towards) {
    const dvec2 inside = at + (towards - at) * 0.03125;
    const Far::PatchTable::PatchHandle* handle = map.FindPatch(face, inside.x, inside.y);
    if (!handle) return {};
    Index& number = patch_number_[handle->patchIndex];
    if (number == none) {
        number = static_cast<Index>(handles_.size());
        handles_.push_back(*handle);
    }
    double u = at.x, v = at.y;
    table_->GetPatchParam(*handle).Normalize(u, v);
    return {number, float(u), float(v)};
}

void LimitPatches::add_places(const Far::PatchMap& map, const Far::TopologyLevel& fine, const std::vector<Cell>& cells,
                              int v) {
    const auto faces = fine.GetVertexFaces(v);
    const auto corners = fine.GetVertexFaceLocalIndices(v);
    const Sector sector = widest_sector(fine, v);
    const auto first = static_cast<std::ptrdiff_t>(shapes_.size());
    for (int i = 0; i < sector.length; ++i) {
        const int at = (sector.begin + i) % faces.size();
        const Cell& cell = cells[faces[at]];
        const dvec2 middle = cell.middle();
        Place place = find(map, cell.face, cell.corner(corners[at]), middle);
        if (i == 0) anchors_[v] = place;
        if (place.patch == none) continue;
        // The vertex is at a non-bicubic patch: sample the middle of the quad instead. Four patches may meet there;
        // those towards the other corners are bicubic.
        if (!is_bicubic(place.patch)) place = find(map, cell.face, middle, cell.corner((corners[at] + 1) % 4));
        const auto known =
            std::find_if(shapes_.begin() + first, shapes_.end(), [&](const Place& other) { return other.same(place); });
        if (known == shapes_.end())
            shapes_.push_back(place);
        else
            known->weight += 1.0f;
    }
}

bool LimitPatches::is_bicubic(Index patch) const {
    return table_->GetPatchDescriptor(handles_[patch]).GetType() == Far::PatchDescriptor::REGULAR;
}

void LimitPatches::evaluate(const std::string& name, In<vec3> cage_positions) {
    check(cage_positions.size() == cage_.number.size(), name + ": " + std::to_string(cage_positions.size()) +
                                                            " positions for " + std::to_string(cage_.number.size()) +
                                                            " vertices; give one for each");
    const int vertices = cage_.refiner->GetNumVerticesTotal();
    points_.resize(std::size_t(vertices) + table_->GetNumLocalPoints());
    for (std::size_t v = 0; v < cage_positions.size(); ++v)
        if (cage_.number[v] != none) points_[cage_.number[v]].p = dvec3(cage_positions[v]);
    const Far::PrimvarRefinerReal<double> refine(*cage_.refiner);
    Point* coarse = points_.data();
    for (int l = 1; l <= cage_.refiner->GetMaxLevel(); ++l) {
        Point* fine = coarse + cage_.refiner->GetLevel(l - 1).GetNumVertices();
        refine.Interpolate(l, coarse, fine);
        coarse = fine;
    }
    if (table_->GetNumLocalPoints() > 0)
        table_->GetLocalPointStencilTable<double>()->UpdateValues(points_.data(), points_.data() + vertices);

    evaluate_patches();
    positions.resize(anchors_.size());
    jets.resize(anchors_.size());
    parallel_for(anchors_.size(), 256, [&](std::size_t v) { evaluate_vertex(Index(v)); });
}

void LimitPatches::evaluate_patches() {
    bicubic_.resize(handles_.size());
    parallel_for(handles_.size(), 64, [&](std::size_t i) {
        if (!is_bicubic(Index(i))) return;
        // OpenSubdiv's derivatives are with respect to the face's parameters; `size` rescales them to the patch's.
        // The depth also counts the first split of non-quads.
        const double size = 1.0 / (1 << table_->GetPatchParam(handles_[i]).GetDepth());
        PatchCorner corner[4];
        for (int k = 0; k < 4; ++k) {
            ParametricJet jet;
            const dvec3 p = by_basis({Index(i), float(k & 1), float(k >> 1)}, jet);
            corner[k] = {p, size * jet.u, size * jet.v, size * size * jet.uv};
        }
        bicubic_[i] = Bicubic::through(corner);
    });
}

/// Position, and derivatives up to second order, from OpenSubdiv's basis.
dvec3 LimitPatches::by_basis(const Place& place, ParametricJet& jet) const {
    const Far::PatchTable::PatchHandle& handle = handles_[place.patch];
    const auto points = table_->GetPatchVertices(handle);
    double u = place.u, v = place.v, w[20], du[20], dv[20], duu[20], duv[20], dvv[20];
    table_->GetPatchParam(handle).Unnormalize(u, v);
    table_->EvaluateBasis(handle, u, v, w, du, dv, duu, duv, dvv);
    dvec3 result(0.0);
    jet = {};
    for (int n = 0; n < points.size(); ++n) {
        const dvec3& p = points_[points[n]].p;
        result += w[n] * p;
        jet.u += du[n] * p;
        jet.v += dv[n] * p;
        jet.uu += duu[n] * p;
        jet.uv += duv[n] * p;
        jet.vv += dvv[n] * p;
    }
    return result;
}

/// Derivatives are exact up to third order in bicubic patches; elsewhere third derivatives are zero.
dvec3 LimitPatches::point(const Place& place, ParametricJet& jet) const {
    return is_bicubic(place.patch) ? bicubic_[place.patch].at(place.u, place.v, jet) : by_basis(place, jet);
}

void LimitPatches::evaluate_vertex(Index v) {
    positions[v] = vec3(std::nanf(""));
    jets[v] = {};
    if (anchors_[v].patch == none) return;
    ParametricJet parametric;
    positions[v] = vec3(point(anchors_[v], parametric));
    HeightJetD jet = height_jet(parametric);
    HeightJetD sum{};
    double weight = 0.0;
    for (Index s = shape_rows_.begin(v); s < shape_rows_.end(v); ++s) {
        point(shapes_[s], parametric);
        const HeightJetD shape = height_jet(parametric);
        if (shape.normal == dvec3(0.0)) continue;
        if (weight == 0.0) {
            // Where the normal at the vertex itself is undefined (a spike, singular parameters), that of the first
            // sample is used.
            const bool known = jet.normal != dvec3(0.0);
            sum.normal = known ? jet.normal : shape.normal;
            sum.tangent = known ? jet.tangent : shape.tangent;
        }
        const HeightJetD own = turned(shape, sum.normal, sum.tangent);
        for (int i = 0; i < 3; ++i) sum.second[i] += shapes_[s].weight * own.second[i];
        for (int i = 0; i < 4; ++i) sum.third[i] += shapes_[s].weight * own.third[i];
        weight += shapes_[s].weight;
    }
    jets[v].normal = vec3(weight > 0.0 ? sum.normal : jet.normal);
    jets[v].tangent = vec3(weight > 0.0 ? sum.tangent : jet.tangent);
    if (!(weight > 0.0)) return;
    for (int i = 0; i < 3; ++i) jets[v].second[i] = float(sum.second[i] / weight);
    for (int i = 0; i < 4; ++i) jets[v].third[i] = float(sum.third[i] / weight);
}

}  // namespace fovea::mesh
