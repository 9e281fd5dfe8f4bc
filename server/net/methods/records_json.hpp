// The records of a session as JSON: in snapshots and lists, and the changes that session.patched and a
// resumed session.join carry.
#pragma once

#include "protocol/api/base/list_json.hpp"
#include "server/sessions/records/observer.hpp"
#include "server/sessions/session.hpp"

#include <nlohmann/json_fwd.hpp>

#include <ranges>
#include <span>

namespace wakesurf::server {

/// Returns an array of ValueRange.
nlohmann::json ranges_json(const ValueRanges& ranges);

/// Returns a Statistics.
nlohmann::json outcome_json(const SurfaceOutcome& outcome);

/// Returns a Problem.
nlohmann::json error_json(const core::Error& error);

/// Returns the array of all records of a type.
template <class R>
auto all_json(const Session& session) {
    return protocol::list_json(session.records().all<R>() | std::views::values,
                               [](const R& record) { return protocol::written(record); });
}

/// Returns what a session is called, and its units where it has some.
nlohmann::json session_name_json(const SessionName& session);

/// Returns a Snapshot, as the description of the API has it.
nlohmann::json records_json(const Session& session);

/// Returns an array of {op: put or delete, type, id, record?}.
nlohmann::json patches_json(std::span<const Patch> patches);

} // namespace wakesurf::server
