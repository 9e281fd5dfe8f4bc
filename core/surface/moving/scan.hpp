// The limits that a step has violated: metrics of every triangle of a moving surface in single precision,
// many at a time and with some margin, then the exact rules for the few that these select.
#pragma once

#include "core/surface/moving/refinement_context.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace wakesurf::core {

/// Lengths are in separations.
struct TriangleMetrics {
    std::array<float, 3> normal{};    ///< of length 1
    std::array<float, 3> cotangent{}; ///< [k]: of the angle opposite to edge k
    std::uint32_t flags = 0;          ///< of TriangleFlag
};

/// What the metrics of a triangle need of a vertex, in one line of the cache.
struct alignas(64) VertexMetrics {
    Vec3 position;
    double s, t;
    Vec3f along_s, along_t;
};

/// The metrics of all vertices and triangles in one step.
struct MeshMetrics {
    std::vector<VertexMetrics> vertices; ///< of vertex slots
    std::vector<float> density;          ///< likewise: area in space of a unit of material
    std::vector<std::uint8_t> states;    ///< likewise
    std::vector<TriangleMetrics> of;     ///< of triangle slots
};

/// Keeps memory from step to step; nothing in it outlives one.
struct ScanMemory {
    MeshMetrics metrics;
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
