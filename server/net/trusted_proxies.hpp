// The proxies of `--trusted-proxy`: what they say about who is behind them is believed, what anybody else says is not.
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

    /// From `ADDR` or `ADDR/BITS` each. Error: InvalidArgument.
    static core::Result<TrustedProxies> parse(const std::vector<std::string>& texts);

    bool trusts(const boost::asio::ip::address& address) const;

    /// Who asks, where `peer` does so on their behalf: of the addresses in X-Forwarded-For, to which each proxy has added the one it was
    /// asked from, the last that is no trusted proxy. `peer` where it is not trusted, or where there is nothing to be read.
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
