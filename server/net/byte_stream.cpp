#include "server/net/byte_stream.hpp"

#include "server/base/limits.hpp"
#include "server/net/http_message.hpp"

#include <boost/asio/ssl/stream.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <optional>
#include <string>
#include <vector>

namespace wakesurf::server {

namespace asio = boost::asio;
namespace ssl = asio::ssl;
using asio::ip::tcp;
using boost::system::error_code;

namespace {

constexpr unsigned char tls_handshake_record = 0x16;

/// Holds a sequence of buffers as Asio wants it.
struct Several {
    const asio::const_buffer* begin() const { return buffers.data(); }

    const asio::const_buffer* end() const { return buffers.data() + buffers.size(); }

    std::span<const asio::const_buffer> buffers;
};

std::string wants_tls() {
    const std::string body = "this port speaks TLS: use https:// or wss://\n";
    std::string text = "HTTP/1.1 400 Bad Request\r\nContent-Type: text/plain\r\n"
                       "Cache-Control: no-store\r\nConnection: close\r\n";
    for (const auto& [name, value] : SecurityHeaders().all())
        text.append(name).append(": ").append(value).append("\r\n");
    return text + "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
}

} // namespace

struct ByteStream::State : std::enable_shared_from_this<State> {
    State(tcp::socket connected, TlsContext* context)
        : socket(std::move(connected)), deadline(socket.get_executor()) {
        if (context != nullptr)
            tls.emplace(socket, context->context());
    }

    void close() {
        deadline.cancel();
        error_code ignored;
        socket.close(ignored);
    }

    void expires_after(std::chrono::milliseconds delay) {
        deadline.expires_after(delay);
        deadline.async_wait([weak = weak_from_this()](error_code error) {
            const auto self = weak.lock();
            // A timer that was set again too late to be cancelled must not act.
            if (error || !self || self->deadline.expiry() > asio::steady_timer::clock_type::now())
                return;
            self->timed_out = true;
            error_code ignored;
            self->socket.close(ignored);
        });
    }

    void expires_never() { deadline.expires_at(asio::steady_timer::time_point::max()); }

    template <class Buffers>
    void write_whole(const Buffers& buffers, AnyHandler handler);
    void read_proxy_header(std::size_t seen, std::function<void(error_code, ProxyHeader)> done);
    void handshake(AnyHandler handler);
    void tell_plain(AnyHandler handler);
    void drain(AnyHandler handler);

    tcp::socket socket;
    asio::steady_timer deadline;
    std::optional<ssl::stream<tcp::socket&>> tls;
    std::string put_back;         ///< read already, to be read again
    std::array<char, 512> rest{}; ///< data behind the end, discarded
    bool timed_out = false;
    bool writing = false;               ///< a write must not be interrupted
    std::vector<AnyHandler> next_write; ///< writes that wait for that
};

template <class Buffers>
void ByteStream::State::write_whole(const Buffers& buffers, AnyHandler handler) {
    auto begin = [self = shared_from_this(), buffers,
                  handler = std::move(handler)](error_code, std::size_t) mutable {
        self->writing = true;
        auto done = [self, handler = std::move(handler)](error_code error,
                                                         std::size_t sent) mutable {
            self->writing = false;
            if (!self->next_write.empty()) {
                AnyHandler next = std::move(self->next_write.front());
                self->next_write.erase(self->next_write.begin());
                next({});
            }
            handler(error, sent);
        };
        if (self->tls)
            asio::async_write(*self->tls, buffers, AnyHandler(std::move(done)));
        else
            asio::async_write(self->socket, buffers, AnyHandler(std::move(done)));
    };
    if (writing)
        next_write.emplace_back(std::move(begin));
    else
        AnyHandler(std::move(begin))({});
}

/// Peeks at the header: behind it may be the first bytes of TLS, which must stay in the socket.
/// @param seen  bytes that were there the last time
void ByteStream::State::read_proxy_header(std::size_t seen,
                                          std::function<void(error_code, ProxyHeader)> done) {
    error_code ignored;
    socket.set_option(asio::socket_base::receive_low_watermark(static_cast<int>(seen) + 1),
                      ignored);
    socket.async_wait(tcp::socket::wait_read, [self = shared_from_this(), seen,
                                               done = std::move(done)](error_code error) mutable {
        std::array<char, longest_proxy_header> first{};
        std::size_t there = 0;
        if (!error)
            there = self->socket.receive(asio::buffer(first), tcp::socket::message_peek, error);
        const ProxyHeader header = parse_proxy_header({first.data(), there});
        const bool partial = header.is == ProxyHeader::Is::Partial;
        if (!error && partial && there > seen)
            return self->read_proxy_header(there, std::move(done));
        if (!error && (partial || header.is == ProxyHeader::Is::Malformed))
            error = asio::error::make_error_code(asio::error::no_protocol_option);
        if (!error)
            self->socket.receive(asio::buffer(first.data(), header.length), 0, error);
        error_code lost;
        self->socket.set_option(asio::socket_base::receive_low_watermark(1), lost);
        done(error, header);
    });
}

/// Decides by the first byte: a TLS record, or plain HTTP.
void ByteStream::State::handshake(AnyHandler handler) {
    socket.async_wait(
        tcp::socket::wait_read,
        [self = shared_from_this(), handler = std::move(handler)](error_code error) mutable {
            unsigned char first = 0;
            if (!error)
                self->socket.receive(asio::buffer(&first, 1), tcp::socket::message_peek, error);
            if (error)
                return handler(error);
            if (first != tls_handshake_record)
                return self->tell_plain(std::move(handler));
            self->tls->async_handshake(ssl::stream_base::server,
                                       [self, handler = std::move(handler)](
                                           error_code failed) mutable { handler(failed); });
        });
}

void ByteStream::State::tell_plain(AnyHandler handler) {
    auto text = std::make_shared<const std::string>(wants_tls());
    tls.reset();
    asio::async_write(socket, asio::buffer(*text),
                      [self = shared_from_this(), text,
                       handler = std::move(handler)](error_code, std::size_t) mutable {
                          handler(asio::error::make_error_code(asio::error::no_protocol_option));
                      });
}

/// Reads until the end: closing with unread bytes would reset the connection and lose what was sent last.
void ByteStream::State::drain(AnyHandler handler) {
    socket.async_read_some(asio::buffer(rest),
                           [self = shared_from_this(),
                            handler = std::move(handler)](error_code error, std::size_t) mutable {
                               if (!error)
                                   return self->drain(std::move(handler));
                               self->close();
                               handler({});
                           });
}

namespace {

template <class State>
auto kept_alive(std::shared_ptr<State> state, AnyHandler handler) {
    return [state = std::move(state), handler = std::move(handler)](
               error_code error, std::size_t bytes) mutable { handler(error, bytes); };
}

} // namespace

ByteStream::ByteStream(tcp::socket socket, TlsContext* tls)
    : state_(std::make_shared<State>(std::move(socket), tls)) {}

ByteStream::~ByteStream() {
    if (state_)
        state_->close();
}

ByteStream::ByteStream(ByteStream&&) noexcept = default;

ByteStream::executor_type ByteStream::get_executor() noexcept {
    return state_->socket.get_executor();
}

void ByteStream::accept(AnyHandler handler) {
    if (state_->tls)
        return state_->handshake(std::move(handler));
    asio::post(state_->socket.get_executor(),
               [handler = std::move(handler)]() mutable { handler({}); });
}

// TLS touches its state once more before it calls a handler, even if the stream is destroyed meanwhile.
void ByteStream::read(asio::mutable_buffer buffer, AnyHandler handler) {
    if (!state_->put_back.empty()) {
        const std::size_t taken = asio::buffer_copy(buffer, asio::buffer(state_->put_back));
        state_->put_back.erase(0, taken);
        return asio::post(state_->socket.get_executor(),
                          [taken, handler = std::move(handler)]() mutable { handler({}, taken); });
    }
    if (state_->tls)
        state_->tls->async_read_some(buffer, kept_alive(state_, std::move(handler)));
    else
        state_->socket.async_read_some(buffer, std::move(handler));
}

void ByteStream::write(const Gathered& buffers, AnyHandler handler) {
    if (asio::buffer_size(buffers) <= whole)
        return state_->write_whole(buffers, std::move(handler));
    if (state_->tls)
        state_->tls->async_write_some(buffers, kept_alive(state_, std::move(handler)));
    else
        state_->socket.async_write_some(buffers, std::move(handler));
}

void ByteStream::async_proxy_header(std::function<void(Error, ProxyHeader)> done) {
    state_->read_proxy_header(0, std::move(done));
}

void ByteStream::put_back(std::string bytes) {
    state_->put_back = std::move(bytes);
}

void ByteStream::write_whole(std::span<const asio::const_buffer> buffers, AnyHandler handler) {
    state_->write_whole(Several{buffers}, std::move(handler));
}

std::size_t ByteStream::write_at_once(std::span<const asio::const_buffer> buffers) {
    if (state_->writing || state_->tls)
        return 0;
    error_code error;
    if (!state_->socket.non_blocking())
        state_->socket.non_blocking(true, error);
    const std::size_t sent = error ? 0 : state_->socket.send(Several{buffers}, 0, error);
    return error ? 0 : sent;
}

void ByteStream::end(AnyHandler handler) {
    expires_after(linger);
    const auto last = [state = state_](AnyHandler then) {
        error_code ignored;
        state->socket.shutdown(tcp::socket::shutdown_send, ignored);
        state->drain(std::move(then));
    };
    if (!state_->tls)
        return last(std::move(handler));
    state_->tls->async_shutdown(
        [last, handler = std::move(handler)](error_code) mutable { last(std::move(handler)); });
}

void ByteStream::close() {
    state_->close();
}

void ByteStream::expires_after(std::chrono::milliseconds delay) {
    state_->expires_after(delay);
}

void ByteStream::expires_never() {
    state_->expires_never();
}

bool ByteStream::timed_out() const {
    return state_->timed_out;
}

bool ByteStream::peer_gone() const {
    tcp_info info{};
    socklen_t size = sizeof info;
    const int socket = state_->socket.native_handle();
    return getsockopt(socket, IPPROTO_TCP, TCP_INFO, &info, &size) != 0 ||
           info.tcpi_state != TCP_ESTABLISHED;
}

bool ByteStream::encrypted() const {
    return state_->tls.has_value();
}

} // namespace wakesurf::server
