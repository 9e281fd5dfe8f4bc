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

} // namespace wakesurf::core
