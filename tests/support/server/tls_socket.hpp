// A TLS connection to a server under test, which trusts one certificate only.
#pragma once

#include "tests/support/server/raw_socket.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace wakesurf::tests {

class TlsSocket {
  public:
    /// Connects and does the handshake; connected() says whether that succeeded.
    /// @param newest   TLS1_1_VERSION, ...; 0: OpenSSL's newest
    /// @param ciphers  of TLS 1.2, as OpenSSL names them; empty: OpenSSL's default
    TlsSocket(std::uint16_t port,
              const std::filesystem::path& trusted,
              int newest = 0,
              const std::string& ciphers = {});
    ~TlsSocket();
    TlsSocket(const TlsSocket&) = delete;
    TlsSocket& operator=(const TlsSocket&) = delete;

    bool connected() const { return connected_; }

    /// Returns "TLSv1.3", ...
    std::string version() const;

    void send(std::string_view bytes);

    /// Returns at least one byte, or empty once the peer has ended. Fails the test after 20 s.
    std::string receive();

    /// Returns everything up to the end of the connection or to `end`, that included; the rest is dropped.
    std::string receive_until(std::string_view end);

    /// Says whether the peer announced the end, which an attacker on the way cannot.
    bool ended_in_order() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
    bool connected_ = false;
};

/// Sends one request on its own connection; returns the whole response as text. `Connection: close` and
/// `Host` are set.
std::string https(std::uint16_t port,
                  const std::filesystem::path& trusted,
                  std::string_view method,
                  std::string_view target,
                  const Headers& headers = {},
                  std::string_view body = {});

} // namespace wakesurf::tests
