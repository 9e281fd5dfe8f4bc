// What connections, of HTTP and WebSockets, use of the server: its parts, the list of open connections, and the order in which they write.
#pragma once

#include "core/base/clock.hpp"
#include "server/base/metrics.hpp"
#include "server/live/compute/budgets.hpp"
#include "server/net/admission.hpp"
#include "server/net/http_message.hpp"
#include "server/net/outbox.hpp"
#include "server/net/routes.hpp"
#include "server/net/tls_context.hpp"
#include "server/net/trusted_proxies.hpp"

#include <chrono>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <set>
#include <string>

namespace wakesurf::server {

/// Connections take turns at writing, a few at a time. So the messages of one event to hundreds of viewers do
/// not delay the next event, and go out in few writes, because all of them are queued by the time a connection
/// has its turn.
/// Distributes turns. Loop thread only. REQUIRES: it outlives its writers.
class WriteScheduler {
  public:
    class Writer {
      public:
        virtual ~Writer() = default;
        /// Writes what is queued. It may ask for a further turn.
        virtual void write_turn() = 0;
    };

    using Post = std::function<void(std::function<void()>)>;

    /// The number of writers between two posts. There are more only if the events in between took long:
    /// writing gets as much of the loop's time as they do.
    static constexpr std::size_t at_once = 16;

    /// @param post   runs a task later on the loop, after those already posted
    /// @param clock  outlives this
    WriteScheduler(Post post, const core::Clock& clock) : post_(std::move(post)), clock_(clock) {}

    /// Queues a writer, in order of asking. Destroyed writers are skipped.
    void ask(std::weak_ptr<Writer> writer);

  private:
    void go_on();
    void turn();

    Post post_;
    std::deque<std::weak_ptr<Writer>> waiting_;
    const core::Clock& clock_;
    /// The time at which the first writer queued, or the last turn ended.
    std::chrono::steady_clock::time_point since_{};
    bool posted_ = false;
};

/// The open connections: counted against the limits, notified of events that concern all, closed when the
/// server stops.
class Connection {
  public:
    virtual ~Connection() = default;
    /// Says goodbye if the protocol allows it, and ends: the server stops.
    virtual void go_away() = 0;
    /// Ends without waiting for the peer.
    virtual void abandon() = 0;

    /// Sends a message if this is a WebSocket.
    virtual void announce(const std::string&) {}

    /// Closes if this is a WebSocket that came by a login of `person`, which has ended.
    virtual void log_out(const std::string& person [[maybe_unused]]) {}
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

/// Refers to parts of the server, which outlive all connections.
struct NetServices {
    Routes& routes;
    Connections& connections;
    Grants& grants;
    Admission& admission;
    Budgets& budgets;
    const TrustedProxies& proxies;
    Metrics& metrics;
    OutboxMemory& outboxes;
    WriteScheduler& turns;
    /// Added to every answer.
    const SecurityHeaders& headers;
    /// Null without TLS.
    TlsContext* tls;
};

} // namespace wakesurf::server
