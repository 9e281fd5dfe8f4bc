// Taking vertices out of a moving surface where they are closer than they need be, or where triangles are
// thin: an edge shrinks to one of its ends.
#pragma once

#include "core/surface/moving/refinement_context.hpp"

#include <span>

namespace wakesurf::core {

/// Quality of a triangle one of whose vertices may be better away.
constexpr double thin_quality = 0.4;

/// True where an edge of the triangle is short, or the triangle thin, and one of its ends could go as far as
/// lengths tell. Most cannot.
bool may_join(const RefinementContext& context, TriangleId t);

/// Shrinks edges of `candidates`, and of those triangles that a join changes, the shortest first, where what
/// comes of it is within all limits.
void join_all(const RefinementContext& context, std::span<const TriangleId> candidates);

/// Joins the ends of a triangle's edge that is shorter than a crumb. False: there is none, or that is not
/// allowed.
bool join_needle(const RefinementContext& context, TriangleId t);

} // namespace wakesurf::core
