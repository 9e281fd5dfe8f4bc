// The limits of one server, by subject. Limits that users are told of are in protocol/api/limits.schema.json;
// the others are here. A request beyond one is answered with -32014, or with 413, 429, 431 or 503 over HTTP,
// never served partly. `--memory` is no limit of this kind: see core/base/memory_account.
#pragma once

#include "protocol/api/generated/limits.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace wakesurf::server::limits {

using namespace protocol::limits;

// Messages.
inline constexpr std::uint32_t http_header_bytes = 8u << 10;

// Connections.
inline constexpr std::size_t connections = 4096;
inline constexpr std::size_t pending = 256; ///< connections of one address that are no WebSocket
inline constexpr std::size_t pending_loopback = 2048; ///< of this machine
/// Bounds each: the TLS handshake, a whole header, a whole body.
inline constexpr std::chrono::seconds handshake{10};
inline constexpr std::chrono::seconds idle{40};    ///< a WebSocket's ping goes out at half of it
inline constexpr std::chrono::seconds stalled{30}; ///< taking no data at all
inline constexpr std::size_t outbox_messages = 4096;
inline constexpr std::size_t outbox_message_bytes = std::size_t{4} << 20;
inline constexpr std::size_t outbox_small_bytes = std::size_t{32} << 10; ///< always fit
inline constexpr std::size_t outboxes_part = 16; ///< of --memory, for all queues of clients

// Requests that show no token, or a wrong one, by address.
inline constexpr double wrong_tokens_per_second = 5.0;
inline constexpr double wrong_tokens_at_once = 20.0;
inline constexpr double strangers_per_second = 200.0; ///< the page's files, logins, /healthz, 401
inline constexpr double strangers_at_once = 4000.0;   ///< many people may share an address
/// Each such piece of an answer counts as one request more.
inline constexpr std::size_t strangers_bytes = std::size_t{64} << 10;
/// The pause between two answers of /healthz on one connection beyond that.
inline constexpr std::chrono::seconds stranger_pause{1};
inline constexpr std::size_t addresses = 4096; ///< that are counted separately

/// Bounds what a client may use at a time, and how fast, over all WebSockets and HTTP requests: see
/// compute/budgets.
struct Budget {
    std::size_t sockets;   ///< WebSockets
    std::size_t requests;  ///< HTTP requests let in and not answered yet
    std::size_t downloads; ///< asked for and not written yet
    std::size_t probes;    ///< running
    std::size_t waits;     ///< calls that wait for a surface or an import
    double edits;          ///< a second; twice as many at once
    double calls;          ///< likewise
    double messages;       ///< likewise; faster ones are read later. A KiB counts for one more
};

/// Each whole piece of this size of an answer counts as one call more.
inline constexpr std::size_t answer_bytes = std::size_t{4} << 10;

/// The budget of one person by a link.
inline constexpr Budget person{protocol::limits::sockets, 64,    protocol::limits::downloads,
                               protocol::limits::probes,  32,    edits_per_second,
                               calls_per_second,          4000.0};
inline constexpr Budget link{512, 256, 16, 8, 48, 600.0, 6000.0, 6000.0};
inline constexpr Budget token{2048, 1024, 64, 32, 1024, 2000.0, 20000.0, 40000.0};
/// The budget of all clients together. Rates are those of each link and of the token.
inline constexpr Budget all{clients, 1024, 64, 32, 1024, 0.0, 0.0, 0.0};
/// The part of `all` that is reserved for the server's token.
inline constexpr Budget for_hosts{128, 256, 8, 4, 64, 0.0, 0.0, 0.0};

// Logins.
inline constexpr std::chrono::seconds login_idle{7 * 24 * 3600};  ///< since its last renewal
inline constexpr std::chrono::seconds login_most{30 * 24 * 3600}; ///< since its beginning

// Share links.
inline constexpr std::size_t grant_depth = 8; ///< links made by links
/// Copies of a session, with a link into each, for all clients of one link.
inline constexpr std::size_t copies_by_link = 32;
inline constexpr std::size_t copies_by_links = 256; ///< for all links
inline constexpr std::size_t lowered = 64;          ///< participants of a link with a lesser role
inline constexpr std::size_t seated = 4096; ///< participants of a link whose person is known

// Queues of the viewers of a surface.
/// The size of a surface's updates, the newest excepted.
inline constexpr std::size_t ring_bytes = std::size_t{32} << 20;
inline constexpr std::chrono::seconds ring_age{5};
/// The time after which a surface without viewers is no longer computed.
inline constexpr std::chrono::seconds hidden_after{2};
/// Updates sent to a client beyond those it has acknowledged.
inline constexpr std::size_t window = 8;
inline constexpr std::size_t behind_bytes = std::size_t{4} << 20;
inline constexpr std::chrono::seconds key_age{1};

// Sessions as a whole.
/// The time after which a session in the trash is deleted for good.
inline constexpr std::chrono::seconds trash_kept{trash_days * 24 * 3600};
inline constexpr std::size_t session_file_bytes = std::size_t{24} << 20;
inline constexpr std::chrono::seconds session_file_time{120}; ///< for receiving one
inline constexpr std::size_t session_imports = 2;             ///< read at a time
/// The size of records in an answer of session.export.
inline constexpr std::size_t session_message_bytes = std::size_t{256} << 10;
/// The time after which a server counts as started.
inline constexpr std::chrono::seconds start_watched{60};

// In a session.
/// The time for which a lost connection is shown.
inline constexpr std::chrono::seconds absence{10};
/// The time for which a participant who left can come back.
inline constexpr std::chrono::seconds place_kept{7 * 24 * 3600};
inline constexpr std::chrono::milliseconds presence_rest{50}; ///< between two notices, at least
/// Notices of one session, to all its participants.
inline constexpr std::size_t presence_bytes_per_ms = 4000;
inline constexpr std::size_t presence_entries = 2000; ///< of one notice, over all recipients
/// Records whose newest change is kept for participants who come back.
inline constexpr std::size_t changes = 1024;
/// A session of this size fits however much others hold.
inline constexpr std::size_t session_small_bytes = std::size_t{32} << 10;
inline constexpr std::size_t records_part = 8; ///< of --memory, for the records of all sessions
inline constexpr std::chrono::milliseconds lease{lease_ms};
inline constexpr std::size_t undo_authors = 128;                ///< of one session
inline constexpr std::size_t undo_bytes = std::size_t{1} << 20; ///< of one session
inline constexpr std::size_t gesture_records = 64;              ///< in one step of undo
inline constexpr std::size_t import_waiters = 1024;             ///< unanswered dataset.open calls

// Surfaces.
/// The size of a moving surface's checkpoints, to step back to.
inline constexpr std::size_t history_bytes = std::size_t{128} << 20;
inline constexpr std::size_t histories_bytes = std::size_t{512} << 20; ///< of all together
/// The poll interval of the process's memory.
inline constexpr std::chrono::milliseconds memory_poll_interval{250};
/// The idle time after which a history is removed before others get smaller.
inline constexpr std::chrono::seconds history_rest{30};

// Clocks.
inline constexpr std::chrono::milliseconds clock_tick{33};
/// The interval at which the journal records a running clock.
inline constexpr std::chrono::milliseconds clock_kept{1000};

// Downloads.
inline constexpr std::size_t kept_downloads = 64; ///< finished files, cached for the next request
inline constexpr std::size_t kept_download_bytes = std::size_t{256} << 20; ///< of all of them
/// The time for which a file being made waits for others to release memory.
inline constexpr std::chrono::seconds download_memory{5};
/// The poll interval for whether a client still waits for its answer.
inline constexpr std::chrono::milliseconds gone_check{250};

} // namespace wakesurf::server::limits
