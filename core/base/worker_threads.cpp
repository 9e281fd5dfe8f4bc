#include "core/base/worker_threads.hpp"

#include <utility>

namespace wakesurf::core {

WorkerThreads::~WorkerThreads() {
    {
        const std::scoped_lock lock(mutex_);
        ending_ = true;
    }
    event_.notify_all();
    for (auto& thread : threads_)
        thread.join();
}

void WorkerThreads::add(std::vector<Work> work) {
    {
        const std::scoped_lock lock(mutex_);
        for (auto& one : work)
            waiting_.push_back(std::move(one));
        while (!ending_ && threads_.size() < most_)
            threads_.emplace_back([this] { run(); });
    }
    event_.notify_all();
}

void WorkerThreads::run() {
    std::unique_lock lock(mutex_);
    for (;;) {
        const auto seen = event_.notifications();
        if (waiting_.empty() && ending_)
            return;
        if (waiting_.empty()) {
            event_.wait(lock, seen);
            continue;
        }
        auto work = std::move(waiting_.front());
        waiting_.pop_front();
        const bool ending = ending_;
        lock.unlock();
        work(ending);
        work = nullptr; // what it holds goes before the next is begun
        lock.lock();
    }
}

} // namespace wakesurf::core
