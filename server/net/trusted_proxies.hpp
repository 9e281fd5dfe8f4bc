// The proxies of `--trusted-proxy`, and the PROXY protocol by which they name the client. Only they are believed about its address.
#pragma once

#include "core/base/result.hpp"

#include <boost/asio/ip/address.hpp>
#include <boost/asio/ip/network_v6.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::server {

/// The PROXY protocol of haproxy, versions 1 and 2: the first bytes of a proxy's connection, which name the
/// client (www.haproxy.org/download/2.8/doc/proxy-protocol.txt). Read from trusted proxies only.
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

class TrustedProxies {
  public:
    TrustedProxies() = default;

    /// Parses `ADDR` or `ADDR/BITS` each. Error: InvalidArgument.
    static core::Result<TrustedProxies> parse(const std::vector<std::string>& texts);

    bool trusts(const boost::asio::ip::address& address) const;

    /// Returns the client's address if `peer` forwards its request. Each proxy appends the address it was
    /// asked from to X-Forwarded-For; the client is the last that is no trusted proxy. Returns `peer` if it
    /// is not trusted, or without valid headers.
    /// @param forwarded  the elements of all such headers, in order
    boost::asio::ip::address client_of(const boost::asio::ip::address& peer,
                                       const std::vector<std::string_view>& forwarded) const;

  private:
    std::vector<boost::asio::ip::network_v6> networks_; ///< IPv4 as mapped
};

} // namespace wakesurf::server
