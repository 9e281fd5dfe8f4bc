// The records of a session, as snapshots and lists show them.
#pragma once

#include "server/service/session/session.hpp"

#include <nlohmann/json_fwd.hpp>

namespace wakesurf::server {

nlohmann::json rakes_json(const Session& session);
nlohmann::json surfaces_json(const Session& session);
nlohmann::json bookmarks_json(const Session& session);
nlohmann::json annotations_json(const Session& session);

/// {session, name, rakes, surfaces, bookmarks, annotations}
nlohmann::json records_json(const Session& session);

} // namespace wakesurf::server
