// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/draw/exposure.h>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>
#include <fovea/draw/frame.h>

namespace fovea::draw {

void Exposure::add(Frame& moment, double weight) {
    check(weight > 0.0, "exposure: the weight of a moment is not above 0");
    moment.ink();
    const Options& options = moment.job.options;
    LinePasses passes;
    if (options.with_hidden || options.with_line_sets) passes = line_passes(moment);
    check(empty() || moment.passes.lines.size() == pixels_, "exposure: its moments differ in size");
    pixels_ = moment.passes.lines.size();
    close(lines_);
    close(hidden_);
    for (auto& [name, sum] : line_sets_) close(sum);
    lines_.last = std::move(moment.passes.lines);
    hidden_.last = std::move(passes.hidden);
    for (auto& [name, pixels] : passes.line_sets) line_sets_[name].last = std::move(pixels);
    weight_of_last_ = weight;
    weight_ += weight;
}

void Exposure::again(double weight) {
    check(!empty() && weight > 0.0, "exposure: there is no moment before this one, or its weight is not above 0");
    weight_of_last_ += weight;
    weight_ += weight;
}

void Exposure::replace(LinePasses& passes) const {
    if (!passes.hidden.empty()) passes.hidden = mean(hidden_);
    for (auto& [name, pixels] : passes.line_sets) {
        const auto found = line_sets_.find(name);
        pixels = mean(found == line_sets_.end() ? Sum{} : found->second);
    }
}

/// Adds the last moment's image to those before it.
void Exposure::close(Sum& sum) const {
    const Array<vec4> last = std::move(sum.last);
    sum.last = {};
    if (last.empty()) return;
    if (sum.before.empty()) sum.before.assign(pixels_, dvec4(0.0));
    parallel_for(pixels_, [&](std::size_t i) { sum.before[i] += weight_of_last_ * dvec4(last[i]); });
}

Array<vec4> Exposure::mean(const Sum& sum) const {
    Array<vec4> pixels(pixels_);
    parallel_for(pixels_, [&](std::size_t i) {
        dvec4 total = sum.before.empty() ? dvec4(0.0) : sum.before[i];
        if (!sum.last.empty()) total += weight_of_last_ * dvec4(sum.last[i]);
        pixels[i] = vec4(total / weight_);
    });
    return pixels;
}

}  // namespace fovea::draw
