// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/stroke/compose.h>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>

namespace fovea {

void compose(In<vec4> lines, vec3 paper, bool film_transparent, In<float> holdout, Array<vec4>& out) {
    check(holdout.empty() || holdout.size() == lines.size(), "holdout: expected one value per pixel");
    out.resize(lines.size());
    parallel_for(
        lines.size(),
        [&](std::size_t i) {
            const float alpha = film_transparent ? 0.0f : holdout.empty() ? 1.0f : 1.0f - holdout[i];
            out[i] = lines[i] + vec4(paper * alpha, alpha) * (1.0f - lines[i].a);
        },
        65536);
}

}  // namespace fovea
