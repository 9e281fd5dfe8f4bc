// A path surface as it grows from its rake: built once, shown up to an age. Cells and vertices are put in order of age, so
// that growing is appending at the end and stepping back is removing there.
#pragma once

#include "core/surface/keyed_mesh.hpp"

#include <cstdint>
#include <vector>

namespace wakesurf::server {

/// Immutable.
class GrowingMesh {
  public:
    /// @param span  integration time: the age of the oldest. Cost: O(cells log cells).
    GrowingMesh(const core::QuadComplex& whole, double span);

    /// The cells that have been swept until `age`; ids are indices. Ages are rounded down to 1/1024 of the span, so that rows stay
    /// together. Cost: O(what is shown).
    core::KeyedMesh at(double age) const;

  private:
    core::QuadComplex mesh_; ///< in order
    double span_;
    std::vector<std::size_t> cells_;    ///< how many there are up to each step of age
    std::vector<std::size_t> vertices_; ///< likewise
};

} // namespace wakesurf::server
