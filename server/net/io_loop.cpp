#include "server/net/io_loop.hpp"

#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>

namespace wakesurf::server {

void IoLoop::post(std::function<void()> task) {
    boost::asio::post(context_, std::move(task));
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
