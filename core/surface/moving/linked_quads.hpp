// The cells of a moving surface: quads with hanging nodes that know their neighbours, so that every operation on
// them stays local. One mechanism changes the mesh: a patch of cells is replaced by another with the same outline.
#pragma once

#include "core/surface/quad_complex.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace wakesurf::core {

using CellIndex = std::uint32_t;
inline constexpr CellIndex no_cell = 0xffffffffu;

struct LinkedCell {
    Cell cell; ///< corners and mid nodes are vertex slots
    /// Neighbour across each side; [1] is that of the second half where the side has a mid node.
    std::array<std::array<CellIndex, 2>, 4> across{
        {{no_cell, no_cell}, {no_cell, no_cell}, {no_cell, no_cell}, {no_cell, no_cell}}};
    std::uint32_t id = 0; ///< never used again within a surface
    bool live = false;
};

/// A directed piece of a cell's outline.
struct SubEdge {
    VertexId from, to;
    std::uint8_t side, half;
};

/// The 4 to 8 sub-edges of a cell, counter-clockwise.
struct Outline {
    std::array<SubEdge, 8> edge;
    std::size_t count = 0;

    const SubEdge* begin() const { return edge.data(); }

    const SubEdge* end() const { return edge.data() + count; }
};

Outline outline(const Cell& cell);

class LinkedQuads {
  public:
    /// Slots, free ones included: `live` tells.
    std::span<const LinkedCell> slots() const { return slots_; }

    const LinkedCell& operator[](CellIndex index) const { return slots_[index]; }

    std::size_t live() const { return slots_.size() - free_.size(); }

    /// Replaces the cells `removed` by `made`; together they must have the same outline, except that pieces of it may
    /// become boundary. made[k] takes the slot of removed[k]; the first `kept` of them keep their ids as well, as cells
    /// that have changed rather than come and gone. Cost: O(patch squared): meant for patches of a few cells.
    void
    replace(std::span<const CellIndex> removed, std::span<const Cell> made, std::size_t kept = 0);

    /// Adds cells, linked among themselves and to the boundary of `beside`.
    void append(std::span<const Cell> made, std::span<const CellIndex> beside);

    /// Slots of the cells the last replace() or append() made.
    std::span<const CellIndex> made() const { return made_; }

    /// Moves cells and vertices to the slots they have in `cells` (in order) and `vertex_slot`. For keeping memory in mesh order.
    void renumber(std::span<const CellIndex> order, std::span<const VertexId> vertex_slot);

    /// What the next one made is called.
    std::uint32_t next_id() const { return next_id_; }

    /// REQUIRES: none has been made.
    void number_from(std::uint32_t first) { next_id_ = first; }

    std::size_t bytes() const {
        return slots_.capacity() * sizeof(LinkedCell) + free_.capacity() * sizeof(CellIndex);
    }

  private:
    CellIndex place(const Cell& cell);
    void link(CellIndex cell, const SubEdge& edge, CellIndex neighbour);
    void relink(CellIndex cell, VertexId from, VertexId to, CellIndex neighbour);

    std::vector<LinkedCell> slots_;
    std::vector<CellIndex> free_;
    std::vector<CellIndex> made_;
    std::uint32_t next_id_ = 0;
};

} // namespace wakesurf::core
