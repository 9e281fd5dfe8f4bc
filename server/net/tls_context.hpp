// The server's certificate and what it is used with: TLS 1.2 and later, ephemeral keys and AEAD ciphers only.
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <memory>

namespace boost::asio::ssl {
class context;
}

namespace wakesurf::server {

/// Loop thread only.
class TlsContext {
  public:
    /// @param certificate  PEM: the certificate, then any intermediate ones
    /// @param key          PEM, not encrypted
    /// Error: Io for a file that cannot be read; Corrupt for one that is no certificate or key, or where the two do not
    /// belong together. The messages name the option, not the path.
    static core::Result<std::unique_ptr<TlsContext>> load(std::filesystem::path certificate,
                                                          std::filesystem::path key);
    ~TlsContext();
    TlsContext(const TlsContext&) = delete;
    TlsContext& operator=(const TlsContext&) = delete;

    /// Reads the files again, for connections from now on. Error: as load; then it stays as it is.
    core::Result<void> renew();

    boost::asio::ssl::context& context() { return *context_; }

  private:
    TlsContext(std::filesystem::path certificate, std::filesystem::path key);

    std::filesystem::path certificate_;
    std::filesystem::path key_;
    std::unique_ptr<boost::asio::ssl::context> context_;
};

} // namespace wakesurf::server
