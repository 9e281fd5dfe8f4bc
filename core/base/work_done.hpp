// The progress of a piece of work, as a fraction, and for a surface in simulation time and quads, and the
// memory it takes. The threads that work write it; those that wait read it.
#pragma once

#include "core/base/result.hpp"
#include "core/base/work_memory.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

namespace wakesurf::core {

/// The progress. It never decreases, except for the number of quads. Thread-safe.
class WorkDone {
  public:
    /// Returns the fraction that is done, 0 to 1.
    double fraction() const { return fraction_.load(std::memory_order_relaxed); }

    /// So much is done: 0 to 1; less than before is ignored.
    void reached(double fraction) {
        const double now = std::clamp(fraction, 0.0, 1.0);
        double before = fraction_.load(std::memory_order_relaxed);
        while (before < now &&
               !fraction_.compare_exchange_weak(before, now, std::memory_order_relaxed)) {
        }
    }

    /// Simulation time that a moving surface has come to, the farthest so far; nothing: there is none.
    std::optional<double> time() const {
        const double time = time_.load(std::memory_order_relaxed);
        return std::isnan(time) ? std::nullopt : std::optional(time);
    }

    /// Returns the number of quads that there are just now.
    std::uint64_t quads() const { return quads_.load(std::memory_order_relaxed); }

    /// The surface has so many quads now.
    void has(std::uint64_t quads) { quads_.store(quads, std::memory_order_relaxed); }

    /// One thread tells it.
    /// @param since  where the surface began: which way time runs for it
    void came_to(double time, double since) {
        const double before = time_.load(std::memory_order_relaxed);
        if (std::isnan(before) || std::abs(time - since) > std::abs(before - since))
            time_.store(time, std::memory_order_relaxed);
    }

  private:
    std::atomic<double> fraction_{0.0};
    std::atomic<double> time_{std::numeric_limits<double>::quiet_NaN()};
    std::atomic<std::uint64_t> quads_{0};
};

/// A part of a piece of work; a default one reports to nothing and may take all memory. A value.
class WorkPart {
  public:
    WorkPart() = default;

    /// Makes the part that is the whole of `done`. `done` null: not reported. `memory` null: not counted.
    WorkPart(WorkDone* done, WorkMemory* memory = nullptr) : done_(done), memory_(memory) {}

    /// Returns the `i`-th of `parts` equal ones of this one.
    WorkPart part(std::size_t i, std::size_t parts) const {
        const auto all = static_cast<double>(parts);
        return between(static_cast<double>(i) / all, static_cast<double>(i + 1) / all);
    }

    /// @param from,to  fractions of this part
    WorkPart between(double from, double to) const {
        WorkPart out = *this;
        out.from_ = from_ + share_ * from;
        out.share_ = share_ * (to - from);
        return out;
    }

    /// Returns the part that is not done yet, as far as known, so that work that begins again continues from
    /// there.
    WorkPart rest() const {
        WorkPart out = *this;
        if (done_ == nullptr)
            return out;
        out.from_ = std::clamp(done_->fraction(), from_, from_ + share_);
        out.share_ = from_ + share_ - out.from_;
        return out;
    }

    /// @param fraction  of this part
    void reached(double fraction) const {
        if (done_ != nullptr)
            done_->reached(from_ + share_ * std::clamp(fraction, 0.0, 1.0));
    }

    /// Calls WorkDone::has().
    void has(std::uint64_t quads) const {
        if (done_ != nullptr)
            done_->has(quads);
    }

    /// Calls WorkDone::came_to().
    void came_to(double time, double since) const {
        if (done_ != nullptr)
            done_->came_to(time, since);
    }

    /// Returns the memory counted for this work; null if it is not counted.
    WorkMemory* memory() const { return memory_; }

    /// Reserves so many bytes for the work itself, besides what above() names. Error: WorkMemory::refusal(),
    /// with which the work should end.
    Result<void> holds(std::size_t bytes) const {
        return had(memory_ == nullptr || memory_->grow_to(others_ + bytes));
    }

    /// Takes so many bytes more. Error: WorkMemory::refusal().
    Result<void> takes(std::size_t bytes) const {
        return had(memory_ == nullptr || memory_->grow(bytes));
    }

    /// Releases so many bytes of what it holds or has taken.
    void gives_back(std::size_t bytes) const {
        if (memory_ != nullptr)
            memory_->shrink(bytes);
    }

    /// Returns a part with the same memory that does not report its progress.
    WorkPart quietly() const {
        WorkPart out = *this;
        out.done_ = nullptr;
        return out;
    }

    /// Returns the same part, where other parts of the work hold so many bytes.
    WorkPart above(std::size_t others) const {
        WorkPart out = *this;
        out.others_ += others;
        return out;
    }

  private:
    Result<void> had(bool there) const {
        return there ? Result<void>{} : tl::unexpected(memory_->refusal());
    }

    WorkDone* done_ = nullptr;
    WorkMemory* memory_ = nullptr;
    std::size_t others_ = 0; ///< bytes
    double from_ = 0.0;
    double share_ = 1.0;
};

} // namespace wakesurf::core
