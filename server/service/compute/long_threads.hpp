// Threads for jobs that take long: each job's parallel loops use all cores, at a lower priority than the threads that answer a person. Which job is
// next: long_lanes. A job that waits for data holds no thread: another is started in its place.
#pragma once

#include "core/base/blocking_wait.hpp"
#include "core/base/event_count.hpp"
#include "core/base/mpsc_queue.hpp"
#include "server/service/compute/long_lanes.hpp"

#include <oneapi/tbb/global_control.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace wakesurf::server {

/// Thread safety: run() may be called from any thread. The destructor waits for all jobs.
class LongThreads final : private core::BlockingWait::Listener {
  public:
    /// @param cores  that the loops of all jobs use together
    explicit LongThreads(unsigned cores);
    ~LongThreads();
    LongThreads(const LongThreads&) = delete;
    LongThreads& operator=(const LongThreads&) = delete;

    /// Waits for no other thread. @param session  empty: the job belongs to none, and has turns like a session of its own
    void run(const std::string& session, FairQueue::Job job);

    /// Threads in the place of others that wait, at most.
    static constexpr std::size_t most_more = 64;

  private:
    struct Arrived {
        std::string session;
        FairQueue::Job job;
    };

    core::EventCount& event(LongLanes::Lane lane) {
        return events_[static_cast<std::size_t>(lane)];
    }

    void blocks() override;
    void goes_on() override;
    void ring();
    void sort();
    void serve(LongLanes::Lane lane);

    unsigned cores_;
    oneapi::tbb::global_control allowed_;
    core::MpscQueue<Arrived> arrived_;
    std::array<core::EventCount, 2> events_; ///< by lane
    std::atomic<bool> ending_{false};
    std::mutex mutex_; ///< guards what follows, until `ending_`
    LongLanes lanes_;
    std::size_t blocked_ = 0; ///< threads whose jobs wait for data
    std::vector<std::jthread> threads_;
    std::size_t least_ = 0; ///< of them should be there for other jobs
};

} // namespace wakesurf::server
