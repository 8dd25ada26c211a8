// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/elision/in_time.h>

#include <algorithm>
#include <cstdlib>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>

namespace fovea::elision {

using Sample = LinePlaces::Sample;

ShownLines shown_lines(const ClippedPaths& clipped, const Paths& paths, const Scene& scene, const Runs& runs,
                       In<float> shown, int width, int height) {
    check(shown.size() == clipped.samples, "smoothing in time: one opacity per atlas sample expected");
    ShownLines lines{line_places(clipped, paths, scene, runs, width, height), {}};
    lines.shown = parallel_map<float>(lines.places.samples.size(),
                                      [&](std::size_t i) { return shown[lines.places.samples[i].number]; });
    return lines;
}

namespace {

double value_at(const ShownLines& lines, const MatchedPlaces::Place& at) {
    return glm::mix(double(lines.shown[at.before]), double(lines.shown[at.after]), at.share);
}

std::vector<MatchedPlaces> matched_with(const LinePlaces& places, In<FrameNear> near) {
    std::vector<MatchedPlaces> matched;
    for (const auto& [away, lines] : near) matched.emplace_back(places, lines->places);
    return matched;
}

}  // namespace

Array<float> smoothed_in_time(In<float> shown, const ShownLines& now, In<FrameNear> near, int frames) {
    const LinePlaces& places = now.places;
    const bool fits = std::ranges::all_of(places.samples, [&](const Sample& s) { return s.number < shown.size(); });
    check(fits, "smoothing in time: lines of another frame");
    for (const auto& [away, lines] : near)
        check(away != 0 && std::abs(away) <= frames, "smoothing in time: a frame is not near by");
    Array<float> smooth(shown.begin(), shown.end());
    const std::vector<MatchedPlaces> matched = matched_with(places, near);
    parallel_for(places.path.size(), 64, [&](std::size_t stretch) {
        for (Index i = places.rows.begin(Index(stretch)); i < places.rows.end(Index(stretch)); ++i) {
            const Sample& sample = places.samples[i];
            if (!sample.inside) continue;
            double weight = frames + 1.0, sum = weight * now.shown[i];
            for (std::size_t k = 0; k < near.size(); ++k) {
                const auto& [away, lines] = near[k];
                const auto there = matched[k].at(sample, places.hidden[stretch]);
                if (!there) continue;
                weight += frames + 1.0 - std::abs(away);
                sum += (frames + 1.0 - std::abs(away)) * value_at(*lines, *there);
            }
            smooth[sample.number] = float(sum / weight);
        }
    });
    return smooth;
}

void show_as_near(Array<float>& shown, const LinePlaces& places, In<float> now, In<FrameNear> near) {
    const std::vector<MatchedPlaces> matched = matched_with(places, near);
    parallel_for(places.path.size(), 64, [&](std::size_t stretch) {
        if (places.hidden[stretch]) return;
        for (Index i = places.rows.begin(Index(stretch)); i < places.rows.end(Index(stretch)); ++i) {
            const LinePlaces::Sample& sample = places.samples[i];
            if (now[sample.number] > 0.0f) continue;
            double count = 0.0, sum = 0.0;
            for (std::size_t k = 0; k < near.size(); ++k)
                if (const auto there = matched[k].at(sample, false)) {
                    ++count;
                    sum += value_at(*near[k].second, *there);
                }
            shown[sample.number] = count > 0.0 ? float(sum / count) : 1.0f;
        }
    });
}

}  // namespace fovea::elision
