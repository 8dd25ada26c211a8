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
    ExactGrid grid{sample, std::getenv("N") ? atoi(std::getenv("N")) : 512};
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
    bool inner(const dvec3& p) const { return name != "waves" || std::max(std::abs(p.x), std::abs(p.y)) < 0.95; }
};

Match compare(const Body& body, const char* name, const Values& values, const Eye& eye, double reach = 1.0) {
    const double feature_size = fields_of(*body.surface)->feature_size;
    const ExactCurves exact = exact_curves(body.grid, exact_line(name, values, feature_size), eye);
    const Curves found = line_definitions()[definition_index(name)]->find(eye.view(*body.surface), values);
    const Match m = match(body.sample, segments_of(found), exact, body.edge, reach, [&](const dvec3& p) { return body.inner(p); });
    if (std::getenv("FOVEA_LINE_TABLE"))
        std::printf("| %s | %s | %s | %.3f | %.3f | %.3f | %.3f | %.3f | %.3f | %.3f |\n", name, body.name.c_str(),
                    eye.orthographic ? "ortho" : "persp", values.empty() ? 0.0 : values[0], m.median, m.most, m.exact, m.found, m.covered, m.false_share);
    return m;
}

}  // namespace

TEST(LineTable, Explore) {
    const std::pair<const char*, double> all[] = {{"smooth_contour",-1}, {"suggestive_contour",-1},{"suggestive_contour",0}, {"suggestive_highlight",0},{"suggestive_highlight",.005},
       {"principal_highlight_ridge",.01},  {"principal_highlight_ridge",.001},  {"principal_highlight_ridge",.0},
                         {"principal_highlight_valley",.01},{"principal_highlight_valley",.0}, {"ridge",-1}, {"ridge",.05},{"ridge",.02}, {"valley",-1}, {"apparent_ridge",.01}, {"apparent_ridge",0}, {"demarcating_curve",-1}, {"demarcating_curve",.01}, {"demarcating_curve",.001},
                         {"laplacian_line",-1}, {"laplacian_line",0}, {"parabolic",-1},{"parabolic",0}, {"zero_mean_curvature",-1},{"zero_mean_curvature",0}};
    for (const bool irregular : {false, true})
        for (int shape = 0; shape < 3; ++shape) {
            const Body body(shape == 0 ? "waves" : shape == 1 ? "torus" : "ellipsoid",
                            shape == 0 ? waves({.n = 256, .irregular = irregular})
                            : shape == 1 ? torus({.n = 256, .irregular = irregular})
                                         : ellipsoid(6, irregular));
            std::printf("%s %d edge %g fs %g %s\n", body.name.c_str(), irregular, body.edge,
                        fields_of(*body.surface)->feature_size, fields_of(*body.surface)->reason.c_str());
            for (const auto& [name,t] : all)
                for (const bool ortho : {true, false}) {
                    const dvec3 v = body.name == "waves" && std::string(name) == "smooth_contour" ? low : oblique;
                    Values d=defaults(name); if(t>=0) d[0]=t;
                    if (ortho || line_definitions()[definition_index(name)]->scope!=Scope::surface)
                    compare(body, name, d, {ortho ? v : 5.0 * v, ortho});
                }
        }
}
