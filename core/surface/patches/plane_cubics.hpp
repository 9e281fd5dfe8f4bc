// Cubic functions over a plane through a cell, fitted to what its vertices and sides say: its height, and
// both coordinates of the surface.
#pragma once

#include "core/base/vec3.hpp"

#include <array>
#include <cstddef>

namespace wakesurf::core {

/// Three functions of a place in the plane at once: height, s, t.
using PlaneValues = Vec3;

/// Polynomials of third degree.
class PlaneCubics {
  public:
    static constexpr std::size_t terms = 10;
    using Terms = std::array<double, terms>;

    PlaneValues value(double x, double y) const;

    /// Returns the derivatives by x and by y.
    std::array<PlaneValues, 2> slope(double x, double y) const;

    std::array<PlaneValues, terms> factor{};
};

/// Fits by least squares, with as little as needed where the conditions leave something open.
class PlaneCubicFit {
  public:
    void add_value(double x, double y, const PlaneValues& value);
    void add_slope(double x, double y, const PlaneValues& by_x, const PlaneValues& by_y);

    PlaneCubics solve() const;

  private:
    void add(const PlaneCubics::Terms& row, const PlaneValues& value);

    std::array<PlaneCubics::Terms, PlaneCubics::terms> matrix_{};
    std::array<PlaneValues, PlaneCubics::terms> right_{};
};

} // namespace wakesurf::core
