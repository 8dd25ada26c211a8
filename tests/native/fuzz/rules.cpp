// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules.h"

#include <cmath>
#include <regex>

#include <fovea/draw/polylines.h>
#include <fovea/vector/center_lines.h>

namespace fovea::fuzz {
using namespace draw;

namespace {

void must(bool holds, const std::string& what) {
    if (!holds) throw Broken(what);
}

template <typename T>
void check_finite(const Array<T>& values, const std::string& name) {
    const auto check = [&](auto value, std::size_t i, const char* part) {
        if (!std::isfinite(double(value)))
            throw Broken(name + "[" + std::to_string(i) + "]" + part + " is " + std::to_string(value));
    };
    static constexpr const char* parts[] = {".x", ".y", ".z", ".w"};
    if constexpr (std::is_floating_point_v<T>)
        for (std::size_t i = 0; i < values.size(); ++i) check(values[i], i, "");
    else if constexpr (requires { T::length(); })
        for (std::size_t i = 0; i < values.size(); ++i)
            for (int c = 0; c < T::length(); ++c) check(values[i][c], i, parts[c]);
}

template <typename Structure, typename Columns>
void check_columns(const Structure& of, const Columns& columns, const std::string& name) {
    std::size_t size = SIZE_MAX;
    for_each_column(columns, [&](const auto& column) {
        const auto& values = of.*column.array;
        if (!values.empty() && size == SIZE_MAX) size = values.size();
        must(values.empty() || values.size() == size, name + "." + column.name + " differs in length from others");
        check_finite(values, name + "." + column.name);
    });
}

void check_runs_of(const Runs& runs, const ClippedPaths& clipped, const std::string& name) {
    check_columns(runs, Runs::columns, name);
    for (std::size_t r = 0; r < runs.size(); ++r) {
        must(runs.piece[r] < clipped.pieces.count(), name + " have one of no piece");
        must(runs.start_px[r] < runs.end_px[r], name + " have an empty one");
    }
}

}  // namespace

void check_arrays(Frame& frame) {
    check_columns(*frame.paths, Paths::path_columns, "paths");
    check_columns(*frame.paths, Paths::point_columns, "paths");
    check_columns(*frame.clipped, ClippedPaths::piece_columns, "clipped");
    check_columns(*frame.clipped, ClippedPaths::point_columns, "clipped");
    check_runs_of(*frame.visible, *frame.clipped, "visible");
    check_runs_of(*frame.runs, *frame.clipped, "runs");
    check_runs_of(*frame.drawn, *frame.clipped, "drawn");
    check_finite(frame.samples, "samples");
    check_finite(samples_from_runs(*frame.clipped, *frame.runs), "samples of runs");
    check_finite(frame.focus, "focus");
    check_finite(frame.distance, "distance");
    check_finite(frame.shown, "shown");
    check_columns(*frame.strokes, Strokes::vertex_columns, "strokes");
    const Polylines lines = polylines_of(frame);
    check_columns(lines, CompactRuns::run_columns, "polylines");
    check_columns(lines, CompactRuns::point_columns, "polylines");
    check_columns(lines, Polylines::pen_columns, "polylines");
    const vector::CenterLines strokes = vector::center_lines_of(frame);
    check_columns(strokes, vector::CenterLines::line_columns, "center lines");
    check_columns(strokes, vector::CenterLines::point_columns, "center lines");

    const std::size_t pixels = std::size_t(frame.job.view.width) * std::size_t(frame.job.view.height);
    const auto check_pass = [&](const auto& pass, const char* name) {
        must(pass.empty() || pass.size() == pixels, std::string(name) + " has not the size of the picture");
        check_finite(pass, name);
    };
    check_pass(frame.passes.lines, "lines");
    check_pass(frame.passes.color, "color");
    check_pass(frame.passes.focus, "focus");
    check_pass(frame.passes.depth, "depth");
    check_pass(frame.passes.combined, "combined");
    must(frame.passes.combined.size() == pixels, "there is no picture");
}

void check_sentence(const std::string& message) {
    const auto refuse = [&](const char* why) { throw Broken("a message " + std::string(why) + ": " + message); };
    if (message.empty()) refuse("is empty");
    for (const char letter : message)
        if (static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f) refuse("is not printable on one line");
    if (message.size() > 1000) refuse("is too long");
    if (message.front() == ' ' || message.back() == ' ' || message.back() == '.' || message.back() == ':')
        refuse("does not begin or end as a sentence");
    static const std::regex inner(R"(std::|vector|bad_alloc|basic_|nlohmann|_M_|0x[0-9a-f]{4}|\berror \d|\bRTC)");
    if (std::regex_search(message, inner)) refuse("has words of the implementation");
    // What a message names: an object; the camera; a member of a style or of the options; or its file.
    static const std::regex named(R"(^(Surface \d: |camera: |options\.\w+ |the style |not JSON at line \d+, column \d+)"
                                  R"(|.+ gives '.*' twice|.+ is nested more than)"
                                  R"(|[a-z_]+(\[\d+\])?([.:]| (is|must|has) )))");
    if (!std::regex_search(message, named)) refuse("names nothing");
    // What to do: a clause of its own, or what is needed or possible instead.
    static const std::regex remedy(
        R"(; |\(| must |\bexpected\b|, outside |\bpossible\b|can be: |there are: |\bonly\b|twice$)"
        R"(|not a finite number|not JSON|nested more|not the number of|: a newer version)"
        R"(|, less than |two ranges hold)");
    if (!std::regex_search(message, remedy)) refuse("does not say what to do");
}

std::string kind_of_sentence(const std::string& message) {
    static const std::regex quoted("'[^']*'"), number(R"(-?\d+(\.\d+)?(e[+-]?\d+)?)");
    return std::regex_replace(std::regex_replace(message, quoted, "'...'"), number, "N");
}

}  // namespace fovea::fuzz
