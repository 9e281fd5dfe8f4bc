// How far a piece of work is, as a fraction: told by the threads that work, read by those who wait. And what memory it takes, told
// by the same.
#pragma once

#include "core/base/work_memory.hpp"

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

/// Part of a piece of work; a default one tells no one and may take all memory. A value.
class WorkPart {
  public:
    WorkPart() = default;

    /// The whole of it; null: no one waits; no one counts its memory.
    WorkPart(WorkDone* done, WorkMemory* memory = nullptr) : done_(done), memory_(memory) {}

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

    /// Null: no one counts.
    WorkMemory* memory() const { return memory_; }

    /// It will hold so many bytes by itself, besides what above() names. False: they are not there, and the work should end.
    bool holds(std::size_t bytes) const {
        return memory_ == nullptr || memory_->grow_to(others_ + bytes);
    }

    /// So many bytes more. False as above.
    bool takes(std::size_t bytes) const { return memory_ == nullptr || memory_->grow(bytes); }

    /// The same memory, and no one is told how far it is.
    WorkPart quietly() const {
        WorkPart out = *this;
        out.done_ = nullptr;
        return out;
    }

    /// The same part, where other parts of the work hold so many bytes.
    WorkPart above(std::size_t others) const {
        WorkPart out = *this;
        out.others_ += others;
        return out;
    }

  private:
    WorkDone* done_ = nullptr;
    WorkMemory* memory_ = nullptr;
    std::size_t others_ = 0; ///< bytes
    double from_ = 0.0;
    double share_ = 1.0;
};

} // namespace wakesurf::core
