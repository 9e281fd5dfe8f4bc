// A mesh whose vertices and cells have ids that last from one state of a surface to the next.
#pragma once

#include "core/surface/quad_complex.hpp"

#include <cstdint>
#include <vector>

namespace wakesurf::core {

/// Ids ascend, one a vertex and one a cell; an id is never used again for something else.
struct KeyedMesh {
    QuadComplex mesh;                     ///< the mesh itself
    std::vector<std::uint32_t> vertex_id; ///< of each vertex
    std::vector<std::uint32_t> cell_id;   ///< of each cell
    double time = 0.0;                    ///< simulation time
};

} // namespace wakesurf::core
