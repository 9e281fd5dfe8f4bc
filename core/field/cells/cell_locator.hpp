// Finds the cell of a point in a mesh from nothing: for first points, and where a walk through faces finds no
// way.
#pragma once

#include "core/field/cells/box_tree.hpp"
#include "core/field/cells/cell_geometry.hpp"

#include <optional>

namespace wakesurf::core {

/// A cell and a point's local coordinates in it.
struct CellPlace {
    std::uint32_t cell;
    Vec3 local;
};

/// Keeps a reference to the mesh. Memory: 36 bytes a cell. Thread safety: concurrent queries are fine.
class CellLocator {
  public:
    /// Builds the locator in parallel. Cost: that of BoxTree.
    explicit CellLocator(const CellMesh& mesh);

    /// Returns the cell of lowest number among those that contain `p`, faces included; nothing for NaN.
    /// @param geometry  work space; afterwards that of the cell found, or any
    std::optional<CellPlace> find(const Vec3& p, CellGeometry& geometry) const;

    /// A cell near `p`, which may be outside of all.
    std::optional<std::uint32_t> near(const Vec3& p) const;

    const Box& bounds() const { return bounds_; }

    std::size_t bytes() const { return tree_.bytes(); }

  private:
    const CellMesh& mesh_;
    BoxTree tree_;
    Box bounds_;
};

/// Returns whether the geometry's cell contains `p`, and where. It tries harder than Newton's iteration from
/// the centre alone.
bool contains(CellGeometry& geometry, const Vec3& p, Vec3& local);

} // namespace wakesurf::core
