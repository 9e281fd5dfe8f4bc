// Smooth sampling of stored data: tricubic in space and cubic in time, Catmull-Rom in both, which makes
// velocity continuously differentiable between obstacles. Source: Catmull, Rom, A Class of Local
// Interpolating Splines, 1974.
#pragma once

#include "core/field/cubic_time_shares.hpp"
#include "core/field/grid_sampler.hpp"

#include <array>

namespace wakesurf::core {

/// Shares of four neighbouring nodes in the value between the middle two, and in its slope along the axis.
struct CubicWeights {
    std::array<double, 4> value;
    std::array<double, 4> slope;

    /// @param f  0 at the second node, 1 at the third
    static CubicWeights catmull_rom(double f) {
        return {{f * (-0.5 + f * (1.0 - 0.5 * f)), 1.0 + f * f * (-2.5 + 1.5 * f),
                 f * (0.5 + f * (2.0 - 1.5 * f)), f * f * (-0.5 + 0.5 * f)},
                {-0.5 + f * (2.0 - 1.5 * f), f * (-5.0 + 4.5 * f), 0.5 + f * (4.0 - 4.5 * f),
                 f * (-1.0 + 1.5 * f)}};
    }

    static CubicWeights linear(double f) { return {{0.0, 1.0 - f, f, 0.0}, {0.0, -1.0, 1.0, 0.0}}; }

    /// Extrapolates beyond the border: the missing node is twice its neighbour less the next.
    void miss(std::size_t node) {
        const std::size_t near = node == 0 ? 1 : 2;
        const std::size_t far = 3 - near;
        for (std::array<double, 4>* weights : {&value, &slope}) {
            (*weights)[near] += 2.0 * (*weights)[node];
            (*weights)[far] -= (*weights)[node];
            (*weights)[node] = 0.0;
        }
    }
};

/// Cells whose 4^3 nodes touch a solid one are trilinear in space: a cubic would overshoot at the wall. Where
/// one of them has no velocity at one of the four times, the field is linear in space and time.
struct CubicSampler {
    GridSampler<UniformGrid> linear; ///< over the two middle time-steps
    StepNodes before{};              ///< the time-steps round them; none at the ends of the series
    StepNodes after{};
    double time_before = 0.0;
    double time_after = 0.0;
    bool gaps = false;                     ///< some velocities of the four are not finite
    const CellMask* round_cells = nullptr; ///< CellMask::round_cells; null: found out at each point

    Vec3 velocity(const Vec3& p, double t) const {
        const Stencil at = stencil(p);
        if (gaps && touches_gap(at))
            return linear.velocity(p, t);
        const std::array<double, 4> share = shares(t);
        return sum(at, share, [&](std::size_t y, std::size_t z, const Vec3& value, const Vec3&) {
            return at.weights[1].value[y] * at.weights[2].value[z] * value;
        });
    }

    /// Returns (grad v) w, exactly.
    Vec3 derivative(const Vec3& p, double t, const Vec3& w) const {
        const Stencil at = stencil(p);
        if (gaps && touches_gap(at))
            return linear.derivative(p, t, w);
        const std::array<double, 4> share = shares(t);
        const Vec3 step = w / linear.grid->spacing;
        const CubicWeights& in_y = at.weights[1];
        const CubicWeights& in_z = at.weights[2];
        return sum(at, share,
                   [&](std::size_t y, std::size_t z, const Vec3& value, const Vec3& slope) {
                       const double across = step.y * in_y.slope[y] * in_z.value[z] +
                                             step.z * in_y.value[y] * in_z.slope[z];
                       return step.x * in_y.value[y] * in_z.value[z] * slope + across * value;
                   });
    }

    // Implements PagedField.
    bool missed() const { return linear.missed(); }

    bool take_missed() const { return linear.take_missed(); }

    MissingBricks* missing() const { return linear.missing(); }

    void note_missing(std::size_t brick) const { linear.note_missing(brick); }

    PointStatus status(const Vec3& p) const { return linear.status(p); }

    bool stands_still() const { return linear.stands_still(); }

    bool at_wall(const Vec3& p) const { return linear.at_wall(p); }

    double cell_speed(const Vec3& p, double t) const { return linear.cell_speed(p, t); }

    /// Returns the weights of the four time-steps.
    std::array<double, 4> shares(double t) const {
        if (!linear.velocity1)
            return {0.0, 1.0, 0.0, 0.0};
        return cubic_time_shares(
            {time_before, linear.time0, linear.time0 + linear.interval, time_after},
            static_cast<bool>(before), static_cast<bool>(after), t);
    }

  private:
    /// The nodes round a point: cell - 1 .. cell + 2 on each axis, as far as they exist.
    struct Stencil {
        std::array<CubicWeights, 3> weights;
        std::array<std::size_t, 3> cell;
        std::array<std::size_t, 3> begin; ///< of the four
        std::array<std::size_t, 3> end;

        std::size_t
        node(const UniformGrid& grid, std::size_t x, std::size_t y, std::size_t z) const {
            const std::size_t row = (cell[2] + z - 1) * grid.dimensions[1] + cell[1] + y - 1;
            return row * grid.dimensions[0] + cell[0] + x - 1;
        }

        /// Bricks of the four nodes on each axis, and where these are in them: what a node has is the sum of
        /// three.
        std::array<std::array<std::size_t, 4>, 3> brick;
        std::array<std::array<std::size_t, 4>, 3> in_brick;

        void find_bricks(const BrickLayout& layout) {
            std::size_t bricks = 1, nodes = 1;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const std::size_t home = cell[axis] >> layout.shift();
                for (std::size_t i = begin[axis]; i < end[axis]; ++i) {
                    const std::size_t at = cell[axis] + i - 1;
                    const bool near = at >= home << layout.shift() &&
                                      at <= (home + 1) << layout.shift(); // the cell's own brick
                    const std::size_t its = near ? home : at >> layout.shift();
                    brick[axis][i] = its * bricks;
                    in_brick[axis][i] = (at - (its << layout.shift())) * nodes;
                }
                bricks *= layout.bricks()[axis];
                nodes *= layout.brick_nodes()[axis];
            }
        }
    };

    const float* velocity_at(const StepNodes& step,
                             const Stencil& at,
                             std::size_t x,
                             std::size_t y,
                             std::size_t z) const {
        if (step.bricks == nullptr)
            return step.whole + 3 * at.node(*linear.grid, x, y, z);
        return linear.at_first(step, {at.brick[0][x] + at.brick[1][y] + at.brick[2][z],
                                      at.in_brick[0][x] + at.in_brick[1][y] + at.in_brick[2][z],
                                      {}});
    }

    Stencil stencil(const Vec3& p) const {
        const UniformGrid& grid = *linear.grid;
        const CellPoint at = locate(grid, p);
        Stencil result;
        result.cell = at.cell;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t nodes = grid.dimensions[axis];
            const std::size_t cell = at.cell[axis];
            result.begin[axis] = cell == 0 ? 1 : 0;
            result.end[axis] = cell + 2 == nodes ? 3 : 4;
        }
        if (linear.layout != nullptr)
            result.find_bricks(*linear.layout);
        const bool smooth = linear.mask->empty() || !touches_solid(result);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double f = at.fraction[static_cast<int>(axis)];
            CubicWeights& weights = result.weights[axis];
            weights = smooth ? CubicWeights::catmull_rom(f) : CubicWeights::linear(f);
            if (result.begin[axis] == 1)
                weights.miss(0);
            if (result.end[axis] == 3)
                weights.miss(3);
        }
        return result;
    }

    bool touches_solid(const Stencil& at) const {
        if (round_cells != nullptr)
            return round_cells->state(at.cell, at.node(*linear.grid, 1, 1, 1)) != CellMask::Fluid;
        for (std::size_t z = at.begin[2]; z < at.end[2]; ++z)
            for (std::size_t y = at.begin[1]; y < at.end[1]; ++y)
                for (std::size_t x = at.begin[0]; x < at.end[0]; ++x)
                    if (!linear.mask->is_fluid(
                            {at.cell[0] + x - 1, at.cell[1] + y - 1, at.cell[2] + z - 1},
                            at.node(*linear.grid, x, y, z)))
                        return true;
        return false;
    }

    bool touches_gap(const Stencil& at) const {
        float zero = 0.0f; // a product with what is not finite is NaN
        for (const StepNodes& step : steps())
            for (std::size_t z = at.begin[2]; step && z < at.end[2]; ++z)
                for (std::size_t y = at.begin[1]; y < at.end[1]; ++y)
                    for (std::size_t x = at.begin[0]; x < at.end[0]; ++x) {
                        const float* v = velocity_at(step, at, x, y, z);
                        zero += 0.0f * v[0] + 0.0f * v[1] + 0.0f * v[2];
                    }
        return zero != 0.0f;
    }

    std::array<StepNodes, 4> steps() const {
        return {before, linear.velocity0, linear.velocity1, after};
    }

    /// Adds up rows of nodes: `weigh(y, z, value, slope)` of the row's value and slope in x.
    template <class Weigh>
    Vec3 sum(const Stencil& at, const std::array<double, 4>& share, const Weigh& weigh) const {
        const std::array<StepNodes, 4> stored = steps();
        Vec3 total(0.0);
        for (std::size_t z = at.begin[2]; z < at.end[2]; ++z)
            for (std::size_t y = at.begin[1]; y < at.end[1]; ++y) {
                Vec3 value(0.0);
                Vec3 slope(0.0);
                for (std::size_t x = at.begin[0]; x < at.end[0]; ++x) {
                    Vec3 v(0.0);
                    for (std::size_t i = 0; i < 4; ++i)
                        if (stored[i]) {
                            const float* at_node = velocity_at(stored[i], at, x, y, z);
                            v += share[i] * Vec3(at_node[0], at_node[1], at_node[2]);
                        }
                    value += at.weights[0].value[x] * v;
                    slope += at.weights[0].slope[x] * v;
                }
                total += weigh(y, z, value, slope);
            }
        return total;
    }
};

} // namespace wakesurf::core
