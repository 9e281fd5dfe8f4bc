// The address a server prints: where it listens, and its token.
#pragma once

#include "core/base/result.hpp"

#include <string>

namespace wakesurf::server {

struct ServerAddress {
    bool tls = false;
    std::string host; ///< without the brackets of an IPv6 address
    std::string port;
    std::string prefix; ///< of a proxy, as /flow; may be empty
    std::string token;  ///< may be empty

    /// Returns the authority as a Host header has it.
    std::string authority() const;
};

/// Parses http://HOST[:PORT][/PREFIX][/][#token=...]. Error: InvalidArgument.
core::Result<ServerAddress> parse_server_address(const std::string& url);

} // namespace wakesurf::server
