#include "server/app/time_limit.hpp"

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace wakesurf::server {

TimeLimit::TimeLimit(double seconds, std::stop_token also)
    : seconds_(seconds), forward_(std::move(also), [this] { source_.request_stop(); }) {
    if (!set())
        return;
    const auto end = std::chrono::steady_clock::now() +
                     std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                         std::chrono::duration<double>(seconds));
    waiter_ = std::jthread([this, end](const std::stop_token& done) {
        std::mutex mutex;
        std::condition_variable_any ended;
        std::unique_lock lock(mutex);
        ended.wait_until(lock, done, end, [] { return false; });
        if (done.stop_requested())
            return;
        over_ = true;
        source_.request_stop();
    });
}

} // namespace wakesurf::server
