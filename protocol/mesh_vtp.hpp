// A surface -> the bytes of a .vtp file (VTK XML PolyData, appended raw data): one polygon a cell, corners and
// hanging nodes in order, so that the polygons share points and the file is as watertight as the surface.
#pragma once

#include "core/surface/quad_complex.hpp"
#include "core/surface/rake.hpp"
#include "core/surface/surface_parameters.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::protocol {

/// What the file says about the surface, in its field data.
struct VtpMetadata {
    core::SurfaceKind kind = core::SurfaceKind::Stream;
    std::vector<core::Vec3> rake{}; ///< the rake's points
    double from = 0.0;
    double to = 0.0;
    double separation = 0.0;
    std::string dataset;
    std::string version;                   ///< of wakesurf
    std::optional<double> release_until{}; ///< these three only where the surface has them
    std::vector<core::Vec3> rake2{};
    std::optional<core::Vec3> sweep{};
};

/// Further point arrays by name, each with one value a vertex.
using VtpScalars = std::map<std::string, std::vector<float>>;

/// Coordinates as computed (Float64). Same input, same bytes. About 100 bytes and 0.2 microseconds a vertex.
/// REQUIRES: every per-vertex array of `mesh` and `scalars` has mesh.vertices() entries; `deformation` may be empty.
std::string mesh_vtp(const core::QuadComplex& mesh,
                     const VtpMetadata& metadata,
                     const VtpScalars& scalars = {});

} // namespace wakesurf::protocol
