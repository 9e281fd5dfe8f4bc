// A finished surface: its mesh, and what making it took.
#pragma once

#include "core/surface/quad_complex.hpp"
#include "core/surface/surface_statistics.hpp"

#include <optional>

namespace wakesurf::core {

/// The result of build_surface.
struct Surface {
    QuadComplex mesh;             ///< the surface itself
    SurfaceStatistics statistics; ///< what it took and gave
    /// The time it is followed to, where that is before the one asked for.
    std::optional<double> ended{};
};

} // namespace wakesurf::core
