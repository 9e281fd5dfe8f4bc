// A few threads for what waits for something slow, a disk for example, so that whoever asks for it does not.
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
    /// Throws nothing. `ending`: whose threads these are is being destroyed; the work tells its owner so, and
    /// returns.
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
    std::mutex mutex_; ///< guards what follows; not held while work runs
    std::deque<Work> waiting_;
    bool ending_ = false;
    std::vector<std::thread> threads_;
    EventCount event_;
};

} // namespace wakesurf::core
