// Particles that are carried together: the vertices of streak and time surfaces, which all move in every
// step. Filled by Flow::advance.
#pragma once

#include "core/base/vec3.hpp"
#include "core/integrate/curve.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace wakesurf::core {

/// A particle of a moving surface: its position and two tangents of the surface there, w' = (grad v) w. The
/// tangents give cubic interpolation between particles, normals and deformation, and with how much the fluid
/// expands the growth of errors. Source: Schneider, Wiebel,
/// Scheuermann, Smooth Stream Surfaces of Fourth Order Precision, EuroVis 2009 (one tangent, stream
/// surfaces).
struct Carried {
    Vec3 position{0.0};
    Vec3 along_s{0.0};
    Vec3 along_t{0.0};
    double expansion =
        0.0; ///< logarithm of the volume that a unit of it at release has: div v over time
};

inline Carried operator+(const Carried& a, const Carried& b) {
    return {a.position + b.position, a.along_s + b.along_s, a.along_t + b.along_t,
            a.expansion + b.expansion};
}

inline Carried operator-(const Carried& a, const Carried& b) {
    return {a.position - b.position, a.along_s - b.along_s, a.along_t - b.along_t,
            a.expansion - b.expansion};
}

inline Carried operator*(double k, const Carried& a) {
    return {k * a.position, k * a.along_s, k * a.along_t, k * a.expansion};
}

inline constexpr std::uint32_t no_cell = 0xffffffffu;

/// Structure of arrays, one entry a particle; the two tangents may be left empty together.
struct Particles {
    std::span<Vec3> position; ///< where each is, and is left
    std::span<Vec3> along_s;  ///< transported tangent dx/ds
    std::span<Vec3> along_t;  ///< transported tangent dx/dt, t the surface's other parameter
    std::span<double> time;   ///< simulation time a particle has reached
    std::span<CurveEnd> end;  ///< Running, or why it stays where it is

    /// May be left empty together. Where a particle arrives, its velocity there, as Flow::sample_at says it,
    /// is often to be had for little: advancing then writes it and sets `sampled` to 1. Of the others it
    /// touches neither.
    std::span<Vec3f> velocity{};
    std::span<std::uint8_t> sampled{}; ///< 1: `velocity` was written

    /// For meshes of cells: the cell to search first for a particle, or no_cell, and afterwards the cell it
    /// has come to; may be empty. It changes how fast a particle is found, not where it goes, unless cells
    /// overlap.
    std::span<std::uint32_t> cell{};

    /// Where they carry tangents: Carried::expansion, which grows on the way; may be empty.
    std::span<float> expansion{};

    /// Returns the number of particles.
    std::size_t count() const { return position.size(); }

    /// Returns whether they carry tangents.
    bool tangents() const { return !along_s.empty(); }
};

/// Options of carrying particles.
struct AdvanceOptions {
    /// The type of the methods.
    using Method = IntegrationMethod;
    /// The method of the steps. Through stored data that are linear, Dopri5 takes one Taylor series a cell of
    /// the same tolerance, as in TraceOptions.
    Method method = Method::Rk4;
    double step = 0.0;               ///< Rk4: longest time step; > 0
    double tolerance = 1e-6;         ///< Dopri5: error allowed per unit length
    double longest_step = 0.0;       ///< Dopri5: arc length a step may cover; > 0
    double stagnation_speed = 0.0;   ///< a slower particle may end: at_rest.hpp says which
    std::size_t most_steps = 50'000; ///< Dopri5: attempts after which a particle ends with Budget
    bool smooth = false; ///< stored data: tricubic in space and cubic in time instead of linear
};

} // namespace wakesurf::core
