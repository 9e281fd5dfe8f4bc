// The open connections: counted against the limits, notified of events that concern all, closed when the
// server stops.
#pragma once

#include <cstddef>
#include <set>
#include <string>

namespace wakesurf::server {

class Connection {
  public:
    virtual ~Connection() = default;
    /// Says goodbye if the protocol allows it, and ends: the server stops.
    virtual void go_away() = 0;
    /// Ends without waiting for the peer.
    virtual void abandon() = 0;
    /// Sends a message if this is a WebSocket.
    virtual void announce(const std::string& message) = 0;
    /// Closes if this is a WebSocket that came by a login of `person`, which has ended.
    virtual void log_out(const std::string& person) = 0;
};

/// Holds the open connections. Loop thread only.
class Connections {
  public:
    void add(Connection& connection) { open_.insert(&connection); }

    void remove(Connection& connection) { open_.erase(&connection); }

    std::size_t count() const { return open_.size(); }

    void announce(const std::string& message) {
        for (Connection* each : std::set(open_))
            each->announce(message);
    }

    void go_away() {
        each_of([](Connection& each) { each.go_away(); });
    }

    void abandon() {
        each_of([](Connection& each) { each.abandon(); });
    }

    void log_out(const std::string& person) {
        each_of([&](Connection& each) { each.log_out(person); });
    }

  private:
    /// A connection may end, and end others, while the list is traversed.
    template <class Act>
    void each_of(Act act) {
        for (Connection* each : std::set(open_))
            if (open_.contains(each))
                act(*each);
    }

    std::set<Connection*> open_;
};

} // namespace wakesurf::server
