#include "core/surface/family/plane_curve.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace wakesurf::core {

namespace {

/// Returns any direction across another one.
Vec3 across(const Vec3& direction) {
    const Vec3 size = glm::abs(direction);
    const Vec3 axis = size.x <= size.y && size.x <= size.z ? Vec3(1, 0, 0)
                      : size.y <= size.z                   ? Vec3(0, 1, 0)
                                                           : Vec3(0, 0, 1);
    return glm::normalize(glm::cross(direction, axis));
}

double cross_of(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

Result<std::optional<Vec3>> plane_of_points(const std::vector<Vec3>& points) {
    const Vec3 first = points.front();
    const auto farthest = [&](const auto& measure) {
        Vec3 found(0.0);
        for (const Vec3& p : points)
            if (const Vec3 each = measure(p - first); glm::length(each) > glm::length(found))
                found = each;
        return found;
    };
    const Vec3 along = farthest([](const Vec3& d) { return d; });
    const Vec3 normal = farthest([&](const Vec3& d) { return glm::cross(along, d); });
    const double extent = glm::length(along);
    if (glm::length(normal) <= 1e-9 * extent * extent)
        return std::optional<Vec3>();
    const Vec3 unit = glm::normalize(normal);
    double off = 0.0;
    for (const Vec3& p : points)
        off = std::max(off, std::abs(glm::dot(p - first, unit)));
    if (off <= 1e-6 * extent)
        return std::optional(unit);
    std::ostringstream text;
    text << "the curve is not planar: a point is " << off << " away from the plane of the others";
    return fail(Error::Code::InvalidArgument, text.str(),
                "a distance on both sides of a curve is measured in its plane: move the points "
                "into one");
}

} // namespace

Result<std::optional<Vec3>> PlaneCurve::plane_of(const Rake& rake) {
    if (rake.kind == Rake::Kind::Points)
        return fail(Error::Code::InvalidArgument, "points are no curve",
                    "choose a line, a polyline or a circle");
    if (rake.kind == Rake::Kind::Circle)
        return std::optional(glm::normalize(
            glm::cross(rake.points[1] - rake.points[0], rake.points[2] - rake.points[0])));
    return plane_of_points(rake.points);
}

PlaneCurve::PlaneCurve(const Rake& rake, const Vec3& normal)
    : origin_(rake.points.front()), u_(across(normal)), v_(glm::cross(normal, u_)) {
    if (rake.kind == Rake::Kind::Circle) {
        radius_ = glm::length(rake.points[1] - rake.points[0]);
        return;
    }
    for (const Vec3& p : rake.points)
        points_.push_back(flat(p));
    closed_ = points_.size() > 3 && glm::length(points_.front() - points_.back()) <=
                                        1e-9 * glm::length(points_[1] - points_[0]);
    if (closed_)
        points_.back() = points_.front();
}

glm::dvec2 PlaneCurve::flat(const Vec3& point) const {
    return {glm::dot(point - origin_, u_), glm::dot(point - origin_, v_)};
}

double PlaneCurve::distance(const Vec3& point) const {
    const Vec2 at = flat(point);
    return radius_ > 0.0 ? glm::length(at) - radius_ : from_pieces(at);
}

double PlaneCurve::from_pieces(const Vec2& point) const {
    const std::size_t pieces = points_.size() - 1;
    const auto direction = [&](std::size_t i) {
        return glm::normalize(points_[i + 1] - points_[i]);
    };
    double nearest = std::numeric_limits<double>::infinity();
    double side = 1.0;
    for (std::size_t i = 0; i < pieces; ++i) {
        const Vec2 ahead = direction(i);
        const Vec2 from = point - points_[i];
        const double length = glm::length(points_[i + 1] - points_[i]);
        const double along = glm::dot(from, ahead);
        const bool before = along < 0.0 && (i > 0 || closed_);
        const bool behind = along > length && (i + 1 < pieces || closed_);
        const Vec2 away = before ? from : behind ? point - points_[i + 1] : from - along * ahead;
        const double distance = glm::length(away);
        if (!(distance < nearest))
            continue;
        nearest = distance;
        // At a corner the two pieces' sides may disagree; the line between them decides.
        Vec2 middle = ahead;
        if (before)
            middle += direction(i > 0 ? i - 1 : pieces - 1);
        if (behind)
            middle += direction(i + 1 < pieces ? i + 1 : 0);
        side = cross_of(middle, away) < 0.0 ? -1.0 : 1.0;
    }
    return side * nearest;
}

} // namespace wakesurf::core
