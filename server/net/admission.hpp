// A bound on connections: in all, and of one address as long as they have shown no token. Such a connection
// may only want to occupy a slot: without a free one, the connection that has been idle for longest is closed
// for a newer one.
#pragma once

#include "server/base/metrics.hpp"

#include <boost/asio/ip/address.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <string>

namespace wakesurf::server {

/// Bounds the number of connections. Loop thread only.
class Admission {
  public:
    struct Limits {
        std::size_t connections;
        std::size_t pending; ///< of one address
        /// The limit for this machine and for trusted proxies, which stand for many clients.
        std::size_t pending_loopback;
    };

    /// A connection's permit, returned on destruction; pending at first. REQUIRES: the Admission outlives it.
    class Permit {
      public:
        Permit(Admission& owner, std::string address, bool proxy);
        ~Permit();
        Permit(const Permit&) = delete;
        Permit& operator=(const Permit&) = delete;

        /// Registers what closes the connection at once; called at most once. The connection then counts no
        /// more.
        void on_end(std::function<void()> end) { end_ = std::move(end); }

        /// Marks the connection as one that has shown a token: it stays.
        void let_in();

        /// Marks the connection as idle: it waits for its next request, or has shown no token.
        void wait();

        /// Sets the client's address as a trusted proxy reports it, perhaps that of another proxy.
        void came_from(const boost::asio::ip::address& address, bool proxy);

        /// Returns the connection's number in the log.
        std::uint64_t number() const { return number_; }

        /// Returns the group of addresses that is counted as one client.
        const std::string& from() const { return address_; }

      private:
        friend class Admission;
        void leave();

        Admission& owner_;
        std::uint64_t number_;
        std::string address_;
        bool proxy_;
        bool counted_ = true;
        bool pending_ = false;
        std::list<Permit*>::iterator at_; ///< while pending
        std::function<void()> end_;
    };

    Admission(const Limits& limits, Metrics& metrics) : limits_(limits), metrics_(metrics) {}

    /// Returns a permit; null without room, with the reason counted.
    /// @param proxy  it is a trusted one: many clients are behind it
    std::unique_ptr<Permit> admit(const boost::asio::ip::address& address, bool proxy = false);

    std::size_t connections() const { return connections_; }

  private:
    using Pending = std::list<Permit*>; ///< idle for longest first

    std::size_t most(const Permit& permit) const;
    void make_room(Pending& among);
    bool make_room_in_all();

    Limits limits_;
    Metrics& metrics_;
    std::uint64_t last_number_ = 0;
    std::size_t connections_ = 0;
    std::map<std::string, Pending> pending_; ///< by address
};

/// Returns the group of addresses that is counted as one client: an IPv4 address, or the /64 of an IPv6 one,
/// which is assigned to a household or machine.
std::string address_group(const boost::asio::ip::address& address);

/// Converts an IPv4-mapped IPv6 address to IPv4.
boost::asio::ip::address plain_address(const boost::asio::ip::address& given);

/// Returns the limits of limits.hpp, lowered to the descriptors that this process may have. Some are reserved
/// for files, so that connections never keep a time-step from being read.
Admission::Limits limits_for_descriptors();

} // namespace wakesurf::server
