// Velocity fields with closed forms: truth for tests, and flows to explore without data. Each is continued a
// little beyond its domain and into its obstacle, as the integrator asks. The tornado is that of Crawfis and
// Max, Texture Splats for 3D Scalar and Vector Field Visualization, 1993. The walls of their obstacles as
// triangles, for display.
#pragma once

#include "core/base/box.hpp"
#include "core/base/vec3.hpp"
#include "core/dataset/wall_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace wakesurf::core {

/// Returns a sphere around the origin. Points lie on the sphere, but for those outside `box`, which are put
/// on its border; it is closed, so that a body which the border cuts is capped there. Returns nothing for a
/// radius of 0.
WallGeometry sphere_wall(double radius, const Box& box);

/// Returns a cylinder around the z axis, all along the box; its points lie as those of sphere_wall().
WallGeometry cylinder_wall(double radius, const Box& box);

struct UniformFlow {
    static constexpr bool divergence_free = true;
    static constexpr bool steady = true;
    double u, v, w;

    Vec3 velocity(const Vec3&, double) const { return {u, v, w}; }
};

struct OscillatingFlow {
    static constexpr bool divergence_free = true;
    double u, a, omega;

    Vec3 velocity(const Vec3&, double t) const { return {u, a * std::sin(omega * t), 0.0}; }
};

struct RotationFlow {
    static constexpr bool divergence_free = true;
    static constexpr bool steady = true;
    double omega, w;

    Vec3 velocity(const Vec3& p, double) const { return {-omega * p.y, omega * p.x, w}; }
};

struct ShearFlow {
    static constexpr bool divergence_free = true;
    static constexpr bool steady = true;
    double u, g;

    Vec3 velocity(const Vec3& p, double) const { return {u + g * p.z, 0.0, 0.0}; }
};

struct StrainFlow {
    static constexpr bool steady = true;
    double a, b, c;

    Vec3 velocity(const Vec3& p, double) const { return {a * p.x, b * p.y, c * p.z}; }
};

struct RotatingStrainFlow {
    static constexpr bool divergence_free = true;
    double s, omega, w;

    Vec3 velocity(const Vec3& p, double t) const {
        const double c2 = std::cos(2.0 * omega * t);
        const double s2 = std::sin(2.0 * omega * t);
        return {s * (c2 * p.x + s2 * p.y), s * (s2 * p.x - c2 * p.y), w};
    }
};

struct LambOseenFlow {
    static constexpr bool divergence_free = true;
    static constexpr bool steady = true;
    double gamma, rc, w;

    Vec3 velocity(const Vec3& p, double) const {
        const double q = (p.x * p.x + p.y * p.y) / (rc * rc);
        const double core = q < 1e-8 ? 1.0 - 0.5 * q : -std::expm1(-q) / q;
        const double angular = gamma / (2.0 * std::numbers::pi * rc * rc) * core;
        return {-angular * p.y, angular * p.x, w};
    }
};

struct SphereFlow {
    static constexpr bool divergence_free = true;
    static constexpr bool steady = true;
    double u, a;

    Vec3 velocity(const Vec3& p, double) const {
        const double r2 = std::max(glm::dot(p, p), 0.25 * a * a);
        const double ratio = a * a * a / (r2 * std::sqrt(r2));
        return Vec3(u * (1.0 + 0.5 * ratio), 0.0, 0.0) - p * (1.5 * u * ratio * p.x / r2);
    }

    bool solid(const Vec3& p) const { return glm::dot(p, p) < a * a; }

    WallGeometry wall(const Box& box) const { return sphere_wall(a, box); }
};

struct CylinderFlow {
    static constexpr bool divergence_free = true;
    static constexpr bool steady = true;
    double u, a, w;

    Vec3 velocity(const Vec3& p, double) const {
        const double r2 = std::max(p.x * p.x + p.y * p.y, 0.25 * a * a);
        const double k = u * a * a / (r2 * r2);
        return {u - k * (p.x * p.x - p.y * p.y), -2.0 * k * p.x * p.y, w};
    }

    bool solid(const Vec3& p) const { return p.x * p.x + p.y * p.y < a * a; }

    WallGeometry wall(const Box& box) const { return cylinder_wall(a, box); }
};

struct HillFlow {
    static constexpr bool divergence_free = true;
    static constexpr bool steady = true;
    double u, a;

    Vec3 velocity(const Vec3& p, double) const {
        const double rho2 = p.x * p.x + p.y * p.y;
        const double r2 = rho2 + p.z * p.z;
        if (r2 <= a * a) {
            const double k = 1.5 * u / (a * a);
            return {-k * p.x * p.z, -k * p.y * p.z,
                    -0.5 * k * (2.0 * a * a - 4.0 * rho2 - 2.0 * p.z * p.z)};
        }
        const double r = std::sqrt(r2);
        const double k = 1.5 * u * a * a * a / (r2 * r2 * r);
        return {-k * p.x * p.z, -k * p.y * p.z, u * (1.0 - a * a * a / (r2 * r)) + k * rho2};
    }
};

struct AbcFlow {
    static constexpr bool divergence_free = true;
    static constexpr bool steady = true;
    double a, b, c;

    Vec3 velocity(const Vec3& p, double) const {
        return {a * std::sin(p.z) + c * std::cos(p.y), b * std::sin(p.x) + a * std::cos(p.z),
                c * std::sin(p.y) + b * std::cos(p.x)};
    }
};

struct DoubleGyreFlow {
    static constexpr bool divergence_free = true;
    double amplitude, eps, period, w;

    Vec3 velocity(const Vec3& p, double t) const {
        constexpr double pi = std::numbers::pi;
        const double a = eps * std::sin(2.0 * pi * t / period);
        const double b = 1.0 - 2.0 * a;
        const double f = a * p.x * p.x + b * p.x;
        return {-pi * amplitude * std::sin(pi * f) * std::cos(pi * p.y),
                pi * amplitude * std::cos(pi * f) * std::sin(pi * p.y) * (2.0 * a * p.x + b), w};
    }
};

struct TornadoFlow {
    Vec3 velocity(const Vec3& p, double t) const {
        const double xc = 0.5 + 0.1 * std::sin(0.04 * t + 10.0 * p.z);
        const double yc = 0.5 + 0.1 * std::cos(0.03 * t + 3.0 * p.z);
        const double r = 0.1 + 0.4 * p.z * p.z + 0.1 * p.z * std::sin(8.0 * p.z);
        const double r2 = 0.2 + 0.1 * p.z;
        const double x = p.x - xc;
        const double y = p.y - yc;
        const double d = std::sqrt(x * x + y * y);
        const double q = std::abs(r - d);
        double scale = q > r2 ? 0.8 - q : 1.0;
        const double z0 = std::max(0.0, 0.1 * (0.1 - d * p.z));
        const double d0 = std::sqrt(d * d + z0 * z0);
        scale = (r + r2 - d0) * scale / (d0 + 1e-10) / (1.0 + p.z);
        return scale * Vec3(y + 0.1 * x, -x + 0.1 * y, z0);
    }
};

struct StagnationFlow {
    static constexpr bool divergence_free = true;
    static constexpr bool steady = true;
    double a;

    Vec3 velocity(const Vec3& p, double) const { return {a * p.x, a * p.y, -2.0 * a * p.z}; }
};

} // namespace wakesurf::core
