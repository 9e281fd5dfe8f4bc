// The threads surfaces are built on: one oneTBB arena, apart from the io thread, which never computes.
#pragma once

#include <functional>
#include <memory>

namespace wakesurf::server {

/// Thread safety: run() may be called from any thread. The destructor waits for jobs that have begun or are queued;
/// request them to stop first.
class ComputePool {
  public:
    /// @param threads  0: one a core
    explicit ComputePool(unsigned threads);
    ~ComputePool();
    ComputePool(const ComputePool&) = delete;
    ComputePool& operator=(const ComputePool&) = delete;

    /// Queues a job, oldest first. Its own parallel loops use the arena's other threads, and while it waits for them its
    /// thread takes on no other job, which might run for seconds. A job must not throw.
    void run(std::function<void()> job);

    unsigned threads() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace wakesurf::server
