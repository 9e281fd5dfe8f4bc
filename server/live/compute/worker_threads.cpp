#include "server/live/compute/worker_threads.hpp"

#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_scheduler_observer.h>
#include <pthread.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <utility>

namespace wakesurf::server {

namespace {

/// sched_setattr(2); the C library has neither.
struct SchedulerAttributes {
    std::uint32_t size = sizeof(SchedulerAttributes);
    std::uint32_t policy = SCHED_OTHER;
    std::uint64_t flags = 0;
    std::int32_t nice = 0;
    std::uint32_t priority = 0;
    std::uint64_t runtime = 0; ///< ns: of a slice
    std::uint64_t deadline = 0;
    std::uint64_t period = 0;
};

constexpr std::uint64_t short_slice = 500'000; // the kernel's own: about 3 ms

double seconds_of(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

} // namespace

int own_thread_id() {
    return static_cast<int>(syscall(SYS_gettid));
}

void step_back(int niceness, int thread) {
    setpriority(PRIO_PROCESS, static_cast<id_t>(thread == 0 ? own_thread_id() : thread), niceness);
}

void ask_for_short_slices() {
    SchedulerAttributes attributes;
    attributes.nice = getpriority(PRIO_PROCESS, static_cast<id_t>(own_thread_id()));
    attributes.runtime = short_slice;
    syscall(SYS_sched_setattr, 0, &attributes, 0u);
}

double processor_seconds() {
    return seconds_of(CLOCK_THREAD_CPUTIME_ID);
}

double processor_seconds(std::thread::native_handle_type thread) {
    clockid_t clock{};
    return pthread_getcpuclockid(thread, &clock) == 0 ? seconds_of(clock) : 0.0;
}

namespace {

/// A session becomes light with time: threads for light ones look at waiting jobs this often.
constexpr std::chrono::milliseconds light_poll_interval{50};

/// oneTBB's workers take the priority of long jobs, which alone have parallel loops.
class StepBack final : public oneapi::tbb::task_scheduler_observer {
  public:
    explicit StepBack(oneapi::tbb::task_arena& arena) : task_scheduler_observer(arena) {
        observe(true);
    }

    ~StepBack() override { observe(false); }

    void on_scheduler_entry(bool is_worker) override {
        thread_local bool done = false;
        if (is_worker && !std::exchange(done, true))
            step_back(long_niceness);
    }
};

} // namespace

WorkerThreads::WorkerThreads(const Rules& rules)
    : rules_(rules),
      queue_(rules.queue), light_{rules.light, FairQueue::Takes::Light, {}, rules.light.permits},
      any_{rules.any, FairQueue::Takes::Any, {}, rules.any.permits} {
    const std::lock_guard lock(mutex_);
    for (Threads* group : {&light_, &any_})
        for (std::size_t i = 0; i < group->rules.permits; ++i)
            start(*group);
    keeper_ = std::jthread([this] { keep(); });
}

WorkerThreads::~WorkerThreads() {
    {
        const std::lock_guard lock(mutex_);
        sort(); // before the threads may end
        ending_ = true;
    }
    keepers_event_.notify_all();
    keeper_.join();
    notify_others();
    workers_.clear();
}

void WorkerThreads::run(const std::string& session, FairQueue::Job job) {
    arrived_.push({session, std::move(job)});
    light_.event.notify_one();
    if (light_asleep_ == 0)
        any_.event.notify_one(); // to sort it, and perhaps to run it
}

void WorkerThreads::start(Threads& group) {
    Worker& worker = workers_.emplace_back(*this, group);
    worker.thread = std::jthread([this, &worker] { serve(worker); });
    ++group.count;
}

/// The first thread that looks for work does it for all.
void WorkerThreads::sort() {
    for (Arrived& each : arrived_.take())
        queue_.push(each.session, std::move(each.job));
}

/// Threads for any session leave light ones to those that are for them alone, which may have a better
/// priority.
std::optional<FairQueue::Turn> WorkerThreads::next(const Threads& group) {
    using Takes = FairQueue::Takes;
    if (group.free == 0)
        return std::nullopt;
    const bool leaves_light = group.takes == Takes::Any && light_.free > 0;
    const Takes takes = ending_ ? Takes::Any : leaves_light ? Takes::NotLight : group.takes;
    return queue_.pop(takes, Clock::now());
}

void WorkerThreads::notify_others() {
    light_.event.notify_all();
    any_.event.notify_all();
}

void WorkerThreads::begin(Worker& self) {
    --self.group.free;
    self.has_permit = true;
    self.since = Clock::now();
    self.seconds_before = processor_seconds();
    if (std::exchange(keeper_sleeps_, false))
        keepers_event_.notify_one();
}

void WorkerThreads::end(Worker& self, const std::string& session) {
    const auto now = Clock::now();
    const double taken = std::chrono::duration<double>(now - *self.since).count();
    queue_.done(session,
                rules_.charge_processor ? processor_seconds() - self.seconds_before : taken, now);
    self.since.reset();
    if (std::exchange(self.has_permit, false))
        ++self.group.free;
    else
        --self.group.lenders;
}

void WorkerThreads::serve(Worker& self) {
    Threads& group = self.group;
    const bool light = group.takes == FairQueue::Takes::Light;
    {
        const std::lock_guard lock(mutex_);
        self.id = own_thread_id();
    }
    if (group.rules.niceness == 0)
        ask_for_short_slices();
    else
        step_back(group.rules.niceness);
    // An arena a thread: while it waits for its loop's other threads it cannot take on another job.
    oneapi::tbb::task_arena arena(static_cast<int>(rules_.loop_threads), 1);
    arena.initialize();
    const StepBack observer(arena);
    core::BlockingWait::listen(&self);
    while (!self.stepped_back) {
        const auto seen = group.event.notifications();
        std::unique_lock lock(mutex_);
        sort();
        auto turn = next(group);
        const bool others = queue_.waiting() > 0;
        if (!turn && ending_ && !others)
            return;
        if (turn)
            begin(self);
        lock.unlock();
        if (others && (turn || light))
            any_.event.notify_one();
        if (!turn) {
            light_asleep_ += light ? 1 : 0;
            if (light && others)
                group.event.wait(seen, light_poll_interval);
            else
                group.event.wait(seen);
            light_asleep_ -= light ? 1 : 0;
            continue;
        }
        arena.execute(turn->job);
        turn->job = nullptr; // what the job holds goes before the threads may
        lock.lock();
        end(self, turn->session);
        if (ending_)
            notify_others();
        else if (queue_.waiting() > 0) // the session's next job may be for either group
            for (Threads* each : {&light_, &any_})
                each->event.notify_one();
    }
    const std::lock_guard lock(mutex_);
    --group.count;
    self.ended = true;
    notify_others(); // it may have been woken for a job
}

void WorkerThreads::blocked(Worker& worker) {
    const std::lock_guard lock(mutex_);
    return_permit(worker);
}

/// Each free permit has a thread that can take it: where no more threads may be started, the job keeps its
/// own.
void WorkerThreads::return_permit(Worker& worker) {
    Threads& group = worker.group;
    const bool enough = group.count - group.lenders > group.rules.permits;
    if (!worker.has_permit || ending_ || (!enough && group.count >= group.rules.most_threads))
        return;
    worker.has_permit = false;
    ++group.lenders;
    ++group.free;
    if (!enough)
        start(group);
    group.event.notify_one();
}

/// Runs on the keeper's thread, and returns permits of jobs that have run for too long.
void WorkerThreads::keep() {
    constexpr auto forever = std::chrono::milliseconds::max();
    const auto interval =
        std::min(rules_.light.patience.value_or(forever), rules_.any.patience.value_or(forever)) /
        4;
    for (;;) {
        const auto seen = keepers_event_.notifications();
        bool busy = false;
        std::list<Worker> ended;
        {
            const std::lock_guard lock(mutex_);
            if (ending_)
                return;
            for (auto each = workers_.begin(); each != workers_.end();) {
                const auto worker = each++;
                busy = supervise(*worker) || busy;
                if (worker->ended)
                    ended.splice(ended.end(), workers_, worker);
            }
            keeper_sleeps_ = !busy;
        }
        ended.clear(); // joins them
        if (busy)
            keepers_event_.wait(seen, interval);
        else
            keepers_event_.wait(seen);
    }
}

/// Returns whether it has a job that may run for too long.
bool WorkerThreads::supervise(Worker& worker) {
    const auto& patience = worker.group.rules.patience;
    if (!worker.since || !patience)
        return false;
    if (Clock::now() - *worker.since > *patience)
        return_permit(worker);
    if (!worker.has_permit && !worker.stepped_back && worker.group.rules.niceness < long_niceness &&
        processor_seconds(worker.thread.native_handle()) - worker.seconds_before > fair_seconds) {
        worker.stepped_back = true;
        step_back(long_niceness, worker.id);
    }
    return true;
}

} // namespace wakesurf::server
