// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/elision/view_lines.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fovea/base/parallel.h>
#include <fovea/project/piece_arcs.h>
#include <fovea/visibility/piece_samples.h>

namespace fovea::elision {
namespace {

constexpr double step = 4.0;        // reference pixels between places
constexpr double cell = 8.0;        // of the grid, reference pixels
constexpr std::size_t crowd = 512;  // places in a cell
constexpr double shortest = 0.01;   // px: shorter pieces have no places

class Finder {
   public:
    Finder(const ClippedPaths& clipped, const Paths& paths, const Scene& scene, const View& view)
        : clipped_(clipped), paths_(paths), scene_(scene), view_(view) {
        std::set<Index> placements;
        for (Index q = 0; q < clipped.pieces.count(); ++q)
            if (wanted(q)) placements.insert(paths.placement[clipped.path[q]]);
        out.pose = pose_of(scene, view, Array<Index>(placements.begin(), placements.end()));
        for (Index i = 0; i < out.pose.placed.size(); ++i) number_[out.pose.placed[i].placement] = i;
    }

    ViewLines out;

    void find() {
        const Index count = clipped_.pieces.count();
        const double step_px = step * view_.reference_scale;
        out.rows.offsets.assign(count, 0);
        out.path.assign(clipped_.path.begin(), clipped_.path.end());
        out.closed.assign(clipped_.closed.begin(), clipped_.closed.end());
        for (Index q = 0; q < count; ++q)
            if (wanted(q)) {
                const double least = clipped_.closed[q] ? 3.0 : 1.0;  // steps, so that a line has a direction
                out.rows.offsets[q] = 1 + Index(std::max(least, std::ceil(length_of(q) / step_px)));
            }
        counts_to_offsets(out.rows.offsets);
        out.places.resize(out.rows.offsets.back());
        parallel_for(count, 64, [&](std::size_t q) {
            if (out.rows.size(Index(q)) > 0) find(Index(q));
        });
        out.grid = std::make_unique<PointGrid>(cell * view_.reference_scale, crowd);
        for (std::size_t j = 0; j < out.places.size(); ++j) out.grid->add(out.places[j].px, j);
    }

   private:
    double length_of(Index piece) const { return clipped_.last_arc(piece) - clipped_.first_arc(piece); }

    bool wanted(Index piece) const {
        const Index path = clipped_.path[piece];
        const std::uint8_t of_view = paths_.of_view[path];
        return of_view && of_view != path::makes_tone && paths_.placement[path] != none &&
               clipped_.pieces.size(piece) > 1 && length_of(piece) > shortest && std::isfinite(length_of(piece));
    }

    void find(Index piece) {
        const Index placed = number_.at(paths_.placement[clipped_.path[piece]]), size = out.rows.size(piece);
        const std::span<ViewLines::Place> places(out.places.data() + out.rows.begin(piece), size);
        const dmat4 view_to_object = glm::inverse(out.pose.placed[placed].object_to_view);
        const project::PieceArcs arcs(clipped_, paths_, piece);
        const double first = clipped_.first_arc(piece), length = length_of(piece);
        for (Index k = 0; k < size; ++k) {
            ViewLines::Place& place = places[k];
            place.arc = k + 1 == size ? first + length : first + length * k / (size - 1);
            place.arc_space = arcs.in_space(place.arc);
            place.piece = piece;
            place.placed = placed;
            locate(place, view_to_object);
        }
        for (Index k = 0; k < size; ++k) {
            const dvec2 way = places[std::min(k + 1, size - 1)].px - places[k > 0 ? k - 1 : 0].px;
            const double length_px = glm::length(way);
            places[k].way = length_px > 0.0 ? way / length_px : dvec2(0.0);
        }
    }

    void locate(ViewLines::Place& place, const dmat4& view_to_object) const {
        const Index i = clipped_.segment_at(place.piece, place.arc), source = clipped_.source[i];
        const double t = clipped_.share_at(i, place.arc);
        const dvec3 position = clipped_.position_at(i, t);
        place.px = glm::mix(dvec2(clipped_.px[i]), dvec2(clipped_.px[i + 1]), t);
        place.depth = -position.z;
        const Index placement = paths_.placement[clipped_.path[place.piece]];
        place.point = surface_point(*scene_.placements[placement].surface, out.pose.placed[place.placed].at(),
                                    paths_.place[source], dvec3(view_to_object * dvec4(position, 1.0)));
        place.kinds = paths_.kinds[source];
    }

    const ClippedPaths& clipped_;
    const Paths& paths_;
    const Scene& scene_;
    const View& view_;
    std::map<Index, Index> number_;  // of placements with such lines, among those of the pose
};

}  // namespace

std::size_t ViewLines::bytes() const { return places.size() * sizeof(Place) + 9 * closed.size() + pose.bytes(); }

double ViewLines::number_at(Index piece, double arc) const {
    const double first = places[rows.begin(piece)].arc, last = places[rows.end(piece) - 1].arc;
    return std::clamp((arc - first) / (last - first), 0.0, 1.0) * (rows.size(piece) - 1);
}

ViewLines view_lines(const ClippedPaths& clipped, const Paths& paths, const Scene& scene, const View& view) {
    Finder finder(clipped, paths, scene, view);
    finder.find();
    return std::move(finder.out);
}

Array<float> values_at_places(const ViewLines& lines, const ClippedPaths& clipped, In<float> values) {
    Array<float> found(lines.places.size());
    parallel_for(lines.rows.count(), 64, [&](std::size_t q) {
        if (lines.rows.size(Index(q)) == 0) return;
        const PieceSamples samples(clipped, Index(q));
        for (Index j = lines.rows.begin(Index(q)); j < lines.rows.end(Index(q)); ++j)
            found[j] = samples.value(values, lines.places[j].arc, 1.0f);
    });
    return found;
}

void values_from_places(Array<float>& values, const ViewLines& lines, const ClippedPaths& clipped,
                        In<std::uint8_t> where, In<float> at_places) {
    parallel_for(lines.rows.count(), 64, [&](std::size_t q) {
        if (lines.rows.size(Index(q)) == 0) return;
        const In<float> of_piece = at_places.subspan(lines.rows.begin(Index(q)), lines.rows.size(Index(q)));
        const PieceSamples samples(clipped, Index(q));
        for (std::ptrdiff_t s = 0; s < samples.count(); ++s) {
            if (!where[samples.in_atlas(s)]) continue;
            const double number = lines.number_at(Index(q), samples.arc(s));
            const std::size_t before = std::min(std::size_t(number), of_piece.size() - 2);
            values[samples.in_atlas(s)] = glm::mix(of_piece[before], of_piece[before + 1], float(number - before));
        }
    });
}

}  // namespace fovea::elision
