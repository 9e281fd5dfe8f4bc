#include "server/net/websocket_connection.hpp"

#include "server/base/limits.hpp"
#include "server/net/methods/client.hpp"

#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/websocket.hpp>
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace wakesurf::server {

namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using boost::system::error_code;

namespace {

std::span<const std::byte> bytes_of(const Outbox::Item& item) {
    if (const auto* text = std::get_if<Outbox::Message>(&item))
        return std::as_bytes(std::span(**text));
    return *std::get<Outbox::Frame>(item);
}

bool is_text(const Outbox::Item& item) {
    return std::holds_alternative<Outbox::Message>(item);
}

/// Several messages and frames in a single write, behind their headers (RFC 6455, 5.2): an event gives a viewer
/// some six of them. Where Beast wrote them one at a time, 500 viewers at 10 Hz cost a fifth more of the network
/// thread, and on two busy cores half of their frames were skipped and a call waited 11 to 32 ms instead of 1.
class MessageBatch {
  public:
    /// Takes messages and frames out of the outbox until it is empty or the batch is full.
    void fill(Outbox& outbox, const bool& frames) {
        while (items_.size() < most_messages && bytes_ < enough_bytes) {
            auto item = outbox.pop(frames); // which may end the connection
            if (!item)
                return;
            bytes_ += bytes_of(*item).size();
            items_.push_back(std::move(*item));
        }
    }

    const std::vector<Outbox::Item>& items() const { return items_; }

    /// Returns what to send, which the batch holds.
    std::vector<boost::asio::const_buffer> buffers() {
        std::vector<boost::asio::const_buffer> out;
        for (std::size_t i = 0; i < items_.size(); ++i) {
            const auto payload = bytes_of(items_[i]);
            out.push_back(header(headers_[i], is_text(items_[i]) ? 0x81 : 0x82, payload.size()));
            out.emplace_back(payload.data(), payload.size());
        }
        return out;
    }

  private:
    static constexpr std::size_t most_messages = 16;
    static constexpr std::size_t enough_bytes = std::size_t{64} << 10;
    using Header = std::array<std::uint8_t, 10>;

    /// Writes an unmasked header, as servers do. @param first  the last fragment's bit and the kind
    static boost::asio::const_buffer header(Header& out, std::uint8_t first, std::uint64_t length) {
        out = {first, static_cast<std::uint8_t>(length)};
        if (length <= 125)
            return boost::asio::buffer(out, 2);
        const std::size_t size = length <= 0xffff ? 2 : 8;
        out[1] = size == 2 ? 126 : 127;
        for (std::size_t i = 0; i < size; ++i) // the most significant byte first
            out[2 + i] = static_cast<std::uint8_t>(length >> (8 * (size - 1 - i)));
        return boost::asio::buffer(out, 2 + size);
    }

    std::vector<Outbox::Item> items_;
    std::array<Header, most_messages> headers_{};
    std::size_t bytes_ = 0;
};

constexpr std::size_t small_message = 1024;
constexpr std::size_t large_part = std::size_t{16} << 10;
constexpr double part_of_message = 0.25; ///< the cost of reading a message that comes in parts
constexpr std::chrono::milliseconds most_debt{2000}; ///< of a client that pings

class WebSocketConnection final : public Connection,
                                  public Wire,
                                  public WriteScheduler::Writer,
                                  public std::enable_shared_from_this<WebSocketConnection> {
  public:
    WebSocketConnection(std::shared_ptr<ByteStream> stream,
                        const Admitted& admitted,
                        NetServices services,
                        std::unique_ptr<Admission::Permit> permit)
        : bytes_(std::move(stream)), stream_(*bytes_), stall_(stream_.get_executor()),
          services_(services), permit_(std::move(permit)), admitted_(admitted),
          pause_(stream_.get_executor()), outbox_(&services.outboxes) {
        services_.connections.add(*this);
    }

    ~WebSocketConnection() override { services_.connections.remove(*this); }

    void accept(const HttpRequest& request);

    void go_away() override { close(websocket::close_code::going_away, "the server is stopping"); }

    void abandon() override { end(); }

    void announce(const std::string& message) override { send(message); }

    void log_out(const std::string& person) override {
        if (client_ && open_ && admitted_.visitor.person == person)
            client_->logged_out();
    }

    void send(std::string message) override {
        send_shared(std::make_shared<const std::string>(std::move(message)));
    }

    void send_shared(const std::shared_ptr<const std::string>& message) override;

    void write_turn() override;

    void close(Goodbye goodbye, const std::string& reason) override {
        close(static_cast<websocket::close_code>(goodbye), reason.c_str());
    }

    bool may_follow(std::uint32_t surface) override { return outbox_.may_follow(surface); }

    void follow(FrameCursor cursor) override;

    bool unfollow(std::uint32_t surface) override { return outbox_.unfollow(surface); }

    bool acknowledge(std::uint32_t surface,
                     std::optional<std::uint32_t> epoch,
                     std::uint32_t seq) override;

  private:
    void read();
    void received(bool text, bool whole);
    void read_after(double messages);
    void pinged();
    void write_soon();
    void written(const MessageBatch& batch, std::chrono::steady_clock::time_point begun);
    void watch_for_stall();
    void close(websocket::close_code code, const char* reason);
    void end();

    std::shared_ptr<ByteStream> bytes_;
    websocket::stream<ByteStream&> stream_;
    boost::asio::steady_timer stall_; ///< runs during a write
    NetServices services_;
    std::unique_ptr<Admission::Permit> permit_;
    const Admitted admitted_;
    /// Runs while a client that sends too fast is not read.
    boost::asio::steady_timer pause_;
    beast::flat_buffer buffer_;
    Outbox outbox_;
    bool busy_ = false; ///< a write is under way, or waits for its turn
    bool open_ = false; ///< between the handshake and the first sign of the end
    std::optional<websocket::close_reason> last_; ///< to be sent behind the messages
    std::optional<Client> client_;
};

void WebSocketConnection::accept(const HttpRequest& request) {
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
    stream_.set_option(websocket::stream_base::decorator(
        [named, &headers = services_.headers](websocket::response_type& response) {
            response.set(http::field::server, "wakesurf");
            for (const auto& [name, value] : headers.all())
                response.set(beast::string_view(name.data(), name.size()),
                             beast::string_view(value.data(), value.size()));
            if (named)
                response.set(http::field::sec_websocket_protocol, "wakesurf.v1");
        }));
    stream_.auto_fragment(false);
    // read() limits it, with a reason in the close frame; far longer messages are cut off earlier.
    stream_.read_message_max(16 * limits::message_bytes);
    stream_.control_callback([this](websocket::frame_type kind, beast::string_view) {
        if (kind == websocket::frame_type::ping)
            pinged();
    });
    stream_.async_accept(upgrade, [self = shared_from_this()](error_code error) {
        if (error)
            return;
        self->open_ = true;
        spdlog::debug("event=client_opened client={}", self->permit_->number());
        self->client_.emplace(*self, self->admitted_.visitor, self->services_.grants);
        self->read();
    });
}

/// Memory of idle clients counts by the thousand: the buffer grows only while a message arrives.
void WebSocketConnection::read() {
    const std::size_t room = buffer_.size() == 0
                                 ? small_message
                                 : std::min(large_part, limits::message_bytes + 1 - buffer_.size());
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
        return close(
            websocket::close_code::too_big,
            fmt::format("a message may have at most {} bytes", limits::message_bytes).c_str());
    if (!whole)
        return read_after(part_of_message);
    const std::string message = beast::buffers_to_string(buffer_.data());
    buffer_.clear();
    if (buffer_.capacity() > small_message)
        buffer_.shrink_to_fit();
    services_.metrics.message_received(message.size());
    services_.routes.dispatcher().dispatch(message, client_->identity(), &*client_,
                                           [weak = weak_from_this()](std::string answer) {
                                               const auto self = weak.lock();
                                               if (self && !answer.empty())
                                                   self->send(std::move(answer));
                                           });
    read_after(1.0 + static_cast<double>(message.size()) / 1024.0);
}

void WebSocketConnection::read_after(double messages) {
    if (!open_)
        return;
    const auto wait = services_.budgets.read(admitted_.visitor, messages);
    if (wait.count() == 0)
        return read();
    services_.metrics.reject(Rejection::RateLimited);
    pause_.expires_after(wait);
    pause_.async_wait([self = shared_from_this()](error_code error) {
        if (!error && self->open_)
            self->read();
    });
}

/// Called while reading, which continues: a client that pings more than it may cannot be made to wait.
void WebSocketConnection::pinged() {
    if (!open_ || services_.budgets.read(admitted_.visitor, 1.0) < most_debt)
        return;
    services_.metrics.reject(Rejection::RateLimited);
    boost::asio::post(stream_.get_executor(), [self = shared_from_this()] {
        self->close(websocket::close_code::policy_error, "the client pings too often");
    });
}

void WebSocketConnection::send_shared(const std::shared_ptr<const std::string>& message) {
    if (!open_)
        return;
    if (!outbox_.push(message)) {
        services_.metrics.reject(Rejection::Overflow);
        return close(websocket::close_code::try_again_later, "the client reads too slowly");
    }
    write_soon();
}

void WebSocketConnection::follow(FrameCursor cursor) {
    cursor.wake_by([weak = weak_from_this()] {
        if (const auto self = weak.lock())
            self->write_soon();
    });
    outbox_.follow(std::move(cursor));
    write_soon();
}

bool WebSocketConnection::acknowledge(std::uint32_t surface,
                                      std::optional<std::uint32_t> epoch,
                                      std::uint32_t seq) {
    FrameCursor* const cursor = outbox_.cursor(surface);
    if (cursor == nullptr)
        return false;
    cursor->acknowledge({epoch.value_or(cursor->ring().epoch()), seq});
    write_soon();
    return true;
}

void WebSocketConnection::write_soon() {
    if (!std::exchange(busy_, true))
        services_.turns.ask(weak_from_this());
}

/// Writes one batch; the next waits for its turn once the socket has taken it.
void WebSocketConnection::write_turn() {
    auto batch = std::make_shared<MessageBatch>();
    batch->fill(outbox_, open_);
    if (batch->items().empty()) {
        busy_ = false;
        if (const auto reason = std::exchange(last_, std::nullopt))
            stream_.async_close(*reason, [self = shared_from_this()](error_code) { self->end(); });
        return;
    }
    if (open_)
        watch_for_stall();
    bytes_->async_write_whole(batch->buffers(), [self = shared_from_this(), batch,
                                                 begun = std::chrono::steady_clock::now()](
                                                    error_code error, std::size_t) {
        if (error)
            return self->end();
        self->written(*batch, begun);
    });
}

void WebSocketConnection::written(const MessageBatch& batch,
                                  std::chrono::steady_clock::time_point begun) {
    if (open_)
        stall_.cancel();
    outbox_.sent();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
    for (const Outbox::Item& each : batch.items()) {
        const std::size_t bytes = bytes_of(each).size();
        if (is_text(each)) {
            services_.metrics.message_sent(bytes);
            continue;
        }
        services_.metrics.observe(Stage::Send, took.count());
        services_.metrics.frame_sent(bytes);
    }
    busy_ = false;
    write_soon();
}

void WebSocketConnection::watch_for_stall() {
    stall_.expires_after(limits::stalled);
    stall_.async_wait([self = shared_from_this()](error_code error) {
        if (error)
            return;
        spdlog::info("event=client_stalled client={} seconds={}", self->permit_->number(),
                     limits::stalled.count());
        self->services_.metrics.reject(Rejection::Stalled);
        self->end();
    });
}

/// Leaves the session at once; the messages before it, the close frame, and waiting for the client's follow.
void WebSocketConnection::close(websocket::close_code code, const char* reason) {
    if (!open_)
        return;
    open_ = false;
    last_.emplace(code, reason);
    spdlog::debug("event=client_closed client={} code={}", permit_->number(),
                  static_cast<unsigned>(code)); // the reason may be a user's text
    boost::asio::post(stream_.get_executor(),
                      [self = shared_from_this()] { self->client_.reset(); });
    watch_for_stall(); // however slowly the client takes the rest
    write_soon();
}

void WebSocketConnection::end() {
    if (open_)
        spdlog::debug("event=client_gone client={}", permit_->number());
    open_ = false;
    stall_.cancel();
    pause_.cancel();
    // A session that is notifying its participants must not lose one meanwhile.
    boost::asio::post(stream_.get_executor(), [self = shared_from_this()] {
        self->client_.reset();
        self->bytes_->close();
    });
}

} // namespace

void serve_websocket(std::shared_ptr<ByteStream> stream,
                     const HttpRequest& upgrade,
                     const Admitted& admitted,
                     NetServices services,
                     std::unique_ptr<Admission::Permit> permit) {
    std::make_shared<WebSocketConnection>(std::move(stream), admitted, services, std::move(permit))
        ->accept(upgrade);
}

} // namespace wakesurf::server
