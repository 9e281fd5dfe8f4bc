// A few threads for slow operations such as reading a disk, so that callers do not block.
#pragma once

#include "core/base/event_count.hpp"

#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace wakesurf::core {

/// Runs work first come, first served. The threads begin with the first work. Thread safety: concurrent calls
/// are fine, from work too.
class WorkerThreads {
  public:
    /// A task; throws nothing. `ending`: the owner of the threads is being destroyed; the task tells it so,
    /// and returns.
    using Work = std::function<void(bool ending)>;

    /// @param most  threads, at least 1
    explicit WorkerThreads(std::size_t most) : most_(most) {}

    WorkerThreads(const WorkerThreads&) = delete;
    WorkerThreads& operator=(const WorkerThreads&) = delete;

    /// Waits for all work; what has not begun is called with `ending`. REQUIRES: called from none of these
    /// threads.
    ~WorkerThreads();

    void add(std::vector<Work> work);

  private:
    void run();

    std::size_t most_;
    std::mutex mutex_; ///< guards what follows; not locked while a task runs
    std::deque<Work> waiting_;
    bool ending_ = false;
    std::vector<std::thread> threads_;
    EventCount event_;
};

} // namespace wakesurf::core
