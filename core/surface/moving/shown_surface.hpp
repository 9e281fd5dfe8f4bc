// Makes what is shown of a moving surface, finished or played: its cells, which face the same way whichever
// way time runs, and what is counted on them.
#pragma once

#include "core/surface/quad_complex.hpp"
#include "core/surface/surface_statistics.hpp"

namespace wakesurf::core {

/// Mirrors the cells of a surface that goes back in time.
void mirror_cells(QuadComplex& mesh);

/// Fills in what is counted on the mesh: quads, vertices, approximated ones, the longest edge, the estimated
/// error.
void count(SurfaceStatistics& statistics, const QuadComplex& mesh);

} // namespace wakesurf::core
