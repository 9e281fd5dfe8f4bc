// The three-dimensional cells of one VTK data set, whatever kind it is, in terms of its own points. First
// step from VTK's blocks to a core::CellMesh.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/cell_mesh.hpp"

#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkUnstructuredGrid.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace wakesurf::importer {

struct BlockCell {
    /// None stands for a flat, empty or blanked cell.
    enum class Form { None, Standard, Polyhedron };
    Form form = Form::None;
    core::CellShape shape = core::CellShape::Hexahedron; ///< of Standard
    std::array<std::uint32_t, 8> point{};          ///< of Standard, in VTK's order for the shape
    std::vector<std::vector<std::uint32_t>> faces; ///< of Polyhedron, at least 4
};

/// Returns the faces of a cell; none of None.
std::vector<std::vector<std::uint32_t>> faces_of(const BlockCell& cell);

/// Calls visit(p, q) for the ends of every edge, once or more often.
template <class Visit>
void visit_edges(const BlockCell& cell, const Visit& visit) {
    for (std::size_t f = 0;
         cell.form == BlockCell::Form::Standard && f < core::face_count(cell.shape); ++f) {
        const core::CellFace corners = core::face(cell.shape, f);
        for (std::size_t i = 0; i < corners.count; ++i)
            visit(cell.point[corners.node[i]], cell.point[corners.node[(i + 1) % corners.count]]);
    }
    if (cell.form == BlockCell::Form::Polyhedron)
        for (const auto& face : cell.faces)
            for (std::size_t i = 0; i < face.size(); ++i)
                visit(face[i], face[(i + 1) % face.size()]);
}

/// Reads the cells of one data set, by their index. Not thread-safe.
class BlockCells {
  public:
    /// REQUIRES: the data set outlives this.
    explicit BlockCells(vtkDataSet& data);

    std::size_t size() const { return size_; }

    /// Says whether the block is an image, rectilinear or structured grid, which have hexahedra only.
    bool structured() const { return grid_ == nullptr; }

    /// Reads a cell. Cells of one or two dimensions, hidden cells, duplicates of another piece's and cells
    /// with a hidden point are None. Error: Unsupported for cells with curved edges and others that would
    /// have to be approximated; Corrupt for a cell of points that do not exist, or a polyhedron that is none.
    core::Result<void> read(std::size_t index, BlockCell& cell);

  private:
    bool blanked(std::size_t index) const;
    bool touches_hidden_point(const BlockCell& cell) const;
    void read_structured(std::size_t index, BlockCell& cell) const;
    core::Result<void> read_unstructured(std::size_t index, BlockCell& cell);
    core::Result<void> read_standard(std::size_t index, int type, BlockCell& cell);
    core::Result<void> read_polyhedron(std::size_t index, BlockCell& cell);
    core::Result<void> read_prism(std::size_t index, BlockCell& cell);

    vtkUnstructuredGrid* grid_; ///< null for a structured block
    std::array<std::size_t, 3> nodes_{0, 0, 0};
    std::size_t points_ = 0;
    std::size_t size_ = 0;
    vtkDataArray* cell_marks_ = nullptr;
    vtkDataArray* point_marks_ = nullptr;
};

} // namespace wakesurf::importer
