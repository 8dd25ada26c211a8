// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/draw/found_lines.h>

#include <fovea/draw/frame.h>

namespace fovea::draw {
namespace {

constexpr double share_until_filter = 0.75;  // of the work, as the steps up to filter() have it

template <typename Values>
std::size_t bytes_of(const Values& values) {
    return values.size() * sizeof(*values.data());
}

template <typename Structure, typename... Columns>
std::size_t bytes_of(const Structure& structure, const Columns&... groups) {
    std::size_t sum = 0;
    const auto add = [&](const auto& column) { sum += bytes_of(structure.*column.array); };
    (for_each_column(groups, add), ...);
    return sum;
}

}  // namespace

std::size_t FoundLines::bytes() const {
    const auto of_view = lines.marked ? lines.marked->lines : lines.seen ? lines.seen->of_view : nullptr;
    return bytes_of(*paths, Paths::path_columns, Paths::point_columns) +
           bytes_of(*clipped, ClippedPaths::piece_columns, ClippedPaths::point_columns) +
           bytes_of(*visible, Runs::columns) + bytes_of(*runs, Runs::columns) + bytes_of(samples) + bytes_of(focus) +
           bytes_of(distance) + bytes_of(shown) +
           (lines.shown ? bytes_of(lines.shown->places.samples) + bytes_of(lines.shown->places.parts) : 0) +
           (lines.seen ? bytes_of(lines.seen->stretches.values) + bytes_of(lines.seen->parts) +
                             bytes_of(lines.seen->seen) + bytes_of(lines.seen->beside) + bytes_of(lines.seen->shown)
                       : 0) +
           (of_view ? of_view->bytes() : 0) + (lines.marked ? lines.marked->bytes() : 0);
}

std::shared_ptr<const FoundLines> Frame::found_lines() {
    filter();
    if (found_) return found_;
    const Cancelling scope(job.cancel.get());
    FoundLines found{paths, clipped, visible, runs, samples, focus, distance, {}, {}, stages};
    if (thins()) {
        found.shown = left(0.0f);
        found.lines.shown = std::make_shared<ShownLines>(
            elision::shown_lines(*clipped, *paths, *job.scene, *runs, found.shown, job.view.width, job.view.height));
    }
    std::shared_ptr<const ViewLines> of_view;
    if (lasts() || hands_on()) of_view = lines_of_view();
    if (lasts()) {
        SeenLines seen = seen_lines(*clipped, *paths, *job.scene, with_halos(), of_view);
        if (thins()) seen.shown = values_at_places(*of_view, *clipped, found.shown);
        found.lines.seen = std::make_shared<SeenLines>(std::move(seen));
    }
    if (hands_on()) found.lines.marked = marked(of_view);
    found_ = std::make_shared<FoundLines>(std::move(found));
    return found_;
}

std::shared_ptr<const ViewLines> Frame::lines_of_view() const {
    return std::make_shared<ViewLines>(view_lines(*clipped, *paths, *job.scene, job.view));
}

std::shared_ptr<const MarkedLines> Frame::marked(std::shared_ptr<const ViewLines> of_view) const {
    return std::make_shared<MarkedLines>(
        marked_lines(std::move(of_view), *clipped, *paths, *job.scene, mark_lengths()));
}

void Frame::take_over(std::shared_ptr<const FoundLines> same) {
    const Cancelling scope(job.cancel.get());
    rays();
    found_ = std::move(same);
    paths = found_->paths;
    clipped = found_->clipped;
    visible = found_->visible;
    runs = found_->runs;
    samples = found_->samples;
    focus = found_->focus;
    distance = found_->distance;
    stages = found_->stages;
    share_ = share_until_filter;
    done_ = Step::filter;
}

}  // namespace fovea::draw
