// Which cells must be cut or torn: divergence, obstacles, curvature, discontinuity, and what lies beside a dead vertex.
// Source: McLoughlin, Laramee, Zhang, SCCG 2010; discontinuity by seed distance: Garth et al. 2008.
#pragma once

#include "core/field/flow.hpp"
#include "core/surface/moving/local_operations.hpp"
#include "core/surface/moving/refinement_rules.hpp"

#include <span>

namespace wakesurf::core {

enum class Cut : std::uint8_t { None, AcrossS, AcrossT, Tear };

/// @param normals  of every cell slot; empty when curvature does not matter
Cut needed_cut(const MovingMesh& mesh,
               CellIndex cell,
               const RefinementRules& rules,
               const Flow& flow,
               std::span<const Vec3f> normals);

bool has_dead_vertex(const MovingMesh& mesh, const Cell& cell);

/// True when the chord between two vertices, longer than a quarter of the separation, passes through an obstacle deeper than
/// a convex wall makes it dip.
bool crosses_obstacle(const MovingMesh& mesh,
                      VertexId a,
                      VertexId b,
                      double length,
                      const RefinementRules& rules,
                      const Flow& flow);

} // namespace wakesurf::core
