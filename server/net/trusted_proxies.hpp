// The proxies of `--trusted-proxy`: only they are believed about the client's address.
#pragma once

#include "core/base/result.hpp"

#include <boost/asio/ip/address.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::server {

class TrustedProxies {
  public:
    TrustedProxies() = default;

    /// Parses `ADDR` or `ADDR/BITS` each. Error: InvalidArgument.
    static core::Result<TrustedProxies> parse(const std::vector<std::string>& texts);

    bool trusts(const boost::asio::ip::address& address) const;

    /// Returns the client's address if `peer` forwards its request. Each proxy appends the address it was
    /// asked from to X-Forwarded-For; the client is the last that is no trusted proxy. Returns `peer` if it
    /// is not trusted, or without valid headers.
    /// @param forwarded  the values of all such headers, in order
    boost::asio::ip::address client_of(const boost::asio::ip::address& peer,
                                       const std::vector<std::string_view>& forwarded) const;

  private:
    struct Range {
        boost::asio::ip::address_v6 address; ///< IPv4 as mapped
        unsigned bits;
    };

    std::vector<Range> ranges_;
};

} // namespace wakesurf::server
