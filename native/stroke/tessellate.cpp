#include "stroke/tessellate.h"

#include <algorithm>
#include <string>

#include "base/check.h"
#include "base/parallel.h"
#include "stroke/centre_line.h"
#include "stroke/strip.h"

namespace fovea {

namespace {

constexpr std::size_t block_size = 128;  // runs
constexpr double whole_error = 1e-3;     // px a run may miss at the ends of a piece that it covers
constexpr float endless = 1e9f;

void check_input(const ClippedPaths& clipped, const Runs& runs, In<Index> pen_of_path,
                 In<float> strength, In<Pen> pens) {
    check(runs.start_px.size() == runs.piece.size() && runs.end_px.size() == runs.piece.size(),
          "runs: piece, start_px and end_px must have the same length");
    Index piece = 0, path = 0, pen = 0;
    for (const Index q : runs.piece) piece = std::max(piece, q);
    check(runs.piece.empty() || piece < clipped.pieces.count(),
          "runs: there is no piece " + std::to_string(piece));
    for (const Index p : clipped.path) path = std::max(path, p);
    check(clipped.path.empty() || path < pen_of_path.size(),
          "pen_of_path: no entry for path " + std::to_string(path));
    for (const Index p : pen_of_path) pen = std::max(pen, p + 1);  // none + 1 == 0
    check(pen <= pens.size(), "pen_of_path: there is no pen " + std::to_string(pen - 1));
    if (strength.empty()) return;
    std::size_t source = 0;
    for (std::size_t i = 0; i < clipped.source.size(); ++i)
        source = std::max<std::size_t>(source,
                                       clipped.source[i] + std::size_t(clipped.source_t[i] > 0.0f));
    check(clipped.source.empty() || source < strength.size(),
          "strength: no entry for point " + std::to_string(source));
}

/// What each block of runs adds to the whole, laid end to end in order.
Strokes join(std::vector<Strokes>& blocks) {
    Array<std::size_t> vertices, triangles;
    for (const Strokes& b : blocks) {
        vertices.push_back(b.px.size());
        triangles.push_back(b.triangles.size());
    }
    counts_to_offsets(vertices);
    counts_to_offsets(triangles);
    check(vertices.back() < none, "strokes: too many vertices for 32-bit indices");

    Strokes all;
    all.px.resize(vertices.back());
    all.arc.resize(vertices.back());
    all.half_width.resize(vertices.back());
    all.opacity.resize(vertices.back());
    all.pen.resize(vertices.back());
    all.piece.resize(vertices.back());
    all.triangles.resize(triangles.back());
    for (const Strokes& b : blocks) all.count += b.count;
    parallel_for(
        blocks.size(),
        [&](std::size_t i) {
            const Strokes block = std::move(blocks[i]);
            const std::size_t v = vertices[i];
            std::ranges::copy(block.px, all.px.begin() + v);
            std::ranges::copy(block.arc, all.arc.begin() + v);
            std::ranges::copy(block.half_width, all.half_width.begin() + v);
            std::ranges::copy(block.opacity, all.opacity.begin() + v);
            std::ranges::copy(block.pen, all.pen.begin() + v);
            std::ranges::copy(block.piece, all.piece.begin() + v);
            std::ranges::transform(block.triangles, all.triangles.begin() + triangles[i],
                                   [&](glm::uvec3 t) { return t + Index(v); });
        },
        1);
    return all;
}

}  // namespace

Strokes tessellate(const ClippedPaths& clipped, const Runs& runs, In<Index> pen_of_path,
                   In<float> strength, In<Pen> pens) {
    check_input(clipped, runs, pen_of_path, strength, pens);
    std::vector<Strokes> blocks((runs.piece.size() + block_size - 1) / block_size);
    parallel_blocks(
        runs.piece.size(), block_size, [&](std::size_t block, std::size_t begin, std::size_t end) {
            CentreLine line;
            for (std::size_t r = begin; r < end; ++r) {
                const Index piece = runs.piece[r];
                const Index pen = pen_of_path[clipped.path[piece]];
                if (pen == none || clipped.pieces.size(piece) < 2) continue;
                const double first = clipped.arc_px[clipped.pieces.begin(piece)];
                const double last = clipped.arc_px[clipped.pieces.end(piece) - 1];
                const double start = std::max(runs.start_px[r], first),
                             stop = std::min(runs.end_px[r], last);
                const bool closed = clipped.closed[piece] && start < first + whole_error &&
                                    stop > last - whole_error;
                cut(clipped, strength, piece, start, stop, line);
                simplify(line);
                const int free = clipped.free_ends[piece];
                shape(line, pens[pen],
                      {(free & 1) && start < first + whole_error, (free & 2) && stop > last - whole_error});
                if (!closed) extend(line, pens[pen].cap);
                if (line.size() < 2) continue;
                add_strip(line, closed,
                          {closed ? -endless : float(start), closed ? endless : float(stop), pen},
                          blocks[block]);
                blocks[block].piece.resize(blocks[block].px.size(), piece);
                ++blocks[block].count;
            }
        });
    return join(blocks);
}

}  // namespace fovea
