// SPDX-License-Identifier: GPL-3.0-or-later
// Bevels, of which the middle edge is a crease (line/bevels.h).
#include <gtest/gtest.h>
#include <set>

#include <fovea/line/bevels.h>

#include "meshes.h"

using namespace fovea;
using namespace fovea::meshes;

namespace {

/// A profile in x and z from (0, 0) along x: lengths and, between them, turns to the left in degrees; extruded along y
/// by `depth` in `rows` rows. `split`: squares are two triangles each.
struct Profile {
    std::vector<double> lengths, turns;
    double depth = 10.0;
    int rows = 1;
    bool split = false;

    Mesh mesh() const {
        std::vector<dvec3> outline{dvec3(0)};
        double angle = 0.0;
        for (std::size_t i = 0; i < lengths.size(); ++i) {
            outline.push_back(outline.back() + lengths[i] * dvec3(std::cos(angle), 0, std::sin(angle)));
            if (i < turns.size()) angle += glm::radians(turns[i]);
        }
        Mesh mesh("profile", {});
        for (int j = 0; j <= rows; ++j)
            for (const dvec3& p : outline) mesh.positions.push_back(vec3(p + dvec3(0, depth * j / rows, 0)));
        const int across = int(outline.size());
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i + 1 < across; ++i) {
                const int a = i + across * j, b = a + 1, c = b + across, d = a + across;
                if (split) {
                    mesh.add_polygon({a, b, c});
                    mesh.add_polygon({a, c, d});
                } else {
                    mesh.add_polygon({a, b, c, d});
                }
            }
        return mesh;
    }
};

/// Where the bevels' edges are in the profile, one entry for each edge.
std::vector<int> middles(const Profile& profile, double angle = 30.0) {
    const auto surface = profile.mesh().surface();
    const auto on = line::find_bevels(field::FacetEdges(*surface), angle);
    const Index across = Index(profile.lengths.size() + 1);
    std::vector<int> found;
    for (Index e = 0; e < on.size(); ++e)
        if (on[e]) {
            EXPECT_EQ(surface->edges[e].x % across, surface->edges[e].y % across);
            found.push_back(int(surface->edges[e].x % across));
        }
    return found;
}

/// Two flats of length 4 at a right angle, joined by so many faces.
Profile corner(int faces) {
    Profile profile{{4.0}, {}};
    for (int i = 0; i <= faces; ++i) {
        profile.turns.push_back(90.0 / (faces + 1));
        profile.lengths.push_back(i < faces ? 0.6 / faces : 4.0);
    }
    return profile;
}

}  // namespace

TEST(Bevels, HaveTheirMiddleEdgeHoweverManyFacesTheyHave) {
    for (const bool split : {false, true})
        for (const int faces : {2, 4, 6, 8}) {
            Profile profile = corner(faces);
            profile.split = split;
            EXPECT_EQ(middles(profile), std::vector<int>{1 + faces / 2}) << faces << " faces, split " << split;
        }
}

TEST(Bevels, HaveOneOfTwoMiddleEdgesAllAlong) {
    for (const int faces : {1, 3}) {
        Profile profile = corner(faces);
        profile.rows = 6;
        const std::vector<int> found = middles(profile);
        ASSERT_EQ(found.size(), 6u) << faces;
        EXPECT_EQ(std::set<int>(found.begin(), found.end()).size(), 1u) << faces;
    }
}

TEST(Bevels, AreConcaveToo) {
    Profile profile = corner(4);
    for (double& turn : profile.turns) turn = -turn;
    EXPECT_EQ(middles(profile), std::vector<int>{3});
}

TEST(Bevels, AreNotSingleEdges) { EXPECT_TRUE(middles(corner(0)).empty()); }

TEST(Bevels, AreNarrowBesideWhatTheyJoin) {
    Profile profile = corner(4);
    profile.lengths.front() = 1.0;
    EXPECT_TRUE(middles(profile).empty()) << "flat on one side for less than twice the width";
}

TEST(Bevels, AreLongerThanWide) {
    Profile profile = corner(4);
    profile.depth = 2.0;
    EXPECT_TRUE(middles(profile).empty());
}

TEST(Bevels, AreNoRimsOfBoardsNoBeadsAndNoTubes) {
    EXPECT_TRUE(middles({{4.0, 0.1, 0.1, 0.1, 4.0}, {45.0, 45.0, 45.0, 45.0}}).empty()) << "a rounded rim";
    EXPECT_TRUE(middles({{4.0, 0.1, 0.1, 0.1, 4.0}, {-45.0, 45.0, 45.0, -45.0}}).empty()) << "a bead on a post";
    Profile tube;
    for (int i = 0; i < 24; ++i) {
        tube.lengths.push_back(1.0);
        tube.turns.push_back(15.0);
    }
    EXPECT_TRUE(middles(tube).empty());
}

TEST(Bevels, TurnByTheAngleAskedFor) {
    EXPECT_TRUE(middles(corner(4), 100.0).empty());
    Profile flat = corner(4);
    for (double& turn : flat.turns) turn *= 0.5;
    EXPECT_TRUE(middles(flat).empty()) << "45 degrees may be a corner of a tube of eight faces";
}
