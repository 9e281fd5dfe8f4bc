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
    /// Connects and shakes hands; connected() says whether that went well.
    /// @param newest   TLS1_1_VERSION, ...; 0: whatever OpenSSL offers
    /// @param ciphers  of TLS 1.2, as OpenSSL names them; empty: whatever it offers
    TlsSocket(std::uint16_t port,
              const std::filesystem::path& trusted,
              int newest = 0,
              const std::string& ciphers = {});
    ~TlsSocket();
    TlsSocket(const TlsSocket&) = delete;
    TlsSocket& operator=(const TlsSocket&) = delete;

    bool connected() const { return connected_; }

    /// "TLSv1.3", ...
    std::string version() const;

    void send(std::string_view bytes);

    /// At least one byte, or empty once the other side has ended. Fails the test after 20 s.
    std::string receive();

    /// Everything up to the end of the connection or to `end`, that included; what comes after is dropped.
    std::string receive_until(std::string_view end);

    /// Whether the other side said that it ends, which an attacker on the way cannot.
    bool ended_in_order() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
    bool connected_ = false;
};

/// One request on its own connection; the whole response as text. `Connection: close` and `Host` are set.
std::string https(std::uint16_t port,
                  const std::filesystem::path& trusted,
                  std::string_view method,
                  std::string_view target,
                  const Headers& headers = {},
                  std::string_view body = {});

} // namespace wakesurf::tests
