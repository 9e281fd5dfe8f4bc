// The vertices of a moving surface between steps: how long the next step is, the row that leaves the rake,
// the count of the dead, and the order in memory.
#pragma once

#include "core/surface/moving/moving_mesh.hpp"
#include "core/surface/moving/moving_plan.hpp"
#include "core/surface/surface_statistics.hpp"

#include <span>
#include <vector>

namespace wakesurf::core {

/// Returns the length of the next step towards `to`. A row released at the rake falls no further behind than
/// rows are apart, and no edge grows by more than half, unless nothing is inserted between vertices.
/// @param separation  longest edge allowed
/// @param releasing   a row is measured by the speed at the rake rather than by the fastest particle
double
step_length(const MovingMesh& mesh, double to, double separation, bool releasing, bool refines);

/// Returns the vertices on the rake, in the order of their slots.
std::vector<VertexId> attached(const MovingMesh& mesh);

/// Sets every living attached vertex free; returns them in order along the rake.
std::vector<VertexId> release_row(MovingMesh& mesh);

/// Seeds of the row to attach behind `released`: theirs, and those of the plan that they leave out by a whole
/// column or more.
std::vector<double>
seeds_behind(const MovingMesh& mesh, std::span<const VertexId> released, const MovingPlan& plan);

/// Attached vertices stay on the rake: theirs is the mesh's time.
void move_attached(MovingMesh& mesh);

/// Returns how many vertices are under way.
std::uint64_t running(const MovingMesh& mesh);

/// Counts those that died in this step. Vertices whose id is at least `fresh` do not count: those on the
/// boundary are new in every step.
void count_the_dead(const MovingMesh& mesh,
                    std::uint32_t fresh,
                    SurfaceStatistics::Terminated& terminated);

/// Puts vertices in order of t and s, each row behind those released before it, and cells in that of their
/// vertices, when more than `share` of the slots have been filled out of order: advection is three times as fast
/// in mesh order as in random order (docs/measurements.md, The limit of the kernel).
void sort_memory(MovingMesh& mesh, double share);

} // namespace wakesurf::core
