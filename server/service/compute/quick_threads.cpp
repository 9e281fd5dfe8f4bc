#include "server/service/compute/quick_threads.hpp"

#include "server/service/compute/thread_priority.hpp"

#include <oneapi/tbb/task_arena.h>

#include <iterator>
#include <optional>
#include <utility>

namespace wakesurf::server {

namespace {

constexpr std::chrono::milliseconds look{5};
constexpr std::size_t most_replaced = 32; ///< at a time

} // namespace

QuickThreads::QuickThreads(unsigned each) : lanes_(each) {
    for (unsigned i = 0; i < each; ++i) {
        start(QuickLanes::Lane::Upper, i == 0 ? Takes::LightOnly : Takes::Any);
        start(QuickLanes::Lane::Lower, Takes::Any);
    }
    keeper_ = std::jthread([this] { keep(); });
}

QuickThreads::~QuickThreads() {
    {
        const std::lock_guard lock(mutex_);
        sort(); // before the threads may end: each lane's run what is sorted now
        ending_ = true;
    }
    keepers_event_.notify_all();
    keeper_.join();
    for (core::EventCount& each : events_)
        each.notify_all();
    workers_.clear();
}

void QuickThreads::run(const std::string& session, FairQueue::Job job) {
    arrived_.push({session, std::move(job)});
    event(QuickLanes::Lane::Upper).notify_all(); // not each of them takes every job
    if (upper_asleep_ == 0)
        event(QuickLanes::Lane::Lower).notify_one(); // to sort it, and perhaps to run it
}

void QuickThreads::start(QuickLanes::Lane lane, Takes takes) {
    Worker& worker = workers_.emplace_back(lane, takes);
    worker.thread = std::jthread([this, &worker] { serve(worker); });
}

/// With the lock: the first thread that looks for work does it for all.
void QuickThreads::sort() {
    for (Arrived& each : arrived_.take())
        if (lanes_.push(each.session, std::move(each.job), Clock::now()) == QuickLanes::Lane::Lower)
            event(QuickLanes::Lane::Lower).notify_one();
}

void QuickThreads::serve(Worker& self) {
    const bool upper = self.lane == QuickLanes::Lane::Upper;
    self.id = own_thread_id();
    if (upper)
        ask_for_short_slices();
    else
        step_back(crowd_niceness);
    oneapi::tbb::task_arena alone(1, 1);
    while (!self.replaced) {
        const auto seen = event(self.lane).notifications();
        std::unique_lock lock(mutex_);
        sort();
        auto turn = self.takes == Takes::LightOnly ? lanes_.pop_light(Clock::now())
                                                   : lanes_.pop(self.lane, Clock::now());
        lock.unlock();
        if (!turn && ending_)
            break;
        if (!turn) {
            upper_asleep_ += upper ? 1 : 0;
            event(self.lane).wait(seen);
            upper_asleep_ -= upper ? 1 : 0;
            continue;
        }
        const double before = self.seconds_before = processor_seconds();
        self.since = Clock::now().time_since_epoch().count();
        if (keeper_sleeps_)
            keepers_event_.notify_one();
        alone.execute(turn->job);
        turn->job = nullptr; // what the job holds goes before the threads may
        self.since = 0;
        lock.lock();
        lanes_.done(self.lane, turn->session, processor_seconds() - before, Clock::now());
    }
    // It may have been woken for a job after another took its place.
    event(self.lane).notify_all();
    self.ended = true;
}

/// The keeper's thread: looks after all while any has a job.
void QuickThreads::keep() {
    const auto any_busy = [this] {
        bool busy = false;
        for (auto each = workers_.begin(); each != workers_.end();) {
            busy = look_after(*each) || busy;
            const bool over = each->ended && each->replaced;
            replaced_ -= over ? 1 : 0;
            each = over ? workers_.erase(each) : std::next(each);
        }
        return busy;
    };
    while (!ending_) {
        const auto seen = keepers_event_.notifications();
        if (any_busy()) {
            keepers_event_.wait(seen, look);
            continue;
        }
        keeper_sleeps_ = true;
        if (!any_busy() && !ending_) // a job may have begun before it was said
            keepers_event_.wait(seen);
        keeper_sleeps_ = false;
    }
}

/// Returns whether it has a job.
bool QuickThreads::look_after(Worker& worker) {
    const auto since = Clock::time_point(Clock::duration(worker.since.load()));
    if (since == Clock::time_point())
        return false;
    if (!worker.replaced && Clock::now() - since > patience && replaced_ < most_replaced) {
        ++replaced_;
        worker.replaced = true;
        start(worker.lane, worker.takes);
    }
    if (worker.replaced && !worker.stepped_back &&
        processor_seconds(worker.thread.native_handle()) - worker.seconds_before > fair_seconds) {
        worker.stepped_back = true;
        step_back(long_niceness, worker.id);
    }
    return true;
}

} // namespace wakesurf::server
