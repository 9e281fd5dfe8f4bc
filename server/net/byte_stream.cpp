#include "server/net/byte_stream.hpp"

#include <boost/asio/post.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <array>
#include <utility>

namespace wakesurf::server {

namespace asio = boost::asio;
namespace ssl = asio::ssl;
using asio::ip::tcp;

namespace {

constexpr char tls_handshake_record = 0x16;

} // namespace

ByteStream::ByteStream(tcp::socket socket, TlsContext* tls) : socket_(std::move(socket)) {
    if (tls != nullptr)
        tls_ = std::make_unique<ssl::stream<tcp::socket&>>(socket_, tls->context());
}

ByteStream::~ByteStream() = default;

/// Reads more of what decides the protocol.
void ByteStream::read_ahead(std::function<void(Error)> done) {
    const std::size_t had = ahead_.size();
    ahead_.resize(had + longest_proxy_header);
    socket_.async_read_some(
        asio::buffer(ahead_) + had,
        [self = shared_from_this(), had, done = std::move(done)](Error error, std::size_t bytes) {
            self->ahead_.resize(had + bytes);
            done(error);
        });
}

void ByteStream::async_proxy_header(std::function<void(Error, ProxyHeader)> done) {
    const ProxyHeader header = parse_proxy_header(ahead_);
    if (header.is == ProxyHeader::Is::Malformed)
        return done(asio::error::make_error_code(asio::error::no_protocol_option), header);
    if (header.is == ProxyHeader::Is::Partial)
        return read_ahead([this, done = std::move(done)](Error error) mutable {
            if (error)
                return done(error, {});
            async_proxy_header(std::move(done));
        });
    ahead_.erase(0, header.length);
    done({}, header);
}

/// Decides by the first byte: a TLS record, or plain HTTP.
void ByteStream::async_accept(std::function<void(Error)> done) {
    if (tls_ && ahead_.empty())
        return read_ahead([this, done = std::move(done)](Error error) mutable {
            if (error)
                return done(error);
            async_accept(std::move(done));
        });
    if (tls_ && ahead_.front() != tls_handshake_record)
        tls_.reset();
    if (!tls_)
        return done({});
    tls_->async_handshake(
        ssl::stream_base::server, asio::buffer(ahead_),
        [self = shared_from_this(), done = std::move(done)](Error error, std::size_t) {
            self->ahead_ = std::string(); // TLS has a copy
            done(error);
        });
}

void ByteStream::read(asio::mutable_buffer buffer, Done done) {
    if (!ahead_.empty()) {
        const std::size_t taken = asio::buffer_copy(buffer, asio::buffer(ahead_));
        ahead_ = ahead_.substr(taken);
        return asio::post(get_executor(), [taken, done = std::move(done)] { done({}, taken); });
    }
    if (!tls_)
        return socket_.async_read_some(buffer, std::move(done));
    // TLS touches its state once more before it calls a handler.
    tls_->async_read_some(buffer, [self = shared_from_this(), done = std::move(done)](
                                      Error error, std::size_t bytes) { done(error, bytes); });
}

void ByteStream::write(Gathered buffers, Done done) {
    if (asio::buffer_size(buffers) <= whole)
        return write_whole(std::move(buffers), std::move(done));
    if (!tls_)
        return socket_.async_write_some(buffers, std::move(done));
    tls_->async_write_some(buffers, [self = shared_from_this(), done = std::move(done)](
                                        Error error, std::size_t bytes) { done(error, bytes); });
}

void ByteStream::write_whole(Gathered buffers, Done done) {
    if (std::exchange(writing_, true))
        return static_cast<void>(waiting_.emplace_back(std::move(buffers), std::move(done)));
    auto written = [self = shared_from_this(), done = std::move(done)](Error error,
                                                                       std::size_t bytes) {
        self->writing_ = false;
        if (!self->waiting_.empty()) {
            auto [next, then] = std::move(self->waiting_.front());
            self->waiting_.erase(self->waiting_.begin());
            self->write_whole(std::move(next), std::move(then));
        }
        done(error, bytes);
    };
    if (tls_)
        asio::async_write(*tls_, buffers, std::move(written));
    else
        asio::async_write(socket_, buffers, std::move(written));
}

void ByteStream::end(Done done) {
    const auto deadline = std::make_shared<asio::steady_timer>(get_executor(), linger);
    deadline->async_wait([weak = weak_from_this()](Error error) {
        if (const auto self = weak.lock(); self && !error)
            self->close();
    });
    auto last = [self = shared_from_this(), deadline, done = std::move(done)](Error) mutable {
        Error ignored;
        self->socket_.shutdown(tcp::socket::shutdown_send, ignored);
        self->drain([deadline, done = std::move(done)](Error error, std::size_t) {
            deadline->cancel();
            done(error, 0);
        });
    };
    if (tls_)
        tls_->async_shutdown(std::move(last));
    else
        last({});
}

/// Reads until the end: closing with unread bytes would reset the connection and lose what was sent last.
void ByteStream::drain(Done done) {
    const auto rest = std::make_shared<std::array<char, 512>>();
    socket_.async_read_some(asio::buffer(*rest),
                            [self = shared_from_this(), rest,
                             done = std::move(done)](Error error, std::size_t) mutable {
                                if (!error)
                                    return self->drain(std::move(done));
                                self->close();
                                done({}, 0);
                            });
}

void ByteStream::close() {
    Error ignored;
    socket_.close(ignored);
}

bool ByteStream::peer_gone() {
    tcp_info info{};
    socklen_t size = sizeof info;
    return getsockopt(socket_.native_handle(), IPPROTO_TCP, TCP_INFO, &info, &size) != 0 ||
           info.tcpi_state != TCP_ESTABLISHED;
}

} // namespace wakesurf::server
