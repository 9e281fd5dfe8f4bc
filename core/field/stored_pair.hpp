// A sampler's field as the batch kernel takes it.
#pragma once

#include "core/field/cubic_sampler.hpp"
#include "core/field/grid_sampler.hpp"
#include "core/field/kernel/rk4_batch.hpp"
#include "core/field/rectilinear_axes.hpp"
#include "core/integrate/particles.hpp"

namespace wakesurf::core {

StoredPair stored_pair(const GridSampler<UniformGrid>& field, const AdvanceOptions& options);

StoredPair stored_pair(const GridSampler<RectilinearAxes>& field, const AdvanceOptions& options);

StoredPair stored_pair(const CubicSampler& field, const AdvanceOptions& options);

/// The field at one time, which is that of the pair's time-step alone where it is a time-step's: also then
/// the same bits as from the pair that begins there.
template <class Field>
StoredPair stored_pair_at(const Field& field, const StoredPair& pair, double time) {
    const auto& steps = [&]() -> const auto& {
        if constexpr (requires { field.linear; })
            return field.linear;
        else
            return field;
    }
    ();
    StoredPair then = pair;
    if (!steps.velocity1)
        return then;
    if (time - steps.time0 == steps.interval) {
        then.velocity0 = pair.velocity1;
        then.bricks0 = pair.bricks1;
    }
    if (time == steps.time0 || time - steps.time0 == steps.interval) {
        then.velocity1 = nullptr;
        then.bricks1 = {};
    }
    return then;
}

} // namespace wakesurf::core
