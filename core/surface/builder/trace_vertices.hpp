// The particles of a finished surface's vertices, traced again from their seeds through any plan: what the error between
// stored times and the distance from a twin are measured by.
#pragma once

#include "core/base/result.hpp"
#include "core/base/work_done.hpp"
#include "core/surface/request/surface_plan.hpp"
#include "core/surface/surface.hpp"

#include <span>
#include <stop_token>
#include <utility>
#include <vector>

namespace wakesurf::core {

/// Returns the vertices that are not interpolated between others.
std::vector<VertexId> traced_vertices(const QuadComplex& mesh);

/// Returns when the vertex's particle begins, and when it is where the vertex is. REQUIRES: not a stream surface's.
std::pair<double, double> life_of(VertexId v, const SurfacePlan& plan, const Surface& surface);

/// Returns the place that each vertex's particle comes to, from the seed and release of the same parameters s and t on the
/// rake of `through`; not a number where it does not arrive. The same for any number of threads. Error: Cancelled,
/// OverLimit, what loading a time-step reports. Cost: each vertex of a streak or time surface and each line of a stream
/// or path surface is traced once.
/// @param surface  of the same kind, `from` and `to` as the plan
/// @param speed    SurfacePlan::largest_speed
Result<std::vector<Vec3>> trace_vertices(const SurfacePlan& through,
                                         const Surface& surface,
                                         std::span<const VertexId> vertices,
                                         double speed,
                                         const std::stop_token& stop,
                                         const WorkPart& work);

/// Gives vertices that are not traced the mean of their neighbours' values; none, which is not a number, where most of
/// these have none. @param values  one a vertex
void fill_between(const QuadComplex& mesh, std::span<float> values);

} // namespace wakesurf::core
