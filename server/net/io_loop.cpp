#include "server/net/io_loop.hpp"

#include <boost/asio/steady_timer.hpp>
#include <sys/eventfd.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <system_error>
#include <utility>

namespace wakesurf::server {

namespace {

int waking_descriptor() {
    const int descriptor = ::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
    if (descriptor < 0)
        throw std::system_error(errno, std::generic_category(), "eventfd");
    return descriptor;
}

} // namespace

IoLoop::IoLoop(boost::asio::io_context& context)
    : context_(context), woken_(context, waking_descriptor()) {
    wait();
}

/// Each poster wakes the loop, not only the first of several: that one may be preempted between the two
/// steps.
void IoLoop::post(std::function<void()> task) {
    posted_.push(std::move(task));
    const std::uint64_t one = 1;
    // Fails only if 2^64 - 2 wake-ups are pending.
    [[maybe_unused]] const auto written = ::write(woken_.native_handle(), &one, sizeof one);
}

void IoLoop::wait() {
    woken_.async_wait(boost::asio::posix::descriptor_base::wait_read,
                      [this](boost::system::error_code error) {
                          if (!error) // else the loop is destroyed
                              run_posted();
                      });
}

/// Tasks that these post run after others that wait for the context.
void IoLoop::run_posted() {
    std::uint64_t times = 0;
    [[maybe_unused]] const auto got = ::read(woken_.native_handle(), &times, sizeof times);
    wait();
    for (auto& task : posted_.take())
        std::exchange(task, nullptr)(); // a task's captures are destroyed before the next begins
}

std::shared_ptr<void> IoLoop::after(std::chrono::milliseconds delay, std::function<void()> task) {
    struct Ticket {
        explicit Ticket(boost::asio::io_context& context) : timer(context) {}

        boost::asio::steady_timer timer;
        std::function<void()> task;
    };

    auto ticket = std::make_shared<Ticket>(context_);
    ticket->task = std::move(task);
    ticket->timer.expires_after(delay);
    // A weak handle: a dropped ticket neither runs nor keeps alive what its task holds.
    ticket->timer.async_wait(
        [weak = std::weak_ptr<Ticket>(ticket)](boost::system::error_code error) {
            const auto self = weak.lock();
            if (self && !error)
                self->task();
        });
    return ticket;
}

} // namespace wakesurf::server
