// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/fixations.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace fovea::study {

std::vector<Fixation> fixations(Plane salience, double shape, int most) {
    const double radius = std::min(shape, 1.0) / 6.0;  // in heights of the picture
    const auto at = [&](int x, int y) { return dvec2((x + 0.5) / salience.width, (y + 0.5) / salience.height); };
    std::vector<Fixation> found;
    double first = 0.0;
    while (int(found.size()) < most) {
        const auto winner = std::ranges::max_element(salience.values);
        if (winner == salience.values.end() || !(*winner > 0.0f)) break;
        if (found.empty()) first = double(*winner);
        const int cell = int(winner - salience.values.begin());
        const dvec2 place = at(cell % salience.width, cell / salience.width);
        found.push_back({place, double(*winner) / first});
        for (int y = 0; y < salience.height; ++y)
            for (int x = 0; x < salience.width; ++x)
                if (glm::length((at(x, y) - place) * dvec2(shape, 1.0)) < radius) salience.at(x, y) = 0.0f;
        *winner = 0.0f;
    }
    return found;
}

double salient_share(const Plane& salience, const Plane& weights) {
    const Plane of_cells = resized(weights, salience.width, salience.height);
    const auto& all = salience.values;
    const double sum = std::accumulate(all.begin(), all.end(), 0.0);
    if (!(sum > 0.0)) return std::accumulate(of_cells.values.begin(), of_cells.values.end(), 0.0) / double(all.size());
    return std::inner_product(all.begin(), all.end(), of_cells.values.begin(), 0.0) / sum;
}

}  // namespace fovea::study
