// How many connections there may be: in all, and of one address as long as they have shown no token. Such a connection may be somebody
// who only wants to take up room: where there is none left, the one that has done nothing for longest makes room for a newer one.
#pragma once

#include "server/service/metrics/metrics.hpp"

#include <boost/asio/ip/address.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <string>

namespace wakesurf::server {

/// Loop thread only.
class Admission {
  public:
    struct Limits {
        std::size_t connections;
        std::size_t pending; ///< of one address
        std::size_t
            pending_loopback; ///< of this machine and of trusted proxies, whence many people come
    };

    /// A connection's place, given back when it goes; pending at first. The Admission outlives it.
    class Place {
      public:
        Place(Admission& owner, std::string address, bool proxy);
        ~Place();
        Place(const Place&) = delete;
        Place& operator=(const Place&) = delete;

        /// Called at most once: the connection is to close at once, and counts no more.
        void on_end(std::function<void()> end) { end_ = std::move(end); }

        /// It has shown a token: it stays.
        void let_in();

        /// It waits for its next request, or has shown nothing.
        void wait();

        /// Who is behind it, as a trusted proxy says; perhaps another one.
        void came_from(const boost::asio::ip::address& address, bool proxy);

        /// Of the connection, in the log.
        std::uint64_t number() const { return number_; }

        /// Who counts as one with it.
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
        std::list<Place*>::iterator at_; ///< while pending
        std::function<void()> end_;
    };

    Admission(const Limits& limits, Metrics& metrics) : limits_(limits), metrics_(metrics) {}

    /// Nothing: no room; the reason is counted.
    /// @param proxy  it is a trusted one: behind it are many
    std::unique_ptr<Place> admit(const boost::asio::ip::address& address, bool proxy = false);

    std::size_t connections() const { return connections_; }

  private:
    using Pending = std::list<Place*>; ///< idle for longest first

    std::size_t most(const Place& place) const;
    void make_room(Pending& among);
    bool make_room_in_all();

    Limits limits_;
    Metrics& metrics_;
    std::uint64_t last_number_ = 0;
    std::size_t connections_ = 0;
    std::map<std::string, Pending> pending_; ///< by address
};

/// Who counts as one: an IPv4 address, the /64 of an IPv6 one, which is what a household or machine is given.
std::string address_group(const boost::asio::ip::address& address);

/// IPv4 in IPv6 clothes is IPv4.
boost::asio::ip::address plain_address(const boost::asio::ip::address& given);

/// The limits of limits.hpp, lowered to the descriptors this process may have: some are kept back for files, so that
/// no number of connections keeps a time-step from being read.
Admission::Limits limits_for_descriptors();

} // namespace wakesurf::server
