// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/draw/object_at.h>

#include <algorithm>
#include <map>

#include <fovea/base/check.h>

namespace fovea::draw {

std::string object_at(const Frame& frame, const dvec2& px, double radius) {
    check(frame.tracer != nullptr, "frame: its lines are not found yet");
    constexpr int across = 8;  // rays from the middle to each side
    std::map<std::string, double> shown;
    for (int y = -across; y <= across; ++y)
        for (int x = -across; x <= across; ++x) {
            const dvec2 away = dvec2(x, y) / double(across);
            const double weight = 1.0 - glm::dot(away, away);
            if (!(weight > 0.0)) continue;
            if (const auto hit = frame.tracer->seen(px + radius * away))
                shown[frame.job.overrides.object_of(hit->placement)] += weight;
        }
    shown.erase("");
    const auto most = std::ranges::max_element(shown, {}, [](const auto& each) { return each.second; });
    return most == shown.end() ? std::string() : most->first;
}

}  // namespace fovea::draw
