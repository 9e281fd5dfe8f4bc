// What happens to the vertices of a moving surface between steps: rows leave the rake, the dead are kept track of, memory is
// put back into mesh order.
#pragma once

#include "core/surface/moving/origin.hpp"
#include "core/surface/surface_statistics.hpp"

#include <span>
#include <vector>

namespace wakesurf::core {

/// Sets every living attached vertex free; returns them in order along the rake.
std::vector<VertexId> release_row(MovingMesh& mesh);

/// Places of the row to attach behind `released`: theirs, and those of `usual` that they leave out by a whole column or more.
std::vector<double> places_behind(const MovingMesh& mesh,
                                  std::span<const VertexId> released,
                                  std::span<const double> usual);

/// Attached vertices stay on the rake: theirs is the mesh's time.
void move_attached(MovingMesh& mesh);

/// The particle left the rake at a seed of its first row; false: it was inserted between others on the way.
bool from_seed(const MaterialVertices& vertices, VertexId v);

/// How many of those are under way.
std::uint64_t running_seeds(const MovingMesh& mesh);

/// Vertices that died in this step are counted, and put where they would have gone on to at their last velocity, so that
/// what is inserted beside them lies on the surface at the mesh's time.
void carry_on_the_dead(MovingMesh& mesh, SurfaceStatistics::Terminated& terminated);

/// Puts vertices in order of row and column, and cells in that of their vertices, when more than `share` of the slots have
/// been filled out of order: advection is three times as fast in mesh order as in random order (docs/measurements.md, The limit of the kernel).
void sort_memory(MovingMesh& mesh, double share);

} // namespace wakesurf::core
