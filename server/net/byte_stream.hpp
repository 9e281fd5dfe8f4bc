// The bytes of one connection, over TCP or over TLS on top of it, behind one type: HTTP and WebSockets are
// compiled against this, so that each of Beast's algorithms exists once. Has a deadline, after which the
// socket is closed.
#pragma once

#include "server/net/tls_context.hpp"
#include "server/net/trusted_proxies.hpp"

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/buffer.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/system/error_code.hpp>

#include <array>
#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <utility>

namespace boost::beast {
enum class role_type;
}

namespace wakesurf::server {

/// A completion handler of any type behind one type, so that Beast's algorithms are compiled once for all
/// streams. Asio has its own (any_completion_handler) since Boost 1.82.
/// Holds a handler. Move-only; called once. Cost: one allocation.
class AnyHandler {
  public:
    template <class Handler>

    requires(!std::is_same_v<std::decay_t<Handler>, AnyHandler>) explicit AnyHandler(
        Handler&& handler)
        : call_(std::make_unique<Held<std::decay_t<Handler>>>(std::forward<Handler>(handler))) {}

    void operator()(boost::system::error_code error, std::size_t bytes = 0) {
        const auto call = std::move(call_); // the handler may own the stream
        call->run(error, bytes);
    }

  private:
    struct Callable {
        virtual ~Callable() = default;
        virtual void run(boost::system::error_code error, std::size_t bytes) = 0;
    };

    template <class Handler>
    struct Held final : Callable {
        template <class From>
        explicit Held(From&& from) : handler(std::forward<From>(from)) {}

        void run(boost::system::error_code error, std::size_t bytes) override {
            Handler local(std::move(handler));
            if constexpr (std::is_invocable_v<Handler&, boost::system::error_code, std::size_t>)
                local(error, bytes);
            else
                local(error);
        }

        Handler handler;
    };

    std::unique_ptr<Callable> call_;
};

/// Reads and writes a connection. Loop thread only. An AsyncReadStream and AsyncWriteStream as Beast wants
/// them; handlers are called later, never from within. Movable while no operation is pending.
class ByteStream {
  public:
    using executor_type = boost::asio::any_io_executor;
    using Error = boost::system::error_code;

    /// @param tls  null: plain TCP; outlives the stream
    ByteStream(boost::asio::ip::tcp::socket socket, TlsContext* tls);
    ~ByteStream();
    ByteStream(ByteStream&&) noexcept;
    ByteStream& operator=(ByteStream&&) = delete;

    executor_type get_executor() noexcept;

    /// Does the TLS handshake; completes at once over plain TCP. A client that speaks plain HTTP to a TLS
    /// port gets an answer that says so.
    template <class Handler>
    void async_accept(Handler&& handler) {
        accept(AnyHandler(std::forward<Handler>(handler)));
    }

    template <class Buffers, class Handler>
    void async_read_some(const Buffers& buffers, Handler&& handler) {
        boost::asio::mutable_buffer first;
        const auto end = boost::asio::buffer_sequence_end(buffers);
        for (auto each = boost::asio::buffer_sequence_begin(buffers); each != end; ++each)
            if (first.size() == 0)
                first = boost::asio::mutable_buffer(*each);
        read(first, AnyHandler(std::forward<Handler>(handler)));
    }

    template <class Buffers, class Handler>
    void async_write_some(const Buffers& buffers, Handler&& handler) {
        Gathered gathered;
        const auto end = boost::asio::buffer_sequence_end(buffers);
        for (auto each = boost::asio::buffer_sequence_begin(buffers); each != end; ++each)
            if (const boost::asio::const_buffer bytes(*each);
                bytes.size() > 0 && gathered.count < gathered.buffers.size())
                gathered.buffers[gathered.count++] = bytes;
        write(gathered, AnyHandler(std::forward<Handler>(handler)));
    }

    /// Sends as much as the socket takes without waiting and returns the number of bytes; 0 also if it must
    /// wait for another write, over TLS, and if the connection is broken.
    std::size_t write_at_once(std::span<const boost::asio::const_buffer> buffers);

    /// Sends all of the buffers, which stay valid until then, without other bytes in between. REQUIRES: what
    /// is written meanwhile with async_write_some has at most `whole` bytes, as control frames have.
    template <class Handler>
    void async_write_whole(std::span<const boost::asio::const_buffer> buffers, Handler&& handler) {
        write_whole(buffers, AnyHandler(std::forward<Handler>(handler)));
    }

    static constexpr std::size_t whole = 256;

    /// Reads the PROXY protocol, if a connection from a proxy begins with it. Called before any other read.
    /// Error: it is malformed.
    void async_proxy_header(std::function<void(Error, ProxyHeader)> done);

    /// Puts bytes back, to be read before any others. REQUIRES: no read is pending.
    void put_back(std::string bytes);

    /// Shuts down sending, waits at most `linger` for the peer to do the same, and closes.
    template <class Handler>
    void async_end(Handler&& handler) {
        end(AnyHandler(std::forward<Handler>(handler)));
    }

    /// Closes at once; pending operations are aborted.
    void close();

    /// Sets the deadline at which the socket is closed, in place of an earlier one.
    void expires_after(std::chrono::milliseconds delay);
    void expires_never();

    /// Says whether the deadline closed the socket.
    bool timed_out() const;

    bool encrypted() const;

    /// Says whether the peer has hung up, or will send no more; also if its earlier bytes have not been read.
    bool peer_gone() const;

    static constexpr std::chrono::seconds linger{2};

    // Beast's WebSocket ends the stream below it by this.
    template <class Handler>
    friend void async_teardown(boost::beast::role_type, ByteStream& stream, Handler&& handler) {
        stream.async_end(std::forward<Handler>(handler));
    }

    friend void beast_close_socket(ByteStream& stream) { stream.close(); }

  private:
    struct State;

    /// Holds the first few buffers of a sequence: a write may always send less than it was given.
    struct Gathered {
        using const_iterator = const boost::asio::const_buffer*;

        const_iterator begin() const { return buffers.data(); }

        const_iterator end() const { return buffers.data() + count; }

        std::array<boost::asio::const_buffer, 8> buffers;
        std::size_t count = 0;
    };

    void accept(AnyHandler handler);
    void read(boost::asio::mutable_buffer buffer, AnyHandler handler);
    void write(const Gathered& buffers, AnyHandler handler);
    void write_whole(std::span<const boost::asio::const_buffer> buffers, AnyHandler handler);
    void end(AnyHandler handler);

    std::shared_ptr<State> state_;
};

} // namespace wakesurf::server
