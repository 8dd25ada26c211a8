// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/image/spans.h>

#include <algorithm>
#include <cmath>

namespace fovea::image {
namespace {

/// Lines [begin, end) that a side crosses: those whose y is in (low, high].
std::pair<int, int> crossed(const Side& side, const ScanLines& lines) {
    const auto [low, high] = std::minmax(side.from.y, side.to.y);
    const auto after = [&](double y) {
        const double at = std::floor((y - lines.first) / lines.step) + 1.0;
        int line = int(std::clamp(at, 0.0, double(lines.count)));
        while (line > 0 && lines.y(line - 1) > y) --line;
        while (line < lines.count && lines.y(line) <= y) ++line;
        return line;
    };
    return {after(low), after(high)};
}

}  // namespace

void each_span(In<Side> sides, const ScanLines& lines, const std::function<void(int, double, double)>& visit) {
    const Lists<Index> met = lists_of<Index>(lines.count, [&](const auto& give) {
        for (Index i = 0; i < sides.size(); ++i) {
            const auto [begin, end] = crossed(sides[i], lines);
            for (int line = begin; line < end; ++line) give(line, i);
        }
    });
    parallel_blocks(lines.count, spans_block, [&](auto, std::size_t begin, std::size_t end) {
        std::vector<std::pair<double, int>> crossings;  // x, and the change of winding
        for (int line = int(begin); line < int(end); ++line) {
            crossings.clear();
            for (const Index i : met[Index(line)]) {
                const auto& [from, to] = sides[i];
                const double t = (lines.y(line) - from.y) / (to.y - from.y);
                crossings.emplace_back(glm::mix(from.x, to.x, t), to.y > from.y ? 1 : -1);
            }
            std::sort(crossings.begin(), crossings.end());
            int winding = 0;
            for (std::size_t k = 0; k + 1 < crossings.size(); ++k) {
                winding += crossings[k].second;
                double& start = crossings[k].first;
                if (winding == 0) continue;
                // An interval that goes on is visited as one.
                if (winding + crossings[k + 1].second != 0)
                    crossings[k + 1].first = start;
                else if (crossings[k + 1].first > start)
                    visit(line, start, crossings[k + 1].first);
            }
        }
    });
}

}  // namespace fovea::image
