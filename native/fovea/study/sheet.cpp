// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/sheet.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fovea/base/check.h>
#include <fovea/study/parts.h>
#include <fovea/study/scan.h>
#include <fovea/vector/page.h>

namespace fovea::study {
namespace {

constexpr double margin = 12.0, line_of_text = 5.0, gap = 10.0;  // [mm]
constexpr double faint = 0.15;                                   // of the picture's ink, below the drawing

// In widths of the frame: how far outside of its corners the discs are, their radius, and where on the way from the
// upper left one to the upper right one the disc is that tells which is which.
constexpr double mark_outside = 0.03, mark_radius = 0.012, fifth_mark = 0.125;

// Of discs on scans.
constexpr double least_size = 1.0 / 300, most_size = 1.0 / 25;  // of the diagonal
constexpr double least_aspect = 0.7, fill_error = 0.09, fill_error_of_pixel = 0.8;
constexpr std::size_t most_discs = 12;
constexpr double fifth_within = 0.6;   // radii: how far from where the others say that it is
constexpr double radius_within = 1.4;  // factor: how much larger or smaller discs are than the others say

/// Centers of the discs around a frame of width x height: upper left, upper right, lower right, lower left, the fifth.
std::array<dvec2, 5> marks_around(double width, double height) {
    const double out = mark_outside * width;
    const dvec2 upper_left(-out, height + out), upper_right(width + out, height + out);
    return {upper_left, upper_right, dvec2(width + out, -out), dvec2(-out, -out),
            upper_left + fifth_mark * (upper_right - upper_left)};
}

vector::Curve circle(const dvec2& center, double radius) {
    constexpr double handle = 4.0 / 3.0 * (std::numbers::sqrt2 - 1.0);
    const auto at = [&](double x, double y) { return center + radius * dvec2(x, y); };
    vector::Curve curve;
    curve.points.push_back(at(1.0, 0.0));
    curve.cubic_to(at(1.0, handle), at(handle, 1.0), at(0.0, 1.0));
    curve.cubic_to(at(-handle, 1.0), at(-1.0, handle), at(-1.0, 0.0));
    curve.cubic_to(at(-1.0, -handle), at(-handle, -1.0), at(0.0, -1.0));
    curve.cubic_to(at(handle, -1.0), at(1.0, -handle), at(1.0, 0.0));
    curve.closed = true;
    return curve;
}

struct Disc {
    dvec2 center;
    double radius;
};

/// The largest round parts of a scan's ink.
std::vector<Disc> discs_of(const color::GrayImage& scan) {
    const Bitmap ink = ink_of(scan);
    const Lists<Index> parts = parts_of(ink);
    std::vector<Disc> discs;
    for (Index part = 0; part < parts.count(); ++part) {
        dvec2 low(INFINITY), high(-INFINITY), sum(0.0);
        for (const Index pixel : parts[part]) {
            const dvec2 center = center_of(pixel, ink.width);
            low = glm::min(low, center - 0.5), high = glm::max(high, center + 0.5);
            sum += center;
        }
        const dvec2 size = high - low;
        const double count = double(parts.size(part)), larger = std::max(size.x, size.y);
        if (larger < least_size * ink.diagonal() || larger > most_size * ink.diagonal()) continue;
        if (std::min(size.x, size.y) < least_aspect * larger) continue;
        const double error = std::abs(count / (size.x * size.y) - 0.25 * std::numbers::pi);
        if (error > fill_error + fill_error_of_pixel / larger) continue;
        discs.push_back({sum / count, 0.5 * larger});
    }
    std::ranges::stable_sort(discs, std::greater(), &Disc::radius);
    if (discs.size() > most_discs) discs.resize(most_discs);
    return discs;
}

/// Whether a disc is where and as large as a map from the frame says of a mark.
bool is_mark(const Disc& disc, const dvec2& mark, double radius, const Homography& map) {
    if (glm::distance(mapped(map, mark), disc.center) >= fifth_within * disc.radius) return false;
    const auto reach = [&](const dvec2& to) {
        return 0.5 * glm::distance(mapped(map, mark + radius * to), mapped(map, mark - radius * to));
    };
    const double expected = std::max(reach({1.0, 0.0}), reach({0.0, 1.0}));
    return disc.radius < radius_within * expected && expected < radius_within * disc.radius;
}

}  // namespace

vector::Document prompt_sheet(const color::GrayImage& picture, vector::Sheet sheet, const std::string& title) {
    vector::Document page;
    page.size = vector::sheet_size(sheet);
    check(page.size.x > 0.0, "a sheet to draw on needs a size: name a4 or letter");
    // Marks, text and margins leave this for the two frames.
    const double free_width = page.size.x - 2.0 * margin, free_height = 0.5 * (page.size.y - 2.0 * margin) - gap;
    const double aspect = double(picture.height) / picture.width, around = 2.0 * (mark_outside + mark_radius);
    const double width = std::min(free_width / (1.0 + around), (free_height - line_of_text) / (aspect + around));
    const double height = aspect * width, left = 0.5 * (page.size.x - width);
    const dvec2 lower(left, margin + line_of_text + 0.5 * around * width), upper(left, 0.5 * page.size.y + gap);

    // One picture of both, as high as they are apart.
    const double px = width / picture.width;
    vector::Image both;
    both.width = picture.width, both.channels = 3;
    const int rise = int(std::lround((upper.y - lower.y) / px));
    both.height = rise + picture.height;
    both.lower = lower, both.size = px * dvec2(both.width, both.height);
    both.values.assign(3 * std::size_t(both.width) * std::size_t(both.height), white);
    for (std::size_t i = 0; i < picture.values.size(); ++i) {
        const double value = picture.values[i];
        const std::size_t above = std::size_t(rise) * std::size_t(picture.width) + i;
        for (std::size_t c = 0; c < 3; ++c) {
            both.values[3 * i + c] = std::uint8_t(std::lround(white - faint * (white - value)));
            both.values[3 * above + c] = picture.values[i];
        }
    }
    page.image = std::move(both);

    vector::Layer layer{"frame", "Frame", "", {}, {}};
    const vector::Points corners{lower, lower + dvec2(width, 0.0), lower + dvec2(width, height),
                                 lower + dvec2(0.0, height), lower};
    layer.paths.push_back({"box", "", "", 0, {dvec3(0.6), 1.0, 0.15}, {vector::Curve::through(corners, true)}});
    vector::Path marks{"marks", "", "", 0, {}, {}};
    for (const dvec2& mark : marks_around(width, height))
        marks.curves.push_back(circle(lower + mark, mark_radius * width));
    layer.paths.push_back(std::move(marks));
    layer.captions.push_back({"title", title, dvec2(left, margin), 0.6 * line_of_text});
    page.layers.push_back(std::move(layer));
    return page;
}

std::optional<Homography> found_by_marks(const color::GrayImage& scan, int width, int height) {
    const std::array<dvec2, 5> marks = marks_around(width, height);
    const std::vector<Disc> discs = discs_of(scan);
    const std::size_t count = discs.size();
    std::optional<Homography> best;
    double largest = 0.0;  // the marks are around all else
    for (std::size_t a = 0; a < count; ++a)
        for (std::size_t b = 0; b < count; ++b)
            for (std::size_t c = 0; c < count; ++c)
                for (std::size_t d = 0; d < count; ++d) {
                    if (a == b || a == c || a == d || b == c || b == d || c == d) continue;
                    const std::array<dvec2, 4> at{discs[a].center, discs[b].center, discs[c].center, discs[d].center};
                    // Clockwise all around, as they are on the sheet.
                    bool is_clockwise = true;
                    for (std::size_t i = 0; i < 4; ++i)
                        is_clockwise &= cross(at[(i + 1) % 4] - at[i], at[(i + 2) % 4] - at[(i + 1) % 4]) < 0.0;
                    const double area = std::abs(cross(at[2] - at[0], at[3] - at[1]));
                    if (!is_clockwise || area <= largest) continue;
                    const auto map = homography_of({marks.data(), 4}, at);
                    if (!map) continue;
                    const auto is_at = [&](std::size_t disc, std::size_t mark) {
                        return is_mark(discs[disc], marks[mark], mark_radius * width, *map);
                    };
                    if (!is_at(a, 0) || !is_at(b, 1) || !is_at(c, 2) || !is_at(d, 3)) continue;
                    for (std::size_t fifth = 0; fifth < count; ++fifth)
                        if (is_at(fifth, 4)) largest = area, best = map;
                }
    return best;
}

}  // namespace fovea::study
