// Accepts connections until stopped. Without free descriptors it only pauses.
#pragma once

#include "core/base/result.hpp"

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace wakesurf::server {

class Listener : public std::enable_shared_from_this<Listener> {
  public:
    using Accepted = std::function<void(boost::asio::ip::tcp::socket)>;

    /// Opens the socket. Error: InvalidArgument for an address, Io if it cannot be listened on.
    static core::Result<std::shared_ptr<Listener>> open(boost::asio::io_context& context,
                                                        const std::string& host,
                                                        std::uint16_t port,
                                                        Accepted accepted);

    std::uint16_t port() const;
    void start();
    void stop();

  private:
    Listener(boost::asio::io_context& context, Accepted accepted)
        : acceptor_(context), pause_(context), accepted_(std::move(accepted)) {}

    boost::asio::ip::tcp::acceptor acceptor_;
    boost::asio::steady_timer pause_;
    Accepted accepted_;
    bool paused_ = false; ///< the last accept failed
};

} // namespace wakesurf::server
