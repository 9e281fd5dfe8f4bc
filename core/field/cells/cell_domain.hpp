// A cell mesh with what finding places and walls in it takes: made once, used by every sampler of its
// time-steps.
#pragma once

#include "core/base/rounding.hpp"
#include "core/dataset/cell_mesh.hpp"
#include "core/field/cells/box_tree.hpp"
#include "core/field/cells/cell_locator.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace wakesurf::core {

/// A triangle, or the bilinear patch a + s b + t c + s t d that a face of four nodes is, with its outward
/// side known.
struct WallPatch {
    Vec3 a, b, c, d;
    bool triangle;
    /// Lengths along the normal that are less count as none: it is a part of what cells reach beyond their
    /// faces.
    double rounding;
    double outward; ///< +1 where b x c points out of the cell, -1 where into it

    /// Returns false if a plane along the patch has all of it on one side and the segment on the other.
    bool may_meet(const Vec3& from, const Vec3& to) const;

    /// True where the segment leaves the patch's cell through the patch, and ends beyond it by more than
    /// rounding.
    bool left_by(const Vec3& from, const Vec3& to) const;
};

/// Takes 150 bytes a wall face, a byte a cell and a byte a node. Thread safety: concurrent queries are fine.
class CellWalls {
  public:
    explicit CellWalls(const CellMesh& mesh);

    bool empty() const { return patch_.empty(); }

    /// Returns false if no wall has a part in the box. Cost: 20 ns where none is near.
    bool near(const Box& box) const {
        return tree_.visit(box, [](std::uint32_t) { return true; });
    }

    /// Returns false if the segment meets no wall. Cost: that of `near`, and 10 ns a wall face beside it.
    bool may_cross(const Vec3& from, const Vec3& to) const {
        return tree_.visit(Box{glm::min(from, to), glm::max(from, to)},
                           [&](std::uint32_t number) { return patch_[number].may_meet(from, to); });
    }

    /// Returns true for cells with a node on a wall.
    bool beside(std::uint32_t cell) const { return beside_[cell] != 0; }

    /// Returns the share of wall nodes in a value at local coordinates `u` of a cell: 1 on a wall face, and
    /// falling from there to the cell's other nodes.
    double share(const CellMesh& mesh, std::uint32_t cell, const Vec3& u) const;

    /// True where the segment goes through a wall, seen from inside the cells.
    bool crossed(const Vec3& from, const Vec3& to) const;

  private:
    std::vector<WallPatch> patch_;
    std::vector<std::uint8_t> on_wall_; ///< by node
    std::vector<std::uint8_t> beside_;
    BoxTree tree_;
};

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
