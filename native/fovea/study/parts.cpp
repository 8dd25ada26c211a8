// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/parts.h>

#include <algorithm>

namespace fovea::study {

Lists<Index> parts_of(const Bitmap& bitmap) {
    Lists<Index> parts;
    Array<std::uint8_t> left = bitmap.set;
    const int width = bitmap.width, height = bitmap.height;
    for (std::size_t start = 0; start < left.size(); ++start) {
        if (!left[start]) continue;
        std::size_t done = parts.values.size();
        const auto take = [&](std::size_t i) {
            left[i] = 0;
            parts.values.push_back(Index(i));
        };
        for (take(start); done < parts.values.size(); ++done) {
            const int x = int(parts.values[done] % Index(width)), y = int(parts.values[done] / Index(width));
            for (int v = std::max(0, y - 1); v <= std::min(height - 1, y + 1); ++v)
                for (int u = std::max(0, x - 1); u <= std::min(width - 1, x + 1); ++u)
                    if (const std::size_t i = std::size_t(v) * std::size_t(width) + std::size_t(u); left[i]) take(i);
        }
        parts.offsets.push_back(Index(parts.values.size()));
    }
    return parts;
}

Bitmap without_specks(const Bitmap& bitmap, std::size_t least) {
    const Lists<Index> parts = parts_of(bitmap);
    Bitmap kept(bitmap.width, bitmap.height);
    for (Index part = 0; part < parts.count(); ++part)
        if (parts.size(part) >= least)
            for (const Index pixel : parts[part]) kept.set[pixel] = 1;
    return kept;
}

}  // namespace fovea::study
