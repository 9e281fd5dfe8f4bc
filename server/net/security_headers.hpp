// What every response says to a browser, whatever it is: errors and the 101 of a WebSocket included.
#pragma once

#include <span>
#include <string_view>
#include <utility>

namespace wakesurf::server {

std::span<const std::pair<std::string_view, std::string_view>> security_headers();

/// Strict-Transport-Security, for those who came over TLS under a name that is not this machine's own: browsers apply
/// it to every port of a host, and other servers of localhost speak plain HTTP.
inline constexpr std::string_view transport_security = "max-age=86400";

} // namespace wakesurf::server
