// A curve in a plane, and how far points of the plane are from it: what the scalar of a family is where it is
// given by a rake.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/rake.hpp"

#include <glm/vec2.hpp>

#include <optional>
#include <vector>

namespace wakesurf::core {

/// A line, polyline or circle. A line's and a polyline's ends continue straight, so that the curve parts its
/// plane in two.
class PlaneCurve {
  public:
    /// The normal of the plane that a rake lies in, of length 1; nothing where it is straight and lies in
    /// many. Error: InvalidArgument for points that lie in no plane, and for a rake that is no curve.
    /// REQUIRES: check_rake(rake).
    static Result<std::optional<Vec3>> plane_of(const Rake& rake);

    /// Makes the curve of a rake. REQUIRES: the rake lies in a plane with this normal, of length 1.
    PlaneCurve(const Rake& rake, const Vec3& normal);

    /// Returns the distance of the point, as seen along the normal; positive outside a circle, and on one
    /// side of other curves.
    double distance(const Vec3& point) const;

  private:
    using Vec2 = glm::dvec2;

    Vec2 flat(const Vec3& point) const;
    double from_pieces(const Vec2& point) const;

    Vec3 origin_, u_, v_;
    std::vector<Vec2> points_; ///< of a polyline
    bool closed_ = false;      ///< its end is its beginning
    double radius_ = 0.0;      ///< of a circle round the origin; 0: a polyline
};

} // namespace wakesurf::core
