// The server's certificate and TLS settings: TLS 1.2 and later, ephemeral keys and AEAD ciphers only.
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <memory>

namespace boost::asio::ssl {
class context;
}

namespace wakesurf::server {

/// Holds the certificate and its key. Loop thread only.
class TlsContext {
  public:
    /// Loads the files. Error: Io for a file that cannot be read; Corrupt for an invalid certificate or key,
    /// or if the two do not belong together. The messages name the option, not the path.
    /// @param certificate  PEM: the certificate, then any intermediate ones
    /// @param key          PEM, not encrypted
    static core::Result<std::unique_ptr<TlsContext>> load(std::filesystem::path certificate,
                                                          std::filesystem::path key);
    ~TlsContext();
    TlsContext(const TlsContext&) = delete;
    TlsContext& operator=(const TlsContext&) = delete;

    /// Reads the files again, for new connections. Error: as load; the old ones then stay in use.
    core::Result<void> renew();

    boost::asio::ssl::context& context() { return *context_; }

  private:
    TlsContext(std::filesystem::path certificate, std::filesystem::path key);

    std::filesystem::path certificate_;
    std::filesystem::path key_;
    std::unique_ptr<boost::asio::ssl::context> context_;
};

} // namespace wakesurf::server
