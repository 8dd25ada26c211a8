// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/vector/title_block.h>

#include <algorithm>
#include <cmath>
#include <map>

#include <fovea/base/check.h>
#include <fovea/vector/text.h>

namespace fovea::vector {
namespace {

// Lengths in millimeters.
constexpr double most_width = 180.0, least_width = 110.0;
constexpr double thick = 0.7, thin = 0.35;
constexpr double usual = 2.5, large = 3.5;                     // heights of letters
constexpr double free_beside = 1.0, below = 1.5, above = 0.8;  // free around text in its cell

/// A cell by the name of what it says; its share of the row's width.
struct Column {
    const char* name;
    double share, letters = usual;
};

struct Row {
    double height;
    std::vector<Column> columns;
};

const std::vector<Row>& rows() {
    static const std::vector<Row> all{
        {8.0, {{"creator", 0.25}, {"approver", 0.25}, {"document", 0.25}, {"date", 0.25}}},
        {12.0, {{"owner", 0.36}, {"title", 0.64, large}}},
        {10.0, {{"scale", 0.17}, {"size", 0.16}, {"number", 0.39, large}, {"revision", 0.15}, {"sheet", 0.13}}}};
    return all;
}

double height() {
    double sum = 0.0;
    for (const Row& row : rows()) sum += row.height;
    return sum;
}

struct Entry {
    std::string label, text;
};

/// What is said, by its names.
std::map<std::string, Entry> entries_of(const Options& options, const std::string& scale) {
    std::map<std::string, Entry> entries{{"scale", {"Scale", scale}},
                                         {"size", {"Sheet Size", style::choices_of<Sheet>[int(options.sheet)].label}}};
    style::for_each_field<Titles>(
        [&](const auto& field) { entries[field.name] = {field.label, options.titles.*field.member}; });
    return entries;
}

/// Width of a letter, of the size of the font: that of DejaVu Sans or more, which is wider than most.
double width_of(char32_t letter) {
    const auto is_of = [&](std::u32string_view some) { return some.find(letter) != some.npos; };
    if (is_of(U" !'(),-./:;I[]`fijlrt|")) return 0.42;
    if (is_of(U"MW@%mw")) return 1.0;
    if ((letter >= U'a' && letter <= U'z') || (letter >= U'0' && letter <= U'9')) return 0.64;
    return letter < 0x250 ? 0.84 : 1.1;
}

Path ruled(const std::string& id, const Points& points, bool closed, double width, const dvec3& ink) {
    return {id, "", "", 0, {.color = ink, .width = width, .round_caps = false}, {Curve::through(points, closed)}};
}

}  // namespace

dvec2 title_block_size(const dvec2& space) {
    check(space.x >= least_width && space.y > height(),
          "vectors: a title block is at least " + number(least_width) + " mm wide and " + number(height()) +
              " mm high, and within its margins this paper has " + number(space.x) + " x " + number(space.y) +
              " mm: take larger paper or a smaller margin");
    return {std::min(space.x, most_width), height()};
}

std::vector<TitleCell> title_cells(const dvec2& lower, double width, const Options& options, const std::string& scale) {
    const std::map<std::string, Entry> entries = entries_of(options, scale);
    std::vector<TitleCell> cells;
    double top = lower.y + height();
    for (const Row& row : rows()) {
        top -= row.height;
        double left = 0.0;
        for (const Column& column : row.columns) {
            const Entry& entry = entries.at(column.name);
            cells.push_back({column.name,
                             entry.label,
                             entry.text,
                             {lower.x + left * width, top},
                             {column.share * width, row.height},
                             column.letters});
            left += column.share;
        }
    }
    return cells;
}

std::string scale_text(const View& view, const Page& page, double unit_meters) {
    // Millimeters on paper to a unit of the scene.
    const double across = 0.5 * view.width * view.view_to_clip[0][0] * page.scale * page.unit_mm;
    const double upright = 0.5 * view.height * view.view_to_clip[1][1] * page.scale * page.unit_mm;
    if (!view.orthographic || std::abs(across / upright - 1.0) > 1e-3) return "not to scale";
    const auto digits = [](double value) {
        const double most = value < 10.0 ? 1000.0 : value < 100.0 ? 100.0 : value < 1000.0 ? 10.0 : 1.0;
        return number(std::round(value * most) / most);
    };
    const double meters = 1000.0 * unit_meters / upright;
    return meters >= 1.0 ? "1:" + digits(meters) : digits(1.0 / meters) + ":1";
}

Caption fitted(const std::string& text, double letters, double width) {
    Caption caption;
    caption.text = printable(text);
    caption.size = letters / capitals;
    const auto wide = [](const std::string& some) {
        double sum = 0.0;
        for (const char32_t letter : code_points(some)) sum += width_of(letter);
        return sum;
    };
    const double all = wide(caption.text), least = std::min(letters, least_letters) / capitals;
    if (all * caption.size <= width) return caption;
    caption.size = std::max(width / all, least);
    if (all * caption.size <= width * (1.0 + 1e-9)) return caption;
    const std::string ellipsis = "...";
    double left = width / caption.size - wide(ellipsis);
    std::size_t end = 0;
    for (std::size_t next = 0; next < caption.text.size(); end = next) {
        do ++next;
        while (next < caption.text.size() && (caption.text[next] & 0xc0) == 0x80);
        left -= wide(caption.text.substr(end, next - end));
        if (left < 0.0) break;
    }
    caption.text = caption.text.substr(0, end) + ellipsis;
    return caption;
}

std::vector<Layer> title_block_layers(const Page& page, const Options& options, const std::string& scale,
                                      const dvec3& ink) {
    const dvec2 from(options.margin), to = page.size - options.margin, size = title_block_size(to - from);
    const dvec2 lower(to.x - size.x, from.y);
    Layer frame{"frame", "frame", {}, {}, {}};
    frame.paths = {
        ruled("frame-sheet", {from, {to.x, from.y}, to, {from.x, to.y}, from}, true, thick, ink),
        ruled("frame-title-block", {lower, {lower.x, lower.y + size.y}, {to.x, lower.y + size.y}}, false, thick, ink)};
    Layer block{"title-block", "title block", {}, {}, {}};
    for (const TitleCell& cell : title_cells(lower, size.x, options, scale)) {
        const dvec2 upper = cell.lower + cell.size;
        const std::string id = block.id + "-" + cell.name;
        // Each cell has the line on its left, and the first of a row that below the row.
        if (cell.lower.x > lower.x)
            block.paths.push_back(ruled(id + "-left", {cell.lower, {cell.lower.x, upper.y}}, false, thin, ink));
        else if (cell.lower.y > lower.y)
            block.paths.push_back(ruled(id + "-below", {cell.lower, {to.x, cell.lower.y}}, false, thin, ink));
        if (options.plotter) continue;
        const auto write = [&](const std::string& name, const std::string& text, double letters, double base) {
            Caption caption = fitted(text, letters, cell.size.x - 2.0 * free_beside);
            caption.id = name;
            caption.color = ink;
            caption.place = {cell.lower.x + free_beside, base};
            block.captions.push_back(std::move(caption));
        };
        write(id + "-label", cell.label, least_letters, upper.y - above - least_letters);
        if (!cell.text.empty()) write(id, cell.text, cell.letters, cell.lower.y + below);
    }
    return {frame, block};
}

}  // namespace fovea::vector
