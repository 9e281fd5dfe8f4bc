// What an exported mesh says about the surface it holds, beside the mesh itself; the same for every file format.
#pragma once

#include "core/surface/rake.hpp"
#include "core/surface/surface_parameters.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::protocol {

/// How the surface of a file was made.
struct MeshMetadata {
    core::Rake rake{};                    ///< it started from
    core::SurfaceParameters parameters{}; ///< it was asked for
    double separation = 0.0; ///< of the mesh: the quad budget may have raised the one asked for
    std::uint32_t tessellate = 1; ///< quads that a cell of that separation was cut into, each way
    std::string dataset;          ///< id or name of the data
    std::string version;          ///< of wakesurf
    std::optional<double> time{}; ///< at which it is shown, where that is not its end
    std::string stopped{};        ///< why it is not what was asked for; usually empty
};

/// Three points of a circle would be taken for a polyline.
inline bool tells_kind(core::Rake::Kind kind) {
    return kind == core::Rake::Kind::Circle || kind == core::Rake::Kind::Points;
}

/// Further vertex arrays by name, each with one value a vertex.
using MeshScalars = std::map<std::string, std::vector<float>>;

} // namespace wakesurf::protocol
