// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_surface.h"

#include <fovea/cutout/cutout.h>
#include <fovea/mesh/polygon_surface.h>
#include <fovea/mesh/refine.h>
#include <fovea/mesh/spheres.h>
#include <fovea/mesh/strands.h>
#include <fovea/repair/repair.h>

#include "random_mesh.h"

namespace fovea::fuzz {
namespace {

using meshes::Mesh;

std::shared_ptr<Surface> repaired_surface(Choices& choices, const std::string& name, const MeshArrays& mesh) {
    repair::Repair repair{.orient = choices.chance(0.7), .resample = choices.below(4)};
    // Lengths below the mesh's own give as many triangles as one likes.
    if (choices.chance(0.1)) repair.edge_length = choices.one_of({-1.0, double(NAN), double(INFINITY), 1e30});
    if (choices.chance(0.02)) repair.resample = choices.one_of({-1, 101});
    const repair::RepairedMesh made = repaired(name, mesh, repair);
    return std::make_shared<Surface>(name, made.arrays());
}

std::shared_ptr<Surface> refined_surface(Choices& choices, const std::string& name, const MeshArrays& mesh) {
    std::vector<float> edges, vertices;
    const auto crease = [&] {
        return choices.chance(0.1) ? float(choices.broken()) : float(choices.between(0.0, 1.0));
    };
    if (choices.chance(0.3)) std::generate_n(std::back_inserter(edges), mesh.edge_verts.size(), crease);
    if (choices.chance(0.3)) std::generate_n(std::back_inserter(vertices), mesh.positions.size(), crease);
    if (choices.chance(0.02)) edges.resize(3);
    const int level = choices.chance(0.02) ? choices.one_of({-1, 0, 8}) : choices.between(1, 2);
    return std::make_shared<RefinedSurface>(name, mesh, Refinement{level, choices.chance(0.5), edges, vertices});
}

std::shared_ptr<Surface> cut_surface(Choices& choices, const std::string& name, const MeshArrays& mesh) {
    auto opacity = std::make_shared<cutout::Opacity>();
    opacity->width = choices.between(1, 9);
    opacity->height = choices.between(1, 9);
    for (int i = opacity->width * opacity->height; i > 0; --i)
        opacity->texels.push_back(float(choices.chance(0.02) ? choices.broken() : choices.between(0.0, 1.0)));
    opacity->threshold = float(choices.chance(0.05) ? choices.broken() : choices.between(0.0, 1.0));
    opacity->extension = static_cast<cutout::Extension>(choices.below(4));
    opacity->closest = choices.chance(0.3);
    if (choices.chance(0.03)) opacity->width = choices.between(-1, 3);
    cutout::Cut cut{.uvs = {}, .opacity = opacity};
    const double broken = choices.one_of({0.0, 0.0, 0.1}), range = choices.one_of({1.0, 2.0, 5.0});
    for (std::size_t c = 0; c < mesh.corner_verts.size(); ++c)
        cut.uvs.push_back(vec2{choices.chance(broken) ? choices.broken() : choices.between(-range, range),
                               choices.between(0.0, range)});
    if (choices.chance(0.03)) cut.uvs.resize(2);
    std::vector<int> cuts;
    for (std::size_t f = 1; f < mesh.polygon_offsets.size(); ++f) cuts.push_back(choices.between(-1, 0));
    if (choices.chance(0.03)) cuts.push_back(5);
    const double px = choices.one_of({0.0, 10.0, 1000.0, choices.broken()});
    return std::make_shared<cutout::CutSurface>(name, mesh, std::vector{cut}, cutout::CutOptions{cuts, px});
}

std::shared_ptr<Surface> strand_surface(Choices& choices, const std::string& name) {
    OwnedStrands strands;
    strands.offsets.push_back(0);
    const double broken = choices.one_of({0.0, 0.0, 0.1});
    for (int s = choices.below(8); s > 0; --s) {
        for (int p = choices.between(2, 9); p > 0; --p) {
            const bool again = !strands.points.empty() && choices.chance(0.1);
            strands.points.push_back(again ? strands.points.back() : places(choices, 1)[0]);
            strands.radii.push_back(float(choices.between(-0.01, 0.1)));
            if (choices.chance(broken)) strands.points.back()[choices.below(3)] = float(choices.broken());
            if (choices.chance(broken)) strands.radii.back() = float(choices.broken());
        }
        strands.offsets.push_back(int(strands.points.size()));
    }
    if (choices.chance(0.05)) strands.offsets[choices.below(int(strands.offsets.size()))] = choices.between(-1, 9);
    if (choices.chance(0.02)) strands.radii.resize(1);
    const int steps = choices.chance(0.02) ? choices.one_of({-1, 65}) : choices.between(0, 4);
    if (steps != 1) strands = rounded_strands(name, strands.strands(), steps);
    const bool occludes = choices.chance(0.5);
    const OwnedMesh mesh =
        choices.chance(0.7) ? strand_prisms(name, strands.strands(), occludes) : strand_wires(name, strands.strands());
    return std::make_shared<Surface>(name, mesh.arrays());
}

std::shared_ptr<Surface> sphere_surface(Choices& choices, const std::string& name) {
    std::vector<vec3> centers = places(choices, choices.one_of({0, 1, 1, 1, 2}));
    std::vector<float> radii;
    // Spheres of endless size, or endlessly far away, lie in one place: all their triangles cross each other.
    const double broken = centers.size() < 2 ? 0.3 : 0.0;
    for (vec3& center : centers) {
        radii.push_back(float(choices.chance(broken) ? choices.broken() : choices.between(0.0, 0.5)));
        if (choices.chance(0.1)) center[choices.below(3)] = choices.one_of({NAN, INFINITY});
    }
    if (choices.chance(0.03)) radii.push_back(1.0f);
    return std::make_shared<Surface>(name, spheres(name, centers, radii, choices.chance(0.5)).arrays());
}

std::shared_ptr<Surface> of_mesh(Choices& choices, const std::string& name, const MeshArrays& mesh) {
    switch (choices.below(8)) {
        case 0:
        case 1:
            return repaired_surface(choices, name, mesh);
        case 2:
            return refined_surface(choices, name, mesh);
        case 3:
            return cut_surface(choices, name, mesh);
        case 4:
            return polygon_surface(name, mesh.positions, mesh.corner_verts, mesh.polygon_offsets, mesh.material);
        default:
            return std::make_shared<Surface>(name, mesh);
    }
}

}  // namespace

std::shared_ptr<Surface> random_surface(Choices& choices, const std::string& name) {
    const int way = choices.below(60);  // spheres are rare: they have thousands of triangles
    const Mesh mesh = random_mesh(choices);
    const auto surface = way == 0  ? sphere_surface(choices, name)
                         : way < 6 ? strand_surface(choices, name)
                                   : of_mesh(choices, name, mesh.arrays());
    surface->set_shape(static_cast<Shape>(choices.below(4)));
    if (choices.chance(0.2)) {
        FieldOptions options{.estimator = static_cast<Estimator>(choices.below(3)),
                             .degree = choices.one_of({0, 0, 2, 3, 4}),
                             .rings = choices.one_of({0, 0, 1, 3, 32}),
                             .smoothing = choices.one_of({0.0, 0.0, 1.0, 8.0})};
        if (choices.chance(0.1)) options.smoothing = choices.broken();
        if (choices.chance(0.05)) options.degree = 1;
        if (choices.chance(0.05)) options.rings = choices.one_of({-1, 33});
        surface->set_field_options(options);
    }
    const bool is_mesh = surface->vertex_count() == mesh.positions.size() && typeid(*surface) == typeid(Surface);
    if (is_mesh && choices.chance(0.1)) {
        Mesh moved = mesh;
        spoil(choices, moved);
        if (choices.chance(0.05)) moved.positions.push_back(vec3(0.0f));
        surface->set_positions(moved.positions, choices.chance(0.5));
    }
    return surface;
}

}  // namespace fovea::fuzz
