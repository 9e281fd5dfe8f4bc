// Which nodes of a stored field make the value at a point, and how much of it each: what scalar fields are sampled by.
#pragma once

#include "core/base/point_status.hpp"

#include <array>
#include <cstddef>

namespace wakesurf::core {

/// Shares add up to 1. None where the point is outside the domain or in an obstacle, and of closed forms, which have no nodes.
struct NodeShares {
    PointStatus status = PointStatus::OutsideDomain;
    std::size_t count = 0;
    std::array<std::size_t, 8> node{};
    std::array<double, 8> share{};
};

} // namespace wakesurf::core
