#include "server/live/compute/compute_pool.hpp"

#include "core/base/event_count.hpp"
#include "core/base/mpsc_queue.hpp"
#include "server/live/compute/worker_threads.hpp"

#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace wakesurf::server {

namespace {

unsigned thread_count(unsigned asked) {
    return asked > 0 ? asked : std::max(1u, std::thread::hardware_concurrency());
}

/// Frees what it is given on a thread of its own.
class Freeing {
  public:
    ~Freeing() {
        ending_ = true;
        event_.notify_all();
    }

    void push(std::shared_ptr<const void> thing) {
        things_.push(std::move(thing));
        event_.notify_all();
    }

  private:
    void free_all() {
        for (;;) {
            const auto seen = event_.notifications();
            const bool last = ending_;
            things_.take();
            if (last)
                return;
            event_.wait(seen);
        }
    }

    core::MpscQueue<std::shared_ptr<const void>> things_;
    core::EventCount event_;
    std::atomic<bool> ending_{false};
    std::jthread thread_{[this] { free_all(); }};
};

/// A permit more than processors, so that one session alone can use them all.
WorkerThreads::Rules quick_rules(unsigned cores) {
    const std::size_t permits = std::max(2u, cores) + 1;
    return {.permits = permits,
            .most_threads = permits + 64,
            .one_a_session = false,
            .niceness = 0,
            .patience = std::chrono::milliseconds(20),
            .loop_threads = 1};
}

/// More permits than processors, because a job may wait for memory. After the patience jobs share the
/// processors by the kernel's turns.
WorkerThreads::Rules long_rules(unsigned cores) {
    const std::size_t permits = std::max(4u, 2 * cores);
    return {.permits = permits,
            .most_threads = permits + 64,
            .one_a_session = true,
            .niceness = long_niceness,
            .patience = std::chrono::milliseconds(500),
            .loop_threads = cores};
}

} // namespace

struct ComputePool::State {
    explicit State(unsigned count) : cores(count) {}

    /// All loops together use as many threads as there are cores.
    struct Threads {
        explicit Threads(unsigned cores)
            : allowed(oneapi::tbb::global_control::max_allowed_parallelism, cores),
              quick(quick_rules(cores)), longer(long_rules(cores)) {}

        oneapi::tbb::global_control allowed;
        Freeing freeing;
        WorkerThreads quick, longer;
    };

    const unsigned cores;
    std::optional<Threads> threads; ///< empty: by hand
    std::mutex by_hand;             ///< guards the queues
    FairQueue quick{1}, longer{1};
    std::atomic<std::uint64_t> without_session{0};
};

ComputePool::ComputePool(unsigned threads)
    : state_(std::make_unique<State>(thread_count(threads))) {
    state_->threads.emplace(state_->cores);
}

ComputePool::ComputePool(ByHand) : state_(std::make_unique<State>(1)) {}

ComputePool::~ComputePool() = default;

void ComputePool::run(const std::string& session, PriorityClass priority, Job job) {
    const bool quick = priority == PriorityClass::Quick;
    if (auto& threads = state_->threads)
        return (quick ? threads->quick : threads->longer).run(session, std::move(job));
    const std::lock_guard lock(state_->by_hand);
    (quick ? state_->quick : state_->longer).push(session, std::move(job));
}

void ComputePool::run(Job job) {
    // No session is called like that.
    run("\n" + std::to_string(state_->without_session++), PriorityClass::Long, std::move(job));
}

void ComputePool::release(std::shared_ptr<const void> thing) {
    if (state_->threads && thing)
        state_->threads->freeing.push(std::move(thing));
}

bool ComputePool::turn() {
    std::unique_lock lock(state_->by_hand);
    for (FairQueue* queue : {&state_->quick, &state_->longer})
        if (auto turn = queue->pop()) {
            lock.unlock(); // it may queue others
            std::exchange(turn->job, nullptr)();
            lock.lock();
            queue->done(turn->session, 0.0);
            return true;
        }
    return false;
}

unsigned ComputePool::threads() const {
    return state_->cores;
}

} // namespace wakesurf::server
