// Makes what a moving surface begins with: the columns of its lattice, the rake's first row of attached
// vertices, or a whole patch. Source: McLoughlin, Laramee, Zhang, SCCG 2010.
#pragma once

#include "core/surface/moving/origin.hpp"

#include <vector>

namespace wakesurf::core {

/// Columns 0, 1, 2 ... of the lattice and their seed parameters.
struct Columns {
    std::vector<double> s;
    double count = 0.0; ///< intervals
    bool closed = false;

    /// Returns the seed parameter of a place between two columns.
    double at(double column) const;
};

/// Returns columns evenly spaced between the curve's corners.
Columns make_columns(const Origin& origin, double intervals);

/// Attaches vertices at the mesh's time on every column, and on every half, quarter ... between an inside and
/// an outside column down to `finest`, in order along the rake. Error: what sampling reports.
Result<std::vector<VertexId>> attach_row(MovingMesh& mesh,
                                         const Origin& origin,
                                         const Flow& flow,
                                         const Columns& columns,
                                         std::span<const double> places,
                                         double row,
                                         std::stop_token stop);

/// Places along the lattice at which a rake is seeded: whole columns, and finer towards where it enters an
/// obstacle.
std::vector<double>
seed_places(const Origin& origin, const Flow& flow, const Columns& columns, double finest);

/// Joins an older row with the newer one behind it. Both in order along the rake; cells come where two
/// neighbours of the older row have neighbours of the same place in the newer one.
void join_rows(MovingMesh& mesh, std::span<const VertexId> newer, std::span<const VertexId> older);

/// Lays the whole patch of a time surface as free vertices and cells. Error: what sampling reports.
Result<void> lay_patch(MovingMesh& mesh,
                       const Origin& origin,
                       const Flow& flow,
                       const Columns& columns,
                       double rows,
                       std::stop_token stop);

} // namespace wakesurf::core
