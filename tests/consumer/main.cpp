// SPDX-License-Identifier: GPL-3.0-or-later
// Draws a box, and prints how many strokes that takes and how much ink.
#include <glm/gtc/matrix_transform.hpp>
#include <iostream>

#include <fovea/draw/frame.h>
#include <fovea/mesh/polygon_surface.h>
#include <fovea/style/json.h>

int main() {
    using namespace fovea::draw;
    std::vector<glm::vec3> corners;
    for (int i = 0; i < 8; ++i) corners.emplace_back(i & 1, i >> 1 & 1, i >> 2);
    const std::vector<int> verts{0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
    const std::vector<int> quads{0, 4, 8, 12, 16, 20, 24};
    Job job;
    job.scene = std::make_shared<Scene>(std::vector<Placement>{{polygon_surface("box", corners, verts, quads)}});
    job.view.width = job.view.height = 400;
    job.view.world_to_view = glm::lookAt(glm::dvec3(4, -3, 2.5), glm::dvec3(0.5), glm::dvec3(0, 0, 1));
    job.view.view_to_clip = glm::perspective(0.5, 1.0, job.view.near_clip, job.view.far_clip);
    job.style =
        fovea::style::read_style(R"({"schema": 1, "line_sets": [{"kinds": {"crease": {}}, "least_length": 0}]})");
    job.assets = std::make_shared<Assets>(".");
    job.backend = std::make_shared<CpuBackend>();
    Frame frame(std::move(job));
    frame.picture();
    double ink = 0.0;
    for (const auto& pixel : frame.passes.lines) ink += pixel.a;
    std::cout << frame.strokes->count << " strokes, " << (ink > 500.0 ? "inked" : "empty") << "\n";
}
