// The bricks that particles come to next, by large steps. A front meets one new brick at a time: with the
// next ones read ahead, a streak surface has fewer rounds of misses an interval. A hint: it changes when
// bricks are read, never the results.
#pragma once

#include "core/field/between_sampler.hpp"
#include "core/field/cubic_sampler.hpp"
#include "core/field/grid_sampler.hpp"

#include <algorithm>
#include <limits>

namespace wakesurf::core {

template <class Grid>
const GridSampler<Grid>& trilinear_part(const GridSampler<Grid>& field) {
    return field;
}

inline const GridSampler<UniformGrid>& trilinear_part(const CubicSampler& field) {
    return field.linear;
}

template <class Grid>
const GridSampler<Grid>& trilinear_part(const BetweenSampler<GridSampler<Grid>>& field) {
    return field.linear();
}

/// Asks for the bricks on the way of a particle to the end of the interval, at most two bricks far: in large
/// steps, and straight on from where its velocity is not known. REQUIRES: a view of a field in bricks.
/// @param sign    direction of time, +1 or -1
/// @param frozen  the field stays as it is at `t`, for ever
template <class Field>
void look_ahead(const Field& view, Vec3 p, double t, int sign, bool frozen = false) {
    constexpr int most_steps = 8;
    constexpr double bricks_a_step = 0.25;
    constexpr std::size_t margin = 2; // cells: a way is known about as well
    const auto& field = trilinear_part(view);
    const std::size_t cells = field.layout->cells();
    double left = frozen ? std::numeric_limits<double>::infinity()
                         : sign * (field.time0 + (sign > 0 ? field.interval : 0.0) - t);
    Vec3 v(0.0);
    for (int i = 0; i < most_steps; ++i) {
        if (const Vec3 here = field.velocity(p, t); !field.take_missed())
            v = here;
        field.misses.forget(); // no caller waits for them
        const auto cell = locate(*field.grid, p).cell;
        const Vec3 by = glm::abs(v) / cell_size(*field.grid, cell);
        const double cells_a_time = std::max({by.x, by.y, by.z});
        const double dt = std::min(bricks_a_step * static_cast<double>(cells) / cells_a_time, left);
        if (!(cells_a_time > 0.0) || !(dt > 0.0)) // NaN among them
            return;
        p += sign * dt * v;
        t += frozen ? 0.0 : sign * dt;
        left -= dt;
        if (!field.grid->bounds().contains(p))
            return;
        const auto at = locate(*field.grid, p).cell;
        std::array<std::size_t, 3> low, high;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = (at[axis] - std::min(at[axis], margin)) / cells;
            high[axis] =
                std::min<std::size_t>(at[axis] + margin, dimensions(*field.grid)[axis] - 2) / cells;
        }
        for (std::size_t z = low[2]; z <= high[2]; ++z)
            for (std::size_t y = low[1]; y <= high[1]; ++y)
                for (std::size_t x = low[0]; x <= high[0]; ++x)
                    view.missing()->look_ahead(x + field.layout->bricks()[0] *
                                                       (y + field.layout->bricks()[1] * z));
    }
}

} // namespace wakesurf::core
