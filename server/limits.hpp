// What one server grants: every quota in one place. A request beyond one is answered with -32014, never served partly.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace wakesurf::server::limits {

// Messages.
inline constexpr std::size_t message_bytes = std::size_t{64} << 10;
inline constexpr std::size_t message_depth = 32;
inline constexpr std::size_t batch = 64;
inline constexpr std::size_t pending_calls = 256; ///< unanswered calls of one WebSocket
inline constexpr std::uint32_t http_header_bytes = 8u << 10;

// Connections.
inline constexpr std::size_t connections = 4096;
inline constexpr std::size_t clients = 2048; ///< WebSockets
inline constexpr std::size_t pending = 256;  ///< connections of one address that are no WebSocket
inline constexpr std::size_t pending_loopback = 2048; ///< of this machine
inline constexpr std::chrono::seconds handshake{
    10}; ///< of TLS, of a whole header, of a whole body: each
inline constexpr std::chrono::seconds idle{40};    ///< a WebSocket's ping goes out at half of it
inline constexpr std::chrono::seconds stalled{30}; ///< taking no data at all
inline constexpr double messages_per_second =
    4000.0; ///< of one WebSocket; what comes faster is read later
inline constexpr double messages_at_once = 8000.0;
inline constexpr std::size_t outbox_messages = 4096;
inline constexpr std::size_t outbox_message_bytes = std::size_t{4} << 20;
inline constexpr double wrong_tokens_per_second = 5.0;
inline constexpr double wrong_tokens_at_once = 20.0;
inline constexpr std::size_t cookies_of_one = 1024; ///< logins that one token or share link keeps
inline constexpr std::size_t cookies = 16384;

// Calls of one WebSocket, or of all HTTP requests with one token or share link.
inline constexpr double edits_per_second = 200.0;
inline constexpr double edits_at_once = 400.0;
inline constexpr double calls_per_second = 2000.0;
inline constexpr double calls_at_once = 4000.0;

// What waits for those who look at a surface.
inline constexpr std::size_t ring_bytes = std::size_t{32}
                                          << 20; ///< of a surface's updates; the newest stays
inline constexpr std::chrono::seconds ring_age{5};
inline constexpr std::size_t window =
    8; ///< updates a client may be sent beyond those it has acknowledged
inline constexpr std::size_t behind_bytes = std::size_t{4} << 20;
inline constexpr std::chrono::seconds key_age{1};
inline constexpr std::size_t subscriptions = 1024; ///< of one WebSocket

// Sessions.
inline constexpr std::size_t sessions = 64;
inline constexpr std::size_t participants = 1536;
inline constexpr std::chrono::seconds absence{10}; ///< how long a lost connection is shown
inline constexpr std::chrono::seconds place_kept{7 * 24 *
                                                 3600};       ///< for whoever left, to come back to
inline constexpr std::chrono::milliseconds presence_rest{50}; ///< between two tellings, at least
inline constexpr std::size_t presence_bytes_per_ms =
    4000;                                             ///< of a session, to all its participants
inline constexpr std::size_t presence_entries = 2000; ///< of one telling, over all who are told
inline constexpr std::size_t presence_points = 64;    ///< of a rake being dragged
inline constexpr std::size_t changes =
    1024; ///< records whose newest change is kept for those who come back
inline constexpr std::size_t grants = 32; ///< share links of one session
inline constexpr std::uint64_t grant_seconds = std::uint64_t{10} * 366 * 24 * 3600;
inline constexpr std::size_t rakes = 256;
inline constexpr std::size_t surfaces = 64;
inline constexpr std::chrono::seconds start_watched{
    60}; ///< a server that lives for so long has started
inline constexpr std::size_t bookmarks = 256;
inline constexpr std::size_t annotations = 512;
inline constexpr std::size_t view_bytes = std::size_t{4} << 10;       ///< of a bookmark
inline constexpr std::size_t annotation_bytes = std::size_t{4} << 10; ///< of its text
inline constexpr std::chrono::milliseconds lease{5000};
inline constexpr std::size_t undo_steps = 100;                  ///< of one participant
inline constexpr std::size_t undo_authors = 128;                ///< of one session
inline constexpr std::size_t undo_bytes = std::size_t{4} << 20; ///< of one session
inline constexpr std::size_t gesture_bytes = 64;                ///< of its name
inline constexpr std::size_t gesture_records = 64;              ///< that one step of undo gathers
inline constexpr std::size_t import_waiters = 1024;             ///< unanswered dataset.open calls
inline constexpr std::size_t waiters = 64; ///< unanswered surface.wait calls of one surface
inline constexpr std::size_t name_bytes = 120;

// Surfaces.
inline constexpr std::uint64_t seeds_least = 2;
inline constexpr std::uint64_t seeds_most = 4096;
inline constexpr std::size_t rake_points = 1024;
inline constexpr std::uint64_t quads_default = 1'000'000;
inline constexpr std::uint64_t quads_most = 4'000'000;
inline constexpr std::size_t fields = 4; ///< of a surface: further attributes of its vertices
inline constexpr std::uint64_t wait_ms = 600'000;
inline constexpr std::size_t history_bytes = std::size_t{128}
                                             << 20; ///< of a moving surface, to step back to
inline constexpr std::size_t histories_bytes = std::size_t{512} << 20; ///< of all together
inline constexpr std::chrono::milliseconds memory_look{250}; ///< at what the process holds
inline constexpr std::chrono::seconds history_rest{
    30}; ///< a history not used for so long goes before others get smaller

// Clocks.
inline constexpr double clock_speed = 1e6; ///< simulation time a second
inline constexpr std::chrono::milliseconds clock_tick{33};
inline constexpr std::chrono::milliseconds clock_kept{
    1000}; ///< between two times in the journal while it runs

// Downloads.
inline constexpr std::size_t kept_downloads = 64; ///< finished files, for the next who asks
inline constexpr std::size_t kept_download_bytes = std::size_t{256} << 20; ///< of all of them
inline constexpr std::chrono::seconds download_memory{
    20}; ///< a file being made waits for memory that others give back
inline constexpr std::chrono::milliseconds gone_check{
    250}; ///< between two looks whether who waits for an answer is still there

// Probes.
inline constexpr std::size_t probes = 32; ///< at a time
inline constexpr std::size_t probe_points = 4096;
inline constexpr std::size_t probe_fields = 64;

} // namespace wakesurf::server::limits
