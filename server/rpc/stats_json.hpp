// What server.stats says: how long each stage took lately, and how the server stands.
#pragma once

#include "server/service/metrics/metrics.hpp"
#include "server/service/session/session.hpp"

#include <nlohmann/json_fwd.hpp>

namespace wakesurf::server {

/// {uptime, connections, clients, sessions, participants, surfaces, stages: {queue: {p50, p95, p99, count}, load, ...}, firstFrame:
/// {p50, ...}, cache: [{dataset, hits, loads, bytes, budget}], memory: {rss, peak}, messages, frames, bytes, keyframes, dropped}.
/// Times in seconds.
nlohmann::json stats_json(const Metrics& metrics, const Standing& standing);

/// What concerns those in one session: {participants, surfaces, stages, firstFrame}.
nlohmann::json stats_json(const Metrics& metrics, Session& session);

} // namespace wakesurf::server
