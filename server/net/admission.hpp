// How many connections there may be: in all, as WebSockets, and of one address before they have become one. A WebSocket
// has passed the gate; everything else may be somebody who only wants to take up room.
#pragma once

#include "server/metrics/metrics.hpp"

#include <boost/asio/ip/address.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace wakesurf::server {

/// Loop thread only.
class Admission {
  public:
    struct Limits {
        std::size_t connections;
        std::size_t clients;
        std::size_t pending;          ///< of one address
        std::size_t pending_loopback; ///< of this machine, whence everybody comes behind a proxy
    };

    /// A connection's place, given back when it goes. The Admission outlives it.
    class Place {
      public:
        Place(Admission& owner, std::string address);
        ~Place();
        Place(const Place&) = delete;
        Place& operator=(const Place&) = delete;

        /// Makes it a WebSocket's. False: there are as many as there may be.
        bool promote();

        /// Of the connection, in the log.
        std::uint64_t number() const { return number_; }

      private:
        Admission& owner_;
        std::uint64_t number_;
        std::string address_; ///< empty: promoted
    };

    Admission(const Limits& limits, Metrics& metrics) : limits_(limits), metrics_(metrics) {}

    /// Nothing: no room; the reason is counted.
    std::unique_ptr<Place> admit(const boost::asio::ip::address& address);

    std::size_t connections() const { return connections_; }

    std::size_t clients() const { return clients_; }

  private:
    Limits limits_;
    Metrics& metrics_;
    std::uint64_t last_number_ = 0;
    std::size_t connections_ = 0;
    std::size_t clients_ = 0;
    std::map<std::string, std::size_t> pending_;
};

/// Who counts as one: an IPv4 address, the /64 of an IPv6 one, which is what a household or machine is given.
std::string address_group(const boost::asio::ip::address& address);

/// The limits of limits.hpp, lowered to the descriptors this process may have: some are kept back for files, so that
/// no number of connections keeps a time-step from being read.
Admission::Limits limits_for_descriptors();

} // namespace wakesurf::server
