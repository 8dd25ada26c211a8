// SPDX-License-Identifier: GPL-3.0-or-later
// Hatching of planes and spheres: where its lines lie, how far apart they are on paper, and where they end.
#include <gtest/gtest.h>
#include <map>

#include <fovea/line/hatch_levels.h>

#include "rules.h"
#include "shadows.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::drawing;
using namespace fovea::meshes;
using namespace fovea::shadows;

namespace {

using Given = std::vector<std::pair<std::string, ParameterValue>>;

constexpr double from_camera = 0, from_world = 1, from_object = 2, from_form = 3;
constexpr double spacing = 7.0;

/// Hatching of a scene by a camera, in its picture: reference pixels are pixels.
struct Hatched {
    Scene scene;
    View view;
    Tracer tracer;
    Paths paths;

    Hatched(std::vector<Placement> placements, std::vector<Light> lights, const View& seen, const Given& given)
        : scene(with_lights(std::move(placements), std::move(lights))),
          view(seen),
          tracer(scene, view),
          paths(extract_paths(scene, view, {line_set_with("hatching", values_of(definition_called("hatching"), given))},
                              tracer, Cancel())) {}
    Hatched(const Hatched&) = delete;

    static Scene with_lights(std::vector<Placement> placements, std::vector<Light> lights) {
        Scene scene(std::move(placements));
        scene.lights = std::move(lights);
        return scene;
    }

    dvec3 at(Index path, Index i) const {
        return dvec3(scene.placements[paths.placement[path]].object_to_world * dvec4(dvec3(paths.points_obj[i]), 1.0));
    }
    dvec2 px(Index path, Index i) const { return pixel_of(view, at(path, i)); }
    double length() const {
        double sum = 0.0;
        each_segment([&](Index p, Index i) { sum += glm::distance(at(p, i), at(p, i + 1)); });
        return sum;
    }
    /// Calls visit(path, point) for the first points of segments.
    template <typename Visit>
    void each_segment(const Visit& visit) const {
        for (Index p = 0; p < paths.count(); ++p)
            for (Index i = paths.rows.begin(p); i + 1 < paths.rows.end(p); ++i) visit(p, i);
    }
    /// Calls visit(path, last point, the one before it) for both ends of open paths.
    template <typename Visit>
    void each_end(const Visit& visit) const {
        for (Index p = 0; p < paths.count(); ++p) {
            if (paths.closed[p]) continue;
            visit(p, paths.rows.begin(p), paths.rows.begin(p) + 1);
            visit(p, paths.rows.end(p) - 1, paths.rows.end(p) - 2);
        }
    }
    /// Where a line crosses a way [px], and the sine of the angle between the two.
    struct Crossing {
        double along, sine;
        dvec3 near;  // the start of the segment, in the world
    };
    /// Those of the way from a to b, from a on.
    std::vector<Crossing> crossings(const dvec2& a, const dvec2& b) const {
        std::vector<Crossing> found;
        const dvec2 way = glm::normalize(b - a), across(-way.y, way.x);
        each_segment([&](Index p, Index i) {
            const dvec2 from = px(p, i) - a, to = px(p, i + 1) - a;
            const double x = glm::dot(from, across), y = glm::dot(to, across);
            if ((x < 0.0) == (y < 0.0)) return;
            const double along = glm::dot(glm::mix(from, to, x / (x - y)), way);
            if (along >= 0.0 && along <= glm::distance(a, b))
                found.push_back({along, std::abs(x - y) / glm::distance(from, to), this->at(p, i)});
        });
        std::ranges::sort(found, {}, &Crossing::along);
        return found;
    }
};

/// Everything has lines of the first direction.
const Given all_of_it = {{"light", 1.0}, {"families", 1.0}, {"lights", 0.0}, {"spacing", spacing}};

Given with(Given given, const Given& more) {
    given.insert(given.end(), more.begin(), more.end());
    return given;
}

Mesh smooth_sphere(int n) {
    Mesh mesh = sphere(n);
    mesh.shape = Shape::smooth;
    return mesh;
}

/// The camera of a picture in which reference pixels are pixels, 45 degrees above a plane.
View slanted_at(double distance) {
    return perspective(distance * glm::normalize(dvec3(0.2, -1.0, 1.0)), {0, 0, 0}, 50.0, 800, 600);
}

/// Heights over the planes through the world's origin that belong to the angles of `given`.
double height(const dvec3& p, double angle, double tilt) {
    const double a = glm::radians(angle), t = glm::radians(tilt);
    return glm::dot(p, dvec3(-std::sin(a) * std::cos(t), -std::sin(t), std::cos(a) * std::cos(t)));
}

}  // namespace

TEST(Hatching, LiesOnItsPlanesWhichAreMultiplesOfAPowerOfTwo) {
    for (const Mesh& mesh : {grid(4), smooth_sphere(24)}) {
        const Hatched found({place(mesh, glm::rotate(moved({0.1, 0.2, 0.3}), 0.4, dvec3(1, 2, 3)))}, {},
                            slanted_at(5.0), with(all_of_it, {{"planes", from_world}, {"angle", 30}, {"tilt", 20}}));
        EXPECT_GT(found.paths.count(), 20u);
        std::map<double, int> values;
        for (Index p = 0; p < found.paths.count(); ++p) {
            const double first = height(found.at(p, found.paths.rows.begin(p)), 30, 20);
            const double units = (first + 0.381966) * 1024.0;
            EXPECT_NEAR(units, std::round(units), 1024 * 1e-6);
            for (Index i = found.paths.rows.begin(p); i < found.paths.rows.end(p); ++i)
                EXPECT_NEAR(height(found.at(p, i), 30, 20), first, 1e-6);
        }
    }
}

TEST(Hatching, IsSpacedOnPaperAsItsNumberSaysHoweverNearTheCamera) {
    // Also of a floor that goes from before the camera to the horizon, in two triangles.
    for (const double planes : {from_camera, from_world, from_object})
        for (const double distance : {400.0, 200.0, 100.0, 60.0, 30.0, 3.0})
            for (const int n : {1, 16}) {
                const Hatched found({place(grid(n, 2000.0f))}, {}, slanted_at(distance),
                                    with(all_of_it, {{"planes", planes}, {"angle", 20}, {"tilt", 25}}));
                int count = 0;
                for (const double x : {120.0, 400.0, 650.0}) {
                    const auto at = found.crossings({x, 20.0}, {x, 580.0});
                    for (std::size_t k = 0; k + 1 < at.size(); ++k) {
                        if (std::min(at[k].sine, at[k + 1].sine) < 0.3) continue;
                        ++count;
                        const double apart = 0.5 * (at[k].sine + at[k + 1].sine) * (at[k + 1].along - at[k].along);
                        EXPECT_LT(apart, spacing * 1.5) << distance;
                        EXPECT_GT(apart, spacing / 1.5) << distance;
                    }
                }
                EXPECT_GT(count, 60) << planes << " " << distance << " " << n;
            }
}

TEST(Hatching, SpacingAcrossLinesIsWithinAFactorOfTheRootOfTwo) {
    for (const double distance : {8.0, 6.5, 5.0, 4.0, 3.0, 2.0}) {
        // Seen head on, tilted planes are upright: 'across' is the direction of their normal.
        const Hatched found({place(grid(1, 30.0f))}, {}, perspective({0, 0, distance}, {0, 0, 0}, 50.0, 800, 600),
                            with(all_of_it, {{"angle", 0}, {"tilt", 0}}));
        const auto at = found.crossings({300.0, 10.0}, {300.0, 590.0});
        ASSERT_GT(at.size(), 50u);
        for (std::size_t k = 0; k + 1 < at.size(); ++k) {
            const double apart = at[k + 1].along - at[k].along;
            EXPECT_LT(apart, spacing * 1.4143) << distance;
            EXPECT_GT(apart, spacing / 1.4143) << distance;
        }
    }
}

TEST(Hatching, OfANearerCameraHasAllLinesOfAFartherOneAndOthersBetween) {
    const auto levels = [](double distance) {
        const Hatched found({place(grid(1, 1.0f))}, {}, perspective({0, 0, distance}, {0, 0, 0}, 50.0, 800, 600),
                            with(all_of_it, {{"planes", from_world}, {"angle", 30}, {"tilt", 20}}));
        std::map<std::int64_t, double> at;  // in units of 2^-16
        found.each_segment([&](Index p, Index i) {
            at[std::llround((height(found.at(p, i), 30, 20) + 0.381966) * 65536)] +=
                glm::distance(found.at(p, i), found.at(p, i + 1));
        });
        return at;
    };
    const auto far = levels(8.0), near = levels(7.0), nearest = levels(2.0);
    for (const auto& [level, length] : far) {
        ASSERT_TRUE(near.contains(level));
        EXPECT_GE(near.at(level), length - 1e-3);
    }
    int missing = 0;
    for (const auto& [level, length] : nearest) missing += !far.contains(level);
    EXPECT_GT(missing, int(far.size()) / 4);
    EXPECT_GT(nearest.size(), 20u);
    for (const auto& [level, length] : far)
        if (level > nearest.begin()->first && level < nearest.rbegin()->first) {
            EXPECT_TRUE(nearest.contains(level)) << level;
        }
}

TEST(Hatching, FollowsTheFormAtTheSpacingOfPaperHoweverNearTheCamera) {
    for (const double distance : {20.0, 14.0, 10.0, 7.0, 5.0}) {
        const Hatched found({place(cylinder(64))}, {}, perspective({distance, 0, 0}, {0, 0, 0}, 50.0, 800, 600),
                            with(all_of_it, {{"planes", from_form}, {"angle", 0}}));
        // Seen from the side its lines are level, and cross an upright way in its middle.
        const double half = glm::distance(pixel_of(found.view, {1, 0, -1}), pixel_of(found.view, {1, 0, 1})) / 2.0;
        auto at = found.crossings({400.0, 300.0 - 0.9 * half}, {400.0, 300.0 + 0.9 * half});
        std::erase_if(at, [](const Hatched::Crossing& crossing) { return crossing.near.x < 0.0; });  // its back
        ASSERT_GT(at.size(), std::size_t(1.8 * half / (2.0 * spacing))) << distance;
        std::vector<double> apart;
        for (std::size_t k = 0; k + 1 < at.size(); ++k) {
            apart.push_back(at[k + 1].along - at[k].along);
            EXPECT_GT(at[k].sine, 0.99);
            EXPECT_LT(apart.back(), 3.0 * spacing) << distance;
            EXPECT_GT(apart.back(), 0.38 * spacing) << distance;
        }
        std::ranges::sort(apart);
        EXPECT_LT(apart[apart.size() / 2], 1.5 * spacing) << distance;
        EXPECT_GT(apart[apart.size() / 2], spacing / 1.5) << distance;
    }
}

TEST(Hatching, OfWhatHasNoFormToFollowIsThatOfTheObjectsPlanes) {
    const auto lines = [](double planes) {
        const Hatched found({place(box())}, {}, slanted_at(6.0), with(all_of_it, {{"planes", planes}}));
        return std::pair(found.paths.points_obj, found.paths.rows.offsets);
    };
    EXPECT_GT(lines(from_object).first.size(), 100u);
    EXPECT_EQ(lines(from_form), lines(from_object));
}

TEST(Hatching, OfASphereInTheSunEndsWhereItsToneIsReached) {
    const dvec3 towards = glm::normalize(dvec3(0.5, -0.6, 0.8));
    const double tone = 0.5;
    for (const bool shadows : {false, true}) {
        const Hatched found({place(smooth_sphere(64))}, {sun(towards)},
                            perspective({0.6, -5, 0.4}, {0, 0, 0}, 60.0, 800, 600),
                            {{"families", 1},
                             {"light", tone},
                             {"spacing", spacing},
                             {"angle", -60},
                             {"tilt", 20},
                             {"shadows", shadows ? 1.0 : 0.0}});
        const auto tone_at = [&](const dvec3& p) { return glm::dot(glm::normalize(p), towards); };
        found.each_segment([&](Index p, Index i) { EXPECT_LT(tone_at(found.at(p, i)), tone + 1e-3); });
        int ends = 0;
        found.each_end([&](Index p, Index end, Index before) {
            const double last = tone_at(found.at(p, end)), slope = last - tone_at(found.at(p, before));
            const double px = glm::distance(found.px(p, end), found.px(p, before));
            if (last < tone - 0.02 || !(slope > 0.0) || px < 0.5) return;
            ++ends;
            EXPECT_NEAR((last - tone) / slope * px, 0.0, 1.0 / 16.0);
        });
        EXPECT_GT(ends, 25);
    }
}

TEST(Hatching, OfAFloorIsInTheShadowOfWhatHangsOverIt) {
    const std::vector<Placement> placements = {place(grid(1, 6.0f), dmat4(1.0), 1), place(box(), moved({0, 0, 4}), 2)};
    const Given given = {{"families", 1}, {"light", 0.5}, {"spacing", spacing}};
    const View view = perspective({0, -14, 8}, {0, 0, 0}, 50.0, 800, 600);
    const Hatched found(placements, {sun({0, 0, 1})}, view, given);
    double inside = 0.0;
    found.each_segment([&](Index p, Index i) {
        if (found.paths.placement[p] != 0) return;
        const dvec3 a = found.at(p, i), b = found.at(p, i + 1);
        for (const dvec3& x : {a, b}) EXPECT_LT(std::max(std::abs(x.x), std::abs(x.y)), 1.0 + 2e-3);
        inside += glm::distance(a, b);
    });
    EXPECT_GT(inside, 10.0);
    // The same lines are cut off on all sides of the shadow, not only on some.
    double low = 1.0, high = -1.0;
    found.each_end([&](Index p, Index end, Index) {
        if (found.paths.placement[p] != 0) return;
        const dvec3 x = found.at(p, end);
        EXPECT_NEAR(std::max(std::abs(x.x), std::abs(x.y)), 1.0, 2e-3);
        low = std::min(low, x.x);
        high = std::max(high, x.x);
    });
    EXPECT_NEAR(low, -1.0, 2e-3);
    EXPECT_NEAR(high, 1.0, 2e-3);
    // Without shadows the floor is bright everywhere.
    const Hatched bright(placements, {sun({0, 0, 1})}, view, with(given, {{"shadows", 0}}));
    bright.each_segment([&](Index p, Index) { EXPECT_EQ(bright.paths.placement[p], 1u); });
}

TEST(Hatching, IsNoneInTheLight) {
    const Hatched found({place(grid(3))}, {sun({0, 0, 1})}, slanted_at(5.0), {{"light", 0.9}, {"spacing", spacing}});
    EXPECT_EQ(found.paths.count(), 0u);
    const Hatched darker({place(grid(3))}, {sun({0, 0, 1}), sun({0, 1, 1e-3})}, slanted_at(5.0),
                         {{"spacing", spacing}});
    EXPECT_EQ(darker.paths.count(), 0u) << "one of two lights is enough";
}

TEST(Hatching, HasMoreDirectionsWhereItIsDarker) {
    // Sides of a box: each lies in a tone of its own.
    const std::vector<Placement> cube = {place(box())};
    const auto length = [&](double families) {
        return Hatched(cube, {sun({0.3, -0.2, 1})}, perspective({5, -4, 5}, {0, 0, 0}, 50.0, 800, 600),
                       {{"families", families}, {"light", 0.5}, {"middle", 0.4}, {"dark", 0.25}, {"spacing", spacing}})
            .length();
    };
    const double one = length(1), two = length(2), three = length(3);
    EXPECT_NEAR(two / one, 2.0, 0.4);
    EXPECT_GT(three, 1.2 * two) << "only the side that is almost turned away";
    EXPECT_LT(three, 1.8 * two);
}

TEST(Hatching, SwellsFromTheLightToTheDark) {
    const dvec3 towards = glm::normalize(dvec3(0.5, -0.6, 0.8));
    const Hatched found({place(smooth_sphere(48)), place(grid(1, 6.0f), moved({0, 0, -2}), 2)}, {sun(towards)},
                        perspective({0.6, -9, 5}, {0, 0, 0}, 50.0, 800, 600),
                        {{"families", 1}, {"light", 0.5}, {"swell", 0.8}, {"spacing", spacing}});
    double most = 0.0, least = 1.0, count = 0.0, strong = 0.0;
    found.each_segment([&](Index p, Index i) {
        const double strength = found.paths.strength[i];
        const double tone = std::clamp(glm::dot(glm::normalize(found.at(p, i)), towards), 0.0, 1.0);
        // In cast shadow lines are as strong as can be; some fade in between others.
        const double expected = found.paths.placement[p] == 1 ? 1.0 : 1.0 - 0.8 * tone / 0.5;
        EXPECT_LT(strength, expected + 0.02);
        ++count;
        if (strength < expected - 0.02) return;
        ++strong;
        most = std::max(most, strength);
        least = std::min(least, strength);
    });
    EXPECT_EQ(most, 1.0);
    EXPECT_NEAR(least, 0.2, 0.02);
    EXPECT_GT(strong, 0.7 * count);
}

TEST(Hatching, FadesInBetweenWithoutAJumpWhileTheCameraApproaches) {
    const auto ink = [](double distance) {
        // Head on, a whole power of two comes in at once.
        const Hatched found({place(grid(1, 30.0f))}, {}, perspective({0, 0, distance}, {0, 0, 0}, 50.0, 400, 300),
                            with(all_of_it, {{"planes", from_world}, {"angle", 30}, {"tilt", 0}}));
        double sum = 0.0;
        found.each_segment([&](Index p, Index i) {
            sum += 0.5 * (found.paths.strength[i] + found.paths.strength[i + 1]) *
                   glm::distance(found.px(p, i), found.px(p, i + 1));
        });
        return sum;
    };
    double before = ink(8.0), least = before, most = before;
    for (double distance = 8.0 / 1.01; distance > 2.0; distance /= 1.01) {
        const double now = ink(distance);
        EXPECT_NEAR(now / before, 1.0, 0.06) << distance;
        least = std::min(least, now);
        most = std::max(most, now);
        before = now;
    }
    EXPECT_LT(most / least, 2.0);
}

TEST(Hatching, IsAsStrongAsItsToneOnEitherSideOfTheEdgeOfAShadow) {
    const dvec3 towards = glm::normalize(dvec3(0.3, -0.2, 1.0));
    const Hatched found({place(grid(1, 30.0f), dmat4(1.0), 1), place(box(), moved({0, 0, 4}), 2)}, {sun(towards)},
                        perspective({0, -14, 8}, {0, 0, 0}, 50.0, 800, 600),
                        {{"families", 1}, {"light", 1.0}, {"swell", 0.8}, {"spacing", spacing}});
    double faint = 0.0, strong = 0.0, right = 0.0, wrong = 0.0;
    found.each_segment([&](Index p, Index i) {
        if (found.paths.placement[p] != 0) return;
        const dvec3 a = found.at(p, i), b = found.at(p, i + 1);
        const bool in_shadow = !is_lit(found.scene, found.scene.lights[0], 0.5 * (a + b), 0);
        const double length = glm::distance(a, b), expected = in_shadow ? 1.0 : 1.0 - 0.8 * towards.z;
        (in_shadow ? strong : faint) += length;
        if (found.paths.strength[i] > expected + 1e-3 || found.paths.strength[i + 1] > expected + 1e-3) wrong += length;
        if (std::abs(found.paths.strength[i] - expected) < 1e-3) right += length;
    });
    EXPECT_LT(wrong, 0.05 * strong) << "it changes within a pixel";
    EXPECT_GT(right, 0.7 * (strong + faint)) << "others fade in between";
    EXPECT_GT(strong, 10.0);
    EXPECT_GT(faint, 10.0 * strong);
}

TEST(Hatching, OfASolidIsOnTheSideThatIsSeen) {
    const Hatched found({place(smooth_sphere(32))}, {}, slanted_at(6.0), all_of_it);
    const dvec3 eye = 6.0 * glm::normalize(dvec3(0.2, -1.0, 1.0));
    found.each_segment([&](Index p, Index i) {
        const dvec3 middle = 0.5 * (found.at(p, i) + found.at(p, i + 1));
        EXPECT_GT(glm::dot(glm::normalize(middle), eye - middle), -0.1);
    });
    // From inside, its inner side is.
    EXPECT_GT(Hatched({place(smooth_sphere(32))}, {}, perspective({0, 0, 0}, {1, 0, 0}), all_of_it).paths.count(), 10u);
}

TEST(Hatching, KeepsItsIdsWhileTheCameraMovesALittle) {
    const auto ids = [](double distance) {
        const Hatched found({place(smooth_sphere(48)), place(grid(8, 4.0f), moved({0, 0, -1}), 2)},
                            {sun({0.5, -0.6, 0.8})}, slanted_at(distance),
                            with(all_of_it, {{"planes", from_world}, {"lights", 4}}));
        return std::set<std::uint64_t>(found.paths.id.begin(), found.paths.id.end());
    };
    const auto before = ids(9.0), after = ids(8.98);
    int kept = 0;
    for (const std::uint64_t id : before) kept += after.contains(id);
    EXPECT_GT(kept, 0.9 * double(before.size()));
}

TEST(Hatching, OfWhatIsSmallerThanItsSpacingIsNone) {
    EXPECT_EQ(Hatched({place(box(), scaled(dvec3(0.01)))}, {}, slanted_at(20.0), all_of_it).paths.count(), 0u);
}

TEST(Hatching, LevelsOfATriangleThatReachesBeyondAllMeasureAreFew) {
    const View view = perspective({0, -6, 1}, {0, 0, 0}, 36);
    const HatchLevels levels(view, spacing);
    const auto count = [&](double farthest) {
        const dvec3 up(0, 1, 0);
        const HatchLevels::Corners floor{{{{-1, -0.5, -1}, up}, {{1, -0.5, -1}, up}, {{0, -0.5, -farthest}, up}}};
        return levels.on({{0.5, 0, 1}, 0.0, 1.0, 0}, floor, false).size();
    };
    EXPECT_GT(count(1e3), 100u);
    for (const double farthest : {1e20, 1e100, 1e300}) EXPECT_LT(count(farthest), 100'000u) << farthest;
}
