// The scalar time-steps that were asked for last, for all who sample them: a surface that is dragged or played needs the same ones
// again and again.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/slab.hpp"

#include <cstddef>
#include <functional>
#include <list>
#include <memory>
#include <mutex>

namespace wakesurf::core {

/// Thread safety: concurrent calls are fine; who asks for one that is just being read reads it as well.
class ScalarSteps {
  public:
    using Values = std::shared_ptr<const Slab>; ///< floats, one a node

    /// @param most  kept at a time; those in use may be more
    explicit ScalarSteps(std::size_t most) : most_(most) {}

    /// Of a scalar at a time-step. Where it is not there, the one not asked for longest goes, and `read` returns it. Error: as `read`.
    Result<Values>
    get(std::size_t scalar, std::size_t step, const std::function<Result<Slab>()>& read);

    /// How many are kept.
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
