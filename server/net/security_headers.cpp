#include "server/net/security_headers.hpp"

#include <array>

namespace wakesurf::server {

namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 7> headers{{
    {"X-Content-Type-Options", "nosniff"},
    {"X-Frame-Options", "DENY"},
    {"Referrer-Policy", "no-referrer"},
    {"Cross-Origin-Resource-Policy", "same-origin"},
    {"Cross-Origin-Opener-Policy", "same-origin"},
    {"Permissions-Policy",
     "camera=(), geolocation=(), microphone=(), payment=(), serial=(), usb=()"},
    {"Content-Security-Policy",
     "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; "
     "connect-src 'self'; style-src 'self'; img-src 'self' data: blob:; object-src 'none'; "
     "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
}};

} // namespace

std::span<const std::pair<std::string_view, std::string_view>> security_headers() {
    return headers;
}

} // namespace wakesurf::server
