#include "server/session/compute_pool.hpp"

#include "server/session/fair_queue.hpp"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_scheduler_observer.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace wakesurf::server {

namespace {

constexpr int lower_priority = 10; ///< nice: a tenth of the time of a thread that answers somebody

unsigned thread_count(unsigned asked) {
    return asked > 0 ? asked : std::max(1u, std::thread::hardware_concurrency());
}

/// Of the calling thread, for good. Where the kernel refuses, all run alike.
void step_back() {
    thread_local bool done = false;
    if (!std::exchange(done, true))
        setpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)), lower_priority);
}

/// oneTBB's workers only ever help with long jobs.
class StepBack final : public oneapi::tbb::task_scheduler_observer {
  public:
    explicit StepBack(oneapi::tbb::task_arena& arena) : task_scheduler_observer(arena) {
        observe(true);
    }

    ~StepBack() override { observe(false); }

    void on_scheduler_entry(bool) override { step_back(); }
};

} // namespace

struct ComputePool::State {
    struct Lane {
        explicit Lane(bool one_a_session) : queue(one_a_session) {}

        FairQueue queue;
        std::condition_variable ready;
    };

    explicit State(unsigned asked)
        : threads(thread_count(asked)),
          allowed(std::in_place, oneapi::tbb::global_control::max_allowed_parallelism, threads) {
        for (unsigned i = 0; i < std::max(2u, threads); ++i)
            workers.emplace_back([this] {
                oneapi::tbb::task_arena alone(1, 1);
                serve(quick, alone);
            });
        for (unsigned i = 0; i < std::max(4u, 2 * threads); ++i)
            workers.emplace_back([this] {
                // An arena a thread: while it waits for its loop's other threads it cannot take on another job.
                oneapi::tbb::task_arena arena(static_cast<int>(threads), 1);
                arena.initialize();
                const StepBack observer(arena);
                serve(longer, arena);
            });
    }

    State() : threads(1) {}

    void serve(Lane& lane, oneapi::tbb::task_arena& arena) {
        std::unique_lock lock(mutex);
        for (;;) {
            lane.ready.wait(
                lock, [&] { return lane.queue.ready() || (ending && lane.queue.waiting() == 0); });
            auto turn = lane.queue.pop();
            if (!turn)
                return;
            lock.unlock();
            arena.execute(turn->job);
            turn->job = nullptr; // what the job holds goes before the pool may
            lock.lock();
            lane.queue.done(turn->session);
            if (lane.queue.ready() || ending)
                lane.ready.notify_all();
        }
    }

    Lane& lane(Pace pace) { return pace == Pace::Quick ? quick : longer; }

    unsigned threads;
    std::optional<oneapi::tbb::global_control> allowed;
    std::mutex mutex;
    bool ending = false;
    Lane quick{false}, longer{true};
    std::uint64_t next_lone = 0;
    std::vector<std::jthread> workers;
};

ComputePool::ComputePool(unsigned threads) : state_(std::make_unique<State>(threads)) {}

ComputePool::ComputePool(ByHand) : state_(std::make_unique<State>()) {}

ComputePool::~ComputePool() {
    {
        const std::lock_guard lock(state_->mutex);
        state_->ending = true;
    }
    state_->quick.ready.notify_all();
    state_->longer.ready.notify_all();
    state_->workers.clear();
}

void ComputePool::run(const std::string& session, Pace pace, std::function<void()> job) {
    State::Lane& lane = state_->lane(pace);
    {
        const std::lock_guard lock(state_->mutex);
        lane.queue.push(session, std::move(job));
    }
    lane.ready.notify_one();
}

void ComputePool::run(std::function<void()> job) {
    std::string lone;
    {
        const std::lock_guard lock(state_->mutex);
        lone = "\n" + std::to_string(state_->next_lone++); // no session is called like that
    }
    run(lone, Pace::Long, std::move(job));
}

bool ComputePool::turn() {
    for (State::Lane* lane : {&state_->quick, &state_->longer}) {
        std::unique_lock lock(state_->mutex);
        auto turn = lane->queue.pop();
        if (!turn)
            continue;
        lock.unlock();
        turn->job();
        turn->job = nullptr;
        lock.lock();
        lane->queue.done(turn->session);
        return true;
    }
    return false;
}

unsigned ComputePool::threads() const {
    return state_->threads;
}

} // namespace wakesurf::server
