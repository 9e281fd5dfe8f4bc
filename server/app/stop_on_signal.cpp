#include "server/app/stop_on_signal.hpp"

#include <ctime>

namespace wakesurf::server {

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
