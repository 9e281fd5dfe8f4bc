// How far a piece of work is, as a fraction: told by the threads that work, read by whoever waits.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>

namespace wakesurf::core {

/// Never goes back. Thread safety: every call may come from any thread.
class WorkDone {
  public:
    /// 0 to 1.
    double fraction() const { return fraction_.load(std::memory_order_relaxed); }

    void reached(double fraction) {
        const double now = std::clamp(fraction, 0.0, 1.0);
        double before = fraction_.load(std::memory_order_relaxed);
        while (before < now &&
               !fraction_.compare_exchange_weak(before, now, std::memory_order_relaxed)) {
        }
    }

  private:
    std::atomic<double> fraction_{0.0};
};

/// Part of a piece of work; a default one tells nobody. A value.
class WorkPart {
  public:
    WorkPart() = default;

    /// The whole of it; null: nobody waits.
    WorkPart(WorkDone* done) : done_(done) {}

    /// The `i`-th of `parts` equal ones of this one.
    WorkPart part(std::size_t i, std::size_t parts) const {
        WorkPart out = *this;
        out.share_ = share_ / static_cast<double>(parts);
        out.from_ = from_ + out.share_ * static_cast<double>(i);
        return out;
    }

    /// @param fraction  of this part
    void reached(double fraction) const {
        if (done_ != nullptr)
            done_->reached(from_ + share_ * std::clamp(fraction, 0.0, 1.0));
    }

  private:
    WorkDone* done_ = nullptr;
    double from_ = 0.0;
    double share_ = 1.0;
};

} // namespace wakesurf::core
