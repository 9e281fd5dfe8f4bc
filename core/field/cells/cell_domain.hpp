// A cell mesh with what finding places in it takes: made once, used by every sampler of its time-steps.
#pragma once

#include "core/base/rounding.hpp"
#include "core/field/cells/cell_locator.hpp"
#include "core/field/cells/cell_walls.hpp"

#include <algorithm>

namespace wakesurf::core {

/// True where every cell can be reached from every other one through faces.
bool connected(const CellMesh& mesh);

/// Keeps a reference to the mesh. Thread safety: immutable.
struct CellDomain {
    explicit CellDomain(const CellMesh& mesh_)
        : mesh(mesh_), locator(mesh_), walls(mesh_), one_piece(connected(mesh_)),
          rounding(core::rounding(locator.bounds())),
          rounding_across(std::min(glm::length(rounding), 1e-5 * shortest(locator.bounds()))) {}

    const CellMesh& mesh;
    CellLocator locator;
    CellWalls walls;
    bool one_piece; ///< all cells hang together by their faces: no blocks, which may overlap
    Vec3 rounding;  ///< along each axis a particle may begin this far beyond the border
    double rounding_across; ///< and beyond a border that is parallel to no axis

  private:
    static double shortest(const Box& box) {
        const Vec3 extent = box.extent();
        return std::min(std::min(extent.x, extent.y), extent.z);
    }
};

} // namespace wakesurf::core
