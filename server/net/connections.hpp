// The connections that are open: counted against the limits, told what concerns all, closed when the server goes.
#pragma once

#include <cstddef>
#include <set>
#include <string>

namespace wakesurf::server {

class Connection {
  public:
    virtual ~Connection() = default;
    /// The server is going: say so where the protocol allows it, and end.
    virtual void go_away() = 0;
    /// No more waiting for the other side.
    virtual void abandon() = 0;
    /// A message for every WebSocket; others ignore it.
    virtual void announce(const std::string& message) = 0;
};

/// Loop thread only.
class Connections {
  public:
    void add(Connection& connection) { open_.insert(&connection); }

    void remove(Connection& connection) { open_.erase(&connection); }

    std::size_t count() const { return open_.size(); }

    void announce(const std::string& message) {
        for (Connection* each : std::set(open_))
            each->announce(message);
    }

    void go_away() { each_of(&Connection::go_away); }

    void abandon() { each_of(&Connection::abandon); }

  private:
    /// A connection may end, and take others along, while the list is gone through.
    void each_of(void (Connection::*act)()) {
        for (Connection* each : std::set(open_))
            if (open_.contains(each))
                (each->*act)();
    }

    std::set<Connection*> open_;
};

} // namespace wakesurf::server
