// The threads on which surfaces are computed, apart from the network thread, which never computes. Quick
// and long passes have threads of their own, and the session served least goes first in both. Long passes
// run at a lower priority: the kernel slices them, so that no surface delays another session.
#pragma once

#include <functional>
#include <memory>
#include <string>

namespace wakesurf::server {

/// Jobs are of one of two priority classes, by how long they are expected to take. A quick one ends within
/// some 15 ms.
enum class PriorityClass { Quick, Long };

/// Thread safety: run() may be called from any thread. The destructor waits for jobs that have begun or are
/// queued; request them to stop first.
class ComputePool {
  public:
    using Job = std::function<void()>;

    /// For tests and simulations: no threads, turn() runs the jobs.
    struct ByHand {};

    /// @param threads  0: one a core
    explicit ComputePool(unsigned threads);
    explicit ComputePool(ByHand);
    /// By hand: forgets the jobs that have not run.
    ~ComputePool();
    ComputePool(const ComputePool&) = delete;
    ComputePool& operator=(const ComputePool&) = delete;

    /// Queues a job of a session, and waits for no other thread. Quick ones run on one thread each; one
    /// session never holds all permits. Of the long ones of a session one runs at a time; its parallel loops
    /// use all cores. A job must not throw.
    void run(const std::string& session, PriorityClass priority, Job job);

    /// Queues a long job that belongs to no session: it has turns like a session of its own.
    void run(Job job);

    /// Destroys a large object on a thread that nothing waits for: the network thread would be busy with it
    /// for milliseconds. By hand, at once.
    void release(std::shared_ptr<const void> thing);

    /// Runs the next job on the caller's thread, quick ones first, by hand only. Returns false when there
    /// is none.
    bool turn();

    /// Returns the number of threads that parallel loops use.
    unsigned threads() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace wakesurf::server
