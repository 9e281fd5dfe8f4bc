#include "server/session/compute_pool.hpp"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace wakesurf::server {

namespace {

unsigned thread_count(unsigned asked) {
    return asked > 0 ? asked : std::max(1u, std::thread::hardware_concurrency());
}

} // namespace

struct ComputePool::State {
    explicit State(unsigned asked)
        : threads(thread_count(asked)),
          // oneTBB counts the main thread, which is our io thread, among the parallel ones.
          allowed(oneapi::tbb::global_control::max_allowed_parallelism, threads + 1),
          arena(static_cast<int>(threads), 0) {}

    unsigned threads;
    oneapi::tbb::global_control allowed;
    oneapi::tbb::task_arena arena;
    std::mutex mutex;
    std::condition_variable idle;
    std::size_t unfinished = 0;
};

ComputePool::ComputePool(unsigned threads) : state_(std::make_unique<State>(threads)) {}

ComputePool::~ComputePool() {
    std::unique_lock lock(state_->mutex);
    state_->idle.wait(lock, [this] { return state_->unfinished == 0; });
}

void ComputePool::run(std::function<void()> job) {
    {
        const std::lock_guard lock(state_->mutex);
        ++state_->unfinished;
    }
    // oneTBB calls a const functor, hence the indirection.
    auto work = std::make_shared<std::function<void()>>(std::move(job));
    state_->arena.enqueue([state = state_.get(), work] {
        oneapi::tbb::this_task_arena::isolate(*work);
        *work = nullptr; // what the job holds goes before the pool may
        const std::lock_guard lock(state->mutex);
        if (--state->unfinished == 0)
            state->idle.notify_all();
    });
}

unsigned ComputePool::threads() const {
    return state_->threads;
}

} // namespace wakesurf::server
