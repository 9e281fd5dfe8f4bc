#include "server/net/listener.hpp"

#include "server/base/log_text.hpp"

#include <boost/asio/io_context.hpp>
#include <spdlog/spdlog.h>

#include <utility>

namespace wakesurf::server {

namespace asio = boost::asio;
using asio::ip::tcp;
using core::Error;
using core::fail;

core::Result<std::shared_ptr<Listener>> Listener::open(asio::io_context& context,
                                                       const std::string& host,
                                                       std::uint16_t port,
                                                       Accepted accepted) {
    boost::system::error_code error;
    tcp::resolver resolver(context);
    const auto found = resolver.resolve(host, std::to_string(port), tcp::resolver::passive, error);
    if (error || found.empty())
        return fail(Error::Code::InvalidArgument,
                    "`" + host + "` is not an address of this machine",
                    "give --listen HOST:PORT, for example 127.0.0.1:8080");
    const tcp::endpoint endpoint = found.begin()->endpoint();
    std::shared_ptr<Listener> self(new Listener(context, std::move(accepted)));
    self->acceptor_.open(endpoint.protocol(), error);
    if (!error)
        self->acceptor_.set_option(tcp::acceptor::reuse_address(true), error);
    if (!error)
        self->acceptor_.bind(endpoint, error);
    if (!error)
        self->acceptor_.listen(asio::socket_base::max_listen_connections, error);
    if (error)
        return fail(Error::Code::Io,
                    "cannot listen on " + host + ":" + std::to_string(port) + ": " +
                        error.message(),
                    "choose another with --listen, port 0 picks a free one");
    return self;
}

std::uint16_t Listener::port() const {
    boost::system::error_code ignored;
    return acceptor_.local_endpoint(ignored).port();
}

void Listener::start() {
    acceptor_.async_accept(
        [self = shared_from_this()](boost::system::error_code error, tcp::socket socket) {
            if (!self->acceptor_.is_open())
                return;
            if (!error) {
                self->paused_ = false;
                self->accepted_(std::move(socket));
                return self->start();
            }
            if (!std::exchange(self->paused_, true)) // logged once, not ten times a second
                spdlog::warn("event=accept_paused reason={}", log_value(error.message()));
            self->pause_.expires_after(std::chrono::milliseconds(100));
            self->pause_.async_wait([self](boost::system::error_code stopped) {
                if (!stopped && self->acceptor_.is_open())
                    self->start();
            });
        });
}

void Listener::stop() {
    boost::system::error_code ignored;
    acceptor_.close(ignored);
    pause_.cancel();
}

} // namespace wakesurf::server
