#include "core/field/stored_pair.hpp"

namespace wakesurf::core {

namespace {

void fill(double (&to)[3], const Vec3& v) {
    for (int axis = 0; axis < 3; ++axis)
        to[axis] = v[axis];
}

StoredBricks bricks_of(const StepNodes& step) {
    return step.bricks != nullptr ? StoredBricks{step.bricks->pointers(), step.bricks->ages()}
                                  : StoredBricks{};
}

StoredStates states_of(const CellMask& mask) {
    return {mask.whole(), mask.bricks() != nullptr ? mask.bricks()->pointers() : nullptr};
}

BrickPlaces places_in(const BrickLayout& layout) {
    BrickPlaces places{};
    places.cells = layout.cells();
    places.per_cell = 1.0 / places.cells;
    const auto& bricks = layout.bricks();
    const auto& nodes = layout.brick_nodes();
    fill(places.brick, Vec3(1.0, bricks[0], 1.0 * bricks[0] * bricks[1]));
    fill(places.node, Vec3(1.0, nodes[0], 1.0 * nodes[0] * nodes[1]));
    return places;
}

/// Sets what does not depend on where the nodes are.
template <class Grid>
StoredPair pair_on(const GridSampler<Grid>& field, const AdvanceOptions& options) {
    StoredPair pair{};
    pair.velocity0 = field.velocity0.whole;
    pair.velocity1 = field.velocity1.whole;
    pair.cell = states_of(*field.cells);
    if (const BrickBytes* states = field.cells->bricks())
        pair.places = places_in(states->layout());
    pair.in_bricks = field.layout != nullptr;
    if (pair.in_bricks) {
        pair.bricks0 = bricks_of(field.velocity0);
        pair.bricks1 = bricks_of(field.velocity1);
        pair.places = places_in(*field.layout);
        pair.places.zeros = field.missing()->zeros();
        pair.places.age = field.missing()->age();
    }
    pair.time0 = field.time0;
    pair.per_interval = 1.0 / field.interval;
    const auto& nodes = dimensions(*field.grid);
    const Vec3 last(nodes[0] - 1, nodes[1] - 1, nodes[2] - 1);
    const Box box = field.grid->bounds();
    fill(pair.last, last);
    fill(pair.last_cell, last - 1.0);
    fill(pair.low, box.lo);
    fill(pair.high, box.hi);
    fill(pair.stride, Vec3(1.0, last.x + 1.0, (last.x + 1.0) * (last.y + 1.0)));
    // The threshold is a little more than the limit: near it, the step in double decides.
    const double speed = 1.00001 * options.stagnation_speed;
    pair.stagnation2 = static_cast<float>(speed * speed);
    return pair;
}

} // namespace

StoredPair stored_pair(const GridSampler<UniformGrid>& field, const AdvanceOptions& options) {
    StoredPair pair = pair_on(field, options);
    fill(pair.origin, field.grid->origin);
    fill(pair.per_spacing, 1.0 / field.grid->spacing);
    return pair;
}

StoredPair stored_pair(const GridSampler<RectilinearAxes>& field, const AdvanceOptions& options) {
    StoredPair pair = pair_on(field, options);
    fill(pair.per_spacing, Vec3(1.0));
    pair.axis = field.grid->tables();
    return pair;
}

StoredPair stored_pair(const CubicSampler& field, const AdvanceOptions& options) {
    StoredPair pair = stored_pair(field.linear, options);
    pair.smooth = true;
    const StepNodes& before = field.before ? field.before : field.linear.velocity0;
    const StepNodes& after = field.after ? field.after : field.linear.velocity0;
    pair.before = before.whole;
    pair.after = after.whole;
    pair.bricks_before = bricks_of(before);
    pair.bricks_after = bricks_of(after);
    if (field.round_cells != nullptr)
        pair.near_solid = states_of(*field.round_cells);
    return pair;
}

} // namespace wakesurf::core
