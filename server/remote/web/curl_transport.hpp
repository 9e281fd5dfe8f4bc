// HTTP by libcurl, which only this file uses.
#pragma once

#include "server/remote/web/http_transport.hpp"

#include <memory>
#include <string>

namespace wakesurf::server {

/// Identifies us to a web server. Never part of an address, a message or the log.
struct HttpCredentials {
    std::string token;     ///< sent as a bearer token
    std::string s3_region; ///< requests are signed for S3 there, with the keys
    std::string access_key, secret_key, session_token;

    bool any() const { return !token.empty() || !s3_region.empty(); }

    /// Reads WAKESURF_HTTP_TOKEN, and WAKESURF_HTTP_S3_REGION with AWS_ACCESS_KEY_ID, AWS_SECRET_ACCESS_KEY
    /// and AWS_SESSION_TOKEN.
    static HttpCredentials of_environment();
};

/// Has a connection for each concurrent call, kept for the next one. Certificates are checked by those the
/// system trusts, or by $SSL_CERT_FILE.
class CurlTransport final : public HttpTransport {
  public:
    explicit CurlTransport(HttpCredentials credentials);
    ~CurlTransport() override;
    CurlTransport(const CurlTransport&) = delete;
    CurlTransport& operator=(const CurlTransport&) = delete;

    tl::expected<HttpAnswer, HttpFault> perform(const HttpRequest& request,
                                                std::span<std::byte> body,
                                                const std::stop_token& stop) override;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace wakesurf::server
