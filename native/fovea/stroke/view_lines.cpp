// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/stroke/view_lines.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include <fovea/base/hash.h>
#include <fovea/base/parallel.h>

namespace fovea::stroke {
namespace {

constexpr double step = 4.0;        // reference pixels between places
constexpr double cell = 8.0;        // of the grid, reference pixels
constexpr std::size_t crowd = 512;  // places in a cell
constexpr double shortest = 0.01;   // px: shorter pieces have no marks
constexpr std::uint64_t far = 509;  // periods by which lines may begin elsewhere
constexpr std::size_t around = 6;   // places to each side over which the side that the surface faces is averaged
constexpr double clear = 0.3;       // sine of its angle to the line

/// Twice the normal of what lies on both sides of a place, object space; outward.
dvec3 normal_at(const Surface& surface, Index place) {
    if (!surface.is_edge(place))
        return dvec3(vec3(surface.facet_plane[surface.triangle_facet[surface.triangle_at(place)]]));
    dvec3 sum(0.0);
    for (const mesh::EdgeSide side : surface.sides(place)) sum += dvec3(vec3(surface.facet_plane[side.facet()]));
    return sum;
}

/// Shares of the corners of a triangle in the point of its plane nearest to `at`.
std::array<double, 3> shares_of(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& at) {
    const dvec3 ab = b - a, ac = c - a, normal = glm::cross(ab, ac);
    const double square = glm::dot(normal, normal);
    if (!(square > 0.0)) return {1.0, 0.0, 0.0};
    const double second = glm::dot(glm::cross(at - a, ac), normal) / square;
    const double third = glm::dot(glm::cross(ab, at - a), normal) / square;
    return {1.0 - second - third, second, third};
}

class Finder {
   public:
    Finder(const ClippedPaths& clipped, const Paths& paths, const Scene& scene, const View& view, In<double> period)
        : clipped_(clipped), paths_(paths), scene_(scene), view_(view), period_(period) {
        for (Index q = 0; q < clipped.pieces.count(); ++q)
            if (wanted(q)) number_.try_emplace(paths.placement[clipped.path[q]]);
        std::vector<std::pair<std::uint64_t, Index>> order;
        for (const auto& [placement, number] : number_) order.emplace_back(scene.placements[placement].id, placement);
        std::ranges::sort(order);
        for (const auto& [id, placement] : order) {
            number_[placement] = Index(out.placed.size());
            const Placement& of = scene.placements[placement];
            ViewLines::Placed placed{id, view.world_to_view * of.object_to_world, {}};
            if (!of.surface->rest().empty()) {
                const auto begin = of.surface->positions.begin();
                placed.positions.assign(begin, begin + of.surface->vertex_count());
            }
            out.placed.push_back(std::move(placed));
        }
    }

    ViewLines out;

    void find() {
        const Index count = clipped_.pieces.count();
        const double step_px = step * view_.reference_scale;
        out.view = view_;
        out.rows.offsets.assign(count, 0);
        out.period.assign(count, 0.0);
        out.closed.assign(clipped_.closed.begin(), clipped_.closed.end());
        for (Index q = 0; q < count; ++q)
            if (wanted(q)) {
                out.rows.offsets[q] = 1 + Index(std::max(1.0, std::ceil(length_of(q) / step_px)));
                out.period[q] = period_[paths_.line_set[clipped_.path[q]]];
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
               period_[paths_.line_set[path]] > 0.0 && clipped_.pieces.size(piece) > 1 && length_of(piece) > shortest &&
               std::isfinite(length_of(piece));
    }

    void find(Index piece) {
        const Index path = clipped_.path[piece], placement = paths_.placement[path];
        const Index placed = number_.at(placement), size = out.rows.size(piece);
        const std::span<ViewLines::Place> places(out.places.data() + out.rows.begin(piece), size);
        const dmat4 view_to_object = glm::inverse(out.placed[placed].object_to_view);
        const double first = clipped_.first_arc(piece), length = length_of(piece);
        for (Index k = 0; k < size; ++k) {
            ViewLines::Place& place = places[k];
            place.arc = k + 1 == size ? first + length : first + length * k / (size - 1);
            place.piece = piece;
            place.placed = placed;
            locate(place, view_to_object);
        }
        for (Index k = 0; k < size; ++k) {
            const dvec2 way = places[std::min(k + 1, size - 1)].px - places[k > 0 ? k - 1 : 0].px;
            const double length_px = glm::length(way);
            places[k].way = length_px > 0.0 ? way / length_px : dvec2(0.0);
        }
        const double period = out.period[piece];
        double own = double(paths_.id[path] % far) * period;
        const std::vector<double> ways = ways_of(places, placement);
        for (Index k = 0; k < size; ++k) {
            if (k > 0) own += ways[k] * (places[k].arc - places[k - 1].arc);
            places[k].own = own;
        }
        if (!out.closed[piece]) return;
        // One that runs around has at least one period; one that comes back as it went may have none.
        const double turn = own - places[0].own, least = std::abs(turn) > 0.5 * length ? 1.0 : 0.0;
        const double whole = std::copysign(std::max(least, std::round(std::abs(turn) / period)) * period, turn);
        const double missing = whole - turn;
        for (Index k = 0; k < size; ++k) places[k].own += missing * k / (size - 1);
    }

    void locate(ViewLines::Place& place, const dmat4& view_to_object) const {
        const Index i = clipped_.segment_at(place.piece, place.arc), source = clipped_.source[i];
        const double t = clipped_.share_at(i, place.arc);
        const dvec3 a(clipped_.position_view[i]), b(clipped_.position_view[i + 1]);
        const dvec3 position = glm::mix(a, b, clipped_.orthographic ? t : share_in_space(t, -a.z, -b.z));
        place.px = glm::mix(dvec2(clipped_.px[i]), dvec2(clipped_.px[i + 1]), t);
        place.depth = -position.z;
        place.position = dvec3(view_to_object * dvec4(position, 1.0));
        place.kinds = paths_.kinds[source];
        const Array<vec3>& at = out.placed[place.placed].positions;
        if (at.empty()) return;
        const Surface& surface = *scene_.placements[paths_.placement[clipped_.path[place.piece]]].surface;
        const Index on = paths_.place[source];
        if (surface.is_edge(on)) {
            const mesh::Edge edge = surface.edges[on];
            const dvec3 from(at[edge.x]), way = dvec3(at[edge.y]) - from;
            const double square = glm::dot(way, way);
            const double share =
                square > 0.0 ? std::clamp(glm::dot(place.position - from, way) / square, 0.0, 1.0) : 0.0;
            place.vertices = {edge.x, edge.y, edge.y};
            place.shares = {1.0 - share, share, 0.0};
        } else {
            const mesh::Triangle& of = surface.triangles[surface.triangle_at(on)];
            place.vertices = {of.x, of.y, of.z};
            place.shares = shares_of(dvec3(at[of.x]), dvec3(at[of.y]), dvec3(at[of.z]), place.position);
        }
    }

    /// Per place: 1 where the surface faces the right of the line, else -1: however a path is chained, that is the
    /// same. Where it faces along the line it is as before.
    std::vector<double> ways_of(In<ViewLines::Place> places, Index placement) const {
        const Surface& surface = *scene_.placements[placement].surface;
        const dmat4& object_to_view = out.placed[places[0].placed].object_to_view;
        const dmat3 normals = glm::transpose(glm::inverse(dmat3(object_to_view)));
        std::vector<double> sums{0.0};  // of how much it does
        for (const ViewLines::Place& place : places) {
            const Index i = clipped_.segment_at(place.piece, place.arc);
            const dvec2 normal(unit_or_zero(normals * normal_at(surface, paths_.place[clipped_.source[i]])));
            const double side = cross(normal, place.way);
            sums.push_back(sums.back() + (std::isfinite(side) ? side : 0.0));
        }
        const std::size_t size = places.size();
        double way = sums.back() < 0.0 ? -1.0 : 1.0;
        std::vector<double> ways(size);
        for (std::size_t k = 0; k < size; ++k) {
            const std::size_t begin = std::max(k, around) - around, end = std::min(k + around + 1, size);
            if (-way * (sums[end] - sums[begin]) > clear * double(end - begin)) way = -way;
            ways[k] = way;
        }
        return ways;
    }

    const ClippedPaths& clipped_;
    const Paths& paths_;
    const Scene& scene_;
    const View& view_;
    In<double> period_;
    std::map<Index, Index> number_;  // of placements with such lines, among those placed
};

}  // namespace

std::shared_ptr<const Array<double>> HandedOn::find(std::uint64_t number) const {
    const std::scoped_lock lock(mutex_);
    const auto at = kept_.find(number);
    return at == kept_.end() ? nullptr : at->second;
}

void HandedOn::keep(std::uint64_t number, std::shared_ptr<const Array<double>> values) {
    const std::scoped_lock lock(mutex_);
    if (kept_.size() == most) kept_.clear();
    kept_.emplace(number, std::move(values));
}

std::size_t ViewLines::bytes() const {
    std::size_t sum = places.size() * (sizeof(Place) + 4 * sizeof(double)) + 13 * period.size();
    for (const Placed& each : placed) sum += sizeof(Placed) + each.positions.size() * sizeof(vec3);
    return sum;
}

std::uint64_t ViewLines::content() const {
    if (places.empty()) return 0;
    std::uint64_t hash = hash_of(In<Index>(rows.offsets));
    const Array<double> own = own_marks(*this);
    const Array<dvec2> px = parallel_map<dvec2>(places.size(), [&](std::size_t j) { return places[j].px; });
    hash = hash_of(In<dvec2>(px), hash_of(In<double>(own), hash));
    return std::max<std::uint64_t>(hash, 1);
}

Array<double> own_marks(const ViewLines& lines) {
    return parallel_map<double>(lines.places.size(), [&](std::size_t j) { return lines.places[j].own; });
}

ViewLines view_lines(const ClippedPaths& clipped, const Paths& paths, const Scene& scene, const View& view,
                     In<double> period) {
    Finder finder(clipped, paths, scene, view, period);
    finder.find();
    static std::atomic<std::uint64_t> made{0};
    finder.out.number = ++made;
    return std::move(finder.out);
}

}  // namespace fovea::stroke
