// Trilinear in space, linear in time: the stored field between its nodes, on a uniform or a rectilinear grid.
// A pair of time-steps, or one for a frozen field. Mirrors what vtkProbeFilter returns on image data and
// rectilinear grids.
#pragma once

#include "core/base/components.hpp"
#include "core/base/node_shares.hpp"
#include "core/base/point_status.hpp"
#include "core/dataset/missing_bricks.hpp"
#include "core/field/cell_mask.hpp"
#include "core/field/uniform_axes.hpp"
#include "core/integrate/at_rest.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace wakesurf::core {

/// The place of a point in the grid. Outside points get the nearest border cell and fractions clamped to it,
/// which continues the field constantly. NaN counts as the lower border.
struct CellPoint {
    std::size_t node; ///< the cell's lowest
    Vec3 fraction;
    std::array<std::size_t, 3> cell;
};

template <class Grid>
CellPoint locate(const Grid& grid, const Vec3& p) {
    CellPoint at{0, Vec3(0.0), {}};
    std::size_t stride = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const AxisPoint found = along(grid, axis, p[static_cast<int>(axis)]);
        at.fraction[static_cast<int>(axis)] = found.fraction;
        at.cell[axis] = found.cell;
        at.node += found.cell * stride;
        stride *= dimensions(grid)[axis];
    }
    return at;
}

/// The distance in memory between neighbours in y and z, in nodes.
struct Strides {
    std::size_t row;
    std::size_t slice;
};

template <class Grid>
Strides strides(const Grid& grid) {
    const std::size_t row = dimensions(grid)[0];
    return {row, row * dimensions(grid)[1]};
}

/// Returns the eight nodes of a cell in x, y, z order.
inline std::array<std::size_t, 8> cell_nodes(const Strides& stride, std::size_t first) {
    std::array<std::size_t, 8> node;
    for (std::size_t i = 0; i < 8; ++i)
        node[i] = first + (i & 1) + (i >> 1 & 1) * stride.row + (i >> 2) * stride.slice;
    return node;
}

/// The eight nodes and their trilinear weights.
struct Corners {
    std::array<std::size_t, 8> node;
    double weight[8];
};

inline Corners corners(const Strides& stride, const CellPoint& at) {
    const Vec3 f = at.fraction;
    const double x[2] = {1.0 - f.x, f.x};
    const double y[2] = {1.0 - f.y, f.y};
    const double z[2] = {1.0 - f.z, f.z};
    Corners result;
    result.node = cell_nodes(stride, at.node);
    for (std::size_t i = 0; i < 8; ++i)
        result.weight[i] = x[i & 1] * y[i >> 1 & 1] * z[i >> 2];
    return result;
}

/// @tparam Grid  UniformGrid or RectilinearAxes
template <class Grid>
struct GridSampler {
    const Grid* grid;
    const CellMask* cells;
    const SolidMask* mask;
    StepNodes velocity0;
    StepNodes velocity1; ///< none: frozen at the first
    double time0 = 0.0;
    double interval = 1.0;
    /// True if some velocities are not finite: cells with such a node are outside the domain.
    bool gaps = false;
    const BrickLayout* layout = nullptr; ///< null: time-steps are in one piece
    BrickMisses misses{};                ///< of this copy, where they are in bricks

    // Implements PagedField.
    bool missed() const { return misses.any(); }

    bool take_missed() const { return misses.take(); }

    MissingBricks* missing() const { return misses.all(); }

    /// Notes what a batch that is sampled for the view was missing.
    void note_missing(std::size_t brick) const { misses.want(brick); }

    /// Returns a finite velocity everywhere: in a cell with a gap the other nodes' values go on into it, so
    /// that a step that leads there can be followed up to the cell's face.
    Vec3 velocity(const Vec3& p, double t) const {
        const Around around = look_up(p);
        Vec3 v;
        if (velocity1) {
            const auto [first, second] = around.ends();
            v = first + (t - time0) / interval * (second - first);
        } else {
            v = around.alone();
        }
        return gaps && !finite(v) ? beside_gaps(around, t) : v;
    }

    /// Returns the velocities at the times of both time-steps.
    std::array<Vec3, 2> ends(const Vec3& p) const {
        const Around around = look_up(p);
        const auto both = around.ends();
        return gaps && !(finite(both[0]) && finite(both[1]))
                   ? std::array{beside_gaps(around, time0), beside_gaps(around, time0 + interval)}
                   : both;
    }

    /// Returns (grad v) w, the exact derivative of the trilinear field within its cell; 0 in a cell with a
    /// gap.
    Vec3 derivative(const Vec3& p, double t, const Vec3& w) const { return gradient(p, t)(w); }

    /// Returns (grad v) w as a function of w, valid for as long as the field.
    auto gradient(const Vec3& p, double t) const {
        const CellPoint at = locate(*grid, p);
        const StoredCell stored = stored_cell(at.cell, at.node);
        const Slopes now = slopes(at_first(velocity0, stored), stored.strides, at.fraction);
        const Slopes then =
            velocity1 ? slopes(at_first(velocity1, stored), stored.strides, at.fraction) : now;
        return [this, t, now, then, size = cell_size(*grid, at.cell)](const Vec3& w) {
            const Vec3 step = w / size;
            Vec3 result = sum(now, step);
            if (velocity1)
                result += (t - time0) / interval * (sum(then, step) - result);
            return gaps && !finite(result) ? Vec3(0.0) : result;
        };
    }

    NodeShares shares(const Vec3& p) const {
        NodeShares shares;
        shares.status = status(p);
        if (shares.status != PointStatus::Inside)
            return shares;
        const Corners at = corners(strides(*grid), locate(*grid, p));
        shares.count = at.node.size();
        for (std::size_t i = 0; i < shares.count; ++i) {
            shares.node[i] = at.node[i];
            shares.share[i] = at.weight[i];
        }
        return shares;
    }

    PointStatus status(const Vec3& p) const {
        if (!grid->bounds().contains(p))
            return PointStatus::OutsideDomain;
        const CellPoint cell = locate(*grid, p);
        const CellMask::State state = cells->state(cell.cell, cell.node);
        if (state == CellMask::Solid)
            return PointStatus::InObstacle;
        if (gaps && gap(cell.cell))
            return PointStatus::OutsideDomain;
        return state == CellMask::Fluid || fluid_share(cell) >= 0.5 ? PointStatus::Inside
                                                                    : PointStatus::InObstacle;
    }

    /// Returns 1 in the fluid, falling to 0 from there to a solid cell, 0 where there is no velocity.
    double open_share(const Vec3& p) const {
        if (!grid->bounds().contains(p))
            return 0.0;
        const CellPoint cell = locate(*grid, p);
        const CellMask::State state = cells->state(cell.cell, cell.node);
        if (state == CellMask::Solid || (gaps && gap(cell.cell)))
            return 0.0;
        return state == CellMask::Fluid ? 1.0 : fluid_share(cell);
    }

    /// Returns false where open_share() is 1 in all of the domain.
    bool bounded() const { return gaps || !mask->empty(); }

    /// Implements FieldOfTimeSteps.
    bool stands_still() const { return !velocity1; }

    /// Implements FieldWithWalls::at_wall. The wall lies between solid nodes and those next to them; where
    /// the data hold the fluid at the latter, a particle gets no farther.
    bool at_wall(const Vec3& p) const {
        if (mask->empty())
            return false;
        const CellPoint cell = locate(*grid, p);
        const Corners at = corners(strides(*grid), cell);
        double share = 0.0;
        for (std::size_t i = 0; i < 8; ++i)
            if (beside_solid(
                    {cell.cell[0] + (i & 1), cell.cell[1] + (i >> 1 & 1), cell.cell[2] + (i >> 2)}))
                share += at.weight[i];
        return share >= 1.0 - near_wall;
    }

    /// Implements FieldOfCells, with the cells around: between solid nodes and those beside them all is at
    /// rest.
    double cell_speed(const Vec3& p, double t) const {
        const std::array<std::size_t, 3> here = locate(*grid, p).cell;
        std::array<std::size_t, 3> cell{};
        double fastest = 0.0;
        const auto around = [&](std::size_t axis) {
            const std::size_t cells = dimensions(*grid)[axis] - 1;
            return std::pair(here[axis] - std::min<std::size_t>(here[axis], 1),
                             std::min(here[axis] + 2, cells));
        };
        const auto [x0, x1] = around(0);
        const auto [y0, y1] = around(1);
        const auto [z0, z1] = around(2);
        for (cell[2] = z0; cell[2] < z1; ++cell[2])
            for (cell[1] = y0; cell[1] < y1; ++cell[1])
                for (cell[0] = x0; cell[0] < x1; ++cell[0])
                    fastest = std::max(fastest, fastest_node(cell, t));
        return fastest;
    }

    /// True where a node of the cell has a velocity that is not finite in either time-step.
    bool gap(const std::array<std::size_t, 3>& cell) const {
        const StoredCell stored = stored_cell(cell, first_node(cell));
        const float* const first = at_first(velocity0, stored);
        const float* const second = velocity1 ? at_first(velocity1, stored) : first;
        float zero = 0.0f; // a product with what is not finite is NaN
        for (const std::size_t node : cell_nodes(stored.strides, 0))
            for (std::size_t i = 3 * node; i < 3 * node + 3; ++i)
                zero += 0.0f * first[i] + 0.0f * second[i];
        return zero != 0.0f;
    }

    /// The place of a cell's values in a time-step: its lowest node, and from there.
    struct StoredCell {
        std::size_t brick;
        std::size_t node; ///< in the brick
        Strides strides;
    };

    StoredCell stored_cell(const std::array<std::size_t, 3>& cell, std::size_t grid_node) const {
        if (layout == nullptr)
            return {0, grid_node, core::strides(*grid)};
        const std::size_t within = layout->cells() - 1;
        const std::size_t row = layout->brick_nodes()[0];
        const Strides stride{row, row * layout->brick_nodes()[1]};
        return {layout->brick_of(cell),
                (cell[0] & within) + stride.row * (cell[1] & within) +
                    stride.slice * (cell[2] & within),
                stride};
    }

    /// Returns the velocity of the cell's lowest node.
    const float* at_first(const StepNodes& step, const StoredCell& cell) const {
        if (step.bricks == nullptr)
            return step.whole + 3 * cell.node;
        const float* brick = step.bricks->at(cell.brick);
        if (brick == nullptr)
            brick = misses.note(cell.brick);
        else
            step.bricks->use(cell.brick, misses.age());
        return brick + 3 * cell.node;
    }

    std::size_t first_node(const std::array<std::size_t, 3>& cell) const {
        const Strides stride = strides(*grid);
        return cell[0] + stride.row * cell[1] + stride.slice * cell[2];
    }

  private:
    /// The values round a point.
    struct Around {
        Corners at;
        const float* first;
        const float* second;

        std::array<Vec3, 2> ends() const {
            // Two components at a time, z of both time-steps together: by itself the compiler leaves them scalar.
            using Pair = double __attribute__((vector_size(16)));
            Pair xy0{}, xy1{}, z{};
            for (std::size_t i = 0; i < 8; ++i) {
                const float* now = first + 3 * at.node[i];
                const float* then = second + 3 * at.node[i];
                xy0 += at.weight[i] * Pair{now[0], now[1]};
                xy1 += at.weight[i] * Pair{then[0], then[1]};
                z += at.weight[i] * Pair{now[2], then[2]};
            }
            return {Vec3(xy0[0], xy0[1], z[0]), Vec3(xy1[0], xy1[1], z[1])};
        }

        Vec3 alone() const {
            Components v;
            for (std::size_t i = 0; i < 8; ++i) {
                const float* now = first + 3 * at.node[i];
                v.xy += at.weight[i] * Components::Pair{now[0], now[1]};
                v.z += at.weight[i] * Components::Pair{now[2], 0.0};
            }
            return v.vector();
        }
    };

    Around look_up(const Vec3& p) const {
        const CellPoint cell = locate(*grid, p);
        const StoredCell stored = stored_cell(cell.cell, cell.node);
        const float* const first = at_first(velocity0, stored);
        return {corners(stored.strides, {0, cell.fraction, {}}), first,
                velocity1 ? at_first(velocity1, stored) : first};
    }

    /// Returns the share of fluid nodes at a point of a cell.
    double fluid_share(const CellPoint& cell) const {
        const Corners at = corners(strides(*grid), cell);
        double fluid = 0.0;
        for (std::size_t i = 0; i < 8; ++i)
            if (mask->is_fluid(
                    {cell.cell[0] + (i & 1), cell.cell[1] + (i >> 1 & 1), cell.cell[2] + (i >> 2)},
                    at.node[i]))
                fluid += at.weight[i];
        return fluid;
    }

    double fastest_node(const std::array<std::size_t, 3>& cell, double t) const {
        const StoredCell stored = stored_cell(cell, first_node(cell));
        const float* const first = at_first(velocity0, stored);
        const float* const second = velocity1 ? at_first(velocity1, stored) : first;
        double fastest = 0.0;
        for (const std::size_t node : cell_nodes(stored.strides, 0)) {
            const float* now = first + 3 * node;
            const float* then = second + 3 * node;
            Vec3 v(now[0], now[1], now[2]);
            v += (t - time0) / interval * (Vec3(then[0], then[1], then[2]) - v);
            fastest = std::max(fastest, glm::length(v));
        }
        return fastest;
    }

    /// True for a node that shares a cell with a solid one, or is one.
    bool beside_solid(const std::array<std::size_t, 3>& node) const {
        for (std::size_t i = 0; i < 8; ++i) {
            const std::array<std::size_t, 3> back{i & 1, i >> 1 & 1, i >> 2};
            std::array<std::size_t, 3> cell{};
            bool there = true;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                there = there && node[axis] >= back[axis] &&
                        node[axis] - back[axis] + 1 < dimensions(*grid)[axis];
                cell[axis] = node[axis] - back[axis];
            }
            if (there && cells->state(cell, first_node(cell)) != CellMask::Fluid)
                return true;
        }
        return false;
    }

    /// The change of the velocity across the cell along each axis.
    using Slopes = std::array<Vec3, 3>;

    static Slopes slopes(const float* velocity, const Strides& stride, const Vec3& fraction) {
        const auto node = cell_nodes(stride, 0);
        const Vec3 part[2] = {1.0 - fraction, fraction};
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
                const float* v = velocity + 3 * node[i];
                const float* beyond = velocity + 3 * node[i | bit];
                low += weight * Vec3(v[0], v[1], v[2]);
                high += weight * Vec3(beyond[0], beyond[1], beyond[2]);
            }
            result[static_cast<std::size_t>(axis)] = high - low;
        }
        return result;
    }

    static Vec3 sum(const Slopes& slopes, const Vec3& step) {
        return step.x * slopes[0] + step.y * slopes[1] + step.z * slopes[2];
    }

    /// Mean of the nodes that have a velocity, by their weights: meets the trilinear field at faces without a
    /// gap.
    Vec3 beside_gaps(const Around& around, double t) const {
        const auto& [at, first, second] = around;
        Vec3 total(0.0);
        double weights = 0.0;
        for (std::size_t i = 0; i < 8; ++i) {
            const float* now = first + 3 * at.node[i];
            Vec3 v(now[0], now[1], now[2]);
            if (velocity1) {
                const float* then = second + 3 * at.node[i];
                v += (t - time0) / interval * (Vec3(then[0], then[1], then[2]) - v);
            }
            if (!finite(v))
                continue;
            const double weight = at.weight[i] + 1e-9; // where all the others weigh nothing
            total += weight * v;
            weights += weight;
        }
        return weights > 0.0 ? total / weights : Vec3(0.0);
    }
};

} // namespace wakesurf::core
