// A cell as a curved piece of the surface between four curves: the bilinearly blended patch of Coons,
// Surfaces for Computer-Aided Design of Space Forms, 1967. Where a cell is no parallelogram, or a mid node
// bends one of its sides, what blending leaves out is of second and third order. So what is blended is only
// how far the sides are from cubic functions over a plane through the cell, which is of fourth.
#pragma once

#include "core/base/vec3.hpp"
#include "core/surface/patches/side_curve.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

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

/// A side of a cell, in the direction in which its outline is run through.
struct PatchSide {
    SideCurve first;
    SideCurve second; ///< from the mid node on, where there is one
    bool mid = false;

    PatchPoint at(double part) const;
    PatchPoint slope(double part) const;
};

/// A point of a patch and how it changes with u and v.
template <class Value>
struct PatchJet {
    Value value, u, v;
};

class CellPatch {
  public:
    /// @param outline  of the cell's sides: no other cell has them. The curves are those of the cells beside
    ///                 it, whichever is asked
    CellPatch(const SideCurves& curves, const Cell& cell, const std::array<bool, 4>& outline);

    /// Returns the point at (u, v): u runs from corner 0 to corner 1, v from corner 0 to corner 3, both from
    /// 0 to 1.
    PatchJet<PatchPoint> at(double u, double v) const;

    const PatchSide& side(std::size_t k) const { return side_[k]; }

    /// Returns how many of its curves are flat for want of tangents.
    std::uint32_t flat_curves() const;

  private:
    /// A plane through the cell, with units of its own in x and y.
    struct Plane {
        Vec3 centre{0.0}, x{0.0}, y{0.0}, up{0.0};
        double per_x = 0.0, per_y = 0.0;

        double x_of(const Vec3& at) const { return per_x * glm::dot(at, x); }

        double y_of(const Vec3& at) const { return per_y * glm::dot(at, y); }
    };

    bool lay_plane();
    void fit(const SideCurves& curves, const Cell& cell);
    void fit_vertex(PlaneCubicFit& fit,
                    const SideCurves& curves,
                    const PatchPoint& at,
                    VertexId vertex,
                    VertexId towards) const;
    PatchJet<PlaneValues> lift(const PatchJet<PatchPoint>& base,
                               const std::array<PatchPoint, 4>& corner,
                               double u,
                               double v) const;

    std::array<PatchSide, 4> side_;
    bool lifted_ = false;
    Plane plane_;
    PlaneCubics cubics_;
};

} // namespace wakesurf::core
