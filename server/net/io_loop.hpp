// The session's loop on the network's io_context.
#pragma once

#include "server/session/loop.hpp"

#include <boost/asio/io_context.hpp>

namespace wakesurf::server {

class IoLoop final : public Loop {
  public:
    explicit IoLoop(boost::asio::io_context& context) : context_(context) {}

    void post(std::function<void()> task) override;
    std::shared_ptr<void> after(std::chrono::milliseconds delay,
                                std::function<void()> task) override;

  private:
    boost::asio::io_context& context_;
};

} // namespace wakesurf::server
