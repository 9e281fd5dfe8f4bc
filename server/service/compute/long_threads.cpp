#include "server/service/compute/long_threads.hpp"

#include "server/service/compute/thread_priority.hpp"

#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_scheduler_observer.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace wakesurf::server {

namespace {

// Beside those that take any long job in its turn; most sleep, as few light jobs begin at a time.
constexpr unsigned light_threads = 4;
constexpr std::chrono::milliseconds settling_look{50};

/// oneTBB's workers only ever help with long jobs.
class StepBack final : public oneapi::tbb::task_scheduler_observer {
  public:
    explicit StepBack(oneapi::tbb::task_arena& arena) : task_scheduler_observer(arena) {
        observe(true);
    }

    ~StepBack() override { observe(false); }

    void on_scheduler_entry(bool) override {
        thread_local bool done = false;
        if (!std::exchange(done, true))
            step_back(long_niceness);
    }
};

} // namespace

LongThreads::LongThreads(unsigned cores)
    : cores_(cores), allowed_(oneapi::tbb::global_control::max_allowed_parallelism, cores) {
    for (unsigned i = 0; i < std::max(4u, 2 * cores); ++i)
        threads_.emplace_back([this] { serve(LongLanes::Lane::Any); });
    for (unsigned i = 0; i < light_threads; ++i)
        threads_.emplace_back([this] { serve(LongLanes::Lane::Light); });
    const std::lock_guard lock(mutex_);
    least_ = threads_.size();
}

LongThreads::~LongThreads() {
    {
        const std::lock_guard lock(mutex_);
        sort(); // before the threads may end
        ending_ = true;
    }
    for (core::EventCount& each : events_)
        each.notify_all();
    threads_.clear();
}

void LongThreads::run(const std::string& session, FairQueue::Job job) {
    arrived_.push({session, std::move(job)});
    ring();
}

/// The thread that takes its place stays: it sleeps when there is less to do.
void LongThreads::blocks() {
    const std::lock_guard lock(mutex_);
    ++blocked_;
    if (!ending_ && threads_.size() < least_ + std::min(blocked_, most_more))
        threads_.emplace_back([this] { serve(LongLanes::Lane::Any); });
}

void LongThreads::goes_on() {
    const std::lock_guard lock(mutex_);
    --blocked_;
}

void LongThreads::ring() {
    for (core::EventCount& each : events_)
        each.notify_one();
}

/// With the lock: the first thread that looks for work does it for all.
void LongThreads::sort() {
    for (Arrived& each : arrived_.take())
        if (each.session.empty())
            lanes_.push_lone(std::move(each.job));
        else
            lanes_.push(each.session, std::move(each.job));
}

void LongThreads::serve(LongLanes::Lane lane) {
    using Clock = std::chrono::steady_clock;
    // An arena a thread: while it waits for its loop's other threads it cannot take on another job.
    oneapi::tbb::task_arena arena(static_cast<int>(cores_), 1);
    arena.initialize();
    const StepBack observer(arena);
    step_back(long_niceness);
    core::BlockingWait::listen(this);
    for (;;) {
        const auto seen = event(lane).notifications();
        std::unique_lock lock(mutex_);
        sort();
        auto turn = lanes_.pop(lane, Clock::now());
        const bool others = lanes_.waiting() > 0;
        lock.unlock();
        if (!turn && ending_ && !others)
            return;
        if (!turn && others && lane == LongLanes::Lane::Light)
            event(lane).wait(seen, settling_look); // time makes it ready
        else if (!turn)
            event(lane).wait(seen);
        if (!turn)
            continue;
        const auto start = Clock::now();
        arena.execute(turn->job);
        turn->job = nullptr; // what the job holds goes before the threads may
        const auto end = Clock::now();
        lock.lock();
        lanes_.done(turn->session, std::chrono::duration<double>(end - start).count(), end);
        const bool more = lanes_.waiting() > 0;
        lock.unlock();
        if (ending_)
            for (core::EventCount& each : events_)
                each.notify_all();
        else if (more)
            ring();
    }
}

} // namespace wakesurf::server
