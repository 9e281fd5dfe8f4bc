#include "server/net/http_message.hpp"

namespace wakesurf::server {

SecurityHeaders::SecurityHeaders(const std::vector<std::string>& frame_origins)
    : headers_{
          {"X-Content-Type-Options", "nosniff"},
          {"Referrer-Policy", "no-referrer"},
          {"Cross-Origin-Resource-Policy", "same-origin"},
          {"Cross-Origin-Opener-Policy", "same-origin"},
          {"Permissions-Policy",
           "camera=(), geolocation=(), microphone=(), payment=(), serial=(), usb=()"},
      } {
    std::string framing;
    for (const std::string& origin : frame_origins)
        framing += " " + origin;
    // X-Frame-Options cannot name other origins: if there are any, it is left out, and frame-ancestors alone
    // decides.
    if (framing.empty())
        headers_.emplace_back("X-Frame-Options", "DENY");
    headers_.emplace_back(
        "Content-Security-Policy",
        "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; "
        "connect-src 'self'; style-src 'self'; img-src 'self' data: blob:; object-src 'none'; "
        "base-uri 'none'; form-action 'none'; frame-ancestors" +
            (framing.empty() ? " 'none'" : framing));
}

} // namespace wakesurf::server
