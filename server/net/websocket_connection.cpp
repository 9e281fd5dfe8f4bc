#include "server/net/websocket_connection.hpp"

#include "server/limits.hpp"
#include "server/net/outbox.hpp"
#include "server/rpc/client.hpp"

#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/websocket.hpp>
#include <spdlog/spdlog.h>

#include <memory>
#include <optional>
#include <string>

namespace wakesurf::server {

namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using boost::asio::ip::tcp;
using boost::system::error_code;

namespace {

class WebSocketConnection final : public Connection,
                                  public Wire,
                                  public std::enable_shared_from_this<WebSocketConnection> {
  public:
    WebSocketConnection(tcp::socket socket, NetServices services)
        : stream_(std::move(socket)), stall_(stream_.get_executor()), services_(services) {
        services_.connections.add(*this);
        ++services_.clients;
    }

    ~WebSocketConnection() override {
        services_.connections.remove(*this);
        --services_.clients;
    }

    void accept(const HttpRequest& request, const Identity& identity);

    void go_away() override { close(websocket::close_code::going_away, "the server is stopping"); }

    void abandon() override { end(); }

    void announce(const std::string& message) override { send(message); }

    void send(std::string message) override;
    void send(std::uint32_t surface, const std::shared_ptr<const SurfaceState>& state) override;

    void close(Goodbye goodbye, const std::string& reason) override {
        close(static_cast<websocket::close_code>(goodbye), reason.c_str());
    }

    void drop_frames(std::uint32_t surface, std::uint32_t epoch) override {
        outbox_.drop_frames(surface, epoch);
    }

  private:
    void read();
    void received(bool text, bool whole);
    void write();
    void close(websocket::close_code code, const char* reason);
    void end();

    websocket::stream<beast::tcp_stream> stream_;
    boost::asio::steady_timer stall_; ///< runs while a message is being written
    NetServices services_;
    beast::flat_buffer buffer_;
    Outbox outbox_;
    Outbox::Item writing_;
    bool busy_ = false; ///< a write is under way
    bool open_ = false; ///< between the handshake and the first sign of the end
    std::optional<Client> client_;
};

void WebSocketConnection::accept(const HttpRequest& request, const Identity& identity) {
    http::request<http::empty_body> upgrade(http::verb::get, request.path, 11);
    for (const auto& [name, value] : request.headers)
        upgrade.insert(name, value);
    websocket::stream_base::timeout timeouts{};
    timeouts.handshake_timeout = limits::handshake;
    timeouts.idle_timeout = limits::idle;
    timeouts.keep_alive_pings = true;
    stream_.set_option(timeouts);
    stream_.set_option(
        websocket::permessage_deflate{}); // off: Draco's bytes do not shrink any further
    const bool named = upgrade.count(http::field::sec_websocket_protocol) > 0;
    stream_.set_option(
        websocket::stream_base::decorator([named](websocket::response_type& response) {
            response.set(http::field::server, "wakesurf");
            if (named)
                response.set(http::field::sec_websocket_protocol, "wakesurf.v1");
        }));
    stream_.auto_fragment(false);
    stream_.read_message_max(0); // read() limits it, with a reason in the close frame
    stream_.async_accept(upgrade, [self = shared_from_this(), identity](error_code error) {
        if (error)
            return;
        self->open_ = true;
        self->client_.emplace(*self, identity, self->services_.grants);
        self->read();
    });
}

void WebSocketConnection::read() {
    const std::size_t room = limits::message_bytes + 1 - buffer_.size();
    stream_.async_read_some(
        buffer_, room, [self = shared_from_this()](error_code error, std::size_t) {
            if (error)
                return self->end();
            self->received(self->stream_.got_text(), self->stream_.is_message_done());
        });
}

void WebSocketConnection::received(bool text, bool whole) {
    if (!open_)
        return;
    if (!text)
        return close(websocket::close_code::unknown_data, "binary messages are not accepted");
    if (buffer_.size() > limits::message_bytes)
        return close(websocket::close_code::too_big, "a message may have at most 65536 bytes");
    if (!whole)
        return read();
    const std::string message = beast::buffers_to_string(buffer_.data());
    buffer_.clear();
    services_.routes.dispatcher().dispatch(message, client_->identity(), &*client_,
                                           [weak = weak_from_this()](std::string answer) {
                                               const auto self = weak.lock();
                                               if (self && !answer.empty())
                                                   self->send(std::move(answer));
                                           });
    if (open_)
        read();
}

void WebSocketConnection::send(std::string message) {
    if (!open_)
        return;
    if (!outbox_.push(std::move(message)))
        return close(websocket::close_code::try_again_later, "the client reads too slowly");
    write();
}

void WebSocketConnection::send(std::uint32_t surface,
                               const std::shared_ptr<const SurfaceState>& state) {
    if (!open_)
        return;
    outbox_.push(surface, state);
    write();
}

void WebSocketConnection::write() {
    if (busy_ || !open_)
        return;
    auto item = outbox_.pop();
    if (!item)
        return;
    busy_ = true;
    writing_ = std::move(*item);
    stall_.expires_after(limits::stalled);
    stall_.async_wait([weak = weak_from_this()](error_code error) {
        const auto self = weak.lock();
        if (!error && self) {
            spdlog::info("a client that took no data for 30 s was disconnected");
            self->end();
        }
    });
    const auto* text = std::get_if<std::string>(&writing_);
    stream_.text(text != nullptr);
    const auto bytes = text != nullptr
                           ? boost::asio::buffer(*text)
                           : boost::asio::buffer(std::get<Outbox::Frame>(writing_)->data(),
                                                 std::get<Outbox::Frame>(writing_)->size());
    stream_.async_write(bytes, [self = shared_from_this()](error_code error, std::size_t) {
        self->busy_ = false;
        self->stall_.cancel();
        if (error)
            return self->end();
        self->write();
    });
}

/// Leaves the session at once; the close frame, and waiting for the client's, follow.
void WebSocketConnection::close(websocket::close_code code, const char* reason) {
    if (!open_)
        return;
    open_ = false;
    boost::asio::post(stream_.get_executor(),
                      [self = shared_from_this()] { self->client_.reset(); });
    stream_.async_close({code, reason}, [self = shared_from_this()](error_code) { self->end(); });
}

void WebSocketConnection::end() {
    open_ = false;
    stall_.cancel();
    // A session may be telling its participants something just now; it must not lose one while it does.
    boost::asio::post(stream_.get_executor(), [self = shared_from_this()] {
        self->client_.reset();
        beast::get_lowest_layer(self->stream_).close();
    });
}

} // namespace

void serve_websocket(tcp::socket socket,
                     const HttpRequest& upgrade,
                     const Identity& identity,
                     NetServices services) {
    std::make_shared<WebSocketConnection>(std::move(socket), services)->accept(upgrade, identity);
}

} // namespace wakesurf::server
