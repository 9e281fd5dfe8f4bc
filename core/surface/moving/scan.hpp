// Finds violated limits after a step: a test of every triangle of a moving surface in single precision, with
// some margin, then the exact rules for the few that it selects.
#pragma once

#include "core/surface/moving/refinement_context.hpp"
#include "core/surface/moving/triangle_looks.hpp"

#include <cstdint>
#include <vector>

namespace wakesurf::core {

/// Keeps memory from step to step; nothing in it outlives one.
struct ScanMemory {
    TriangleLooks looks;
    std::vector<std::uint8_t> needs; ///< of triangle slots
};

/// Triangles in order of their slots.
struct Needs {
    std::vector<TriangleId> flipping, cutting, joining, pairing; ///< cutting: or clipping
};

/// @param turn  counts the steps: what has not changed is looked at for joining, and for a better other half,
///              in one of several. Most of it has been refused before.
/// Cost: O(triangles), in parallel; the same result for any number of threads.
Needs scan(const RefinementContext& context, std::uint64_t turn, ScanMemory& memory);

} // namespace wakesurf::core
