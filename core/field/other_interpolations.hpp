// The flows that one flow has been asked for with another interpolation between stored times: the same answer to
// the same question, for surfaces are kept as long as their flow is the same.
#pragma once

#include "core/field/flow.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <mutex>

namespace wakesurf::core {

/// Thread safety: concurrent calls are fine.
class OtherInterpolations {
  public:
    /// Returns what `make()` returned, as long as somebody holds it; then makes it anew.
    template <class Make>
    std::shared_ptr<const Flow> get(Between between, const Make& make) const {
        const std::scoped_lock lock(mutex_);
        std::weak_ptr<const Flow>& kept = kept_[static_cast<std::size_t>(between)];
        std::shared_ptr<const Flow> flow = kept.lock();
        if (!flow)
            kept = flow = make();
        return flow;
    }

  private:
    mutable std::mutex mutex_;
    mutable std::array<std::weak_ptr<const Flow>, 3> kept_;
};

} // namespace wakesurf::core
