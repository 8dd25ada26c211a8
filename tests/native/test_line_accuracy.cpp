// Lines of every definition against exact curves, with the settings that artists get: how far off, how much is missing,
// how much is false. With FOVEA_LINE_TABLE set, prints a row for each.
#include <gtest/gtest.h>

#include <cstdlib>

#include "curve_match.h"
#include "exact_lines.h"

using namespace fovea;
using namespace fovea::analytic;

namespace {

const dvec3 oblique = glm::normalize(dvec3(.8, .5, 1)), low = glm::normalize(dvec3(.9, .3, .25));

Values defaults(const char* name) {
    Values values;
    for (const Parameter& p : line_definitions()[definition_index(name)]->parameters) values.push_back(p.value);
    return values;
}

/// A surface and the mesh of it that lines are found on.
struct Body {
    std::string name;
    Sample sample;
    std::shared_ptr<Surface> surface = sample.mesh.surface();
    ExactGrid grid{sample};
    double edge = 0.0;  ///< length that makes squares of twice the triangles' mean area

    Body(std::string called, Sample made) : name(std::move(called)), sample(std::move(made)) {
        double area = 0.0;
        for (const Triangle& t : surface->triangles) {
            const dvec3 a(surface->positions[t.x]), b(surface->positions[t.y]), c(surface->positions[t.z]);
            area += 0.5 * glm::length(glm::cross(b - a, c - a));
        }
        edge = std::sqrt(2.0 * area / double(surface->triangles.size()));
    }
    /// Away from the border of a grid over [-1, 1]^2, where neighbourhoods are one-sided.
    bool inner(const dvec3& p) const { return name[0] != 'w' || std::max(std::abs(p.x), std::abs(p.y)) < 0.95; }
};

/// What is asked of one definition on one body. Values beyond `first` and `second` are defaults.
struct Case {
    const char* name;
    double first = -1.0, second = -1.0;  ///< instead of the defaults of the first two parameters
    bool low = false;                    ///< seen at a slant, where there are contours

    Values values() const {
        Values values = defaults(name);
        if (first >= 0.0) values[0] = first;
        if (second >= 0.0) values[1] = second;
        return values;
    }
};

Match compare(const Body& body, const Case& of, bool orthographic, double reach = 1.0) {
    const Eye eye{(orthographic ? 1.0 : 5.0) * (of.low ? low : oblique), orthographic};
    const double feature_size = fields_of(*body.surface)->feature_size;
    const ExactCurves exact = exact_curves(body.grid, exact_line(of.name, of.values(), feature_size), eye);
    const Curves found = line_definitions()[definition_index(of.name)]->find(eye.view(*body.surface), of.values());
    const Match m = match(body.sample, segments_of(found), exact, body.edge, reach, [&](const dvec3& p) { return body.inner(p); });
    if (std::getenv("FOVEA_LINE_TABLE"))
        std::printf("| %s%s | %s | %s | %.3f | %.3f | %.3f | %.3f | %.3f | %.3f |\n", of.name,
                    of.first < 0.0 ? "" : (" " + std::to_string(of.first)).c_str(), body.name.c_str(),
                    orthographic ? "orthographic" : "perspective", m.median, m.most, m.exact, m.found / m.exact, m.covered,
                    m.false_share);
    return m;
}

Body body_of(const std::string& name, bool irregular) {
    const GridOptions grid{.n = 256, .irregular = irregular};
    return {name + (irregular ? " irregular" : ""), name == "waves"   ? waves(grid)
                                                    : name == "torus" ? torus(grid)
                                                                      : ellipsoid(6, irregular)};
}

/// Where a body has lines at all; the settings are the defaults unless those leave nothing of it.
std::vector<Case> cases_of(const std::string& name) {
    if (name == "waves")
        return {{"smooth_contour", -1, -1, true}, {"suggestive_contour"}, {"suggestive_highlight", .005},
                {"principal_highlight_ridge", .01}, {"principal_highlight_valley", .01}, {"ridge"}, {"ridge", .02},
                {"valley"}, {"apparent_ridge", .01}, {"apparent_ridge", 0}, {"demarcating_curve"}, {"demarcating_curve", .01},
                {"laplacian_line"}, {"parabolic"}, {"zero_mean_curvature"}};
    if (name == "torus")
        return {{"smooth_contour"}, {"suggestive_contour", 0}, {"suggestive_highlight", 0}, {"principal_highlight_ridge", .001},
                {"laplacian_line"}, {"parabolic"}};
    return {{"smooth_contour"}, {"ridge", .02, 0}, {"principal_highlight_ridge", 0}, {"laplacian_line"}};
}

}  // namespace

class LineAccuracy : public testing::TestWithParam<std::tuple<const char*, bool>> {};

TEST_P(LineAccuracy, OfWhatIsFound) {
    const auto [name, irregular] = GetParam();
    const Body body = body_of(name, irregular);
    for (const Case& of : cases_of(name))
        for (const bool orthographic : {true, false}) {
            if (!orthographic && line_definitions()[definition_index(of.name)]->scope == Scope::surface) continue;
            SCOPED_TRACE(std::string(of.name) + (orthographic ? ", orthographic" : ", perspective"));
            const Match m = compare(body, of, orthographic);
            EXPECT_GT(m.exact, 0.3);
            EXPECT_LE(m.median, .02);
            EXPECT_LE(m.most, .07);
            EXPECT_NEAR(m.found / m.exact, 1.0, .03);
            EXPECT_GE(m.covered, .97);
            EXPECT_LE(m.false_share, .03);
        }
}

INSTANTIATE_TEST_SUITE_P(Bodies, LineAccuracy,
                         testing::Combine(testing::Values("waves", "torus", "ellipsoid"), testing::Bool()),
                         [](const auto& info) {
                             return std::string(std::get<0>(info.param)) + (std::get<1>(info.param) ? "_irregular" : "");
                         });
