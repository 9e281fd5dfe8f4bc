// Where scalar fields are read from, and the most recently used time-steps of them, shared by all samplers: a
// surface that is dragged or played needs the same ones again and again.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/slab.hpp"

#include <cstddef>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
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

/// A cache of the scalars last requested. Thread safety: concurrent calls are fine; a caller that asks for
/// one that is just being read reads it as well.
class ScalarSteps {
  public:
    using Values = std::shared_ptr<const Slab>; ///< floats, one a node

    /// @param most  held at a time; those in use may be more
    explicit ScalarSteps(std::size_t most) : most_(most) {}

    /// Returns a scalar at a time-step. If it is not in the cache, the one requested longest ago goes, and
    /// `read` returns it. Error: that of `read`.
    Result<Values>
    get(std::size_t scalar, std::size_t step, const std::function<Result<Slab>()>& read);

    /// Returns how many are held at most.
    std::size_t most() const { return most_; }

  private:
    struct Entry {
        std::size_t scalar, step;
        Values values;
    };

    Values find(std::size_t scalar, std::size_t step);
    void make_room();

    std::size_t most_;
    std::mutex mutex_;
    std::list<Entry> entries_; ///< newest first
};

} // namespace wakesurf::core
