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
    : rules_(rules), queue_(rules.one_a_session ? 1 : rules.permits - 1), free_(rules.permits) {
    const std::lock_guard lock(mutex_);
    for (std::size_t i = 0; i < rules_.permits; ++i)
        start();
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
    event_.notify_all();
    workers_.clear();
}

void WorkerThreads::run(const std::string& session, FairQueue::Job job) {
    arrived_.push({session, std::move(job)});
    event_.notify_one();
}

void WorkerThreads::start() {
    Worker& worker = workers_.emplace_back(*this);
    worker.thread = std::jthread([this, &worker] { serve(worker); });
    ++threads_;
}

/// The first thread that looks for work does it for all.
void WorkerThreads::sort() {
    for (Arrived& each : arrived_.take())
        queue_.push(each.session, std::move(each.job));
}

std::optional<FairQueue::Turn> WorkerThreads::begin(Worker& self) {
    sort();
    auto turn = free_ > 0 ? queue_.pop() : std::nullopt;
    if (!turn)
        return turn;
    --free_;
    self.has_permit = true;
    self.session = turn->session;
    self.since = Clock::now();
    self.seconds_before = processor_seconds();
    if (std::exchange(keeper_sleeps_, false))
        keepers_event_.notify_one();
    return turn;
}

void WorkerThreads::end(Worker& self) {
    if (self.has_permit)
        take_permit(self);
    else
        --lenders_;
    if (rules_.one_a_session)
        queue_.done(self.session, self.served);
    self.since.reset();
}

/// The job's session pays for the time that others could not have it.
void WorkerThreads::take_permit(Worker& worker) {
    worker.has_permit = false;
    worker.served = std::chrono::duration<double>(Clock::now() - *worker.since).count();
    ++free_;
    if (!rules_.one_a_session)
        queue_.done(worker.session, worker.served);
}

void WorkerThreads::serve(Worker& self) {
    {
        const std::lock_guard lock(mutex_);
        self.id = own_thread_id();
    }
    if (rules_.niceness == 0)
        ask_for_short_slices();
    else
        step_back(rules_.niceness);
    // An arena a thread: while it waits for its loop's other threads it cannot take on another job.
    oneapi::tbb::task_arena arena(static_cast<int>(rules_.loop_threads), 1);
    arena.initialize();
    const StepBack observer(arena);
    core::BlockingWait::listen(&self);
    while (!self.stepped_back) {
        const auto seen = event_.notifications();
        std::unique_lock lock(mutex_);
        auto turn = begin(self);
        const bool more = queue_.waiting() > 0;
        if (!turn && ending_ && !more)
            return;
        lock.unlock();
        if (!turn) {
            event_.wait(seen);
            continue;
        }
        if (more)
            event_.notify_one();
        arena.execute(turn->job);
        turn->job = nullptr; // what the job holds goes before the threads may
        lock.lock();
        end(self);
        if (ending_)
            event_.notify_all();
    }
    const std::lock_guard lock(mutex_);
    --threads_;
    self.ended = true;
    event_.notify_one(); // the session's next job may wait for this one
}

void WorkerThreads::blocked(Worker& worker) {
    const std::lock_guard lock(mutex_);
    return_permit(worker);
}

/// Each free permit has a thread that can take it: where no more threads may be started, the job keeps its
/// own.
void WorkerThreads::return_permit(Worker& worker) {
    const bool enough = threads_ - lenders_ > rules_.permits;
    if (!worker.has_permit || ending_ || (!enough && threads_ >= rules_.most_threads))
        return;
    take_permit(worker);
    ++lenders_;
    if (!enough)
        start();
    event_.notify_one();
}

/// Runs on the keeper's thread, and returns permits of jobs that have run for too long.
void WorkerThreads::keep() {
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
            keepers_event_.wait(seen, rules_.patience / 4);
        else
            keepers_event_.wait(seen);
    }
}

/// Returns whether it has a job that may run for too long.
bool WorkerThreads::supervise(Worker& worker) {
    if (!worker.since)
        return false;
    if (Clock::now() - *worker.since > rules_.patience)
        return_permit(worker);
    if (!worker.has_permit && !worker.stepped_back && rules_.niceness < long_niceness &&
        processor_seconds(worker.thread.native_handle()) - worker.seconds_before > fair_seconds) {
        worker.stepped_back = true;
        step_back(long_niceness, worker.id);
    }
    return true;
}

} // namespace wakesurf::server
