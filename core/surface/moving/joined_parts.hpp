// The parts of a surface that goes both ways in time, as one mesh with one set of statistics (moving_parts.hpp): for a finished surface
// and for one that is played.
#pragma once

#include "core/surface/quad_complex.hpp"
#include "core/surface/surface_statistics.hpp"

namespace wakesurf::core {

/// Appends a part's vertices and cells. @param mirrored  for the part that goes back in time, so that both face the same way
void append(QuadComplex& to, const QuadComplex& part, bool mirrored);

/// Adds what making a part took.
void add(SurfaceStatistics& sum, const SurfaceStatistics& part);

/// Fills in what is counted on the joined mesh: quads, vertices, approximated ones, the longest edge.
void count(SurfaceStatistics& statistics, const QuadComplex& mesh);

} // namespace wakesurf::core
