// SPDX-License-Identifier: GPL-3.0-or-later
// Visibility over frames: lines drawn by how long they are seen.
#include <algorithm>
#include <cstdlib>

#include <fovea/draw/frame.h>
#include <fovea/elision/seen_in_time.h>

namespace fovea::draw {
namespace {

constexpr float half_the_time = 0.5f;  // where lines end that retract

}  // namespace

/// Runs that are visible for a part of the time over the style's frames, in place of those that are visible now, and
/// how long at each sample: fills `seen`, and `shown` where they are not visible now. Without frames near by as they
/// are.
Runs Frame::over_frames(Runs runs) {
    const style::Animation& animation = job.style.animation;
    std::vector<SeenNear> near;
    std::vector<FrameNear> elided;
    for (const auto& [away, lines] : job.near) {
        if (away == 0 || std::abs(away) > animation.visibility_frames) continue;
        if (lines.seen) near.emplace_back(away, lines.seen);
        if (lines.shown) elided.emplace_back(away, lines.shown);
    }
    if (!lasts() || near.empty()) return runs;
    const SeenLines& now = *found_lines()->lines.seen;
    const SeenInTime in_time(*paths, now, near, animation.visibility_frames);
    const auto ramps = in_time.ramps();
    if (std::ranges::all_of(ramps, [](const auto& of_path) { return of_path.empty(); })) return runs;
    const bool retracts = animation.vanish == style::Vanish::retract;
    Runs found = seen_runs(*clipped, *paths, runs, ramps, retracts ? half_the_time : 0.0f);
    if (!retracts) seen = seen_at_samples(*clipped, *paths, ramps);
    if (shown.empty() && samples.empty()) return found;
    const Array<float> drawn_then = samples_from_runs(*clipped, found);
    if (!shown.empty()) {
        const LinePlaces places = line_places(*clipped, *paths, *job.scene, found, job.view.width, job.view.height);
        const Array<float> drawn_now = samples_from_runs(*clipped, runs);
        show_as_near(shown, places, drawn_now, elided);
        const auto comes = parallel_map<std::uint8_t>(
            shown.size(), [&](std::size_t s) { return drawn_then[s] > 0.0f && drawn_now[s] == 0.0f; });
        values_from_places(shown, *now.of_view, *clipped, comes, in_time.shown_near());
        leave_out_faint();
    }
    if (!samples.empty()) {
        // What partly visible samples say of ends is of the lines as they are now.
        at_ends_ = samples;
        for (Index q = 0; q < clipped->path.size(); ++q)
            if (!ramps[clipped->path[q]].empty())
                for (Index s = clipped->first_sample(q); s < clipped->first_sample(q + 1); ++s)
                    at_ends_[s] = drawn_then[s] > 0.0f ? 1.0f : 0.0f;
    }
    return found;
}

}  // namespace fovea::draw
