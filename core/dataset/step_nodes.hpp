// The velocities of a time-step as samplers reach them: in one piece, or brick by brick as the cache has
// them.
#pragma once

#include <cstddef>

namespace wakesurf::core {

class BrickTable;

/// Points to the nodes of a time-step, float3 in file order, whole or in bricks. With neither there is no
/// such time-step.
struct StepNodes {
    const float* whole = nullptr;       ///< x fastest
    const BrickTable* bricks = nullptr; ///< which are there, and where

    StepNodes() = default;

    /// Points to nodes in one piece.
    StepNodes(const float* in_one_piece) : whole(in_one_piece) {}

    /// Points to nodes in bricks.
    StepNodes(const BrickTable* in_bricks) : bricks(in_bricks) {}

    /// Points to no time-step.
    StepNodes(std::nullptr_t) {}

    /// There is such a time-step.
    explicit operator bool() const { return whole != nullptr || bricks != nullptr; }
};

} // namespace wakesurf::core
