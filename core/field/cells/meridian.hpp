// A flow that is the same all the way round an axis, known in a thin wedge round one half plane: a place is turned
// into that plane, what is found there is turned back. Sampling in the plane costs no accuracy in the flow's two
// dimensions, whatever the angle of the wedge.
#pragma once

#include "core/dataset/cell_mesh.hpp"

#include <cmath>
#include <optional>

namespace wakesurf::core {

/// Keeps the turn of the last place. Without an axis it changes nothing.
class Meridian {
  public:
    explicit Meridian(const std::optional<SymmetryAxis>& axis) : axis_(axis) {
        if (axis_)
            around_ = glm::cross(axis_->direction, axis_->radial);
    }

    explicit operator bool() const { return axis_.has_value(); }

    /// Turns a place into the half plane, and what follows by the same angle.
    Vec3 enter(const Vec3& p) {
        if (!axis_)
            return p;
        const Vec3 from = p - axis_->origin;
        const double along = glm::dot(from, axis_->direction);
        const double x = glm::dot(from, axis_->radial);
        const double y = glm::dot(from, around_);
        const double radius = std::hypot(x, y);
        cos_ = radius > 0.0 ? x / radius : 1.0;
        sin_ = radius > 0.0 ? y / radius : 0.0;
        return axis_->origin + along * axis_->direction + radius * axis_->radial;
    }

    /// Turns a vector back.
    Vec3 back(const Vec3& v) const { return turned(v, sin_); }

    /// Turns a vector as the place was.
    Vec3 into(const Vec3& v) const { return turned(v, -sin_); }

  private:
    Vec3 turned(const Vec3& v, double sine) const {
        if (!axis_)
            return v;
        const double x = glm::dot(v, axis_->radial);
        const double y = glm::dot(v, around_);
        return v + (cos_ * x - sine * y - x) * axis_->radial + (sine * x + cos_ * y - y) * around_;
    }

    std::optional<SymmetryAxis> axis_;
    Vec3 around_{0.0};
    double cos_ = 1.0;
    double sin_ = 0.0;
};

} // namespace wakesurf::core
