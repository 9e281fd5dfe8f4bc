// Any field of a dataset at places in the flow: what is stored, and what is made of the velocity there.
#pragma once

#include "core/base/result.hpp"
#include "core/base/vec3.hpp"
#include "core/dataset/scalar_steps.hpp"
#include "core/field/flow.hpp"
#include "core/field/velocity_gradient.hpp"

#include <cstddef>
#include <span>
#include <stop_token>
#include <variant>
#include <vector>

namespace wakesurf::core {

/// The magnitude of the velocity.
struct SpeedField {};

/// The component of the velocity along a direction of length 1.
struct VelocityAlong {
    Vec3 direction;
};

/// A stored scalar.
struct StoredScalar {
    const ScalarSource* source = nullptr; ///< over the grid of the flow
    std::size_t scalar = 0;
};

using SampledField = std::variant<SpeedField, VelocityAlong, StoredScalar, GradientField>;

/// Returns the values of a field at places that are inside the flow, at one time; NaN where there is none. The velocity is
/// that of Flow::sample_at, linear in space; other fields are as sample_scalar and sample_gradient_fields have them.
/// Error: Cancelled, OutOfTime, what reading reports. Thread safety: concurrent calls are fine. Runs in parallel; the values do not
/// depend on the number of threads.
Result<std::vector<float>> sample_field(const SampledField& field,
                                        const Flow& flow,
                                        std::span<const Vec3> places,
                                        double time,
                                        const std::stop_token& stop);

} // namespace wakesurf::core
