// The distance of points of a surface from the reference, as reported figures.
#pragma once

#include "tests/bench/deviation/dense_reference.hpp"

#include <algorithm>

namespace wakesurf::bench {

/// Distances in cells. Points within a cell of the domain's border are apart: lines end there, and how they
/// end is no accuracy.
struct Deviation {
    double mean = 0.0, p99 = 0.0, max = 0.0;
    double border_max = 0.0;
};

inline Deviation deviation(const DenseReference& reference,
                           const std::vector<core::Vec3>& points,
                           const core::Box& domain,
                           double cell) {
    const core::Box inner{domain.lo + cell, domain.hi - cell};
    std::vector<double> distances;
    Deviation result;
    for (const core::Vec3& point : points) {
        const double cells = reference.distance(point) / cell;
        if (inner.contains(point))
            distances.push_back(cells);
        else
            result.border_max = std::max(result.border_max, cells);
    }
    if (distances.empty())
        return result;
    std::sort(distances.begin(), distances.end());
    for (const double d : distances)
        result.mean += d / static_cast<double>(distances.size());
    result.p99 = distances[distances.size() * 99 / 100];
    result.max = distances.back();
    return result;
}

} // namespace wakesurf::bench
