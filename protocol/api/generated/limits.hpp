// Made by protocol/api/generate from limits.schema.json: do not edit.
// What one server grants, as far as users are told of it.
#pragma once

#include <cstddef>
#include <cstdint>

namespace wakesurf::protocol::limits {

inline constexpr std::size_t message_bytes = 65536; ///< size of one message (bytes)
inline constexpr std::size_t batch = 64;            ///< calls in one message
inline constexpr std::size_t message_depth = 32;    ///< levels of nesting in a message
inline constexpr std::size_t clients = 2048;        ///< WebSockets of all people together
inline constexpr double calls_per_second =
    2000.0; ///< calls of one person in a second; bursts may have twice as many
inline constexpr double edits_per_second =
    200.0; ///< edits of one person in a second; bursts may have twice as many
inline constexpr std::size_t kept_sessions = 1024;    ///< sessions that the server keeps
inline constexpr std::size_t trash = 256;             ///< deleted sessions that can be restored
inline constexpr std::size_t thumbnail_bytes = 24576; ///< size of a session's picture (bytes)
inline constexpr std::size_t participants = 1536;     ///< participants in a session at a time
inline constexpr std::size_t rakes = 256;             ///< rakes in a session
inline constexpr std::size_t rake_points = 1024;      ///< points of a rake
inline constexpr std::uint64_t seeds_most = 4096;     ///< seeds of a rake
inline constexpr std::size_t surfaces = 64;           ///< surfaces in a session
inline constexpr std::size_t bookmarks = 256;         ///< bookmarks in a session
inline constexpr std::size_t annotations = 512;       ///< annotations in a session
inline constexpr std::size_t session_bytes =
    1048576; ///< size of all records of a session; as text, when someone joins, they take three times as much (bytes)
inline constexpr std::size_t undo_steps = 100; ///< edits of one participant that can be taken back
inline constexpr std::size_t grants = 32;      ///< valid share links of a session
inline constexpr std::size_t subscriptions = 1024; ///< subscriptions of one WebSocket
inline constexpr std::size_t waiters = 64;         ///< unanswered surface.wait calls of one surface
inline constexpr std::size_t pending_calls = 256;  ///< unanswered calls of one WebSocket
inline constexpr std::size_t probes = 4;           ///< unanswered probe.sample calls of one person
inline constexpr std::size_t sockets = 64;         ///< WebSockets of one person
inline constexpr std::size_t downloads = 8;        ///< unfinished downloads of one person
inline constexpr std::uint64_t quads_most = 4000000; ///< quads of a surface
inline constexpr std::size_t fields = 5;         ///< additional attributes of a surface's vertices
inline constexpr std::uint64_t wait_ms = 600000; ///< time that a call may wait (ms)
inline constexpr std::size_t name_bytes = 120;   ///< length of a name (bytes)
inline constexpr std::size_t unit_bytes = 32;    ///< length of the name of a unit (bytes)
inline constexpr std::size_t gesture_bytes = 64; ///< length of a gesture's name (bytes)
inline constexpr std::size_t view_bytes =
    4096; ///< length of a bookmark's view, as JSON text (bytes)
inline constexpr std::size_t annotation_bytes = 4096; ///< length of an annotation's text (bytes)
inline constexpr std::size_t presence_points = 64;    ///< points of a rake while it is dragged
inline constexpr std::size_t probe_points = 4096;     ///< points in one call of probe.sample
inline constexpr std::size_t probe_fields = 64;       ///< fields in one call of probe.sample
inline constexpr std::uint64_t seeds_least = 2;       ///< fewest seeds of a rake
inline constexpr std::uint64_t quads_default =
    1000000; ///< quads of a surface, if `maxQuads` is left out
inline constexpr std::uint64_t grant_seconds =
    316224000; ///< lifetime of a share link that expires (s)
inline constexpr std::uint64_t grant_seconds_default =
    604800; ///< lifetime of a share link, if `expiresIn` is left out (s)
inline constexpr double clock_speed = 1000000.0; ///< speed of a clock, in simulation time a second
inline constexpr std::size_t lease_ms = 5000;    ///< duration of a rake's lease (ms)
inline constexpr std::size_t trash_days =
    30; ///< days for which a deleted session can be restored (days)

/// A limit that server.info tells.
struct ToldLimit {
    const char* name;
    std::uint64_t value;
};

inline constexpr ToldLimit told[]{
    {"messageBytes", 65536},   {"batch", 64},           {"depth", 32},      {"clients", 2048},
    {"callsPerSecond", 2000},  {"editsPerSecond", 200}, {"sessions", 1024}, {"trash", 256},
    {"thumbnailBytes", 24576}, {"participants", 1536},  {"rakes", 256},     {"rakePoints", 1024},
    {"seeds", 4096},           {"surfaces", 64},        {"bookmarks", 256}, {"annotations", 512},
    {"sessionBytes", 1048576}, {"undo", 100},           {"shareLinks", 32}, {"subscriptions", 1024},
    {"waiters", 64},           {"pendingCalls", 256},   {"probes", 4},      {"sockets", 64},
    {"downloads", 8},          {"quads", 4000000},      {"fields", 5},      {"waitMs", 600000},
};

} // namespace wakesurf::protocol::limits
