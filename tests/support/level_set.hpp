// A level set of values at the nodes of a uniform grid, as points on its edges, and the distance of sets of
// points from each other.
#pragma once

#include "core/dataset/grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <unordered_map>
#include <vector>

namespace wakesurf::tests {

using core::Vec3;

/// Returns the points at which the linearly interpolated values are `level`.
inline std::vector<Vec3>
level_points(const core::UniformGrid& grid, std::span<const float> values, double level) {
    std::vector<Vec3> out;
    const std::array<std::size_t, 3> stride{1, grid.dimensions[0],
                                            std::size_t{grid.dimensions[0]} * grid.dimensions[1]};
    for (std::size_t node = 0; node < grid.nodes(); ++node)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (node / stride[axis] % grid.dimensions[axis] + 1 == grid.dimensions[axis])
                continue;
            const double a = values[node] - level;
            const double b = values[node + stride[axis]] - level;
            if (!(a * b <= 0.0) || a == b)
                continue;
            out.push_back(glm::mix(core::node_position(grid, node),
                                   core::node_position(grid, node + stride[axis]), a / (a - b)));
        }
    return out;
}

/// Says whether all nodes of the cell that a point lies in, and of those beside it, have values that differ
/// by less than `jump`.
inline bool all_known(const core::UniformGrid& grid,
                      std::span<const float> values,
                      const Vec3& point,
                      double jump = std::numeric_limits<double>::infinity()) {
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -lowest;
    const Vec3 at = (point - grid.origin) / grid.spacing;
    for (int k = -1; k <= 2; ++k)
        for (int j = -1; j <= 2; ++j)
            for (int i = -1; i <= 2; ++i) {
                const auto x = static_cast<std::int64_t>(std::floor(at.x)) + i;
                const auto y = static_cast<std::int64_t>(std::floor(at.y)) + j;
                const auto z = static_cast<std::int64_t>(std::floor(at.z)) + k;
                if (x < 0 || y < 0 || z < 0 || x >= grid.dimensions[0] || y >= grid.dimensions[1] ||
                    z >= grid.dimensions[2])
                    return false;
                const auto node = static_cast<std::size_t>(
                    x + grid.dimensions[0] * (y + std::int64_t{grid.dimensions[1]} * z));
                if (!std::isfinite(values[node]))
                    return false;
                lowest = std::min(lowest, double{values[node]});
                highest = std::max(highest, double{values[node]});
            }
    return highest - lowest < jump;
}

/// Sorts points into boxes of one size, to find the nearest one within that.
class NearPoints {
  public:
    NearPoints(std::span<const Vec3> points, double size) : size_(size) {
        for (const Vec3& p : points)
            boxes_[key(glm::floor(p / size_))].push_back(p);
    }

    /// Returns the distance of the nearest point; infinite if there is none within the size.
    double distance(const Vec3& from) const {
        double nearest = std::numeric_limits<double>::infinity();
        const Vec3 box = glm::floor(from / size_);
        for (int i = 0; i < 27; ++i)
            if (const auto found =
                    boxes_.find(key(box + Vec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1)));
                found != boxes_.end())
                for (const Vec3& p : found->second)
                    nearest = std::min(nearest, glm::length(p - from));
        return nearest <= size_ ? nearest : std::numeric_limits<double>::infinity();
    }

  private:
    static std::int64_t key(const Vec3& box) {
        const auto part = [](double x) { return static_cast<std::int64_t>(x) & 0x1fffff; };
        return part(box.x) | part(box.y) << 21 | part(box.z) << 42;
    }

    double size_;
    std::unordered_map<std::int64_t, std::vector<Vec3>> boxes_;
};

} // namespace wakesurf::tests
