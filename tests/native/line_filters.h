// SPDX-License-Identifier: GPL-3.0-or-later
// Lines at given pixels and distances, runs on them, and what runs cover.
#pragma once

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <random>

#include <fovea/runs/filters.h>

#include "wires.h"

namespace fovea::line_filters {
using namespace draw;

using namespace wires;

/// What the camera of wires.h sees at a pixel, so far away.
inline dvec3 at(double x, double y, double distance = 4.0) {
    return distance * dvec3(0.8 * (x / 320.0 - 1.0), 0.6 * (y / 240.0 - 1.0), -1.0);
}

/// Points on the straight line in the image between two places, dividing it evenly.
inline std::vector<dvec3> divided(dvec3 from, dvec3 to, int segments) {
    std::vector<dvec3> line;
    for (int i = 0; i <= segments; ++i) line.push_back(glm::mix(from, to, double(i) / segments));
    return line;
}

struct Part {
    Index piece;
    double start, end;
    int hidden_by = 0;
};

inline Runs runs_of(const std::vector<Part>& parts) {
    Runs runs;
    for (const Part& p : parts) runs.push(p.piece, p.start, p.end, std::uint8_t(p.hidden_by));
    return runs;
}

/// The whole of every piece.
inline Runs whole(const ClippedPaths& clipped) {
    Runs runs;
    for (Index q = 0; q < clipped.path.size(); ++q)
        runs.push(q, clipped.arc_px[first_of(clipped, q)], clipped.arc_px[last_of(clipped, q)]);
    return runs;
}

inline std::vector<float> everywhere(const ClippedPaths& clipped, float amount) {
    return std::vector<float>(clipped.path.empty() ? 0 : clipped.path.back() + 1, amount);
}

inline void expect_runs(const Runs& runs, const std::vector<Part>& expected, double error = 1e-3) {
    ASSERT_EQ(runs.size(), expected.size());
    for (std::size_t r = 0; r < runs.size(); ++r) {
        EXPECT_EQ(runs.piece[r], expected[r].piece) << r;
        EXPECT_NEAR(runs.start_px[r], expected[r].start, error) << r;
        EXPECT_NEAR(runs.end_px[r], expected[r].end, error) << r;
        EXPECT_EQ(runs.invisibility[r], expected[r].hidden_by) << r;
    }
}

inline void expect_same(const Runs& a, const Runs& b) {
    EXPECT_EQ(a.piece, b.piece);
    EXPECT_EQ(a.start_px, b.start_px);
    EXPECT_EQ(a.end_px, b.end_px);
    EXPECT_EQ(a.invisibility, b.invisibility);
}

/// Runs as they must be: ascending, apart, of some length.
inline void expect_sound(const Runs& runs) {
    for (std::size_t r = 0; r < runs.size(); ++r) {
        EXPECT_LT(runs.start_px[r], runs.end_px[r]);
        if (r > 0 && runs.piece[r] == runs.piece[r - 1]) {
            EXPECT_GE(runs.start_px[r], runs.end_px[r - 1] - 1e-9);
        } else if (r > 0) {
            EXPECT_GT(runs.piece[r], runs.piece[r - 1]);
        }
    }
}

inline double visible_length(const Runs& runs) {
    double sum = 0.0;
    for (std::size_t r = 0; r < runs.size(); ++r)
        if (runs.invisibility[r] == 0) sum += runs.end_px[r] - runs.start_px[r];
    return sum;
}

/// Whether all that is visible in `part` is visible in `all`, but for a hundred thousandth of a pixel at each end.
inline bool holds(const Runs& all, const Runs& part) {
    for (std::size_t r = 0; r < part.size(); ++r) {
        if (part.invisibility[r] != 0) continue;
        double from = part.start_px[r];  // not found visible yet
        for (std::size_t k = 0; k < all.size(); ++k) {
            const bool goes_on =
                all.invisibility[k] == 0 && all.piece[k] == part.piece[r] && all.start_px[k] <= from + 1e-5;
            if (goes_on) from = std::max(from, all.end_px[k]);
        }
        if (from < part.end_px[r] - 1e-5) return false;
    }
    return true;
}

/// Visible and hidden parts at random, of all pieces.
inline Runs random_runs(const ClippedPaths& clipped, std::mt19937& random) {
    std::uniform_real_distribution<double> step(0.2, 12.0);
    Runs runs;
    for (Index q = 0; q < clipped.path.size(); ++q) {
        const double last = clipped.arc_px[last_of(clipped, q)];
        for (double arc = clipped.arc_px[first_of(clipped, q)]; arc < last;) {
            const double next = std::min(last, arc + step(random));
            if (random() % 5 > 0) runs.push(q, arc, next, std::uint8_t(random() % 3));
            arc = next;
        }
    }
    return runs;
}

}  // namespace fovea::line_filters
