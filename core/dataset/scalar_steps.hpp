// The most recently used scalar time-steps, shared by all samplers: a surface that is dragged or played needs
// the same ones again and again.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/slab.hpp"

#include <cstddef>
#include <functional>
#include <list>
#include <memory>
#include <mutex>

namespace wakesurf::core {

/// Keeps the scalars last asked for. Thread safety: concurrent calls are fine; a caller that asks for one
/// that is just being read reads it as well.
class ScalarSteps {
  public:
    using Values = std::shared_ptr<const Slab>; ///< floats, one a node

    /// @param most  kept at a time; those in use may be more
    explicit ScalarSteps(std::size_t most) : most_(most) {}

    /// Returns a scalar at a time-step. If it is not kept, the one asked for longest ago goes, and `read`
    /// returns it. Error: that of `read`.
    Result<Values>
    get(std::size_t scalar, std::size_t step, const std::function<Result<Slab>()>& read);

    /// Returns how many are kept at most.
    std::size_t most() const { return most_; }

  private:
    struct Kept {
        std::size_t scalar, step;
        Values values;
    };

    Values find(std::size_t scalar, std::size_t step);
    void make_room();

    std::size_t most_;
    std::mutex mutex_;
    std::list<Kept> kept_; ///< newest first
};

} // namespace wakesurf::core
