// The tangents of a moving surface at a vertex: those that it carries, or, where none are carried, those that its edges tell.
#pragma once

#include "core/surface/carried_error.hpp"
#include "core/surface/moving/moving_mesh.hpp"

#include <vector>

namespace wakesurf::core {

/// As the edges from a corner of a cell tell; zero where they do not.
SurfaceTangents tangents_in(const MovingMesh& mesh, const Cell& cell, std::size_t corner);

/// Tangents of all vertices of a mesh, as it is now.
class MeshTangents {
  public:
    /// @param carried  the vertices carry their tangents. Cost without: one look at every cell.
    MeshTangents(const MovingMesh& mesh, bool carried);

    SurfaceTangents at(VertexId v) const;

  private:
    const MovingMesh& mesh_;
    bool carried_;
    std::vector<CellIndex>
        cell_of_; ///< one with the vertex as a corner, or else as a mid node; empty where tangents are carried
};

} // namespace wakesurf::core
