// Bounds how far a particle may be from where it should be, along the surface as across it, on a surface that
// the flow carries and deforms: in coordinates in which it does not change. It decides when a vertex is
// traced again; what is stated is the part across the surface.
#pragma once

#include "core/surface/carried_error.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

/// Errors of all directions that have come together since a particle was released. Along the surface they are
/// an ellipse in the surface's coordinates, which takes part in what happens to the surface without being
/// touched: an error keeps its coordinates. Through the surface they are lengths times areas, as of
/// CarriedError. Errors add up as if all had one direction.
class CarriedDistance {
  public:
    /// Length that it has where the tangents are these.
    double length(const SurfaceTangents& at) const {
        const double det = determinant(metric(at));
        return det > 0.0 ? std::hypot(along(at), double(through_) / std::sqrt(det) * at.growth())
                         : along(at);
    }

    /// Adds an error of any direction that arose where the tangents are these. A particle that had no
    /// tangents, since nothing moved where it was released, has no errors.
    void add(const SurfaceTangents& at, double radius) {
        const Metric g = metric(at);
        const double det = determinant(g);
        if (!(radius > 0.0 && det > 0.0))
            return;
        // The sum is the ellipse round all sums of one of either ellipse, of the least trace.
        const double before = along(at);
        const double added = std::sqrt(2.0) * radius;
        const double own = before > 0.0 ? 1.0 + added / before : 1.0;
        const double others = (1.0 + before / added) * radius * radius / det;
        set(own * square(a_) + others * g.tt, own * a_ * b_ - others * g.st,
            own * (square(b_) + square(c_)) + others * g.ss);
        through_ += static_cast<float>(radius * std::sqrt(det) / at.growth());
    }

    /// Returns the distance half-way between two particles.
    static CarriedDistance between(const CarriedDistance& p, const CarriedDistance& q) {
        CarriedDistance mid;
        mid.set(0.5 * (square(p.a_) + square(q.a_)),
                0.5 * (double(p.a_) * p.b_ + double(q.a_) * q.b_),
                0.5 * (square(p.b_) + square(p.c_) + square(q.b_) + square(q.c_)));
        mid.through_ = 0.5f * (p.through_ + q.through_);
        return mid;
    }

    bool operator==(const CarriedDistance&) const = default;

  private:
    struct Metric {
        double ss, st, tt;
    };

    static Metric metric(const SurfaceTangents& at) {
        return {glm::dot(at.s, at.s), glm::dot(at.s, at.t), glm::dot(at.t, at.t)};
    }

    /// Returns the determinant, kept away from zero: where the tangents are parallel, what lies between them
    /// is not known.
    static double determinant(const Metric& g) {
        return std::max(g.ss * g.tt - g.st * g.st, 1e-8 * g.ss * g.tt);
    }

    static double square(double x) { return x * x; }

    double along(const SurfaceTangents& at) const {
        const Vec3 first = double(a_) * at.s + double(b_) * at.t;
        const Vec3 second = double(c_) * at.t;
        return std::sqrt(glm::dot(first, first) + glm::dot(second, second));
    }

    void set(double ss, double st, double tt) {
        const double a = std::sqrt(ss);
        const double b = a > 0.0 ? st / a : 0.0;
        a_ = static_cast<float>(a);
        b_ = static_cast<float>(b);
        c_ = static_cast<float>(std::sqrt(std::max(tt - b * b, 0.0)));
    }

    /// Hold a root of the ellipse's matrix, lower triangular: along a sheared surface the terms of the matrix
    /// itself would cancel.
    float a_ = 0.0f, b_ = 0.0f, c_ = 0.0f;
    float through_ = 0.0f;
};

} // namespace wakesurf::core
