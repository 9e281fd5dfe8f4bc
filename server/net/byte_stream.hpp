// The bytes of one connection, over TCP or over TLS on top of it, behind one type: HTTP and WebSockets are
// compiled against this, so that each of Beast's algorithms exists once.
#pragma once

#include "server/net/tls_context.hpp"
#include "server/net/trusted_proxies.hpp"

#include <boost/asio/buffer.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/system/error_code.hpp>

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace boost::asio::ssl {
template <typename Stream>
class stream;
}

namespace boost::beast {
enum class role_type;
}

namespace wakesurf::server {

/// Reads and writes a connection. Loop thread only. An AsyncReadStream and AsyncWriteStream as Beast wants
/// them; their handlers are called later, never from within. It lives until its operations have ended.
class ByteStream : public std::enable_shared_from_this<ByteStream> {
  public:
    using executor_type = boost::asio::ip::tcp::socket::executor_type;
    using Error = boost::system::error_code;

    /// @param tls  null: plain TCP; outlives the stream
    ByteStream(boost::asio::ip::tcp::socket socket, TlsContext* tls);
    ~ByteStream();
    ByteStream(const ByteStream&) = delete;
    ByteStream& operator=(const ByteStream&) = delete;

    executor_type get_executor() noexcept { return socket_.get_executor(); }

    /// Reads the PROXY protocol, if a connection from a proxy begins with it. Called before any other read.
    /// Error: it is malformed.
    void async_proxy_header(std::function<void(Error, ProxyHeader)> done);

    /// Does the TLS handshake. The connection of a client that speaks plain HTTP to a TLS port is then not
    /// encrypted().
    void async_accept(std::function<void(Error)> done);

    template <class Buffers, class Handler>
    void async_read_some(const Buffers& buffers, Handler&& handler) {
        boost::asio::mutable_buffer first;
        const auto end = boost::asio::buffer_sequence_end(buffers);
        for (auto each = boost::asio::buffer_sequence_begin(buffers); each != end; ++each)
            if (first.size() == 0)
                first = boost::asio::mutable_buffer(*each);
        read(first, held(std::forward<Handler>(handler)));
    }

    template <class Buffers, class Handler>
    void async_write_some(const Buffers& buffers, Handler&& handler) {
        write(Gathered(boost::asio::buffer_sequence_begin(buffers),
                       boost::asio::buffer_sequence_end(buffers)),
              held(std::forward<Handler>(handler)));
    }

    /// Sends all of the buffers, which stay valid until then, without other bytes in between. REQUIRES: what
    /// is written meanwhile with async_write_some has at most `whole` bytes, as control frames have.
    template <class Handler>
    void async_write_whole(std::vector<boost::asio::const_buffer> buffers, Handler&& handler) {
        write_whole(std::move(buffers), held(std::forward<Handler>(handler)));
    }

    static constexpr std::size_t whole = 256;

    /// Puts bytes back, to be read before any others. REQUIRES: no read is pending.
    void put_back(std::string bytes) { ahead_ = std::move(bytes); }

    /// Shuts down sending, waits at most `linger` for the peer to do the same, and closes.
    template <class Handler>
    void async_end(Handler&& handler) {
        end(held(std::forward<Handler>(handler)));
    }

    /// Closes at once; pending operations are aborted.
    void close();

    bool encrypted() const { return tls_ != nullptr; }

    /// Says whether the peer has hung up, or will send no more; also if its earlier bytes have not been read.
    bool peer_gone();

    static constexpr std::chrono::seconds linger{2};

    // Beast's WebSocket ends the stream below it by this.
    template <class Handler>
    friend void async_teardown(boost::beast::role_type, ByteStream& stream, Handler&& handler) {
        stream.async_end(std::forward<Handler>(handler));
    }

    friend void beast_close_socket(ByteStream& stream) { stream.close(); }

  private:
    using Done = std::function<void(Error, std::size_t)>;
    using Gathered = std::vector<boost::asio::const_buffer>;

    /// Hides the type of a handler, which may only be movable. Asio has its own for this since Boost 1.82.
    template <class Handler>
    static Done held(Handler&& handler) {
        return [kept = std::make_shared<std::decay_t<Handler>>(std::forward<Handler>(handler))](
                   Error error, [[maybe_unused]] std::size_t bytes) {
            if constexpr (std::is_invocable_v<std::decay_t<Handler>&, Error, std::size_t>)
                (*kept)(error, bytes);
            else
                (*kept)(error);
        };
    }

    void read_ahead(std::function<void(Error)> done);
    void read(boost::asio::mutable_buffer buffer, Done done);
    void write(Gathered buffers, Done done);
    void write_whole(Gathered buffers, Done done);
    void end(Done done);
    void drain(Done done);

    boost::asio::ip::tcp::socket socket_;
    std::unique_ptr<boost::asio::ssl::stream<boost::asio::ip::tcp::socket&>> tls_;
    std::string ahead_;                              ///< read already, to be read again
    bool writing_ = false;                           ///< a write that must not be interrupted
    std::vector<std::pair<Gathered, Done>> waiting_; ///< writes that wait for its end
};

} // namespace wakesurf::server
