// A share link as it is kept: the role it gives, the digest of its key, when it expires, who made it, and
// whom a host has set a lesser role. Never the key.
#pragma once

#include "core/base/result.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::protocol {

struct GrantRecord {
    std::string role;
    std::string digest;                         ///< SHA-256 of the key, 64 hexadecimal digits
    std::optional<std::int64_t> expires;        ///< seconds since 1970
    std::string maker;                          ///< name of who made it; empty: a script
    std::vector<std::string> lineage;           ///< links it was made by, the first one first
    std::map<std::string, std::string> lowered; ///< participant -> role
    std::string copier = {}; ///< link by which its session was copied; empty: no copy

    bool operator==(const GrantRecord&) const = default;
};

/// Returns JSON text.
std::string grant_text(const GrantRecord& record);

/// Reads it back. Error: Corrupt.
core::Result<GrantRecord> read_grant(std::string_view text);

} // namespace wakesurf::protocol
