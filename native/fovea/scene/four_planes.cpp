// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/scene/four_planes.h>

namespace fovea::scene {
namespace {

/// Products below this have lost digits: they are as good as 0. Where bounds of errors are above the other, products
/// may have overflowed.
constexpr float smallest = 1e-35f, greatest = 1e30f;

Vectors operator-(const Vectors& a, const Vectors& b) { return {{a.x[0] - b.x[0], a.x[1] - b.x[1], a.x[2] - b.x[2]}}; }

Vectors vectors(const Four (&x)[3]) { return {{x[0], x[1], x[2]}}; }

Four dot(const Vectors& a, const Vectors& b) { return a.x[0] * b.x[0] + a.x[1] * b.x[1] + a.x[2] * b.x[2]; }

Vectors cross(const Vectors& a, const Vectors& b) {
    return {{a.x[1] * b.x[2] - a.x[2] * b.x[1], a.x[2] * b.x[0] - a.x[0] * b.x[2], a.x[0] * b.x[1] - a.x[1] * b.x[0]}};
}

/// Largest magnitude of a coordinate.
Four largest(const Vectors& v) { return greater(size_of(v.x[0]), greater(size_of(v.x[1]), size_of(v.x[2]))); }

/// Six times the volumes of the tetrahedra that a triangle forms with the corners of another one.
struct Volumes {
    Four of[3];
    Four lowest = four(infinity), highest = four(-infinity), farthest = four(0.0f);
    Four room;  ///< bound of their errors

    void add(int corner, const Vectors& normal, const Vectors& offset, FourInts common) {
        of[corner] = dot(normal, offset);
        lowest = lesser(lowest, common ? four(infinity) : of[corner]);
        highest = greater(highest, common ? four(-infinity) : of[corner]);
        farthest = greater(farthest, largest(offset));
    }
    /// `longest`, `area`: of the triangle. With u = 2^-24, its normal has an error of 16 u area, a volume one of 64 u
    /// area farthest; moving all four points by `error` changes it by less than 32 times the product of that and two
    /// lengths.
    void bound(Four longest, Four area, float error) {
        room = 0x1p-18f * area * farthest + 32.0f * error * longest * (longest + farthest) + smallest;
    }
    FourInts on_one_side() const { return (room < greatest) & ((lowest > room) | (highest < -room)); }
};

/// What a triangle cuts from the plane of another one, measured along a direction.
struct CutSpan {
    Four low = four(infinity), high = four(-infinity);

    /// `volumes`: of its corners over the other triangle. `at`: places of the corners along the direction. `common`:
    /// which corners the other triangle has, too; their sides are left out.
    CutSpan(const Volumes& volumes, const Four (&at)[3], const FourInts (&common)[3]) {
        const Four& room = volumes.room;
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3;
            const Four from = volumes.of[i], to = volumes.of[j], along = at[j] - at[i];
            const FourInts left_out =
                ((from > room) & (to > room)) | ((from < -room) & (to < -room)) | common[i] | common[j];
            // Both volumes are uncertain by `room`: the share is by less than 4 room / fall, where that is below 1.
            const Four fall = from - to, size = greater(size_of(fall), four(smallest));
            const Four share = lesser(size_of(from) / size, four(1.0f));
            const Four uncertain = lesser(4.0f * room / size, four(2.0f)) * size_of(along);
            const Four middle = at[i] + share * along;
            low = lesser(low, left_out ? four(infinity) : middle - uncertain);
            high = greater(high, left_out ? four(-infinity) : middle + uncertain);
        }
    }
};

}  // namespace

FourPlanes::FourPlanes(const FourTriangles& triangles, float error, bool within)
    : triangles_(triangles), error_(error), within_(within) {
    const Vectors corner = vectors(triangles.corner[0]);
    const Vectors first = vectors(triangles.corner[1]) - corner, second = vectors(triangles.corner[2]) - corner;
    normal_ = cross(first, second);
    longest_ = greater(largest(first), largest(second));
    area_ = largest(first) * largest(second);
}

unsigned FourPlanes::may_cross(unsigned lanes, const FourTriangles& others, int lane) const {
    Vectors other[3];  // the same triangle four times
    FourInts of_ours[3] = {}, of_others[3] = {};
    for (int k = 0; k < 3; ++k)
        for (int axis = 0; axis < 3; ++axis) other[k].x[axis] = four(others.corner[k][axis][lane]);
    FourInts common{};  // minus the number of common corners
    if (within_)
        for (int k = 0; k < 3; ++k)
            for (int i = 0; i < 3; ++i) {
                const Four(&at)[3] = triangles_.corner[i];
                const FourInts same = (at[0] == other[k].x[0]) & (at[1] == other[k].x[1]) & (at[2] == other[k].x[2]);
                of_ours[i] |= same;
                of_others[k] |= same;
                common += same;
            }
    Volumes over_ours, over_other;
    const Vectors corner = vectors(triangles_.corner[0]);
    for (int k = 0; k < 3; ++k) over_ours.add(k, normal_, other[k] - corner, of_others[k]);
    over_ours.bound(longest_, area_, error_);
    lanes &= ~bits((common < -1) | over_ours.on_one_side());
    if (lanes == 0) return 0;

    const Vectors first = other[1] - other[0], second = other[2] - other[0], normal = cross(first, second);
    Vectors offset[3];
    for (int k = 0; k < 3; ++k) {
        offset[k] = vectors(triangles_.corner[k]) - other[0];
        over_other.add(k, normal, offset[k], of_ours[k]);
    }
    const Four longest = greater(largest(first), largest(second));
    over_other.bound(longest, largest(first) * largest(second), error_);
    lanes &= ~bits(over_other.on_one_side());
    if (lanes == 0) return 0;

    const Vectors line = cross(normal_, normal);
    const Four at_other[3] = {four(0.0f), dot(line, first), dot(line, second)};
    const Four at_ours[3] = {dot(line, offset[0]), dot(line, offset[1]), dot(line, offset[2])};
    const CutSpan cut_of_other(over_ours, at_other, of_others), cut_of_ours(over_other, at_ours, of_ours);
    const Four sum = size_of(line.x[0]) + size_of(line.x[1]) + size_of(line.x[2]);
    const Four room = sum * (0x1p-19f * greater(longest, over_other.farthest) + 4.0f * error_) + smallest;
    const FourInts finite = (room < greatest) & (over_ours.room < greatest) & (over_other.room < greatest);
    FourInts apart = (cut_of_other.high + room < cut_of_ours.low) | (cut_of_ours.high + room < cut_of_other.low);
    if (within_) {
        // From a common corner both cuts go as far as the side opposite to it: apart, if into opposite directions.
        const Four at = of_others[0] ? at_other[0] : of_others[1] ? at_other[1] : at_other[2];
        const FourInts opposite = ((cut_of_other.high + room < at) & (cut_of_ours.low - room > at)) |
                                  ((cut_of_ours.high + room < at) & (cut_of_other.low - room > at));
        apart = common == 0 ? apart : opposite;
    }
    return lanes & ~bits(finite & apart);
}

}  // namespace fovea::scene
