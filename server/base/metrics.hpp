// The server's counters: the time of each stage from an edit to the screen, what was sent, dropped and
// refused. Read by /metrics as Prometheus text and by server.stats as quantiles of the last minute.
#pragma once

#include "core/base/clock.hpp"
#include "core/base/memory_account.hpp"

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::server {

/// The state of the server at the moment of a request: what is open, held and used. Gathered on request.
struct CacheStatus {
    std::string dataset;
    std::uint64_t hits = 0;  ///< requested time-steps that were in memory
    std::uint64_t loads = 0; ///< those that were not
    std::size_t bytes = 0;
    std::size_t budget = 0;
};

/// Describes the bricks of a dataset with an MPI job.
struct BricksStatus {
    std::string dataset;
    std::uint64_t by_ranks = 0;
    std::uint64_t by_files = 0;
    std::uint64_t ranks = 0; ///< of the job; 0: not connected
};

/// Counts the datasets in a state.
struct DatasetCount {
    std::string_view state;
    std::size_t count = 0;

    bool operator==(const DatasetCount&) const = default;
};

/// Returns the text of /healthz: "ok", and how many of how many datasets failed or are incomplete. No names:
/// it is public.
std::string health_text(std::span<const DatasetCount> datasets);

/// Describes the account of memory, in bytes.
struct MemoryStatus {
    std::size_t budget = 0;
    std::size_t used = 0;
    std::array<std::size_t, core::memory_uses> by_use{};
    std::uint64_t refused = 0; ///< requests that did not fit
};

MemoryStatus memory_status(const core::MemoryAccount& account);

struct ServerStatus {
    double uptime = 0.0; ///< seconds
    std::size_t connections = 0;
    std::size_t clients = 0; ///< WebSockets
    std::size_t sessions = 0;
    std::size_t surfaces = 0;
    std::size_t participants = 0;
    std::vector<DatasetCount> datasets; ///< of each state
    std::vector<CacheStatus> caches;
    std::vector<BricksStatus> bricks;
    MemoryStatus memory;
};

struct ProcessMemory {
    std::uint64_t resident = 0; ///< bytes
    std::uint64_t peak = 0;     ///< bytes, of `resident`
    std::uint64_t descriptors = 0;
};

/// Describes this process, from /proc; zeros if there is none. Cost: tens of microseconds.
ProcessMemory process_memory();

/// Quantiles of recent observations: a ring of the newest values with their times. Exact over what it holds,
/// unlike a histogram's buckets, and it forgets, unlike a histogram.
struct Quantiles {
    double p50 = 0.0, p95 = 0.0, p99 = 0.0;
    std::uint64_t count = 0; ///< number of values; if 0, the others mean nothing
};

/// Holds recent values. Thread-safe.
class RecentValues {
  public:
    using Time = std::chrono::steady_clock::time_point;
    static constexpr std::size_t most = 1024;
    static constexpr std::chrono::seconds window{60};

    void add(Time now, double value);

    /// Returns nearest-rank quantiles of the newest `most` values no older than `window`. Cost: sorting them.
    Quantiles quantiles(Time now) const;

  private:
    struct Value {
        Time at;
        float value;
    };

    mutable std::mutex mutex_;
    std::array<Value, most> values_{};
    std::uint64_t added_ = 0;
};

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
    std::string text(const ServerStatus& status) const;

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
