// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/line/streamlines.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include <fovea/base/cancel.h>
#include <fovea/base/elementary.h>
#include <fovea/base/hash.h>
#include <fovea/base/parallel.h>
#include <fovea/base/steps.h>
#include <fovea/field/bend_directions.h>
#include <fovea/mesh/triangle_sides.h>

namespace fovea::line {
namespace {

/// In shares of the distance between curves: where a curve begins, others are at least so far away; where they come
/// nearer, it ends; shorter ones are not drawn; places at which distances are looked at are at most so far apart.
constexpr double beginning = 0.85, ending = 0.55, least_streamline = 2.0, step = 0.25;
/// Parts of one curve that are farther apart along it, in the same unit, must not come near each other, either.
constexpr double own = 3.0;
/// Squares, as wide as curves are apart, on a surface at most.
constexpr double most_squares = 4e5;
/// Where none begins beside others, it is tried so many times on a square.
constexpr double trials = 8.0;
constexpr int most_in_triangle = 4096;  // steps across one triangle
/// Cosine of the angle between normals up to which places are on the same side of a sheet.
constexpr double same_side = 0.2;
/// How near curves come to the corners of triangles, as a share of a side.
constexpr double from_corner = 1e-4;

/// A place on the surface.
struct Place {
    Index triangle = none;
    dvec3 weight{1.0 / 3.0};
};

struct Chord {
    Index triangle;
    StreamChord across;
};

/// A place along a curve, in a grid. `along`: from where the curve began to grow, negative backwards.
struct Sample {
    dvec3 at, normal;
    double along;
    Index curve, next;
};

/// Samples by cells as wide as curves are apart, in a table with open addressing: of the cells that are asked for, most
/// are empty.
class Grid {
   public:
    explicit Grid(double width) : width_(width) {}

    void add(Sample sample) {
        if (2 * used_ >= cells_.size()) enlarge();
        const std::uint64_t key = key_of(cell_of(sample.at));
        Cell& cell = cells_[slot_of(cells_, key)];
        used_ += cell.first == none;
        sample.next = cell.first;
        cell = {key, Index(samples_.size())};
        samples_.push_back(sample);
    }

    /// Whether is_near(sample) for any sample nearer than `distance` on the same side of a sheet.
    template <typename IsNear>
    bool any(const dvec3& at, const dvec3& normal, double distance, const IsNear& is_near) const {
        const auto any_in = [&](const glm::i64vec3& cell) {
            for (Index s = cells_[slot_of(cells_, key_of(cell))].first; s != none; s = samples_[s].next) {
                const Sample& sample = samples_[s];
                const dvec3 way = sample.at - at;
                if (glm::dot(way, way) < distance * distance && glm::dot(normal, sample.normal) > same_side &&
                    is_near(sample))
                    return true;
            }
            return false;
        };
        const double reach = distance * (1.0 + 1e-6);  // more than what coordinates are rounded by
        const glm::i64vec3 own = cell_of(at), low = cell_of(at - reach), high = cell_of(at + reach);
        if (any_in(own)) return true;
        glm::i64vec3 cell;
        for (cell.z = low.z; cell.z <= high.z; ++cell.z)
            for (cell.y = low.y; cell.y <= high.y; ++cell.y)
                for (cell.x = low.x; cell.x <= high.x; ++cell.x)
                    if (cell != own && any_in(cell)) return true;
        return false;
    }

   private:
    struct Cell {
        std::uint64_t key = 0;
        Index first = none;  ///< of its samples; none: there is no such cell
    };

    glm::i64vec3 cell_of(const dvec3& p) const {
        constexpr double farthest = 0x1p52;  // what is flung away farther is in one cell
        return glm::i64vec3(glm::clamp(glm::floor(p / width_), -farthest, farthest));
    }
    static std::uint64_t key_of(const glm::i64vec3& c) { return hash_numbers(c.x, c.y, c.z); }

    /// Where in a table the cell of a key is, or would be put.
    static std::size_t slot_of(In<Cell> cells, std::uint64_t key) {
        std::size_t slot = key & (cells.size() - 1);
        while (cells[slot].first != none && cells[slot].key != key) slot = (slot + 1) & (cells.size() - 1);
        return slot;
    }

    void enlarge() {
        std::vector<Cell> larger(2 * cells_.size());
        for (const Cell& cell : cells_)
            if (cell.first != none) larger[slot_of(larger, cell.key)] = cell;
        cells_.swap(larger);
    }

    double width_;
    std::vector<Cell> cells_ = std::vector<Cell>(1024);  // a power of two, half of them empty
    std::size_t used_ = 0;
    std::vector<Sample> samples_;
};

/// Where curves grow: the rest shape, if the surface has one.
struct Ground {
    In<vec3> positions;
    const Array<Triangle>& triangles;
    const TriangleSides& sides;
    const Lists<Index>& at_sides;
    const field::BendDirections& directions;
    double area = 0.0;  ///< of its finite triangles, as the bounds
    dvec3 low{HUGE_VAL}, high{-HUGE_VAL};

    /// The surface's cache keeps what is borrowed of it.
    explicit Ground(const Surface& surface)
        : positions(surface.rest().empty() ? In<vec3>(surface.positions) : surface.rest()),
          triangles(surface.triangles),
          sides(*triangle_sides(surface)),
          at_sides(*triangles_at_sides(surface)),
          directions(*field::bend_directions(surface)) {
        Cancelling::poll();
        for (Index t = 0; t < triangles.size(); ++t) {
            const double own = area_of(t);
            if (!std::isfinite(own)) continue;
            area += own;
            for (int k = 0; k < 3; ++k) {
                low = glm::min(low, dvec3(positions[triangles[t][k]]));
                high = glm::max(high, dvec3(positions[triangles[t][k]]));
            }
        }
    }

    double area_of(Index triangle) const {
        return 0.5 * glm::length(mesh::area_vector(positions, triangles[triangle]));
    }
};

class Grower {
   public:
    Grower(const Ground& ground, double angle)
        : ground_(ground), turned_(cosine(angle), sine(angle)), crossed_by_(ground.triangles.size(), none) {}

    Streamlines grow(int finest) {
        if (ground_.area > 0.0) {
            const int coarsest = std::ilogb(glm::distance(ground_.low, ground_.high));
            finest = std::max(finest, std::ilogb(std::sqrt(ground_.area / most_squares)));
            for (int power = coarsest; power >= finest; --power) grow_level(power);
        }
        return lists_of<StreamChord>(ground_.triangles.size(), [&](const auto& give) {
            for (const Chord& chord : chords_) give(chord.triangle, chord.across);
        });
    }

   private:
    using Side = std::int8_t;

    dvec3 at(Index v) const { return dvec3(ground_.positions[v]); }
    dvec3 area_vector(const Triangle& t) const { return mesh::area_vector(ground_.positions, t); }
    dvec3 normal_of(Index triangle) const { return unit_or_zero(area_vector(ground_.triangles[triangle])); }
    dvec3 at(const Place& place) const {
        const Triangle& t = ground_.triangles[place.triangle];
        return place.weight.x * at(t.x) + place.weight.y * at(t.y) + place.weight.z * at(t.z);
    }

    /// The direction of curves at a place, in its triangle's plane, towards `along`; zero where there is none.
    dvec3 direction(const Place& place, const dvec3& along) const {
        const auto& corners = ground_.directions.corner[place.triangle];
        const auto& w = place.weight;
        const dvec3 nearest(corners[w.x >= w.y && w.x >= w.z ? 0 : w.y >= w.z ? 1 : 2]), n = normal_of(place.triangle);
        dvec3 sum(0.0);
        for (int k = 0; k < 3; ++k)
            sum += (glm::dot(dvec3(corners[k]), nearest) < 0.0 ? -w[k] : w[k]) * dvec3(corners[k]);
        for (const dvec3& found : {sum, nearest}) {
            const dvec3 flat = found - n * glm::dot(found, n);
            const double length = glm::length(flat);
            if (!(length > 1e-6)) continue;
            const dvec3 turned = (turned_.x * flat + turned_.y * glm::cross(n, flat)) / length;
            return glm::dot(turned, along) < 0.0 ? -turned : turned;
        }
        return dvec3(0.0);
    }

    /// Goes straight to the border of a triangle: the side, or -1 where that leads nowhere.
    Side to_border(Place& place, const dvec3& direction) const {
        const Triangle& t = ground_.triangles[place.triangle];
        const dvec3 twice = area_vector(t);
        const double area2 = glm::dot(twice, twice);
        double least = HUGE_VAL;
        int corner = -1;
        dvec3 slope;
        for (int k = 0; k < 3; ++k) {
            slope[k] = glm::dot(glm::cross(twice, at(t[(k + 2) % 3]) - at(t[(k + 1) % 3])), direction) / area2;
            if (!(slope[k] < 0.0)) continue;
            const double way = place.weight[k] / -slope[k];
            if (way < least) least = way, corner = k;
        }
        if (corner < 0 || !(least > 0.0) || !std::isfinite(least)) return -1;
        dvec3 weight = place.weight + least * slope;
        const int a = (corner + 1) % 3, b = (corner + 2) % 3;
        const double share = std::clamp(weight[b] / (weight[a] + weight[b]), from_corner, 1.0 - from_corner);
        if (!std::isfinite(share)) return -1;
        // Rounded as it is kept, from the lower vertex on, so that both triangles at the side have the same place.
        const bool ascends = t[a] < t[b];
        const float kept = float(ascends ? share : 1.0 - share);
        weight[corner] = 0.0;
        weight[ascends ? b : a] = kept;
        weight[ascends ? a : b] = 1.0 - double(kept);
        place.weight = weight;
        return Side(a);
    }

    /// The same place in the triangle beyond a side, unless the surface ends or is folded there.
    bool cross(Place& place, Side side) const {
        const auto here = ground_.at_sides[ground_.sides.of_triangle[place.triangle][side]];
        if (here.size() != 2) return false;
        const Index other = here[0] == place.triangle ? here[1] : here[0];
        const Triangle &from = ground_.triangles[place.triangle], &to = ground_.triangles[other];
        if (other == place.triangle || !field::goes_on(ground_.positions, from, to)) return false;
        dvec3 weight(0.0);
        for (const int k : {int(side), (side + 1) % 3}) weight[corner_of(to, from[k])] = place.weight[k];
        place = {other, weight};
        return true;
    }

    static dvec3 flattened(const dvec3& along, const dvec3& n) { return unit_or_zero(along - n * glm::dot(along, n)); }

    /// Walks straight over the surface; false where that leads over a border or a fold.
    bool walk(Place& place, dvec3 along, double distance) const {
        for (int count = 0; count < 100'000; ++count) {
            const dvec3 from = at(place);
            Place to = place;
            const Side side = to_border(to, along);
            if (side < 0) return false;
            const double way = glm::distance(from, at(to));
            if (way >= distance) {
                place.weight = glm::mix(place.weight, to.weight, distance / way);
                return true;
            }
            distance -= way;
            place = to;
            if (!cross(place, side)) return false;
            along = flattened(along, normal_of(place.triangle));
        }
        return false;
    }

    struct Growing {
        Place seed;
        dvec3 direction;
        Index curve;
        double length = 0.0;
        bool closed = false;
        std::vector<Chord> chords{};
    };

    /// Whether a curve may be at a place, so far along it.
    bool is_free(const dvec3& here, const dvec3& normal, double along, Index curve) const {
        return !grid_->any(here, normal, ending * apart_, [&](const Sample& sample) {
            if (sample.curve != curve) return !dropped_[sample.curve];
            return std::abs(sample.along - along) > own * apart_ && std::abs(sample.along) > apart_;
        });
    }

    /// The share of a straight way across a triangle that a curve can go, beginning so far from its seed; with samples.
    double free_share(Growing& curve, Index triangle, const dvec3& from, const dvec3& to, double begins, double sign) {
        Cancelling::poll();
        const dvec3 n = normal_of(triangle), seed = at(curve.seed);
        const double way = glm::distance(from, to);
        const int steps = steps_of(way / (step * apart_), most_in_triangle);
        double free = 0.0;
        for (int i = 1; i <= steps; ++i) {
            const double share = double(i) / steps, length = begins + share * way;
            const dvec3 here = glm::mix(from, to, share);
            // It ends where it has come around, beside its beginning.
            if (length > own * apart_ && glm::distance(here, seed) < apart_) {
                const double beyond = sign * glm::dot(here - seed, curve.direction);
                const double before = sign * glm::dot(glm::mix(from, to, free) - seed, curve.direction);
                curve.closed = beyond >= 0.0 && before < 0.0;
                if (curve.closed) return glm::mix(free, share, before / (before - beyond));
            }
            if (!is_free(here, n, sign * length, curve.curve)) return free;
            grid_->add({here, n, sign * length, curve.curve, none});
            free = share;
        }
        return 1.0;
    }

    /// Grows on beyond the side of a triangle that a curve has crossed, to the way `along`.
    void grow(Growing& curve, Place place, Side side, dvec3 along, double length, double sign) {
        while (cross(place, side)) {
            Index& crossed = crossed_by_[place.triangle];
            if (crossed == curve.curve) return;
            crossed = curve.curve;
            // By the direction in the middle of the way that the one at its beginning leads.
            Place to = place;
            const dvec3 first = direction(place, flattened(along, normal_of(place.triangle)));
            if (first == dvec3(0.0) || to_border(to, first) < 0) return;
            along = direction({place.triangle, 0.5 * (place.weight + to.weight)}, first);
            to = place;
            side = to_border(to, along);
            if (side < 0) return;
            const dvec3 from = at(place), end = at(to);
            const double free = free_share(curve, place.triangle, from, end, length, sign);
            // It has come in by the side that is opposite the corner without weight.
            const int opposite = place.weight.x == 0.0 ? 0 : place.weight.y == 0.0 ? 1 : 2;
            if (free > 0.0)
                curve.chords.push_back({place.triangle,
                                        {curve.curve,
                                         power_,
                                         {vec3(place.weight), vec3(glm::mix(place.weight, to.weight, free))},
                                         {Side((opposite + 1) % 3), free == 1.0 ? side : Side(-1)}}});
            length += free * glm::distance(from, end);
            curve.length += free * glm::distance(from, end);
            if (free < 1.0 || curve.closed) return;
            place = to;
        }
    }

    /// Grows a curve both ways from a place, if there is room for it.
    void grow_from(const Place& seed) {
        const dvec3 n = normal_of(seed.triangle), here = at(seed);
        if (n == dvec3(0.0) || !std::isfinite(here.x + here.y + here.z)) return;
        if (grid_->any(here, n, beginning * apart_, [](const Sample&) { return true; })) return;
        const dvec3 along = direction(seed, dvec3(0.0));
        if (along == dvec3(0.0)) return;
        Growing curve{seed, along, Index(dropped_.size())};
        dropped_.push_back(0);
        grid_->add({here, n, 0.0, curve.curve, none});
        crossed_by_[seed.triangle] = curve.curve;
        Place ends[2];
        Side sides[2];
        double lengths[2];
        for (const int k : {0, 1}) {
            const double sign = k == 0 ? -1.0 : 1.0;
            ends[k] = seed;
            sides[k] = to_border(ends[k], sign * along);
            const double way = glm::distance(here, at(ends[k]));
            const double free = sides[k] < 0 ? 0.0 : free_share(curve, seed.triangle, here, at(ends[k]), 0.0, sign);
            if (free < 1.0) sides[k] = -1, ends[k].weight = glm::mix(seed.weight, ends[k].weight, free);
            lengths[k] = free * way;
            curve.length += lengths[k];
        }
        curve.chords.push_back(
            {seed.triangle, {curve.curve, power_, {vec3(ends[0].weight), vec3(ends[1].weight)}, {sides[0], sides[1]}}});
        if (sides[1] >= 0) grow(curve, ends[1], sides[1], along, lengths[1], 1.0);
        if (sides[0] >= 0 && !curve.closed) grow(curve, ends[0], sides[0], -along, lengths[0], -1.0);
        if (curve.length < least_streamline * apart_) {
            dropped_[curve.curve] = 1;
            return;
        }
        chords_.insert(chords_.end(), curve.chords.begin(), curve.chords.end());
    }

    void grow_level(int power) {
        power_ = power;
        apart_ = std::ldexp(1.0, power);
        Grid grid(apart_);
        grid_ = &grid;
        // Of dropped curves no samples are left: they may grow at another level.
        for (const Chord& chord : chords_) {
            Cancelling::poll();
            const auto [from, to] = ends_of(chord);
            const int steps = steps_of(glm::distance(from, to) / (step * apart_), most_in_triangle);
            const dvec3 n = normal_of(chord.triangle);
            for (int i = 0; i <= steps; ++i)
                grid.add({glm::mix(from, to, double(i) / steps), n, 0.0, chord.across.curve, none});
        }
        std::size_t done = 0;
        carried_ = 0.0;
        for (; done < chords_.size(); ++done) grow_beside(chords_[done]);
        double passed = 0.0;  // area
        for (Index t = 0; t < ground_.triangles.size(); ++t) {
            const double area = ground_.area_of(t);
            if (std::isfinite(area)) passed += area;
            if (passed < apart_ * apart_ / trials) continue;
            passed = 0.0;
            grow_from({t, dvec3(1.0 / 3.0)});
            for (; done < chords_.size(); ++done) grow_beside(chords_[done]);
        }
        grid_ = nullptr;
    }

    std::pair<dvec3, dvec3> ends_of(const Chord& chord) const {
        const auto& [from, to] = chord.across.weight;
        return {at(Place{chord.triangle, dvec3(from)}), at(Place{chord.triangle, dvec3(to)})};
    }

    /// Grows curves on both sides of a part of one, at each of its places that are as far apart as curves are.
    void grow_beside(const Chord chord) {
        Cancelling::poll();
        const auto [from, to] = ends_of(chord);
        const dvec3 n = normal_of(chord.triangle), across = glm::cross(n, to - from);
        const double length = glm::length(across);
        if (!(length > 0.0)) return;
        carried_ += length;
        for (; carried_ >= apart_; carried_ -= apart_)
            for (const double sign : {1.0, -1.0}) {
                const double share = std::clamp((length - carried_ + apart_) / length, 0.0, 1.0);
                Place place{chord.triangle,
                            glm::mix(dvec3(chord.across.weight[0]), dvec3(chord.across.weight[1]), share)};
                if (walk(place, sign / length * across, apart_)) grow_from(place);
            }
    }

    const Ground& ground_;
    const dvec2 turned_;
    Array<Index> crossed_by_;
    int power_ = 0;
    double apart_ = 1.0, carried_ = 0.0;
    Grid* grid_ = nullptr;
    std::vector<Chord> chords_;
    std::vector<std::uint8_t> dropped_;  // per curve
};

}  // namespace

std::vector<std::shared_ptr<const Streamlines>> streamlines(const Surface& surface, In<double> angles, int power) {
    Cache& cache = surface.cache();
    const auto key = [&](double angle) { return hash_numbers(std::bit_cast<std::uint64_t>(angle), power); };
    return cache.together([&] {
        std::vector<std::shared_ptr<const Streamlines>> found;
        std::vector<std::size_t> missing;
        for (const double angle : angles) {
            found.push_back(cache.find<Streamlines>(key(angle)));
            if (!found.back()) missing.push_back(found.size() - 1);
        }
        if (missing.empty()) return found;
        const Ground ground(surface);
        std::vector<Streamlines> grown(missing.size());
        parallel_for(missing.size(), 1,
                     [&](std::size_t i) { grown[i] = Grower(ground, angles[missing[i]]).grow(power); });
        for (std::size_t i = 0; i < missing.size(); ++i)
            found[missing[i]] = cache.get<Streamlines>(key(angles[missing[i]]), [&] { return std::move(grown[i]); });
        return found;
    });
}

}  // namespace fovea::line
