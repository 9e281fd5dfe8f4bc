// The description of the surface in an exported mesh; the same for every file format.
#pragma once

#include "core/surface/rake.hpp"
#include "core/surface/surface_parameters.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::protocol {

/// Describes how the surface of a file was made.
struct MeshMetadata {
    core::Rake rake{};                    ///< the rake of the surface
    core::SurfaceParameters parameters{}; ///< the parameters asked for
    double separation = 0.0; ///< of the mesh: the quad budget may have raised the one asked for
    std::uint32_t tessellate = 1; ///< quads that a cell of that separation was cut into, each way
    std::string dataset;          ///< id or name of the data
    std::string version;          ///< of wakesurf
    /// The time at which the surface is shown, if that is not its end.
    std::optional<double> time{};
    /// The reason why the surface is not what was asked for; usually empty.
    std::string stopped{};
};

/// Says whether a file states the kind of a rake: three points of a circle would be taken for a polyline.
inline bool tells_kind(core::Rake::Kind kind) {
    return kind == core::Rake::Kind::Circle || kind == core::Rake::Kind::Points;
}

/// Holds further vertex arrays by name, each with one value a vertex.
using MeshScalars = std::map<std::string, std::vector<float>>;

} // namespace wakesurf::protocol
