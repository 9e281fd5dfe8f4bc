// A test of every triangle of a moving surface in single precision, many at a time, with some margin: the
// questions for the exact rules, and the facts for its neighbours.
#pragma once

#include "core/surface/moving/refinement_context.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace wakesurf::core {

/// Single precision may be off by this, and some more.
inline constexpr float look_room = 1e-4f;

/// The tests. Edges have three bits each: the first << k.
enum Look : std::uint32_t {
    look_dead = 1,      ///< a vertex is; nothing else is said then
    look_small = 2,     ///< an edge is short, or the triangle thin
    look_web = 4,       ///< may be one
    look_wall = 8,      ///< an edge may meet one
    look_no_shape = 16, ///< no area, or not a number
    look_wide = 32,     ///< an edge is too long for a diagonal
    look_long = 64,
    look_bent = 512,
};

inline constexpr std::uint32_t look_any_long = 7 * look_long;

/// Lengths are in separations.
struct TriangleLook {
    std::array<float, 3> normal{};    ///< of length 1
    std::array<float, 3> cotangent{}; ///< [k]: of the angle opposite to edge k
    std::uint32_t flags = 0;
};

/// The data of a vertex for the check of a triangle, in one line of the cache.
struct alignas(64) VertexLook {
    Vec3 position;
    double s, t;
    Vec3f along_s, along_t;
};

/// Keeps memory from step to step; nothing in it outlives one.
struct TriangleLooks {
    std::vector<VertexLook> vertices; ///< of vertex slots
    std::vector<float> density;       ///< likewise: area in space of a unit of material
    std::vector<std::uint8_t> states; ///< likewise
    std::vector<TriangleLook> of;     ///< of triangle slots
};

/// Checks every triangle in parallel. Cost: O(triangles).
void look_at_all(const RefinementContext& context, TriangleLooks& looks);

/// True where an edge from the vertex may meet a wall. REQUIRES: look_at_all().
bool may_meet_wall(const TriangleLooks& looks, VertexId v);

} // namespace wakesurf::core
