// A cell mesh with what finding places in it takes: made once, used by every sampler of its time-steps.
#pragma once

#include "core/field/cells/cell_locator.hpp"
#include "core/field/cells/cell_walls.hpp"

namespace wakesurf::core {

/// Keeps a reference to the mesh. Thread safety: immutable.
struct CellDomain {
    explicit CellDomain(const CellMesh& mesh_) : mesh(mesh_), locator(mesh_), walls(mesh_) {}

    const CellMesh& mesh;
    CellLocator locator;
    CellWalls walls;
};

} // namespace wakesurf::core
