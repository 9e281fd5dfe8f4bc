// The velocities of a time-step as samplers reach them: in one piece, or brick by brick as the cache has them.
#pragma once

#include <cstddef>

namespace wakesurf::core {

class BrickTable;

/// Float3 in file order. Neither: there is no such time-step.
struct StepNodes {
    const float* whole = nullptr;       ///< x fastest
    const BrickTable* bricks = nullptr; ///< which are there, and where

    StepNodes() = default;

    /// In one piece.
    StepNodes(const float* in_one_piece) : whole(in_one_piece) {}

    /// In bricks.
    StepNodes(const BrickTable* in_bricks) : bricks(in_bricks) {}

    /// None.
    StepNodes(std::nullptr_t) {}

    /// There is such a time-step.
    explicit operator bool() const { return whole != nullptr || bricks != nullptr; }
};

} // namespace wakesurf::core
