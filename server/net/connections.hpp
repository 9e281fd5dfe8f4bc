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
    /// A login has ended: a WebSocket that came by it goes; others ignore it.
    virtual void log_out(const std::string& person) = 0;
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
    /// A connection may end, and take others along, while the list is gone through.
    template <class Act>
    void each_of(Act act) {
        for (Connection* each : std::set(open_))
            if (open_.contains(each))
                act(*each);
    }

    std::set<Connection*> open_;
};

} // namespace wakesurf::server
