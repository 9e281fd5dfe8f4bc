// The threads of one priority class. Each job holds a permit while it runs, so that few jobs share the
// processors. A job that waits for data, or runs for longer than was expected, returns its permit early:
// another thread takes it, and no job waits for that one. A part of the threads is for light sessions only
// (fair_queue).
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

/// Sets the priority of a thread beside others of the machine, and measures its processor time.
/// The niceness of threads that yield. Beside a thread that answers a client they get a third and a tenth
/// of its time.
constexpr int crowd_niceness = 5, long_niceness = 10;

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
    struct Group {
        std::size_t permits;      ///< jobs that run at a time, at least 1
        std::size_t most_threads; ///< with those whose jobs have returned their permits
        int niceness;             ///< added to that of the process
        /// A job returns its permit after this time, and its thread takes long_niceness once it has used
        /// `fair_seconds` of a processor. Empty: jobs may run for as long as they like.
        std::optional<std::chrono::milliseconds> patience;
    };

    struct Rules {
        FairQueue::Rules queue;
        Group light;
        Group any;
        /// Threads that the parallel loops of a job use, its own included.
        unsigned loop_threads;
        /// Sessions are charged for processor time, else for the time that their jobs take, waits included.
        bool charge_processor;
    };

    static constexpr double fair_seconds = 0.02;

    explicit WorkerThreads(const Rules& rules);
    ~WorkerThreads();
    WorkerThreads(const WorkerThreads&) = delete;
    WorkerThreads& operator=(const WorkerThreads&) = delete;

    /// Queues a job and waits for no other thread. The job must not throw.
    void run(const std::string& session, FairQueue::Job job);

  private:
    using Clock = std::chrono::steady_clock;

    struct Threads {
        Group rules;
        FairQueue::Takes takes;
        core::EventCount event;
        std::size_t free;        ///< permits
        std::size_t count = 0;   ///< threads
        std::size_t lenders = 0; ///< of them, those whose job has returned its permit
    };

    struct Worker final : core::BlockingWait::Listener {
        Worker(WorkerThreads& of, Threads& in) : pool(of), group(in) {}

        void blocks() override { pool.blocked(*this); }

        void goes_on() override {}

        WorkerThreads& pool;
        Threads& group;
        std::optional<Clock::time_point> since; ///< when its job began
        double seconds_before = 0.0;            ///< of a processor, that it had had then
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
    void start(Threads& group);
    void sort();
    std::optional<FairQueue::Turn> next(const Threads& group);
    void begin(Worker& self);
    void end(Worker& self, const std::string& session);
    void return_permit(Worker& worker);
    bool supervise(Worker& worker);
    void notify_others();

    const Rules rules_;
    core::MpscQueue<Arrived> arrived_;
    core::EventCount keepers_event_;
    std::atomic<int> light_asleep_{0};
    std::mutex mutex_; ///< guards what follows, but for the events
    FairQueue queue_;
    Threads light_, any_;
    std::list<Worker> workers_;
    bool ending_ = false, keeper_sleeps_ = false;
    std::jthread keeper_;
};

} // namespace wakesurf::server
