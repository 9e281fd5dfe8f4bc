// The server's counters: the time of each stage from an edit to the screen, what was sent, dropped and
// refused. Read by /metrics as Prometheus text and by server.stats as quantiles of the last minute.
#pragma once

#include "core/base/clock.hpp"
#include "server/base/recent_values.hpp"
#include "server/base/standing.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace wakesurf::server {

/// Names the stages of an edit, in order: it waits for a compute thread, waits for time-steps, moves
/// particles, keeps the surface fine enough, is encoded, and is written to a socket.
enum class Stage : std::uint8_t { Queue, Load, Advect, Refine, Encode, Send };

inline constexpr std::array<std::string_view, 6> stage_names{"queue",  "load",   "advect",
                                                             "refine", "encode", "send"};

/// Says why a client was refused or disconnected.
enum class Rejection : std::uint8_t {
    Unauthenticated,  ///< no token, or a wrong one
    Forbidden,        ///< Host, Origin or role
    RateLimited,      ///< wrong tokens, or messages, too fast
    TooManyClients,   ///< WebSockets or connections
    TooManyPending,   ///< connections of one address that have not shown a token
    Malformed,        ///< no HTTP, no WebSocket frame, no TLS
    TooLarge,         ///< header, body or message
    HandshakeTimeout, ///< TLS, header or upgrade
    Stalled,          ///< took no data
    Overflow,         ///< too many messages waiting
};

inline constexpr std::array<std::string_view, 10> rejection_names{
    "unauthenticated", "forbidden", "rate_limited",      "too_many_clients", "too_many_pending",
    "malformed",       "too_large", "handshake_timeout", "stalled",          "overflow"};

/// Says which part of a person's, a link's or an address's budget was used up; see limits::Budget.
enum class Budgeted : std::uint8_t {
    Sockets,
    Requests,
    Downloads,
    Probes,
    Waits,
    Edits,
    Calls,
    Messages, ///< read later
    WrongTokens,
    Strangers, ///< requests that showed no token
};

inline constexpr std::array<std::string_view, 11> budgeted_names{
    "sockets", "requests", "downloads", "probes",       "waits",
    "edits",   "calls",    "messages",  "wrong_tokens", "without_token"};

/// Counts events. Thread-safe. Cost of an observation: two uncontended locks, about 0.1 microseconds; once a
/// pass or a frame, never once a particle.
class Metrics {
  public:
    /// REQUIRES: the clock outlives it.
    explicit Metrics(const core::Clock& clock);
    ~Metrics();
    Metrics(const Metrics&) = delete;
    Metrics& operator=(const Metrics&) = delete;

    void observe(Stage stage, double seconds);

    /// Records the time from receiving an edit to handing the first frame that shows it to a subscriber's
    /// connection.
    void first_frame(double seconds);

    void frame_sent(std::size_t bytes);
    void message_sent(std::size_t bytes);
    void message_received(std::size_t bytes);
    /// Counts a whole state sent in place of a delta.
    void keyframe();
    /// Counts a client that fell behind and will get a keyframe.
    void catching_up();
    /// Counts stale frames that were not sent: because of a keyframe, or a newer edit.
    void frames_dropped(std::uint64_t frames);
    void reject(Rejection reason);
    /// Counts a request that was refused, or is read later, because of a budget.
    void over_budget(Budgeted kind);
    /// Counts a call answered with a JSON-RPC error.
    void error(int code);
    /// Records whether edits reach the disk; never called without a state folder.
    void durable(bool yes);

    /// Returns Prometheus text, version 0.0.4.
    std::string text(const Standing& standing) const;

    /// Return the quantiles of the last minute.
    Quantiles quantiles(Stage stage) const;
    Quantiles first_frames() const;

    struct Totals {
        std::uint64_t frames = 0, frame_bytes = 0, messages = 0, message_bytes = 0, keyframes = 0,
                      dropped = 0;
    };

    Totals totals() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace wakesurf::server
