// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/line_direction.h>

#include <algorithm>
#include <cmath>

namespace fovea::study {

vec2 normal_at(const Bitmap& lines, int x, int y, int within) {
    double n = 0.0, sx = 0.0, sy = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
    for (int v = std::max(0, y - within); v <= std::min(lines.height - 1, y + within); ++v)
        for (int u = std::max(0, x - within); u <= std::min(lines.width - 1, x + within); ++u)
            if (lines.set[std::size_t(v) * std::size_t(lines.width) + std::size_t(u)]) {
                const double du = u - x, dv = v - y;
                n += 1.0, sx += du, sy += dv, xx += du * du, xy += du * dv, yy += dv * dv;
            }
    const double a = xx - sx * sx / n, b = xy - sx * sy / n, c = yy - sy * sy / n;
    const double spread = std::hypot(a - c, 2.0 * b);
    if (spread < 0.5 * (a + c) || spread == 0.0) return vec2(0.0f);  // neither way more than the other
    const double angle = 0.5 * std::atan2(2.0 * b, a - c);
    return {float(-std::sin(angle)), float(std::cos(angle))};
}

}  // namespace fovea::study
