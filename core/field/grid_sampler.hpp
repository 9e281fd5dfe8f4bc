// Trilinear in space, linear in time: the stored field between its nodes. A pair of time-steps, or one for a
// frozen field. Mirrors what vtkProbeFilter gives on image data.
#pragma once

#include "core/base/point_status.hpp"
#include "core/dataset/solid_mask.hpp"
#include "core/dataset/uniform_grid.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace wakesurf::core {

/// Per cell: are all, none or some of its nodes fluid? One byte read answers nearly every status question.
class CellMask {
  public:
    CellMask(const UniformGrid& grid, const SolidMask& mask);

    enum State : std::uint8_t { Fluid, Mixed, Solid };

    State state(std::size_t first_node) const {
        return state_.empty() ? Fluid : static_cast<State>(state_[first_node]);
    }

    /// A State a byte, by the cell's lowest node; null where all is fluid.
    const std::uint8_t* data() const { return state_.empty() ? nullptr : state_.data(); }

  private:
    std::vector<std::uint8_t> state_; ///< indexed by the cell's lowest node
};

/// Where a point falls in the grid: lowest node of its cell and the fractions in it. Outside points get the nearest
/// border cell and fractions clamped to it, which continues the field constantly. NaN counts as 0.
struct CellPoint {
    std::size_t node;
    Vec3 fraction;
};

inline CellPoint locate(const UniformGrid& grid, const Vec3& p) {
    CellPoint at{0, Vec3(0.0)};
    std::size_t stride = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const double cells = grid.dimensions[static_cast<std::size_t>(axis)] - 1;
        const double x =
            std::min(std::max(0.0, (p[axis] - grid.origin[axis]) / grid.spacing[axis]), cells);
        const auto cell = static_cast<std::size_t>(std::min(x, cells - 1.0));
        at.fraction[axis] = x - static_cast<double>(cell);
        at.node += cell * stride;
        stride *= grid.dimensions[static_cast<std::size_t>(axis)];
    }
    return at;
}

/// The eight nodes of a cell in x, y, z order, and their trilinear weights.
struct Corners {
    std::size_t node[8];
    double weight[8];
};

inline Corners corners(const UniformGrid& grid, const CellPoint& at) {
    const std::size_t dx = 1;
    const std::size_t dy = grid.dimensions[0];
    const std::size_t dz = dy * grid.dimensions[1];
    const Vec3 f = at.fraction;
    const double x[2] = {1.0 - f.x, f.x};
    const double y[2] = {1.0 - f.y, f.y};
    const double z[2] = {1.0 - f.z, f.z};
    Corners result;
    for (std::size_t i = 0; i < 8; ++i) {
        const std::size_t ix = i & 1, iy = i >> 1 & 1, iz = i >> 2;
        result.node[i] = at.node + ix * dx + iy * dy + iz * dz;
        result.weight[i] = x[ix] * y[iy] * z[iz];
    }
    return result;
}

struct GridSampler {
    const UniformGrid* grid;
    const CellMask* cells;
    const SolidMask* mask;
    const float* velocity0;
    const float* velocity1; ///< null: frozen at the first
    double time0 = 0.0;
    double interval = 1.0;

    Vec3 velocity(const Vec3& p, double t) const {
        // Two components at a time, z of both time-steps together: by itself the compiler leaves them scalar.
        using Pair = double __attribute__((vector_size(16)));
        const Corners at = corners(*grid, locate(*grid, p));
        const float* other = velocity1 ? velocity1 : velocity0;
        Pair xy0{}, xy1{}, z{};
        for (std::size_t i = 0; i < 8; ++i) {
            const float* now = velocity0 + 3 * at.node[i];
            const float* then = other + 3 * at.node[i];
            xy0 += at.weight[i] * Pair{now[0], now[1]};
            xy1 += at.weight[i] * Pair{then[0], then[1]};
            z += at.weight[i] * Pair{now[2], then[2]};
        }
        const Vec3 v0(xy0[0], xy0[1], z[0]);
        if (!velocity1)
            return v0;
        return v0 + (t - time0) / interval * (Vec3(xy1[0], xy1[1], z[1]) - v0);
    }

    /// (grad v) w: the exact derivative of the trilinear field within its cell.
    Vec3 derivative(const Vec3& p, double t, const Vec3& w) const {
        return derivatives(p, t, {&w, 1})[0];
    }

    /// Of one or two vectors `w`: they share the slopes.
    std::array<Vec3, 2> derivatives(const Vec3& p, double t, std::span<const Vec3> w) const {
        const CellPoint at = locate(*grid, p);
        const Slopes now = slopes(velocity0, at);
        const Slopes then = velocity1 ? slopes(velocity1, at) : now;
        std::array<Vec3, 2> result{};
        for (std::size_t i = 0; i < w.size(); ++i) {
            const Vec3 step = w[i] / grid->spacing;
            result[i] = along(now, step);
            if (velocity1)
                result[i] += (t - time0) / interval * (along(then, step) - result[i]);
        }
        return result;
    }

    PointStatus status(const Vec3& p) const {
        if (!grid->bounds().contains(p))
            return PointStatus::OutsideDomain;
        const CellPoint cell = locate(*grid, p);
        switch (cells->state(cell.node)) {
        case CellMask::Fluid:
            return PointStatus::Inside;
        case CellMask::Solid:
            return PointStatus::InObstacle;
        case CellMask::Mixed:
            break;
        }
        const Corners at = corners(*grid, cell);
        double fluid = 0.0;
        for (int i = 0; i < 8; ++i)
            fluid += at.weight[i] * mask->fluid[at.node[i]];
        return fluid < 0.5 ? PointStatus::InObstacle : PointStatus::Inside;
    }

  private:
    /// Change of the velocity across the cell along each axis.
    using Slopes = std::array<Vec3, 3>;

    Slopes slopes(const float* velocity, const CellPoint& at) const {
        const Corners corner = corners(*grid, at);
        const Vec3 part[2] = {1.0 - at.fraction, at.fraction};
        Slopes result;
        for (int axis = 0; axis < 3; ++axis) {
            const int first = axis == 0 ? 1 : 0;
            const int second = axis == 2 ? 1 : 2;
            Vec3 low(0.0), high(0.0);
            for (std::size_t i = 0; i < 8; ++i) {
                const std::size_t bit = std::size_t{1} << axis;
                if (i & bit)
                    continue;
                const double weight = part[i >> first & 1][first] * part[i >> second & 1][second];
                const float* v = velocity + 3 * corner.node[i];
                const float* beyond = velocity + 3 * corner.node[i | bit];
                low += weight * Vec3(v[0], v[1], v[2]);
                high += weight * Vec3(beyond[0], beyond[1], beyond[2]);
            }
            result[static_cast<std::size_t>(axis)] = high - low;
        }
        return result;
    }

    static Vec3 along(const Slopes& slopes, const Vec3& step) {
        return step.x * slopes[0] + step.y * slopes[1] + step.z * slopes[2];
    }
};

} // namespace wakesurf::core
