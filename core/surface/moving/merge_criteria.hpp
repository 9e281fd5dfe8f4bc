// Which neighbouring cells are joined: convergence. Source: McLoughlin, Laramee, Zhang, SCCG 2010.
#pragma once

#include "core/field/flow.hpp"
#include "core/surface/moving/local_operations.hpp"
#include "core/surface/moving/refinement_rules.hpp"

#include <span>

namespace wakesurf::core {

/// True when `cell` and its partner across `axis` are small enough to be one, flat enough, and both stand for an odd place of
/// the lattice between them, so that neighbouring rows are joined at the same columns.
bool should_merge(const MovingMesh& mesh,
                  const LocalOperations& operations,
                  CellIndex cell,
                  Axis axis,
                  const RefinementRules& rules,
                  const Flow& flow,
                  std::span<const Vec3f> normals);

/// True when the vertex `mid` may go: it is on the border of the parameter rectangle and its neighbours' chord misses it by little.
bool droppable(const MovingMesh& mesh,
               VertexId before,
               VertexId mid,
               VertexId after,
               const RefinementRules& rules);

} // namespace wakesurf::core
