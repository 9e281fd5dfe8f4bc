// The security headers of every response: errors and the 101 of a WebSocket included.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace wakesurf::server {

class SecurityHeaders {
  public:
    /// @param frame_origins  origins whose pages may show ours in a frame; empty: no page may
    explicit SecurityHeaders(const std::vector<std::string>& frame_origins = {});

    std::span<const std::pair<std::string_view, std::string>> all() const { return headers_; }

  private:
    std::vector<std::pair<std::string_view, std::string>> headers_;
};

/// The value of Strict-Transport-Security, sent over TLS under a name other than this machine's own: browsers
/// apply it to every port of a host, and other servers of localhost speak plain HTTP.
inline constexpr std::string_view transport_security = "max-age=86400";

} // namespace wakesurf::server
