// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/bas_relief.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <fovea/base/check.h>
#include <fovea/base/elementary.h>

namespace fovea::study {
namespace {

/// Logarithm of the depth, and the slope: what is searched.
using Point = dvec3;

constexpr std::array<double, 3> start_depths{1.0, 0.35, 3.0};
constexpr double first_step = 0.3, least_step = 1e-7;
constexpr int most_moves = 400, restarts = 3;

BasRelief relief_at(const Point& point) {
    return {std::clamp(exponential(point.x), least_depth, most_depth), dvec2(point.y, point.z)};
}

/// A search for the point with the least cost, by a simplex of four (Nelder and Mead 1965).
template <typename Cost>
class Simplex {
   public:
    Simplex(const Cost& cost, const Point& start) : cost_(cost) {
        corners_[0] = {start, cost_(start)};
        for (int i = 0; i < 3; ++i) {
            Point moved = start;
            moved[i] += first_step;
            corners_[std::size_t(i) + 1] = {moved, cost_(moved)};
        }
    }

    /// (cost, point) of the least found.
    std::pair<double, Point> least() {
        for (int move = 0; move < most_moves; ++move) {
            std::ranges::stable_sort(corners_, {}, &Corner::cost);
            double size = 0.0;
            for (const Corner& corner : corners_) size = std::max(size, glm::distance(corner.at, corners_[0].at));
            if (size < least_step) break;
            step();
        }
        const Corner& best = *std::ranges::min_element(corners_, {}, &Corner::cost);
        return {best.cost, best.at};
    }

   private:
    struct Corner {
        Point at;
        double cost;
    };

    void step() {
        Corner& worst = corners_[3];
        const Point middle = (corners_[0].at + corners_[1].at + corners_[2].at) / 3.0;
        const auto along = [&](double share) {
            const Point at = middle + share * (worst.at - middle);
            return Corner{at, cost_(at)};
        };
        const Corner turned = along(-1.0);
        if (turned.cost < corners_[0].cost) {
            const Corner further = along(-2.0);
            worst = further.cost < turned.cost ? further : turned;
        } else if (turned.cost < corners_[2].cost) {
            worst = turned;
        } else {
            const Corner nearer = along(turned.cost < worst.cost ? -0.5 : 0.5);
            if (nearer.cost < std::min(turned.cost, worst.cost)) {
                worst = nearer;
            } else {
                for (std::size_t i = 1; i < 4; ++i) {
                    const Point at = 0.5 * (corners_[0].at + corners_[i].at);
                    corners_[i] = {at, cost_(at)};
                }
            }
        }
    }

    const Cost& cost_;
    std::array<Corner, 4> corners_;
};

}  // namespace

double angle_between(const dvec3& a, const dvec3& b) { return arc_cosine(std::clamp(glm::dot(a, b), -1.0, 1.0)); }

BasRelief fitted_relief(In<dvec3> normals, In<dvec3> onto) {
    check(normals.size() == onto.size() && normals.size() >= 3, "a relief: three pairs of normals are needed, or more");
    const auto cost = [&](const Point& point) {
        const BasRelief relief = relief_at(point);
        double sum = 0.0;
        for (std::size_t i = 0; i < normals.size(); ++i) sum += angle_between(relief.of_normal(normals[i]), onto[i]);
        // Beyond the bounds the cost rises, so that the search comes back.
        const double bound = logarithm(most_depth);
        return sum / double(normals.size()) + std::max(0.0, std::abs(point.x) - bound);
    };
    std::pair<double, Point> best{INFINITY, Point(0.0)};
    for (const double depth : start_depths) {
        std::pair<double, Point> found{INFINITY, Point(logarithm(depth), 0.0, 0.0)};
        for (int i = 0; i < restarts; ++i) found = Simplex(cost, found.second).least();
        if (found.first < best.first) best = found;
    }
    return relief_at(best.second);
}

}  // namespace fovea::study
