#include "server/app/stop_tokens.hpp"

#include <chrono>
#include <condition_variable>
#include <ctime>
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

namespace {

sigset_t ending_signals() {
    sigset_t set;
    ::sigemptyset(&set);
    ::sigaddset(&set, SIGINT);
    ::sigaddset(&set, SIGTERM);
    return set;
}

} // namespace

StopOnSignal::StopOnSignal() {
    const sigset_t signals = ending_signals();
    ::pthread_sigmask(SIG_BLOCK, &signals, &before_);
    waiter_ = std::jthread([this, signals](const std::stop_token& done) {
        while (!done.stop_requested()) {
            const timespec patience{0, 50'000'000};
            if (::sigtimedwait(&signals, nullptr, &patience) > 0)
                source_.request_stop();
        }
    });
}

StopOnSignal::~StopOnSignal() {
    waiter_.request_stop();
    waiter_.join();
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

} // namespace wakesurf::server
