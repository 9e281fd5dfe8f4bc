#include "server/live/compute/compute_pool.hpp"

#include "core/base/event_count.hpp"
#include "core/base/mpsc_queue.hpp"
#include "server/live/compute/worker_threads.hpp"

#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <limits>
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

/// Light sessions have threads of full priority, never all of them for one session. The others have threads
/// that leave the processors to those and to the network thread.
WorkerThreads::Rules quick_rules(unsigned cores) {
    constexpr std::chrono::milliseconds patience{20};
    const std::size_t each = std::max(2u, cores);
    const std::size_t most = each + 32;
    return {.queue = {.at_once = std::numeric_limits<std::size_t>::max(),
                      .light_at_once = each - 1,
                      .light_share = 0.5,
                      .busy = 0.05,
                      .memory = std::chrono::milliseconds(250)},
            .light = {each, most, 0, patience},
            .any = {each, most, crowd_niceness, patience},
            .loop_threads = 1,
            .charge_processor = true};
}

/// A session counts as light until its first job has run: after the patience the next light one has its
/// turn.
WorkerThreads::Rules long_rules(unsigned cores) {
    const std::size_t any = std::max(4u, 2 * cores);
    return {.queue = {.at_once = 1,
                      .light_at_once = 1,
                      .light_share = 0.5,
                      .busy = std::numeric_limits<double>::infinity(),
                      .memory = std::chrono::milliseconds(4000)},
            .light = {2, 4, long_niceness, std::chrono::milliseconds(500)},
            .any = {any, any + 64, long_niceness, std::nullopt},
            .loop_threads = cores,
            .charge_processor = false};
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
    FairQueue quick{quick_rules(cores).queue}, longer{long_rules(cores).queue};
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

void ComputePool::let_go(std::shared_ptr<const void> thing) {
    if (state_->threads && thing)
        state_->threads->freeing.push(std::move(thing));
}

bool ComputePool::turn() {
    std::unique_lock lock(state_->by_hand);
    for (FairQueue* queue : {&state_->quick, &state_->longer})
        if (auto turn = queue->pop(FairQueue::Takes::Any, {})) {
            lock.unlock(); // it may queue others
            std::exchange(turn->job, nullptr)();
            lock.lock();
            queue->done(turn->session, 0.0, {});
            return true;
        }
    return false;
}

unsigned ComputePool::threads() const {
    return state_->cores;
}

} // namespace wakesurf::server
