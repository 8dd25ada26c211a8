// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>
#include <random>

#include <fovea/mesh/equal_polygons.h>
#include <fovea/mesh/polygon_surface.h>

using namespace fovea;
using namespace fovea::draw;

namespace {

/// Polygons of the given numbers of corners, each of different vertices of `vertices` many, drawn at random: few, so
/// that neighbors in the list often have vertices and edges in common.
struct Polygons {
    Array<int> offsets{0}, corner_verts;
    PolygonEdges edges;

    Polygons(const std::vector<int>& sizes, int vertices, std::mt19937& random) {
        std::vector<int> all(static_cast<std::size_t>(vertices));
        std::iota(all.begin(), all.end(), 0);
        for (const int size : sizes) {
            std::shuffle(all.begin(), all.end(), random);
            corner_verts.insert(corner_verts.end(), all.begin(), all.begin() + size);
            offsets.push_back(static_cast<int>(corner_verts.size()));
        }
        edges = polygon_edges(offsets, corner_verts);
    }
    bool all_have(int corners) const {
        return all_polygons_have(corners, edges.edge_verts, corner_verts, edges.corner_edges);
    }
};

TEST(EqualPolygons, AreThoseWithTheSameNumberOfCornersWhateverVerticesTheyShare) {
    std::mt19937 random(7);
    for (int k = 0; k < 20000; ++k) {
        std::vector<int> sizes(1 + random() % 5);
        for (int& size : sizes) size = 3 + static_cast<int>(random() % 3) * int(random() % 2);
        const Polygons polygons(sizes, 5 + static_cast<int>(random() % 3), random);
        for (const int corners : {3, 4})
            ASSERT_EQ(polygons.all_have(corners), std::ranges::all_of(sizes, [&](int n) { return n == corners; }));
    }
}

TEST(EqualPolygons, AreFoundAmongManyWhereverOneDiffers) {
    std::mt19937 random(8);
    EXPECT_TRUE(Polygons(std::vector<int>(30000, 4), 9, random).all_have(4));
    for (const std::size_t at : {std::size_t(0), std::size_t(14321), std::size_t(29998)}) {
        std::vector<int> sizes(30000, 4);
        sizes[at] = 3;
        sizes[at + 1] = 5;  // as many corners as before
        EXPECT_FALSE(Polygons(sizes, 9, random).all_have(4));
    }
}

TEST(EqualPolygons, NumbersOutOfRangeAreNone) {
    std::mt19937 random(9);
    for (const int wrong : {-1, 1000, -2147483647 - 1}) {
        Polygons polygons({4, 4, 4}, 6, random);
        polygons.edges.corner_edges[5] = wrong;
        EXPECT_FALSE(polygons.all_have(4));
        polygons.corner_verts.pop_back();
        EXPECT_FALSE(polygons.all_have(4));
    }
}

}  // namespace
