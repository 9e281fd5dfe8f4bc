// Advances many particles through stored data by RK4, in batches of a kernel, in parallel. Each is a pure
// function of where it is: neither the batch it travels in nor the number of threads changes a bit, and
// neither does the kernel.
#pragma once

#include "core/field/cubic_sampler.hpp"
#include "core/field/grid_sampler.hpp"
#include "core/field/kernel/rk4_batch.hpp"
#include "core/field/rectilinear_axes.hpp"
#include "core/integrate/particles.hpp"

#include <span>
#include <stop_token>

namespace wakesurf::core {

/// Returns the kernel for this processor.
Rk4Kernel choose_rk4_kernel(Simd simd);

/// Advances like advance_particles with Method::Rk4, to float accuracy: velocity is computed in float, the
/// position kept in double. A step in which a particle ends is computed as there.
/// @param sign  direction of time, +1 or -1
/// Returns false if `stop` fired.
bool advance_stored(const GridSampler<UniformGrid>& field,
                    Rk4Kernel kernel,
                    const Particles& particles,
                    double to,
                    int sign,
                    const AdvanceOptions& options,
                    const std::stop_token& stop);

bool advance_stored(const GridSampler<RectilinearAxes>& field,
                    Rk4Kernel kernel,
                    const Particles& particles,
                    double to,
                    int sign,
                    const AdvanceOptions& options,
                    const std::stop_token& stop);

/// Velocities at points at one time, as they are carried. REQUIRES: no gaps.
/// Returns false if `stop` fired.
bool sample_stored(const GridSampler<UniformGrid>& field,
                   Rk4Kernel kernel,
                   std::span<const Vec3> positions,
                   double time,
                   std::span<Vec3f> velocities,
                   const std::stop_token& stop);

bool sample_stored(const GridSampler<RectilinearAxes>& field,
                   Rk4Kernel kernel,
                   std::span<const Vec3> positions,
                   double time,
                   std::span<Vec3f> velocities,
                   const std::stop_token& stop);

/// Returns false if the kernel cannot sample the field, because it has gaps or fewer than four nodes on an
/// axis.
bool kernel_samples(const CubicSampler& field);

/// Advances through the smooth field. REQUIRES: kernel_samples(field).
bool advance_stored(const CubicSampler& field,
                    Rk4Kernel kernel,
                    const Particles& particles,
                    double to,
                    int sign,
                    const AdvanceOptions& options,
                    const std::stop_token& stop);

bool sample_stored(const CubicSampler& field,
                   Rk4Kernel kernel,
                   std::span<const Vec3> positions,
                   double time,
                   std::span<Vec3f> velocities,
                   const std::stop_token& stop);

} // namespace wakesurf::core
