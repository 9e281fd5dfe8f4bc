// What a step may have brought out of its limits: one look at every triangle of a moving surface in single
// precision, with some room, then the exact rules for the few of which it says so.
#pragma once

#include "core/surface/moving/refinement_context.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace wakesurf::core {

/// A triangle as far as its neighbours have to know it.
struct TriangleLook {
    Vec3f normal{0.0f};               ///< of length 1
    std::array<float, 3> cotangent{}; ///< [k]: of the angle opposite to edge k
    std::uint8_t flags = 0;
};

/// Memory kept from step to step; nothing in it outlives one.
struct ScanMemory {
    std::vector<float> density;          ///< of vertex slots: area in space of a unit of material
    std::vector<std::uint8_t> near_wall; ///< likewise: an edge from it may meet one
    std::vector<TriangleLook> looks;     ///< of triangle slots
    std::vector<std::uint8_t> needs;     ///< likewise
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
