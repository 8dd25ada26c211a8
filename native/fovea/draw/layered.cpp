// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/draw/layered.h>

#include <algorithm>

#include <fovea/color/displayed.h>
#include <fovea/color/png.h>
#include <fovea/color/section_fill.h>

namespace fovea::draw {
namespace {

constexpr int thumbnail_side = 256;  // as the format asks for

/// Means of the pixels that each pixel of a smaller picture covers.
Array<vec4> reduced(In<vec4> pixels, const glm::ivec2& size, const glm::ivec2& to) {
    Array<vec4> small(std::size_t(to.x) * to.y);
    parallel_for(small.size(), [&](std::size_t i) {
        const glm::ivec2 at(int(i % to.x), int(i / to.x));
        const glm::ivec2 low = at * size / to, high = glm::max((at + 1) * size / to, low + 1);
        vec4 sum(0.0f);
        for (int y = low.y; y < high.y; ++y)
            for (int x = low.x; x < high.x; ++x) sum += pixels[std::size_t(y) * size.x + x];
        small[i] = sum / float((high.x - low.x) * (high.y - low.y));
    });
    return small;
}

class Layers {
   public:
    explicit Layers(Frame& frame) : frame_(frame), view_(frame.job.view), style_(frame.job.style) {}

    LayeredPicture make() {
        frame_.picture();
        const bool with_alpha = style_.paper.transparent;
        const In<vec4> picture = frame_.passes.combined;
        found_.merged = png(color::displayed_bytes(picture, with_alpha), size());
        const int longest = std::max({size().x, size().y, thumbnail_side});
        const glm::ivec2 small = glm::max(size() * thumbnail_side / longest, 1);
        found_.thumbnail = png(color::displayed_bytes(reduced(picture, size(), small), with_alpha), small);
        add_ground();
        for (Index set = 0; set < style_.line_sets.size(); ++set) add_lines(set);
        return std::move(found_);
    }

   private:
    glm::ivec2 size() const { return {view_.width, view_.height}; }

    static std::string png(const Array<std::uint8_t>& bytes, const glm::ivec2& size) {
        return color::png_bytes(bytes, size.x, size.y, int(bytes.size() / (std::size_t(size.x) * size.y)));
    }

    void add(const std::string& group, const std::string& name, const Array<std::uint8_t>& bytes) {
        found_.layers.push_back({group, name, png(bytes, size())});
    }

    void add_ground() {
        const bool colored = !frame_.passes.color.empty(), has_paper = !style_.paper.transparent;
        const Array<vec4> paper = has_paper ? frame_.bare_paper() : Array<vec4>();
        if (has_paper) add("", "paper", color::displayed_bytes(paper, true));
        if (colored) {
            const Array<vec4> ground = frame_.ground();
            add("", "colors",
                has_paper ? color::bytes_between(paper, ground, frame_.passes.color)
                          : color::displayed_bytes(ground, true));
        }
        if (!style_.section.filled) return;
        Array<vec4> inside(std::size_t(view_.width) * view_.height, vec4(0.0f));
        fill_section(section_sides(*frame_.job.scene, view_), view_, vec3(style_.section.color), inside);
        add("", "section", color::bytes_over(inside, style_.paper.color));
    }

    /// Those of hidden parts of lines below those of visible ones.
    void add_lines(Index set) {
        const style::LineSet& lines = style_.line_sets[set];
        const std::string group = std::to_string(set + 1) + " " + lines.name;
        for (const bool visible : {false, true}) {
            Array<std::uint8_t> pens(frame_.pens.pens.size(), 0);
            for (const PenRange& range : frame_.pens.ranges)
                if (range.line_set == set && (range.to == 0) == visible) pens[range.pen] = 1;
            const Array<vec4> drawn = frame_.lines_of(pens);
            if (std::ranges::all_of(drawn, [](const vec4& pixel) { return pixel.a <= 0.0f; })) continue;
            add(group, visible ? "visible" : "hidden", color::bytes_over(drawn, style_.paper.color));
        }
    }

    Frame& frame_;
    const View& view_;
    const style::Style& style_;
    LayeredPicture found_;
};

}  // namespace

LayeredPicture layered(Frame& frame) { return Layers(frame).make(); }

}  // namespace fovea::draw
