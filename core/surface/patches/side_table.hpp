// The pieces of the sides of a mesh's cells, between one vertex and the next, each once: numbers for what
// both cells beside one share.
#pragma once

#include "core/surface/quad_complex.hpp"

#include <cstdint>
#include <vector>

namespace wakesurf::core {

class SideTable {
  public:
    /// Builds the table. Cost: O(cells), 28 bytes a cell.
    explicit SideTable(const QuadComplex& mesh);

    std::size_t count() const { return to_.size(); }

    /// Returns the number of the piece between two vertices that are beside each other, in either order.
    std::size_t number(VertexId a, VertexId b) const;

    /// Only one cell has it.
    bool outline(std::size_t number) const { return cells_[number] == 1; }

    struct Ends {
        VertexId a, b; ///< a < b
    };

    /// Calls visit(number, Ends) for all, in order.
    template <class Visit>
    void for_each(const Visit& visit) const {
        for (VertexId a = 0; a + 1 < first_.size(); ++a)
            for (std::size_t k = first_[a]; k < first_[a + 1]; ++k)
                visit(k, Ends{a, to_[k]});
    }

  private:
    std::vector<std::uint32_t> first_; ///< by the smaller vertex, where its pieces begin
    std::vector<VertexId> to_;         ///< the larger vertex
    std::vector<std::uint8_t> cells_;  ///< how many have it
};

} // namespace wakesurf::core
