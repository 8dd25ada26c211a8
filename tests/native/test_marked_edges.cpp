// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <ostream>

#include <fovea/path/marked_edges.h>

#include "meshes.h"
#include "rules.h"

namespace fovea::path {
using namespace meshes;

bool operator==(const MarkedEdge& a, const MarkedEdge& b) {
    return a.edge == b.edge && a.kinds == b.kinds && a.set == b.set;
}
void PrintTo(const MarkedEdge& of, std::ostream* out) {
    *out << "edge " << of.edge << ", kinds " << of.kinds << ", set " << int(of.set);
}

namespace {

Kinds kind_called(const char* definition) { return kind_of(definition_called(definition)); }

LineKind with_defaults(const char* definition) { return {definition_index(definition), defaults(definition)}; }

/// A box whose first face is of another material than all others.
std::shared_ptr<Surface> box_with_lid() {
    Mesh mesh = box();
    mesh.material.assign(mesh.polygon_offsets.size() - 1, 0);
    mesh.material[0] = 1;
    return mesh.surface();
}

TEST(MarkedEdges, HaveTheKindsOfAllDefinitionsThatTheirSetRequests) {
    const auto surface = box_with_lid();
    const PlacedSet set{{with_defaults("material_boundary"), with_defaults("crease")}, 1.0};
    const MarkedEdges marked = mark_edges(set, 3, {.surface = *surface}, true);
    ASSERT_EQ(marked.size(), 12u);
    const Kinds crease = kind_called("crease"), both = crease | kind_called("material_boundary");
    for (Index e = 0; e < 12; ++e) {
        const auto sides = surface->sides(e);
        const bool at_lid = surface->material(sides[0].facet()) != surface->material(sides[1].facet());
        EXPECT_EQ(marked[e], (MarkedEdge{e, at_lid ? both : crease, 3}));
    }
}

TEST(MarkedEdges, OfASetForOneMaterialLieAtFacesOfIt) {
    const auto surface = box_with_lid();
    const PlacedSet set{{with_defaults("crease")}, 1.0, {0, 1}};
    EXPECT_EQ(mark_edges(set, 0, {.surface = *surface}, true).size(), 4u);
}

TEST(MarkedEdges, OfTheViewAreAddedToThoseThatAreKept) {
    const auto surface = box_with_lid();
    const PlacedSet set{{with_defaults("contour"), with_defaults("crease")}, 1.0};
    const SurfaceView seen{.surface = *surface, .facing = {1, 0, 0, 0, 0, 0}};
    const MarkedEdges kept = mark_edges(set, 0, seen, true), all = mark_edges(set, 0, seen, false, kept);
    ASSERT_EQ(kept.size(), 12u);
    ASSERT_EQ(all.size(), 12u);
    const Kinds crease = kind_called("crease"), both = crease | kind_called("contour");
    for (Index e = 0; e < 12; ++e) {
        const auto sides = surface->sides(e);
        const bool at_first = sides[0].facet() == 0 || sides[1].facet() == 0;
        EXPECT_EQ(all[e], (MarkedEdge{e, at_first ? both : crease, 0}));
    }
    EXPECT_EQ(mark_edges(set, 0, seen, false).size(), 4u);
    const PlacedSet of_surface{{with_defaults("crease")}, 1.0};
    EXPECT_EQ(mark_edges(of_surface, 0, seen, false, kept), kept);
}

TEST(MarkedEdges, OfSeveralSetsAreThoseOfTheFirstThatHasThem) {
    const MarkedEdges first{{2, 1, 0}, {70000, 1, 0}}, second{{0, 2, 1}, {2, 4, 1}, {99999, 2, 1}};
    EXPECT_EQ(of_first_sets(100000, {first, {}, second}),
              (MarkedEdges{{0, 2, 1}, {2, 1, 0}, {70000, 1, 0}, {99999, 2, 1}}));
    EXPECT_EQ(of_first_sets(0, {{}}), MarkedEdges());
}

}  // namespace
}  // namespace fovea::path
