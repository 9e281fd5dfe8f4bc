// The nodes of a stored field that make the value at a point, and the weight of each: scalar fields are
// sampled by them.
#pragma once

#include "core/base/point_status.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace wakesurf::core {

/// Shares add up to 1. None where the point is outside the domain or in an obstacle, and of closed forms,
/// which have no nodes.
struct NodeShares {
    PointStatus status = PointStatus::OutsideDomain; ///< of the point
    std::size_t count = 0;                           ///< of the nodes that count
    std::array<std::size_t, 8> node{};               ///< their numbers
    std::array<double, 8> share{};                   ///< what each counts; together 1
};

/// Nodes without a value that have no more than this of a point's shares are the rounding of a point on a
/// cell's face or edge: the others make its value.
inline constexpr double rounding_share = 1e-6;

/// Value at a point of a field over the nodes; NaN where too much of it has no finite value.
/// @param value  value(i), of the node that is i-th among them
template <class Value>
double weighed_by(const NodeShares& shares, const Value& value) {
    double sum = 0.0;
    double known = 0.0;
    for (std::size_t i = 0; i < shares.count; ++i)
        if (const double here = value(i); std::isfinite(here)) {
            sum += shares.share[i] * here;
            known += shares.share[i];
        }
    if (known == 1.0)
        return sum;
    return known >= 1.0 - rounding_share ? sum / known : std::numeric_limits<double>::quiet_NaN();
}

/// Sums the values of the nodes by their shares.
template <class Value>
double weighed(const NodeShares& shares, const Value& value) {
    return weighed_by(shares, [&](std::size_t i) { return value(shares.node[i]); });
}

} // namespace wakesurf::core
