#include "server/service/compute/compute_pool.hpp"

#include "core/base/event_count.hpp"
#include "core/base/mpsc_queue.hpp"
#include "server/service/compute/long_threads.hpp"
#include "server/service/compute/quick_threads.hpp"

#include <algorithm>
#include <atomic>
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

} // namespace

struct ComputePool::State {
    struct Threads {
        explicit Threads(unsigned cores) : quick(std::max(2u, cores)), longer(cores) {}

        Freeing freeing;
        QuickThreads quick;
        LongThreads longer;
    };

    unsigned cores = 1;
    std::optional<Threads> threads;                            ///< nothing: by hand
    std::mutex by_hand;                                        ///< guards what follows
    QuickLanes quick{std::numeric_limits<std::size_t>::max()}; ///< by hand: one lane
    LongLanes longer;
};

ComputePool::ComputePool(unsigned threads) : state_(std::make_unique<State>()) {
    state_->cores = thread_count(threads);
    state_->threads.emplace(state_->cores);
}

ComputePool::ComputePool(ByHand) : state_(std::make_unique<State>()) {}

ComputePool::~ComputePool() = default;

void ComputePool::run(const std::string& session, Pace pace, std::function<void()> job) {
    const bool quick = pace == Pace::Quick;
    if (auto& threads = state_->threads)
        return quick ? threads->quick.run(session, std::move(job))
                     : threads->longer.run(session, std::move(job));
    const std::lock_guard lock(state_->by_hand);
    if (quick)
        state_->quick.push(session, std::move(job), {});
    else
        state_->longer.push(session, std::move(job));
}

void ComputePool::run(std::function<void()> job) {
    if (state_->threads)
        return state_->threads->longer.run({}, std::move(job));
    const std::lock_guard lock(state_->by_hand);
    state_->longer.push_lone(std::move(job));
}

void ComputePool::let_go(std::shared_ptr<const void> thing) {
    if (state_->threads && thing)
        state_->threads->freeing.push(std::move(thing));
}

bool ComputePool::turn() {
    constexpr auto lane = QuickLanes::Lane::Upper;
    std::unique_lock lock(state_->by_hand);
    auto turn = state_->quick.pop(lane, {});
    const bool quick = turn.has_value();
    if (!quick)
        turn = state_->longer.pop(LongLanes::Lane::Any, {});
    if (!turn)
        return false;
    lock.unlock(); // it may queue others
    std::exchange(turn->job, nullptr)();
    lock.lock();
    if (quick)
        state_->quick.done(lane, turn->session, 0.0, {});
    else
        state_->longer.done(turn->session, 0.0, {});
    return true;
}

unsigned ComputePool::threads() const {
    return state_->cores;
}

} // namespace wakesurf::server
