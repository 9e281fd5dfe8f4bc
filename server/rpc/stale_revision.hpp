// ifRev: an edit that is only meant for a record that no one has changed since.
#pragma once

#include "protocol/api/json_rpc.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>

namespace wakesurf::server {

/// A fault carrying the current record, or nothing when the revision is the expected one.
std::optional<protocol::RpcFault> stale_revision(std::optional<std::uint64_t> expected,
                                                 std::uint64_t rev,
                                                 const nlohmann::json& record);

} // namespace wakesurf::server
