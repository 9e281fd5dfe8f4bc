// Carries how far a particle is from a surface that the flow moves and deforms, across it. What has slid
// along the surface is where the surface is, and stays there.
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

} // namespace wakesurf::core
