// Changes of a session's records, as session.patched and a resumed session.join carry them.
#pragma once

#include "server/service/session/records/observer.hpp"

#include <nlohmann/json_fwd.hpp>

#include <span>

namespace wakesurf::server {

/// An array of {op: put or delete, type, id, record?}.
nlohmann::json patches_json(std::span<const Patch> patches);

} // namespace wakesurf::server
