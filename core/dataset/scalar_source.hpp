// Where sampling gets the values of a stored scalar from: a store's reader, or a test's own series. Beside
// core/dataset/time_step_source.hpp on the path.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/slab.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace wakesurf::core {

/// Reads scalars. Thread safety: concurrent calls are allowed.
class ScalarSource {
  public:
    virtual ~ScalarSource() = default;

    /// Returns the times of all time-steps, strictly increasing.
    virtual const std::vector<double>& times() const = 0;

    /// Returns the BrickRead::field of the scalar, if the source has its bricks beside those of the velocity;
    /// nothing if it is had whole.
    virtual std::optional<std::size_t> brick_field(std::size_t /*scalar*/) const { return {}; }

    /// Returns one float a node, of a scalar at a time-step. Error: NotFound (not written yet), Corrupt, Io,
    /// Cancelled.
    virtual Result<std::shared_ptr<const Slab>>
    scalar_values(std::size_t scalar, std::size_t step, const std::stop_token& stop) const = 0;
};

} // namespace wakesurf::core
