// A finished surface: its mesh, what making it took, and the times of its vertices, at which fields are
// sampled.
#pragma once

#include "core/surface/quad_complex.hpp"
#include "core/surface/surface_parameters.hpp"
#include "core/surface/surface_statistics.hpp"

#include <optional>
#include <vector>

namespace wakesurf::core {

/// The result of build_surface.
struct Surface {
    QuadComplex mesh;             ///< the surface itself
    SurfaceStatistics statistics; ///< what it took and gave
    /// The time it is followed to, where that is before the one asked for.
    std::optional<double> ended{};
};

/// Returns one time a vertex: the frozen time of a stream surface, release plus t on a path surface, the time
/// a streak or time surface is shown at.
std::vector<double> vertex_times(const Surface& surface, const SurfaceParameters& parameters);

} // namespace wakesurf::core
