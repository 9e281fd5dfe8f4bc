// The threads of one priority class. Each job holds a permit while it runs, so that few jobs share the
// processors. A job that waits for data, or runs for longer than was expected, returns its permit early:
// another thread takes it, and no job waits for that one.
#pragma once

#include "core/base/blocking_wait.hpp"
#include "core/base/event_count.hpp"
#include "core/base/mpsc_queue.hpp"
#include "server/live/compute/fair_queue.hpp"

#include <atomic>
#include <chrono>
#include <cstddef>
#include <list>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace wakesurf::server {

/// The niceness of threads that work for long: beside one that answers a client they get a tenth of its time.
constexpr int long_niceness = 10;

/// Returns the number that the system gives the calling thread.
int own_thread_id();

/// Lowers the priority of a thread for good. Where the kernel refuses, all threads have the same.
/// @param thread  one of this process; 0: the calling one
void step_back(int niceness, int thread = 0);

/// The calling thread works for moments and is waited for: it begins sooner beside threads that work for
/// long, and has no more of the processor for it. Linux 6.12 and later; elsewhere nothing changes.
/// (sched(7), sched_setattr(2): sched_runtime of SCHED_OTHER)
void ask_for_short_slices();

/// Returns the processor time of the calling thread, in s.
double processor_seconds();

/// Returns that of another thread; 0 once it has ended. REQUIRES: it is not joined meanwhile.
double processor_seconds(std::thread::native_handle_type thread);

/// Thread safety: run() may be called from any thread. The destructor waits for all jobs.
class WorkerThreads {
  public:
    struct Rules {
        std::size_t
            permits; ///< jobs that run at a time; at least 2, since one session never has all
        std::size_t most_threads; ///< with those whose jobs have returned their permits
        /// A session's next job waits for the end of the one before, also where that has returned its permit.
        bool one_a_session;
        int niceness; ///< added to that of the process
        /// A job returns its permit after this time, and its thread takes long_niceness once it has used
        /// `fair_seconds` of a processor.
        std::chrono::milliseconds patience;
        /// Threads that the parallel loops of a job use, its own included.
        unsigned loop_threads;
    };

    static constexpr double fair_seconds = 0.02;

    explicit WorkerThreads(const Rules& rules);
    ~WorkerThreads();
    WorkerThreads(const WorkerThreads&) = delete;
    WorkerThreads& operator=(const WorkerThreads&) = delete;

    /// Queues a job and waits for no other thread. The job must not throw. Its session is charged for the
    /// time that it holds its permit.
    void run(const std::string& session, FairQueue::Job job);

  private:
    using Clock = std::chrono::steady_clock;

    struct Worker final : core::BlockingWait::Listener {
        explicit Worker(WorkerThreads& of) : pool(of) {}

        void blocks() override { pool.blocked(*this); }

        void goes_on() override {}

        WorkerThreads& pool;
        std::optional<Clock::time_point> since; ///< when its job began
        std::string session;                    ///< the job's
        double seconds_before = 0.0;            ///< of a processor, that it had had then
        double served = 0.0;                    ///< s that its job held the permit
        bool has_permit = false, stepped_back = false, ended = false;
        int id = 0; ///< the system's
        std::jthread thread;
    };

    struct Arrived {
        std::string session;
        FairQueue::Job job;
    };

    void serve(Worker& self);
    void blocked(Worker& worker);
    void keep();

    // With the lock.
    void start();
    void sort();
    std::optional<FairQueue::Turn> begin(Worker& self);
    void end(Worker& self);
    void take_permit(Worker& worker);
    void return_permit(Worker& worker);
    bool supervise(Worker& worker);

    const Rules rules_;
    core::MpscQueue<Arrived> arrived_;
    core::EventCount event_, keepers_event_;
    std::mutex mutex_; ///< guards what follows
    FairQueue queue_;
    std::list<Worker> workers_;
    std::size_t free_;        ///< permits
    std::size_t threads_ = 0; ///< that serve
    std::size_t lenders_ = 0; ///< of them, those whose job has returned its permit
    bool ending_ = false, keeper_sleeps_ = false;
    std::jthread keeper_;
};

} // namespace wakesurf::server
