// The local operations on the quads of a moving surface: insert, merge, reconnect, tear. Each keeps the mesh watertight and 2:1
// balanced (at most one mid node a side). Source: McLoughlin, Laramee, Zhang, Constructing Streak Surfaces
// for 3D Unsteady Vector Fields, SCCG 2010; hanging nodes as in Bürger et al. 2009.
#pragma once

#include "core/surface/moving/moving_mesh.hpp"

#include <functional>
#include <vector>

namespace wakesurf::core {

/// S: across the columns; T: along them.
enum class Axis : std::uint8_t { S = 0, T = 1 };

/// How a cross edge shared by two cells, or by two pairs of three cells, moves along a column.
enum class Reconnection : std::uint8_t {
    LeftYoung,
    RightYoung,
    LeftOld,
    RightOld,
    PairRight,
    PairLeft
};

class LocalOperations {
  public:
    using Insert = std::function<VertexId(CellIndex cell, std::size_t side)>;

    /// @param insert  makes the vertex in the middle of a whole side
    LocalOperations(MovingMesh& mesh, Insert insert) : mesh_(mesh), insert_(std::move(insert)) {}

    /// Cuts a cell in two across `axis`, and neighbours first where that keeps the balance. False when a ring of hanging
    /// nodes forbids it now.
    bool split(CellIndex cell, Axis axis);

    /// The cell that would become one with `cell`: its neighbour on the s+ or the old side, whole sides and no mid
    /// nodes where they would be joined; no_cell if it is none.
    CellIndex partner(CellIndex cell, Axis axis) const;

    /// Joins `cell` with partner(cell, axis). Mid nodes that no other cell needs disappear; on the boundary where `droppable`
    /// says so.
    void merge(CellIndex cell,
               Axis axis,
               const std::function<bool(VertexId before, VertexId mid, VertexId after)>& droppable);

    /// The edge (left, right) that reconnecting at the old side of `cell` would make; nothing when it cannot.
    struct CrossEdge {
        VertexId left = no_vertex, right = no_vertex;
    };

    CrossEdge reconnected(CellIndex cell, Reconnection how) const;

    /// The same without looking at what lies beside it: reconnected() may still be nothing. Cheaper.
    CrossEdge shifted(CellIndex cell, Reconnection how) const;

    /// REQUIRES: reconnected(cell, how) returns an edge.
    void reconnect(CellIndex cell, Reconnection how);

    void tear(CellIndex cell);

    /// Slots of cells that operations have made or changed since the last clear().
    std::vector<CellIndex>& touched() { return touched_; }

  private:
    bool clear_of_young(const Cell& cell, VertexId left, VertexId right) const;
    bool clear_of_old(const Cell& cell, VertexId left, VertexId right) const;
    bool ensure_mid(CellIndex cell, std::size_t side);
    void drop_mid(CellIndex cell,
                  std::size_t side,
                  const std::function<bool(VertexId, VertexId, VertexId)>& droppable);
    void replace(std::span<const CellIndex> removed, std::span<const Cell> made, std::size_t kept);
    CellIndex whole_neighbour(CellIndex cell, std::size_t side) const;

    MovingMesh& mesh_;
    Insert insert_;
    std::vector<CellIndex> busy_; ///< cells whose split waits for a neighbour's
    std::vector<CellIndex> touched_;
};

} // namespace wakesurf::core
