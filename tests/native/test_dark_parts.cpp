// SPDX-License-Identifier: GPL-3.0-or-later
// What is known to be dark without rays is dark by rays.
#include <gtest/gtest.h>
#include <random>

#include <fovea/line/dark_parts.h>

#include "shadows.h"

using namespace fovea;
using namespace fovea::line;
using namespace fovea::drawing;
using namespace fovea::meshes;
using namespace fovea::shadows;

namespace {

/// Boxes and spheres of all sizes, some of which stand in each other.
Scene crowd(std::mt19937& random) {
    std::uniform_real_distribution<double> side(-6.0, 6.0), size(0.2, 1.5);
    std::vector<Placement> placements;
    for (int i = 0; i < 40; ++i) {
        const dmat4 at = glm::scale(moved({side(random), side(random), side(random)}),
                                    dvec3(size(random), size(random), size(random)));
        placements.push_back(place(i % 2 ? box() : sphere(6), at, std::uint64_t(i)));
    }
    return cut_open(std::move(placements), {});
}

}  // namespace

TEST(DarkParts, OfSegmentsOneAfterTheOtherAreDarkByRays) {
    std::mt19937 random(23);
    std::uniform_real_distribution<double> way(-7.0, 7.0), share(0.0, 1.0);
    int dark = 0, lit = 0, without_ray = 0;
    for (const Light& light : {sun({0.4, -0.2, 1.0}), lamp({0.3, 0.2, 0.1}), lamp({9.0, 1.0, 5.0})}) {
        const Scene scene = crowd(random);
        const LightEye eye(scene, light);
        DarkParts parts(eye);
        dvec3 from(way(random), way(random), way(random));
        for (int n = 0; n < 300; ++n) {
            const auto placement = Index(n) % Index(scene.placements.size());
            const Ignore ignore = eye.tracer.ignore_at(placement, Index(n) % 12);
            const dvec3 to = from + 0.2 * dvec3(way(random), way(random), way(random));
            const auto in_light = [&](const dvec3& p) {
                return dvec3(eye.tracer.view().world_to_view * dvec4(p, 1.0));
            };
            const dvec3 a = in_light(from), b = in_light(to);
            parts.next_segment(a, b, ignore);
            const auto by_ray = [&](double t) { return eye.pass(glm::mix(a, b, t), ignore); };
            for (int k = 0; k < 20; ++k) {
                const double t = share(random);
                Interval part = parts.known(t);
                without_ray += !part.is_empty();
                if (const LightEye::Passing at = by_ray(t); !at.lit && at.hit && part.is_empty())
                    part = parts.hidden_by(*at.hit, t);
                if (part.is_empty()) {
                    lit += by_ray(t).lit;
                    continue;
                }
                EXPECT_TRUE(part.holds(t));
                ++dark;
                for (const double in : {part.begin, glm::mix(part.begin, part.end, share(random)), part.end})
                    EXPECT_FALSE(by_ray(glm::clamp(in, part.begin + 1e-9, part.end - 1e-9)).lit) << n << " at " << in;
            }
            from = n % 10 ? to : dvec3(way(random), way(random), way(random));
        }
    }
    EXPECT_GT(dark, 1000);
    EXPECT_GT(lit, 1000);
    EXPECT_GT(without_ray, dark / 3);
}
