// A TCP connection to a server under test, byte by byte, so that tests can send what no library would.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace wakesurf::tests {

class RawSocket {
  public:
    explicit RawSocket(std::uint16_t port);
    ~RawSocket();
    RawSocket(RawSocket&& other) noexcept;
    RawSocket& operator=(RawSocket&&) = delete;

    void send(std::string_view bytes);

    /// Returns at least one byte, or empty if the peer has closed. Fails the test after `patience`, which
    /// ends a test that hangs: on a busy machine a server's long passes, which have low priority, were seen
    /// to be silent for half a minute.
    std::string receive(std::chrono::milliseconds patience = std::chrono::minutes(3));

    /// Returns everything up to and including `end`; the bytes behind it are kept for the next call.
    std::string receive_until(std::string_view end);
    std::string receive_exactly(std::size_t bytes);

    /// Says whether there is something to read, or the peer has closed, within `patience`.
    bool readable_within(std::chrono::milliseconds patience) const;

    /// Says whether the peer closes within `patience`; data on the way are dropped.
    bool closed_within(std::chrono::milliseconds patience);

    /// Waits until the peer has closed; returns false after so long that it never will.
    bool closes() { return closed_within(std::chrono::minutes(1)); }

    /// Closes abruptly: the peer gets a reset.
    void reset();

  private:
    int descriptor_ = -1;
    std::string kept_;
};

struct HttpReply {
    int status = 0;
    std::vector<std::pair<std::string, std::string>> headers; ///< names in lower case
    std::string body;

    std::string header(std::string_view name) const;
};

using Headers = std::vector<std::pair<std::string, std::string>>;

/// Reads one response.
HttpReply read_reply(RawSocket& socket, bool head = false);

/// Sends one request on its own connection. `Host` is set unless given.
HttpReply http(std::uint16_t port,
               std::string_view method,
               std::string_view target,
               Headers headers = {},
               std::string_view body = {});

} // namespace wakesurf::tests
