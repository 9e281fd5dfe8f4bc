// Threads for jobs that should be over within some 15 ms, of two priorities (quick_lanes). A job that takes longer all the same keeps no one
// waiting: another thread takes the place of its own, which steps back and ends with it.
#pragma once

#include "core/base/event_count.hpp"
#include "core/base/mpsc_queue.hpp"
#include "server/service/compute/quick_lanes.hpp"

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <list>
#include <mutex>
#include <string>
#include <thread>

namespace wakesurf::server {

/// Thread safety: run() may be called from any thread. The destructor waits for all jobs.
class QuickThreads {
  public:
    /// After so long a job has had its time on a thread that others wait for.
    static constexpr std::chrono::milliseconds patience{20};
    /// Of a processor; after that its thread steps back as well.
    static constexpr double fair_seconds = 0.02;

    /// @param each  threads of either priority, at least 2
    explicit QuickThreads(unsigned each);
    ~QuickThreads();
    QuickThreads(const QuickThreads&) = delete;
    QuickThreads& operator=(const QuickThreads&) = delete;

    /// Waits for no other thread.
    void run(const std::string& session, FairQueue::Job job);

  private:
    using Clock = std::chrono::steady_clock;

    enum class Takes { Any, LightOnly };

    struct Arrived {
        std::string session;
        FairQueue::Job job;
    };

    struct Worker {
        Worker(QuickLanes::Lane of, Takes what) : lane(of), takes(what) {}

        const QuickLanes::Lane lane;
        const Takes takes;
        std::atomic<Clock::rep> since{0};        ///< when its job began; 0: it has none
        std::atomic<double> seconds_before{0.0}; ///< of a processor, that it had had then
        std::atomic<bool> replaced{false}, ended{false};
        bool stepped_back = false; ///< the keeper's
        std::atomic<int> id{0};    ///< the system's
        std::jthread thread;
    };

    core::EventCount& event(QuickLanes::Lane lane) {
        return events_[static_cast<std::size_t>(lane)];
    }

    void start(QuickLanes::Lane lane, Takes takes);
    void serve(Worker& self);
    void sort();
    void keep();
    bool look_after(Worker& worker);

    core::MpscQueue<Arrived> arrived_;
    std::array<core::EventCount, 2> events_; ///< by lane
    core::EventCount keepers_event_;
    std::atomic<bool> ending_{false}, keeper_sleeps_{false};
    std::atomic<int> upper_asleep_{0};
    std::mutex mutex_; ///< guards lanes_
    QuickLanes lanes_;
    std::list<Worker> workers_; ///< the keeper's, once it runs
    std::size_t replaced_ = 0;  ///< of them, still at work
    std::jthread keeper_;
};

} // namespace wakesurf::server
