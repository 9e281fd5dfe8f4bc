#include "server/session/compute_pool.hpp"

#include "server/session/long_lanes.hpp"
#include "server/session/quick_lanes.hpp"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_scheduler_observer.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <ctime>
#include <limits>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace wakesurf::server {

namespace {

// nice: next to a thread that answers somebody, a third and a tenth of its time.
constexpr int crowd_priority = 5;
constexpr int long_priority = 10;

// Beside those that take any long job in its turn; most sleep, as few light jobs begin at a time.
constexpr unsigned light_threads = 4;
constexpr std::chrono::milliseconds settling_look{50};

unsigned thread_count(unsigned asked) {
    return asked > 0 ? asked : std::max(1u, std::thread::hardware_concurrency());
}

/// Of the calling thread, for good. Where the kernel refuses, all run alike.
void step_back(int priority) {
    thread_local bool done = false;
    if (!std::exchange(done, true))
        setpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)), priority);
}

/// s that the calling thread has had a processor.
double processor_time() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// oneTBB's workers only ever help with long jobs.
class StepBack final : public oneapi::tbb::task_scheduler_observer {
  public:
    explicit StepBack(oneapi::tbb::task_arena& arena) : task_scheduler_observer(arena) {
        observe(true);
    }

    ~StepBack() override { observe(false); }

    void on_scheduler_entry(bool) override { step_back(long_priority); }
};

} // namespace

struct ComputePool::State {
    using Lane = QuickLanes::Lane;
    using Clock = std::chrono::steady_clock;

    explicit State(unsigned asked)
        : threads(thread_count(asked)), quick(quick_threads()),
          allowed(std::in_place, oneapi::tbb::global_control::max_allowed_parallelism, threads) {
        workers.emplace_back([this] {
            serve_quick(
                Lane::Upper, [this] { return quick.ready_light(Clock::now()); },
                [this] { return quick.pop_light(Clock::now()); });
        });
        for (unsigned i = 1; i < quick_threads(); ++i)
            workers.emplace_back([this] { serve_quick(Lane::Upper); });
        for (unsigned i = 0; i < quick_threads(); ++i)
            workers.emplace_back([this] {
                step_back(crowd_priority);
                serve_quick(Lane::Lower);
            });
        for (unsigned i = 0; i < std::max(4u, 2 * threads); ++i)
            workers.emplace_back([this] { serve_long(LongLanes::Lane::Any); });
        for (unsigned i = 0; i < light_threads; ++i)
            workers.emplace_back([this] { serve_long(LongLanes::Lane::Light); });
    }

    State() : threads(1), quick(std::numeric_limits<std::size_t>::max()) {} // by hand: one lane

    unsigned quick_threads() const { return std::max(2u, threads); }

    void serve_quick(Lane lane) {
        serve_quick(
            lane, [this, lane] { return quick.ready(lane); },
            [this, lane] { return quick.pop(lane, Clock::now()); });
    }

    void serve_quick(Lane lane,
                     const std::function<bool()>& there,
                     const std::function<std::optional<FairQueue::Turn>()>& pop) {
        oneapi::tbb::task_arena alone(1, 1);
        std::condition_variable& ready = quick_ready[static_cast<std::size_t>(lane)];
        std::unique_lock lock(mutex);
        for (;;) {
            ready.wait(lock, [&] { return there() || ending; });
            auto turn = pop();
            if (!turn)
                return;
            const double before = processor_time();
            run(*turn, alone, lock);
            quick.done(lane, turn->session, processor_time() - before, Clock::now());
        }
    }

    void serve_long(LongLanes::Lane lane) {
        // An arena a thread: while it waits for its loop's other threads it cannot take on another job.
        oneapi::tbb::task_arena arena(static_cast<int>(threads), 1);
        arena.initialize();
        const StepBack observer(arena);
        std::unique_lock lock(mutex);
        for (;;) {
            while (!longer.ready(lane, Clock::now()) && !(ending && longer.waiting() == 0))
                if (lane == LongLanes::Lane::Light && longer.waiting() > 0)
                    long_ready.wait_for(lock, settling_look); // time makes it ready
                else
                    long_ready.wait(lock);
            auto turn = longer.pop(lane, Clock::now());
            if (!turn)
                return;
            const auto start = Clock::now();
            run(*turn, arena, lock);
            const auto end = Clock::now();
            longer.done(turn->session, std::chrono::duration<double>(end - start).count(), end);
            long_ready.notify_all();
        }
    }

    static void
    run(FairQueue::Turn& turn, oneapi::tbb::task_arena& arena, std::unique_lock<std::mutex>& lock) {
        lock.unlock();
        arena.execute(turn.job);
        turn.job = nullptr; // what the job holds goes before the pool may
        lock.lock();
    }

    unsigned threads;
    std::mutex mutex;
    bool ending = false;
    QuickLanes quick;
    LongLanes longer;
    std::array<std::condition_variable, 2> quick_ready;
    std::condition_variable long_ready;
    std::uint64_t next_lone = 0;
    std::optional<oneapi::tbb::global_control> allowed;
    std::vector<std::jthread> workers;
};

ComputePool::ComputePool(unsigned threads) : state_(std::make_unique<State>(threads)) {}

ComputePool::ComputePool(ByHand) : state_(std::make_unique<State>()) {}

ComputePool::~ComputePool() {
    {
        const std::lock_guard lock(state_->mutex);
        state_->ending = true;
    }
    for (auto& each : state_->quick_ready)
        each.notify_all();
    state_->long_ready.notify_all();
    state_->workers.clear();
}

void ComputePool::run(const std::string& session, Pace pace, std::function<void()> job) {
    std::unique_lock lock(state_->mutex);
    if (pace == Pace::Long) {
        state_->longer.push(session, std::move(job));
        lock.unlock();
        return state_->long_ready.notify_all(); // not each of them takes it
    }
    const auto lane = state_->quick.push(session, std::move(job), State::Clock::now());
    lock.unlock();
    state_->quick_ready[static_cast<std::size_t>(lane)].notify_all(); // not each of them takes it
}

void ComputePool::run(std::function<void()> job) {
    {
        const std::lock_guard lock(state_->mutex);
        // No session is called like that.
        state_->longer.push_lone("\n" + std::to_string(state_->next_lone++), std::move(job));
    }
    state_->long_ready.notify_all();
}

bool ComputePool::turn() {
    const auto run = [this](std::optional<FairQueue::Turn> turn, auto done) {
        if (!turn)
            return false;
        turn->job(); // without the lock: it may queue others
        turn->job = nullptr;
        const std::lock_guard lock(state_->mutex);
        done(turn->session);
        return true;
    };
    const auto next = [this](auto& queue, auto... lane) {
        const std::lock_guard lock(state_->mutex);
        return queue.pop(lane...);
    };
    constexpr auto upper = QuickLanes::Lane::Upper;
    return run(next(state_->quick, upper, State::Clock::time_point{}),
               [this](const std::string& session) {
                   state_->quick.done(upper, session, 0.0, {});
               }) ||
           run(next(state_->longer, LongLanes::Lane::Any, State::Clock::time_point{}),
               [this](const std::string& session) { state_->longer.done(session, 0.0, {}); });
}

unsigned ComputePool::threads() const {
    return state_->threads;
}

} // namespace wakesurf::server
