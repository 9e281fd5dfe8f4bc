// The PROXY protocol of haproxy, versions 1 and 2: the first bytes of a proxy's connection, which name the
// client (www.haproxy.org/download/2.8/doc/proxy-protocol.txt). Read from trusted proxies only.
#pragma once

#include <boost/asio/ip/address.hpp>

#include <cstddef>
#include <optional>
#include <string_view>

namespace wakesurf::server {

/// Classifies the first bytes of a connection.
struct ProxyHeader {
    enum class Is {
        None,     ///< something else
        Partial,  ///< may be one, with more bytes
        Complete, ///< the first `length` bytes
        Malformed ///< begins like one and is none
    };
    Is is = Is::None;
    std::size_t length = 0;
    /// The client's address; empty for the proxy's own requests, or if it does not know.
    std::optional<boost::asio::ip::address> from;
};

/// The longest header that is understood; addresses take at most 52 bytes of version 2, the rest are
/// extensions.
inline constexpr std::size_t longest_proxy_header = 536;

ProxyHeader parse_proxy_header(std::string_view bytes);

} // namespace wakesurf::server
