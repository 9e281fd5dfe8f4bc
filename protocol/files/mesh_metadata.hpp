// What an exported mesh says about the surface it holds, beside the mesh itself; the same for every file format.
#pragma once

#include "core/surface/rake.hpp"
#include "core/surface/surface_parameters.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::protocol {

struct MeshMetadata {
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
    std::optional<double> time{}; ///< at which it is shown, where that is not its end
};

/// Further vertex arrays by name, each with one value a vertex.
using MeshScalars = std::map<std::string, std::vector<float>>;

} // namespace wakesurf::protocol
