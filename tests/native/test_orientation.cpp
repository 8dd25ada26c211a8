// SPDX-License-Identifier: GPL-3.0-or-later
// Exact orientation: signs that never contradict each other, in general position and out of it.
#include <algorithm>
#include <gtest/gtest.h>
#include <random>

#include <fovea/scene/orientation.h>

using namespace fovea;
using namespace fovea::draw;

namespace {

int sign(const dvec3 (&p)[4], const int (&order)[4], unsigned second = 0) {
    unsigned bits = 0;
    for (int i = 0; i < 4; ++i) bits |= (second >> order[i] & 1u) << i;
    return orientation({p[order[0]], p[order[1]], p[order[2]], p[order[3]]}, bits).sign;
}

/// Every order of the points gives the sign of its permutation.
void expect_antisymmetric(const dvec3 (&p)[4], unsigned second) {
    int order[4] = {0, 1, 2, 3};
    const int first = sign(p, order, second);
    do {
        int inversions = 0;
        for (int i = 0; i < 4; ++i)
            for (int j = i + 1; j < 4; ++j) inversions += order[i] > order[j];
        EXPECT_EQ(sign(p, order, second), inversions % 2 ? -first : first);
    } while (std::next_permutation(order, order + 4));
}

}  // namespace

TEST(Orientation, IsTheVolume) {
    const Orientation below = orientation({dvec3(0, 0, 0), dvec3(3, 0, 0), dvec3(0, 2, 0), dvec3(0, 0, -5)}, 0);
    EXPECT_EQ(below.value, 30.0);
    EXPECT_EQ(below.sign, 1);
}

TEST(Orientation, TellsTheLastUnitOfTheGrid) {
    const double far = grid_limit;
    const dvec3 a(-far, -far, -far), b(far, far, far), c(-far, far, 0);
    // The middle of a and b, and its neighbors on the grid.
    EXPECT_EQ(orientation({a, b, c, dvec3(0, 0, 0)}, 8).value, 0.0);
    const Orientation above = orientation({a, b, c, dvec3(0, 0, 1)}, 8),
                      below = orientation({a, b, c, dvec3(0, 0, -1)}, 8);
    EXPECT_NE(above.value, 0.0);
    EXPECT_EQ(above.value, -below.value);
    EXPECT_EQ(above.sign, -below.sign);
}

TEST(Orientation, NeverContradictsItself) {
    std::mt19937 random(3);
    std::uniform_int_distribution<int> few(0, 2);  // many coplanar, collinear and equal points
    int undecided = 0;
    for (int k = 0; k < 3000; ++k) {
        dvec3 p[4];
        for (dvec3& point : p) point = {few(random), few(random), few(random)};
        expect_antisymmetric(p, 0);
        for (const unsigned second : {1u, 3u, 7u, 8u, 12u}) expect_antisymmetric(p, second);
        bool same = false;
        for (int i = 0; i < 4; ++i)
            for (int j = i + 1; j < 4; ++j) same = same || p[i] == p[j];
        const int within = orientation(p, 0).sign;
        EXPECT_EQ(within == 0, same);
        undecided += within == 0;
    }
    EXPECT_GT(undecided, 100);
}

TEST(Orientation, AShiftedSurfaceIsOnOneSideOfAllThatItTouches) {
    // Corners of a square of the second surface over a triangle of the first, in one plane.
    const dvec3 a(0, 0, 0), b(8, 1, 2), c(1, 9, 4);
    const dvec3 u = b - a, v = c - a;
    const int first = orientation({a, b, c, a}, 8).sign;
    EXPECT_NE(first, 0);
    for (int i = -3; i <= 3; ++i)
        for (int j = -3; j <= 3; ++j)
            EXPECT_EQ(orientation({a, b, c, a + double(i) * u + double(j) * v}, 8).sign, first);
    EXPECT_EQ(orientation({a, a + u, a + 2.0 * u, dvec3(1, 2, 3)}, 8).sign, 0) << "a triangle without area";
}

TEST(Orientation, IsThatOfTheSecondSurfaceMovedByFarLessThanAllDistances) {
    std::mt19937 random(5);
    std::uniform_int_distribution<int> few(0, 2);
    // Volumes of such points are below 100 units: of this step's powers, each outweighs all later ones.
    constexpr double scale = 1 << 27;
    const dvec3 shift(1 << 18, 1 << 9, 1);
    int coplanar = 0;
    for (int k = 0; k < 3000; ++k) {
        dvec3 p[4];
        for (dvec3& point : p) point = {few(random), few(random), few(random)};
        for (unsigned second = 1; second < 15; ++second) {
            dvec3 moved[4];
            for (int i = 0; i < 4; ++i) moved[i] = scale * p[i] + (second >> i & 1 ? shift : dvec3(0.0));
            const double volume = orientation({moved[0], moved[1], moved[2], moved[3]}, second).value;
            const Orientation found = orientation({p[0], p[1], p[2], p[3]}, second);
            EXPECT_EQ(found.sign, (volume > 0.0) - (volume < 0.0));
            coplanar += found.value == 0.0 && found.sign != 0;
        }
    }
    EXPECT_GT(coplanar, 1000);
}
