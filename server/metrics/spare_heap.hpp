// Memory that was freed and that the allocator still keeps: a part of what the process is seen to hold. It goes back to the system when
// others need it, and once the process rests after work. Why: docs/measurements.md, "Memory of a server in use".
#pragma once

#include <chrono>

namespace wakesurf::server {

/// Changes how the allocator works, for the whole process: it keeps less of what is freed.
void make_allocator_frugal();

/// Takes some ms, while others wait for the allocator; does nothing when it was called less than a quarter of a second ago. From any
/// thread.
void give_back_spare_heap();

/// s of processors that the process has had.
double processor_seconds();

/// When no one would notice that the spare heap is given back. Asked a few times a second.
class HeapRest {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// So long nothing is computed, and next to nothing else done.
    static constexpr std::chrono::seconds quiet_for{5};
    /// Of a processor, between two times of asking: less is next to nothing.
    static constexpr double quiet_share = 0.1;
    /// s of processors since the last time: after less there is little to give back.
    static constexpr double work = 0.5;

    /// True once after work, when it has rested.
    /// @param processors  s that the process has had of them: little where others keep it from them, too
    /// @param computing   surfaces or files are being computed now
    bool due(double processors, bool computing, Time now);

  private:
    double seen_ = 0.0; ///< processors, when last asked
    double done_ = 0.0; ///< processors, when last due
    Time asked_{};
    Time quiet_since_{};
};

} // namespace wakesurf::server
