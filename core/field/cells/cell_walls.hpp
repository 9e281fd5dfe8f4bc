// The faces of a mesh that are walls, as the surfaces they are: a walk between cells may go round the end of a thin wall or
// come out behind a corner, and then asks here whether the straight way goes through.
#pragma once

#include "core/dataset/cell_mesh.hpp"
#include "core/field/cells/box_tree.hpp"

#include <array>
#include <vector>

namespace wakesurf::core {

/// A triangle, or the bilinear patch a + s b + t c + s t d that a face of four nodes is, with its outward side known.
struct WallPatch {
    Vec3 a, b, c, d;
    bool triangle;
    double size;    ///< longest side
    double outward; ///< +1 where b x c points out of the cell, -1 where into it

    /// True where the segment leaves the patch's cell through the patch, and ends beyond it by more than rounding.
    bool left_by(const Vec3& from, const Vec3& to) const;
};

/// Memory: 150 bytes a wall face and a byte a cell. Thread safety: concurrent queries are fine.
class CellWalls {
  public:
    explicit CellWalls(const CellMesh& mesh);

    bool empty() const { return patch_.empty(); }

    /// True for cells with a node on a wall.
    bool beside(std::uint32_t cell) const { return beside_[cell] != 0; }

    /// True where the segment goes through a wall, seen from inside the cells.
    bool crossed(const Vec3& from, const Vec3& to) const;

  private:
    std::vector<WallPatch> patch_;
    std::vector<std::uint8_t> beside_;
    BoxTree tree_;
};

} // namespace wakesurf::core
