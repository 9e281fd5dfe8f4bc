// How far a particle may be from where it should be on a surface that the flow moves and deforms. Across the
// surface it is the stated error: what has slid along the surface is where the surface is. In any direction
// it decides when a vertex is traced again.
#pragma once

#include "core/base/vec3.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

/// The tangents of a surface at a particle: how its place changes with the surface's two coordinates.
struct SurfaceTangents {
    Vec3 s;                 ///< dx/ds
    Vec3 t;                 ///< dx/dt
    double expansion = 0.0; ///< of the fluid there since the particle's release, as of Carried

    /// Returns how much of a vector points across the surface; all of it where the tangents do not say.
    double across(const Vec3& v) const {
        const Vec3 normal = glm::cross(s, t);
        const double length = glm::length(normal);
        return length > 1e-4 * glm::length(s) * glm::length(t)
                   ? std::abs(glm::dot(v, normal)) / length
                   : glm::length(v);
    }

    /// Returns how many times as large a volume has become since release. No fluid becomes 1e17 times as thin
    /// or as dense: where data say so, errors must not become 0 or overflow a float.
    double growth() const { return std::exp(std::clamp(expansion, -40.0, 40.0)); }

    /// Returns the volume that a unit had at release, per length across the surface now.
    double volume() const { return area() / growth(); }

    /// Returns the area of a unit of either coordinate, kept away from zero: where the tangents are parallel,
    /// what lies between them is not known.
    double area() const {
        const Vec3 normal = glm::cross(s, t);
        const double square = glm::dot(normal, normal), sides = glm::dot(s, s) * glm::dot(t, t);
        // This shows that they are far from parallel without their lengths, which are two roots.
        return square > 1.001e-8 * sides
                   ? std::sqrt(square)
                   : std::max(std::sqrt(square), 1e-4 * glm::length(s) * glm::length(t));
    }
};

/// Errors that have come together since a particle was released, each as the volume between the surface and
/// where the particle was put, as large as it was at release: for a unit of the surface's coordinates that is
/// a length across times an area, and volumes grow as the fluid does. Errors add up as if all were on one
/// side.
class CarriedError {
  public:
    /// Length across the surface that it has where the tangents are these.
    double across(const SurfaceTangents& at) const { return across(at.volume()); }

    /// @param volume  of the tangents there
    double across(double volume) const { return volume_ == 0.0f ? 0.0 : double(volume_) / volume; }

    /// Adds an error that arose where the tangents are these. A particle that had no tangents, since nothing
    /// moved where it was released, has no errors.
    void add(const SurfaceTangents& at, double across) {
        volume_ += static_cast<float>(across * at.volume());
    }

    /// Returns the error half-way between two particles.
    static CarriedError between(const CarriedError& p, const CarriedError& q) {
        CarriedError mid;
        mid.volume_ = 0.5f * (p.volume_ + q.volume_);
        return mid;
    }

    bool operator==(const CarriedError&) const = default;

  private:
    float volume_ = 0.0f;
};

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
