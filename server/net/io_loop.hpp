// The session's loop on the network's io_context. Compute threads, which run at lower priorities, post here
// all the time: a queue and a descriptor that wakes, because asio's own queue has a lock, which it holds
// while it wakes the network thread. That thread then waited for the poster it had just displaced: up to 114
// ms on two busy cores, several times a second.
#pragma once

#include "core/base/mpsc_queue.hpp"
#include "server/base/loop.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>

namespace wakesurf::server {

/// Keeps the context's run() from returning until stop().
class IoLoop final : public Loop {
  public:
    explicit IoLoop(boost::asio::io_context& context);

    void post(std::function<void()> task) override;
    std::shared_ptr<void> after(std::chrono::milliseconds delay,
                                std::function<void()> task) override;

  private:
    void run_posted();
    void wait();

    boost::asio::io_context& context_;
    core::MpscQueue<std::function<void()>> posted_;
    boost::asio::posix::stream_descriptor woken_; ///< an eventfd
};

} // namespace wakesurf::server
