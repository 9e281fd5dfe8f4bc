// A path surface as it grows from its rake: built once, shown up to an age. Cells and vertices are put in
// order of age, so that growing is appending at the end and stepping back is removing there.
#pragma once

#include "core/surface/quad_complex.hpp"

#include <cstdint>
#include <vector>

namespace wakesurf::core {

/// The values of each of some fields at each vertex.
using VertexFields = std::vector<std::vector<float>>;

/// A path surface that grows with time; immutable.
class GrowingMesh {
  public:
    /// @param span    integration time: the age of the oldest. Cost: O(cells log cells).
    /// @param fields  of the vertices
    GrowingMesh(const QuadComplex& whole, double span, const VertexFields& fields = {});

    /// The cells that have been swept until `age`; ids are indices. Ages are rounded down to 1/1024 of the
    /// span, so that rows stay together. Cost: O(what is shown).
    KeyedMesh at(double age) const;

    /// Returns the fields at the vertices that at() returns.
    VertexFields fields_at(double age) const;

    /// Returns the bytes that it takes.
    std::size_t bytes() const;

  private:
    std::size_t step_at(double age) const;

    QuadComplex mesh_;    ///< in order
    VertexFields fields_; ///< likewise
    double span_;
    std::vector<std::size_t> cells_;    ///< how many there are up to each step of age
    std::vector<std::size_t> vertices_; ///< likewise
};

} // namespace wakesurf::core
