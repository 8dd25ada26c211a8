// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/gauges.h>

#include <cmath>
#include <optional>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>
#include <fovea/field/corner_normals.h>

namespace fovea::study {
namespace {

/// Of neighbors a pixel apart, on one surface: cosine of the angle between their normals, sine of the angle between the
/// line through them and the surface, and the step in depth in widths of a pixel.
constexpr double least_turn = 0.87, most_lift = 0.5, most_step = 12.0;

struct Seen {
    Index placement;
    dvec3 place, normal;  ///< in view space; the normal is on the viewer's side
};

class Looker {
   public:
    explicit Looker(const Tracer& tracer) : tracer_(tracer), clip_to_view_(glm::inverse(tracer.view().view_to_clip)) {
        for (const Placement& placement : tracer.scene().placements) {
            normals_.push_back(corner_normals(*placement.surface));
            normal_to_view_.push_back(
                glm::transpose(glm::inverse(dmat3(tracer.view().world_to_view * placement.object_to_world))));
        }
    }

    std::optional<Seen> at(const dvec2& px) const {
        const auto hit = tracer_.seen(px);
        if (!hit || !(tracer_.scene().placements[hit->placement].usage & usage_draw)) return {};
        const Surface& surface = *tracer_.scene().placements[hit->placement].surface;
        const Triangle& triangle = surface.triangles[hit->triangle];
        const auto corner = [&](int k) { return dvec3(normals_[hit->placement]->at(triangle, hit->triangle, k)); };
        const dvec3 mixed = (1.0 - double(hit->u) - double(hit->v)) * corner(0) + double(hit->u) * corner(1) +
                            double(hit->v) * corner(2);
        const dvec3 normal = normal_to_view_[hit->placement] * mixed;
        const double length = glm::length(normal);
        if (!(length > 0.0)) return {};
        const View& view = tracer_.view();
        const dvec3 place = from_pixels(view, clip_to_view_, px, hit->t);
        const dvec3 to_eye = view.orthographic ? dvec3(0, 0, 1) : -place;
        return Seen{hit->placement, place, (glm::dot(normal, to_eye) < 0.0 ? -1.0 : 1.0) / length * normal};
    }

    /// Width of a pixel at a distance along the view.
    double pixel(const dvec2& px, double distance) const {
        const auto point = [&](double x) {
            return from_pixels(tracer_.view(), clip_to_view_, {px.x + x, px.y}, distance);
        };
        return glm::distance(point(0.5), point(-0.5));
    }

   private:
    const Tracer& tracer_;
    dmat4 clip_to_view_;
    std::vector<std::shared_ptr<const CornerNormals>> normals_;
    std::vector<dmat3> normal_to_view_;
};

/// Whether two neighbors lie on one surface. `pixel`: its width there.
bool continues(const Seen& a, const Seen& b, double pixel) {
    const dvec3 step = b.place - a.place;
    if (a.placement != b.placement || !(glm::dot(a.normal, b.normal) >= least_turn)) return false;
    const double lift = std::abs(glm::dot(step, glm::normalize(a.normal + b.normal)));
    return lift <= most_lift * glm::length(step) && std::abs(step.z) <= most_step * pixel;
}

/// Whether all within a radius is one surface; neighbors are a pixel apart, along rows and columns.
bool is_one(const Looker& looker, const dvec2& middle, double radius) {
    const int reach = int(std::ceil(radius)), side = 2 * reach + 1;
    const Seen outside{none, dvec3(0.0), dvec3(0.0)};
    std::vector<Seen> seen(std::size_t(side) * std::size_t(side), outside);
    const auto at = [&](int x, int y) -> Seen& {
        return seen[std::size_t(y + reach) * std::size_t(side) + std::size_t(x + reach)];
    };
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x) {
            if (std::hypot(x, y) > radius) continue;
            const auto here = looker.at(middle + dvec2(x, y));
            if (!here) return false;
            at(x, y) = *here;
        }
    const double pixel = looker.pixel(middle, -at(0, 0).place.z);
    const auto breaks = [&](const Seen& a, const Seen& b) {
        return a.placement != none && b.placement != none && !continues(a, b, pixel);
    };
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x) {
            if (x < reach && breaks(at(x, y), at(x + 1, y))) return false;
            if (y < reach && breaks(at(x, y), at(x, y + 1))) return false;
        }
    return true;
}

}  // namespace

dvec3 gauge_normal(const View& view, const dvec3& place, const dvec3& normal) {
    // Derivative of pixels by places: columns x, y, z.
    const dmat4 rows = glm::transpose(view.view_to_clip);
    const dvec4 clip = view.view_to_clip * dvec4(place, 1.0);
    const auto derivative = [&](int row, int side) {
        return 0.5 * side * (dvec3(rows[row]) - clip[row] / clip.w * dvec3(rows[3])) / clip.w;
    };
    const dvec3 dx = derivative(0, view.width), dy = derivative(1, view.height);
    // Two radii of the disc, at right angles, and the ellipse's matrix: sums of squares of what they project to.
    const dvec3 other = std::abs(normal.z) < 0.9 ? dvec3(0, 0, 1) : dvec3(1, 0, 0);
    const dvec3 first = glm::normalize(glm::cross(normal, other)), second = glm::cross(normal, first);
    const dvec2 a(glm::dot(dx, first), glm::dot(dy, first)), b(glm::dot(dx, second), glm::dot(dy, second));
    const double xx = a.x * a.x + b.x * b.x, xy = a.x * a.y + b.x * b.y, yy = a.y * a.y + b.y * b.y;
    const double mean = 0.5 * (xx + yy), apart = std::hypot(0.5 * (xx - yy), xy), major = mean + apart;
    const double area = a.x * b.y - a.y * b.x;  // of the ellipse, over pi: the product of its axes
    const double narrow = std::min(1.0, std::abs(area) / major);
    // The direction of the minor axis is the eigenvector of the least eigenvalue.
    dvec2 minor = yy >= xx ? dvec2(0.5 * (yy - xx) + apart, -xy) : dvec2(-xy, 0.5 * (xx - yy) + apart);
    const double length = glm::length(minor);
    if (!(length > 0.0)) return {0, 0, 1};
    minor /= length;
    const dvec3 out = (glm::dot(normal, view.orthographic ? dvec3(0, 0, 1) : -place) < 0.0 ? -1.0 : 1.0) * normal;
    if (minor.x * glm::dot(dx, out) + minor.y * glm::dot(dy, out) < 0.0) minor = -minor;
    return {std::sqrt(1.0 - narrow * narrow) * minor, narrow};
}

GaugePlaces gauge_places(const Tracer& tracer, In<dvec2> px, double radius) {
    check(radius >= 0.0 && radius <= 100.0, "gauges: a radius is 0 to 100 pixels");
    tracer.check_current();
    const Looker looker(tracer);
    GaugePlaces found;
    found.placement.resize(px.size());
    found.normal.resize(px.size());
    parallel_for(px.size(), 1, [&](std::size_t i) {
        const bool one = is_one(looker, px[i], radius);
        const auto seen = one ? looker.at(px[i]) : std::nullopt;
        found.placement[i] = seen ? seen->placement : none;
        found.normal[i] = seen ? gauge_normal(tracer.view(), seen->place, seen->normal) : dvec3(0.0);
    });
    return found;
}

}  // namespace fovea::study
