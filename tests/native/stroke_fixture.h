// SPDX-License-Identifier: GPL-3.0-or-later
// Strokes from plain polylines, and what their picture adds up to.
#pragma once

#include <cmath>
#include <numbers>

#include <fovea/stroke/raster.h>
#include <fovea/stroke/tessellate.h>

namespace fovea::stroke_fixture {
using namespace draw;

/// Adds a piece whose path is the polyline itself; arc length 0 at its middle. Strength is indexed
/// by point.
inline void add_piece(ClippedPaths& clipped, const std::vector<vec2>& line, bool closed = false) {
    double length = 0.0, arc = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) length += glm::distance(dvec2(line[i]), dvec2(line[i - 1]));
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (i > 0) arc += glm::distance(dvec2(line[i]), dvec2(line[i - 1]));
        clipped.source.push_back(Index(clipped.px.size()));
        clipped.source_t.push_back(0.0f);
        clipped.px.push_back(line[i]);
        clipped.arc_px.push_back(arc - length / 2.0);
    }
    clipped.path.push_back(clipped.pieces.count());
    clipped.path_length_px.push_back(length);
    clipped.closed.push_back(closed);
    clipped.free_ends.push_back(closed ? 0 : 3);
    clipped.pieces.offsets.push_back(Index(clipped.px.size()));
}

inline void add_run(Runs& runs, Index piece, double start, double end, std::uint8_t hidden_by = 0) {
    runs.piece.push_back(piece);
    runs.start_px.push_back(start);
    runs.end_px.push_back(end);
    runs.invisibility.push_back(hidden_by);
}

/// Runs over the whole of every piece.
inline Runs whole_runs(const ClippedPaths& clipped) {
    Runs runs;
    for (Index q = 0; q < clipped.pieces.count(); ++q)
        if (clipped.pieces.size(q) > 0)
            add_run(runs, q, clipped.arc_px[clipped.pieces.begin(q)], clipped.arc_px[clipped.pieces.end(q) - 1]);
    return runs;
}

/// Every run drawn with the one pen.
inline Strokes strokes_of(const ClippedPaths& clipped, const Runs& runs, const Pen& pen, In<float> strength = {}) {
    const std::vector<Index> pen_of_run(runs.size(), 0);
    return tessellate(clipped, runs, pen_of_run, strength, {&pen, 1});
}

inline Strokes strokes_of(const std::vector<vec2>& line, const Pen& pen, bool closed = false) {
    ClippedPaths clipped;
    add_piece(clipped, line, closed);
    return strokes_of(clipped, whole_runs(clipped), pen);
}

inline Array<vec4> picture(const Strokes& strokes, const Pen& pen, int width, int height,
                           In<PenTexture> textures = {}) {
    return rasterize(strokes, {&pen, 1}, textures, width, height);
}

/// Sum of alpha: the area in px that ink covers.
inline double area(const Array<vec4>& image) {
    double sum = 0.0;
    for (const vec4& p : image) sum += p.a;
    return sum;
}

inline float largest_alpha(const Array<vec4>& image) {
    float largest = 0.0f;
    for (const vec4& p : image) largest = std::max(largest, p.a);
    return largest;
}

/// Points on a circle, the first repeated at the end.
inline std::vector<vec2> circle(dvec2 center, double radius, int count) {
    std::vector<vec2> line;
    for (int i = 0; i <= count; ++i) {
        const double a = 2.0 * std::numbers::pi * (i % count) / count;
        line.push_back(vec2(center + radius * dvec2(std::cos(a), std::sin(a))));
    }
    return line;
}

inline Pen pen(float width, Cap cap = Cap::round, float opacity = 1.0f) {
    Pen p;
    p.width_px = width;
    p.look.cap = cap;
    p.look.opacity = opacity;
    return p;
}

}  // namespace fovea::stroke_fixture
